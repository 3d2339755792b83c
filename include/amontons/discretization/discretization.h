// All that changes only with the mesh: finite element, mapping, degrees of freedom, index sets, hanging
// nodes.
#pragma once

#include <amontons/base/linear_algebra.h>
#include <amontons/base/parameters.h>
#include <amontons/discretization/free_slides.h>
#include <amontons/geometry/geometry.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

#include <map>
#include <memory>

namespace Amontons
{
  struct DiscretizationParameters : ParameterGroup
  {
    std::string degree = "automatic"; // 1 | 2 | automatic: see degree_for()
    // A target asks for the contact pressure, and not too exactly.
    bool for_pressure = false;

    void
    declare(ParameterHandler &prm) override;

    // Quadratic elements need about a tenth of the unknowns of linear ones at equal error in contact force
    // and half-width (doc/results: half-plane box), and bend. In space, where a solve costs much, linear ones
    // take less time to the pressure of compact bodies, however near its edge limits both (doc/benchmarks).
    template <int dim>
    unsigned int
    degree_for(const Scene &scene, const Geometry<dim> &geometry) const;
  };

  // Global DoF indices of the corners A, B, C(, D) of a carrier cell (see geometry.h), by component.
  template <int dim>
  using CarrierDofs = std::array<std::array<types::global_dof_index, dim>, dim + 1>;

  // A round body that slides without friction, and that nothing else keeps from turning: the second
  // displacement follows the first.
  struct FreeTurn
  {
    unsigned int            body;
    types::global_dof_index first, second;
  };

  template <int dim>
  class Discretization
  {
  public:
    Discretization(const Scene &scene, const Geometry<dim> &geometry, const unsigned int degree);

    // To be called after every change of the mesh.
    void
    distribute_dofs();

    // Makes further DoFs (of replicated contact surfaces) known on this rank.
    void
    add_relevant(const IndexSet &dofs);

    // Hanging nodes with everything that the scene prescribes at time t: displacements, symmetry planes,
    // platens, rigid bodies and carriers. Consistent between ranks on all relevant DoFs; closed.
    Constraints
    make_supports(const double t) const;

    // Corner weights N_k(X) of carrier m: u(X) = sum_k N_k(X) u_k.
    std::array<double, dim + 1>
    carrier_weights(const unsigned int m, const Point<dim> &X) const;

    const Scene         &scene;
    const Geometry<dim> &geometry;
    // Given rotations are finite, and surfaces move. As the scene has it; `auto` begins without.
    bool            finite_strain;
    bool            degree_is_chosen = false; // by degree_for()
    FESystem<dim>   fe;
    MappingQ<dim>   load_mapping; // curved where linear elements have facets
    DoFHandler<dim> dof_handler;

    // Lines of the hanging nodes of owned and ghosted cells, closed.
    Constraints hanging_nodes;

    IndexSet                      locally_owned;
    IndexSet                      relevant;     // owned, ghosted, and whatever is replicated
    std::vector<CarrierDofs<dim>> carrier_dofs; // on every rank
    // Per rigid body: index of its carrier; numbers::invalid_unsigned_int for deformable bodies.
    std::vector<unsigned int> carrier_of_body;
    std::vector<FreeTurn>     free_turns;
    std::vector<FreeSlide>    free_slides; // held at finite strain
    // Names of pairs whose obstacles nothing touches: taken for none when the next DoFs are distributed.
    std::set<std::string> walls;

    bool
    is_deformable(const types::material_id id) const;

    // Of the elements: isoparametric, hanging nodes included.
    const Mapping<dim> &
    mapping() const
    {
      return *elements;
    }

    LA::Vector
    make_owned_vector() const; // writable also at relevant DoFs of other ranks, compress(add) sums them
    LA::Vector
    make_relevant_vector() const; // readable at all relevant DoFs

  private:
    std::unique_ptr<const Mapping<dim>> elements;
    LA::Vector                          to_parents; // from the vertices that hang, for linear elements

    void
    place_hanging_vertices();
    void
    find_carrier_dofs();
    void
    find_free_turns();
    void
    find_free_slides();
    void
    constrain_carriers(Constraints &constraints, const double t) const;
    void
    constrain_carrier_cells(Constraints &constraints) const;
    void
    constrain_rigid_bodies(Constraints &constraints) const;
    void
    constrain_platen(Constraints &constraints, const ConditionData &condition) const;
    void
    constrain_displacement(Constraints &constraints, const ConditionData &condition, const double t) const;
    void
    constrain_symmetry(Constraints &constraints, const ConditionData &condition) const;
  };

  // Local indices, in the base element, of the nodes on face f, in lexicographic order of the face's
  // coordinates.
  template <int dim>
  std::vector<unsigned int>
  nodes_on_face(const FiniteElement<dim> &base_element, const unsigned int f);
} // namespace Amontons
