// What small strain leaves out.
#pragma once

#include <amontons/adaptivity/error_estimator.h>
#include <amontons/contact/contact_interface.h>
#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/elasticity/stress_recovery.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  // Relative; the largest of the load program.
  struct NeglectedTerms
  {
    // The quadratic terms of the stress, in the energy norm, against the stress of small strain, see
    // ElasticityOperator::energy_of_neglected_stress(); a rotation alone has them, too. Where finite strain
    // cannot be tried, as rotations are free: no more than that of H less the mean rotation of each body, or
    // that rotation, by which its arms change.
    double strain = 0;
    // The largest of: the work of the contact forces on the gaps that their nodes have where the surfaces
    // really are (they should be 0), against twice the stored energy (doc/introduction.md, (28)); the part of
    // a pair's force where nothing is opposite any more; and, where surfaces overlap that carry no force, how
    // far, against their motion.
    double contact = 0;
    // What pressures are off, in the mean square, as gaps of closed nodes where the surfaces really are vary
    // along them: a flat that slides by T with its rounded end, of radius R, has a kink T/R, and a pressure
    // without bound there.
    double pressure = 0;
    // By how much the normals turn as surfaces move, so that the force of a pair has another direction: the
    // sum of its nodal pressures times areas times their change, against the force. Not across planes of
    // symmetry, where it vanishes in the whole model.
    double turn = 0;
    // How much stress may change the stiffness, at most: see slenderness.h. No error; but where it is small,
    // strings do not stiffen and columns do not buckle.
    double stiffening = 0;
    double buckling   = 0; // the same of compression alone

    double
    largest() const
    {
      return std::max(strain, contact);
    }
  };

  // Finite strain knows rotations that are given or held.
  template <int dim>
  bool
  holds_all_rotations(const Discretization<dim> &discretization);

  // Collects them over the increments of a load program with small strain. Energies and works count against
  // the largest energy so far. The gaps are measured where the surfaces have moved farthest, and in the end:
  // coupling surfaces anew costs too much for each increment.
  template <int dim>
  class NeglectedTermsOfHistory
  {
  public:
    // A converged increment; energy: stored. Collective.
    void
    add(const Discretization<dim>                &discretization,
        const StressRecovery<dim>                &recovery,
        const ElasticityOperator<dim>            &elasticity,
        const SolutionState<dim>                 &state,
        const std::vector<ContactInterface<dim>> &interfaces,
        const double                              energy);

    // Before the mesh changes, and in the end. pressures: what uneven gaps make of them, too; not if the
    // answer is that of a finer mesh, whose facets are others. Collective.
    void
    measure_gaps(const Discretization<dim>                &discretization,
                 const Constraints                        &supports,
                 const std::vector<ContactInterface<dim>> &interfaces,
                 const bool                                pressures = true);

    const NeglectedTerms &
    largest() const
    {
      return terms;
    }
    // The last state says little of the others.
    bool
    came_back() const
    {
      return has_come_back;
    }

  private:
    struct Place;
    std::vector<ContactInterface<dim>>
    interfaces_at(const LA::Vector                         &u,
                  const Place                              &place,
                  const Discretization<dim>                &discretization,
                  const Constraints                        &supports,
                  const std::vector<ContactInterface<dim>> &interfaces) const;
    double
    turned_force(const Place                              &place,
                 const std::vector<ContactInterface<dim>> &interfaces,
                 const std::vector<ContactInterface<dim>> &moved) const;
    double
    neglected_contact(const Place                              &place,
                      const std::vector<ContactInterface<dim>> &at_rest,
                      const std::vector<ContactInterface<dim>> &moved) const;

    struct Node // of the slave, with a multiplier
    {
      unsigned int node;
      bool         closed;
      double       area, pressure;
      double       initial_gap, gap; // before any motion, and now to first order
    };
    std::map<unsigned int, double>
    true_gaps(const unsigned int                        i,
              const Place                              &place,
              const std::vector<ContactInterface<dim>> &at_rest,
              const std::vector<ContactInterface<dim>> &moved) const;
    double
    pressure_of_uneven_gaps(const Place                              &place,
                            const Discretization<dim>                &discretization,
                            const std::vector<ContactInterface<dim>> &at_rest,
                            const std::vector<ContactInterface<dim>> &moved) const;

    struct Place
    {
      LA::Vector                     displacement;
      double                         motion = 0, energy = 0, t = 0;
      double                         pressure = 0; // in the mean square, not relative
      std::vector<std::vector<Node>> nodes;        // by pair
    };

    // What is left out there is not told relative to what is left, see Evaluation::judge_by_history().
    bool
    is_unloaded(const Place &place) const
    {
      return place.pressure < unloaded_part * largest_pressure;
    }

    NeglectedTerms       terms;
    double               largest_energy   = 0; // twice the stored one
    double               largest_pressure = 0;
    double               measured_motion  = 0; // of places that are gone
    bool                 has_come_back    = false;
    std::optional<Place> farthest, last; // last: unless it is the farthest
  };
} // namespace Amontons
