// Rigid motions of the bodies: which ones supports leave, which of these contact can hold, and whether loads
// drive the others.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/discretization/dof_places.h>
#include <amontons/discretization/discretization.h>
#include <amontons/discretization/elimination.h>

#include <deal.II/lac/full_matrix.h>

#include <numeric>

namespace Amontons
{
  // The displacements of all bodies and carriers as rigid motions: v = sum_m q_m v_m with translations and
  // rotations (scaled by the body's size) of each. A constraint line u_d = sum a u_j is violated by e_m =
  // v_m,d - sum a v_m,j, a contact equation by a . v_m; the null space of S = sum e e^T over the lines are
  // the motions that supports leave, that of S + C the ones that contact cannot hold either. With a
  // displacement (readable at relevant DoFs) the bodies are where it takes them.
  template <int dim>
  class FloatingBodies
  {
  public:
    FloatingBodies(const Discretization<dim>                &discretization,
                   const Constraints                        &supports,
                   const std::vector<ContactInterface<dim>> &interfaces,
                   const LA::Vector                         *displacement = nullptr);

    // What the loads (raw) do on each motion; to be called before the functions below.
    void
    set_loads(const LA::Vector &loads);

    // Names of the bodies and motions that supports alone do not hold.
    const std::vector<bool> &
    floats() const
    {
      return floating;
    } // by body, then by carrier
    bool
    any() const
    {
      return n_free > 0;
    }

    // Motions that no node that may close could hold need not move: as many DoFs of contact surfaces as there
    // are such motions, chosen so that holding their increments holds the motions. Statically determinate, so
    // nothing is strained by it.
    const std::vector<types::global_dof_index> &
    pins() const
    {
      return pinned;
    }
    void
    choose_pins(const std::vector<const LinearEquation *> &all_equations);

    // Motions that supports, pins and the equations (of closed nodes) leave, as coefficients of the bodies'
    // motions, in the direction that loads drive.
    std::vector<std::vector<double>>
    free_rigid_modes(const std::vector<const LinearEquation *> &equations) const;
    // By body, then by carrier: whether any of these motions moves it.
    std::vector<bool>
    moved_by(const std::vector<std::vector<double>> &motions) const;
    // Of the loads on each of these motions (of unit length), relative to the largest sum of their magnitudes
    // on any of the bodies that the motions move: one scale for all of them, as the work is linear in q.
    std::vector<double>
    relative_work(const std::vector<std::vector<double>> &motions) const;
    double
    work(const std::vector<double> &motion) const // of the loads
    {
      return std::inner_product(motion.begin(), motion.end(), force.begin(), 0.);
    }
    std::string
    describe(const std::vector<double> &motion) const;
    // sum coefficient u for the displacements u of a motion.
    double
    evaluate_on(const LinearEquation &equation, const std::vector<double> &motion) const;

    // At the point x of a body (or n_bodies + carrier).
    Tensor<1, dim>
    velocity(const std::vector<double> &motion, const unsigned int owner, const Point<dim> &x) const;

    // Throws InputError if loads work on a motion that neither supports nor any node that may close can hold;
    // else returns a sentence about motions that nothing holds (and nothing drives), or "".
    std::string
    check_loads(const std::vector<const LinearEquation *> &all_equations) const;

    // Body (or n_bodies + carrier) that a relevant DoF belongs to.
    unsigned int
    owner_of(const types::global_dof_index dof) const;

  private:
    void
    check_rolling() const; // throws InputError
    void
    place_dofs(const std::vector<ContactInterface<dim>> &interfaces, const LA::Vector *displacement);
    void
    add_supports(const Constraints &supports);
    std::vector<double>
    violation(const Coefficients &coefficients) const;
    double
    value_of_mode(const unsigned int owner,
                  const unsigned int mode,
                  const Point<dim>  &X,
                  const unsigned int component) const;
    void
    add_modes_of(const types::global_dof_index dof, const double weight, std::vector<double> &e) const;
    FullMatrix<double>
    null_space(const FullMatrix<double> &S, const double relative_threshold) const; // columns
    bool
    is_driven(const std::vector<double> &q) const;
    FullMatrix<double>
    with_equations(const std::vector<const LinearEquation *> &equations) const;
    SourceLocation
    place_of(const std::vector<double> &q) const; // of the body or motion that moves most

    DofPlace<dim> &
    place(const types::global_dof_index dof)
    {
      return places[discretization.relevant.index_within_set(dof)];
    }

    const Discretization<dim>           &discretization;
    std::vector<DofPlace<dim>>           places;       // of the relevant DoFs
    std::vector<types::global_dof_index> surface_dofs; // of all interfaces, the same on every rank
    std::vector<Point<dim>>              centres;      // by body, then carrier
    std::vector<double>                  sizes;
    unsigned int                         modes_per_body, n_modes;
    FullMatrix<double>                   supports_matrix;
    std::vector<bool>                    floating;
    unsigned int                         n_free = 0;
    std::vector<types::global_dof_index> pinned;
    std::vector<double>                  force, magnitude; // by motion
  };
} // namespace Amontons
