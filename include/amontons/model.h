/// The bodies of a scene and what is between them: all that changes with the mesh.
#pragma once

#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/elasticity/loads.h>
#include <amontons/elasticity/mechanics.h>
#include <amontons/solver/solution_state.h>

#include <deal.II/base/timer.h>

namespace Amontons
{
  /// The mesh with its unknowns. It may serve several models, one after the other: the same bodies with small
  /// and with finite strain.
  template <int dim>
  struct BodyMesh
  {
    /// Throws InputError. Collective.
    BodyMesh(const Scene &scene, const unsigned int degree);

    Geometry<dim>                        geometry;
    std::unique_ptr<Discretization<dim>> discretization;
    std::vector<bool>                    first_is_slave;        // by pair, see choose_slaves
    bool                                 collocated    = false; // node to segment
    unsigned int                         n_refinements = 0;     // by error estimates
  };

  /// Who solves reads the bodies' stiffness, the interfaces, supports and loads, all of the same mesh and
  /// time.
  template <int dim>
  class Model
  {
  public:
    /// At time t, with the surfaces coupled where the bodies are undeformed. timer: of the run.
    Model(const std::shared_ptr<BodyMesh<dim>> &mesh,
          const bool                            finite_strain,
          const double                          t,
          TimerOutput                          &timer);

    /// Another one on the same mesh, undeformed at time t.
    Model
    at_rest(const double t) const;

    /// Another one on the same mesh, where the state is. This one is of use again after resume().
    Model
    with_finite_strain(const SolutionState<dim> &state) const;
    void
    resume();

    bool
    finite_strain() const
    {
      return elasticity.finite_strain();
    }
    const Discretization<dim> &
    discretization() const
    {
      return *mesh->discretization;
    }
    double
    time() const
    {
      return t;
    }
    /// At the present time; must not outlive the model. Small strain: with the loads, and all assembled.
    std::unique_ptr<Mechanics<dim>>
    mechanics(const SolutionState<dim> &state);

    /// Supports and declared gaps.
    void
    set_time(const double t);
    /// Finite strain: couples the surfaces where the state takes them (else they stay where they are).
    void
    move_to(const SolutionState<dim> &state);
    void
    update_loads(const SolutionState<dim> &state);

    /// Surfaces that touch in a small part of what faces each other are refined there, at most `times`.
    void
    refine_where_bodies_are_close(const unsigned int times);
    /// False where no cell may be refined.
    bool
    mark_cells(const RefinementParameters &parameters, const ErrorEstimate<dim> &error);
    /// Refines marked cells, and takes fields along (see refine_and_transfer). Finite strain: move_to() has
    /// to follow.
    void
    refine(const std::vector<LA::Vector *> &fields);

    /// Gaps that are far larger than what displacements close never matter. Of those of the nodes that are
    /// closed and of what displacements closed elsewhere, the next meshes take twice the largest into
    /// account; if that was not enough here, the surfaces are coupled again with more (returns true).
    bool
    widen_search(const SolutionState<dim> &state);

    std::shared_ptr<BodyMesh<dim>>     mesh;
    ElasticityOperator<dim>            elasticity;
    std::vector<ContactInterface<dim>> interfaces;
    Constraints                        supports;
    LA::Vector                         loads; // of the last update_loads()

  private:
    Model(const std::shared_ptr<BodyMesh<dim>> &mesh,
          const bool                            finite_strain,
          const double                          t,
          TimerOutput                          &timer,
          const std::vector<double>            &reaches);

    void
    make_supports(const double t);
    void
    find_surfaces();
    void
    couple_at_rest();
    void
    rebuild();
    std::vector<CoveredPoint<dim>>
    covered_points() const;

    TimerOutput        &timer;
    double              t;       // of the supports
    std::vector<double> reaches; // by pair, of the next coupling, see widen_search; 0: not known yet
  };
} // namespace Amontons
