/// The bodies of a scene and what is between them: all that changes with the mesh.
#pragma once

#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/adaptivity/small_contacts.h>
#include <amontons/elasticity/loads.h>
#include <amontons/elasticity/mechanics.h>
#include <amontons/solver/solution_state.h>

#include <deal.II/base/timer.h>

namespace Amontons
{
  template <int dim>
  class KeptSystem;

  /// The mesh with its unknowns. It may serve several models, one after the other: the same bodies with small
  /// and with finite strain.
  template <int dim>
  struct BodyMesh
  {
    /// Throws InputError. Collective.
    BodyMesh(const Scene &scene, const DiscretizationParameters &parameters);

    Geometry<dim>                        geometry;
    std::unique_ptr<Discretization<dim>> discretization;
    std::vector<bool>                    first_is_slave;        // by pair, see choose_slaves
    bool                                 collocated    = false; // node to segment
    unsigned int                         n_refinements = 0;     // by error estimates
    std::set<CellId>                     first_cells; // before these, if it is coarsened, see Model::coarsen
  };

  /// Who solves reads the bodies' stiffness, the interfaces, supports and loads, all of the same mesh and
  /// time. How they follow the state is a matter of the kinematics: small_strain_model.h,
  /// finite_strain_model.h.
  template <int dim>
  class Model
  {
  public:
    virtual ~Model() = default;

    /// Another one on the same mesh, undeformed at time t.
    virtual std::unique_ptr<Model>
    at_rest(const double t) const = 0;

    /// After another model has used the mesh.
    void
    resume();

    const Discretization<dim> &
    discretization() const
    {
      return *mesh->discretization;
    }
    bool
    finite_strain() const
    {
      return elasticity.finite_strain();
    }
    double
    time() const
    {
      return t;
    }

    /// Supports and declared gaps.
    virtual void
    set_time(const double t);
    /// Couples the surfaces where the state takes them, if they move.
    virtual void
    move_to(const SolutionState<dim> &state) = 0;
    /// Of the state.
    virtual void
    update_loads(const SolutionState<dim> &state) = 0;
    /// For an iteration that starts from the state, at the present time; must not outlive the model.
    virtual std::unique_ptr<Mechanics<dim>>
    mechanics(const SolutionState<dim> &state) = 0;
    /// The couplings left something out that this state, their solution, closes or may close, or has come
    /// through: the surfaces are coupled anew, and it has to be solved again.
    bool
    couple_better(const SolutionState<dim> &state);

    /// Surfaces that touch in a small part of what faces each other are refined there, as often as
    /// `Initial refinements` allow.
    void
    refine_where_bodies_are_close(const RefinementParameters &parameters);
    /// step: growth of the number of cells where the stress marks few (adaptivity/mesh_refinement.h). False
    /// where no cell may be refined.
    bool
    mark_cells(const RefinementParameters &parameters,
               const ErrorEstimate<dim>   &error,
               const double                target,
               const double                step);
    /// Instead of mark_cells(), where contacts are far smaller than the faces that carry them: they are
    /// refined to their size at once (adaptivity/small_contacts.h). False where there are none.
    bool
    mark_small_contacts(const RefinementParameters            &parameters,
                        const std::vector<SurfaceFields<dim>> &fields);
    /// After mark_cells() for a target: marks what need not be as fine any more (mark_cells_to_coarsen).
    void
    coarsen(const ErrorEstimate<dim> &error, const double target);
    /// Refines and coarsens marked cells, and takes fields along (see refine_and_transfer); move_to() has to
    /// follow.
    void
    refine(const std::vector<LA::Vector *> &fields);

    const std::shared_ptr<BodyMesh<dim>> mesh;
    ElasticityOperator<dim>              elasticity;
    std::vector<ContactInterface<dim>>   interfaces;
    Constraints                          supports;
    LA::Vector                           loads; // of the last update_loads()
    /// Small strain; of the mesh, for all models on it at rest.
    std::shared_ptr<KeptSystem<dim>> kept_system;

    /// Points of faces where bodies lie on each other, on which pressure does not act.
    std::vector<CoveredPoint<dim>>
    covered_points() const;

  protected:
    // Surfaces that are not coupled yet.
    Model(const std::shared_ptr<BodyMesh<dim>> &mesh,
          const bool                            finite_strain,
          const double                          t,
          TimerOutput                          &timer);

    virtual void
    couple_at_rest();
    // Coupled anew in a larger part, if need be.
    virtual bool
    widen_search(const SolutionState<dim> &state) = 0;
    // As far as that can be done before move_to().
    virtual void
    couple_refined() = 0;
    // A point where the surfaces of an interface face each other: they lie on each other, as they did at
    // rest, and pressure does not act.
    virtual bool
    is_covered(const unsigned int interface, const OverlapPoint<dim> &point) const = 0;

    TimerOutput &timer;

  private:
    void
    find_surfaces();
    void
    rebuild();

    double                                          t;       // of the supports
    DeeperCells                                     deeper;  // of the refinement that is marked
    std::vector<SmallContact<dim>>                  small;   // likewise
    std::set<std::pair<unsigned int, unsigned int>> changed; // see prefer_overlapped(), at this time
  };

  /// At time t, with the surfaces coupled where the bodies are undeformed. timer: of the run.
  template <int dim>
  std::unique_ptr<Model<dim>>
  make_model(const std::shared_ptr<BodyMesh<dim>> &mesh,
             const bool                            finite_strain,
             const double                          t,
             TimerOutput                          &timer);
} // namespace Amontons
