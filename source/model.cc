#include <amontons/adaptivity/first_mesh.h>
#include <amontons/adaptivity/mesh_coarsening.h>
#include <amontons/base/points.h>
#include <amontons/contact/shared_nodes.h>
#include <amontons/finite_strain_model.h>
#include <amontons/geometry/rigid_rims.h>
#include <amontons/geometry/small_obstacles.h>
#include <amontons/output/target_quantity.h>
#include <amontons/small_strain_model.h>
#include <amontons/solver/kept_system.h>

namespace Amontons
{
  template <int dim>
  BodyMesh<dim>::BodyMesh(const Scene &scene, const DiscretizationParameters &parameters)
      : geometry(MPI_COMM_WORLD)
  {
    make_geometry(scene, geometry);
    refine_below_small_obstacles(scene, geometry);
    refine_rims_of_rigid_bodies(scene, geometry);
    discretization =
        std::make_unique<Discretization<dim>>(scene, geometry, parameters.degree_for(scene, geometry));
    discretization->degree_is_chosen = parameters.degree == "automatic";
    discretization->distribute_dofs();
    first_is_slave = choose_slaves(*discretization);
  }

  template <int dim>
  Model<dim>::Model(const std::shared_ptr<BodyMesh<dim>> &mesh,
                    const bool                            finite_strain,
                    const double                          t,
                    TimerOutput                          &timer)
      : mesh(mesh), elasticity(*mesh->discretization, finite_strain), timer(timer), t(t)
  {
    resume();
    find_surfaces();
  }

  // Given rotations are finite, and surfaces may come from afar, as in this model.
  template <int dim>
  void
  Model<dim>::resume()
  {
    mesh->discretization->finite_strain = finite_strain();
  }

  template <int dim>
  void
  Model<dim>::find_surfaces()
  {
    changed.clear();
    std::vector<std::optional<typename ContactInterface<dim>::FirstGap>> first_gaps;
    for (const auto &interface : interfaces)
      first_gaps.push_back(interface.first_gap);
    interfaces  = make_interfaces(discretization(), mesh->first_is_slave);
    kept_system = std::make_shared<KeptSystem<dim>>();
    for (unsigned int i = 0; i < first_gaps.size(); ++i)
      interfaces[i].first_gap = first_gaps[i];
    for (auto &interface : interfaces)
      {
        interface.t          = t;
        interface.collocated = mesh->collocated;
        for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
          if (surface != nullptr)
            mesh->discretization->add_relevant(surface->dofs());
      }
    supports = discretization().make_supports(t);
  }

  template <int dim>
  void
  Model<dim>::couple_at_rest()
  {
    integrate_couplings(discretization(), supports, interfaces);
  }

  // All that depends on the mesh, but for the couplings.
  template <int dim>
  void
  Model<dim>::rebuild()
  {
    TimerOutput::Scope scope(timer, "contact surfaces");
    mesh->discretization->distribute_dofs();
    elasticity.clear();
    find_surfaces();
  }

  template <int dim>
  void
  Model<dim>::set_time(const double now)
  {
    if (t == now)
      return;
    t        = now;
    supports = discretization().make_supports(t);
    changed.clear();
  }

  template <int dim>
  bool
  Model<dim>::couple_better(const SolutionState<dim> &state)
  {
    if (widen_search(state))
      return true;
    TimerOutput::Scope scope(timer, "contact surfaces");
    if (!prefer_overlapped(discretization(), state.displacement, interfaces, changed))
      return false;
    integrate_couplings(discretization(), supports, interfaces, finite_strain());
    return true;
  }

  template <int dim>
  std::vector<CoveredPoint<dim>>
  Model<dim>::covered_points() const
  {
    const unsigned int             rank = Utilities::MPI::this_mpi_process(mesh->geometry.communicator);
    std::vector<CoveredPoint<dim>> covered;
    const auto                     add = [&](const ContactSurface<dim> &surface,
                         const unsigned int         face,
                         const Point<dim - 1>      &xi,
                         const double               weight) {
      if (surface.faces[face].rank != rank)
        return;
      const auto [cell, f] = surface.owned[surface.faces[face].owned_index];
      covered.push_back({cell, f, on_unit_cell<dim>(f, xi), weight});
    };
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (const auto &p : interfaces[i].coupling.points)
        if (is_covered(i, p))
          {
            add(*interfaces[i].slave, p.slave_face, p.xi_slave, p.weight);
            if (interfaces[i].master.surface != nullptr)
              add(*interfaces[i].master.surface, p.master_face, p.xi_master, p.weight);
          }
    return covered;
  }

  template <int dim>
  void
  Model<dim>::refine_where_bodies_are_close(const RefinementParameters &parameters)
  {
    const unsigned int times    = parameters.initial_refinements;
    const bool         flat_too = dim == 2 || !always_converges(parameters.target_quantity);
    TimerOutput::Scope scope(timer, "mesh");
    const auto         refine = [&]() {
      mesh->geometry.triangulation.execute_coarsening_and_refinement();
      rebuild();
      couple_at_rest();
    };
    constexpr unsigned int most_times = 12; // a face that is 4,000 times as large
    for (unsigned int i = 0;
         times > 0 && i < most_times && mark_cells_at_small_surfaces(discretization(), interfaces) > 0;
         ++i)
      refine();
    for (unsigned int i = 0; i < times && mark_close_cells(discretization(), interfaces, 0.1, flat_too) > 0;
         ++i)
      refine();
  }

  // Unless tractions have a target there are two aims: the stress everywhere, on which contact forces and
  // sizes depend, and the tractions themselves.
  template <int dim>
  bool
  Model<dim>::mark_cells(const RefinementParameters &parameters,
                         const ErrorEstimate<dim>   &error,
                         const double                target,
                         const double                step)
  {
    deeper.clear();
    if (target > 0 && parameters.strategy == "adaptive" && !error.quantity && error.contact > 0)
      return mark_cells_for_target(discretization(),
                                   mesh->geometry,
                                   parameters.max_dofs,
                                   error.indicators_for(target),
                                   target / error.of_target(),
                                   discretization().scene.has_friction(),
                                   deeper);
    const auto mark = [&](const Vector<float> &indicators, const double growth = 0) {
      return Amontons::mark_cells(discretization(), mesh->geometry, parameters, indicators, growth);
    };
    const bool is_adaptive = parameters.strategy == "adaptive",
               is_unseen   = is_adaptive && error.data >= 1; // what touches: it shows there alone
    bool any               = !is_unseen && mark(error.cell_indicators, step);
    if (is_adaptive && (any || is_unseen))
      {
        any = mark(error.contact_indicators) || any;
        mark(error.shear_indicators);
        const bool is_peak = parameters.target_quantity == "peak pressure",
                   is_size = parameters.target_quantity == "contact size";
        if (is_peak || (is_size && error.contact < 0.5)) // more: what is not known is beside an edge
          mark(error.pollution_indicators);
        if (is_peak || is_size || parameters.target_quantity == "stick size")
          mark(error.quantity_indicators);
      }
    return any;
  }

  template <int dim>
  bool
  Model<dim>::mark_small_contacts(const RefinementParameters            &parameters,
                                  const std::vector<SurfaceFields<dim>> &fields)
  {
    deeper.clear();
    small = small_contacts(discretization(), interfaces, fields);
    if (parameters.strategy != "adaptive" || 2 * discretization().dof_handler.n_dofs() > parameters.max_dofs)
      small.clear();
    return !small.empty() && mark_cells_at(discretization(), small) > 0;
  }

  template <int dim>
  void
  Model<dim>::coarsen(const ErrorEstimate<dim> &error, const double target)
  {
    if (mesh->first_cells.empty())
      mesh->first_cells = deformable_cells(discretization());
    mark_cells_to_coarsen(
        discretization(), mesh->geometry, mesh->first_cells, error.indicators_for(target), target);
  }

  template <int dim>
  void
  Model<dim>::refine(const std::vector<LA::Vector *> &fields)
  {
    while (!deeper.empty() || !small.empty())
      {
        refine_and_transfer(*mesh->discretization, mesh->geometry, fields, [&]() {
          mesh->discretization->distribute_dofs();
        });
        mark_children(discretization(), mesh->geometry, deeper);
        if (mark_cells_at(discretization(), small) == 0)
          small.clear();
      }
    refine_and_transfer(*mesh->discretization, mesh->geometry, fields, [&]() {
      rebuild();
      couple_refined();
    });
    ++mesh->n_refinements;
  }

  template <int dim>
  std::unique_ptr<Model<dim>>
  make_model(const std::shared_ptr<BodyMesh<dim>> &mesh,
             const bool                            finite_strain,
             const double                          t,
             TimerOutput                          &timer)
  {
    TimerOutput::Scope scope(timer, "contact surfaces");
    if (finite_strain)
      return std::make_unique<FiniteStrainModel<dim>>(mesh, t, timer);
    return std::make_unique<SmallStrainModel<dim>>(mesh, t, timer);
  }

  template struct BodyMesh<2>;
  template struct BodyMesh<3>;
  template class Model<2>;
  template class Model<3>;
  template std::unique_ptr<Model<2>>
  make_model(const std::shared_ptr<BodyMesh<2>> &, const bool, const double, TimerOutput &);
  template std::unique_ptr<Model<3>>
  make_model(const std::shared_ptr<BodyMesh<3>> &, const bool, const double, TimerOutput &);
} // namespace Amontons
