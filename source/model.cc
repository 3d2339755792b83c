#include <amontons/base/points.h>
#include <amontons/contact/surface_search.h>
#include <amontons/elasticity/finite_mechanics.h>
#include <amontons/elasticity/linear_mechanics.h>
#include <amontons/model.h>

namespace Amontons
{
  template <int dim>
  BodyMesh<dim>::BodyMesh(const Scene &scene, const unsigned int degree) : geometry(MPI_COMM_WORLD)
  {
    make_geometry(scene, geometry);
    discretization = std::make_unique<Discretization<dim>>(scene, geometry, degree);
    discretization->distribute_dofs();
    first_is_slave = choose_slaves(*discretization);
  }

  template <int dim>
  Model<dim>::Model(const std::shared_ptr<BodyMesh<dim>> &mesh,
                    const bool                            finite_strain,
                    const double                          t,
                    TimerOutput                          &timer)
      : Model(mesh, finite_strain, t, timer, {})
  {
    TimerOutput::Scope scope(timer, "contact surfaces");
    couple_at_rest();
  }

  template <int dim>
  Model<dim>::Model(const std::shared_ptr<BodyMesh<dim>> &mesh,
                    const bool                            finite_strain,
                    const double                          t,
                    TimerOutput                          &timer,
                    const std::vector<double>            &reaches)
      : mesh(mesh), elasticity(*mesh->discretization, finite_strain), timer(timer), t(t), reaches(reaches)
  {
    resume();
    find_surfaces();
  }

  template <int dim>
  Model<dim>
  Model<dim>::at_rest(const double t) const
  {
    Model other(mesh, finite_strain(), t, timer, reaches);
    other.couple_at_rest();
    return other;
  }

  template <int dim>
  Model<dim>
  Model<dim>::with_finite_strain(const SolutionState<dim> &state) const
  {
    std::vector<double> same;
    for (const auto &interface : interfaces)
      same.push_back(interface.reach);
    Model other(mesh, true, t, timer, same);
    other.move_to(state);
    return other;
  }

  // Given rotations are finite, and surfaces may come from afar, as in this model.
  template <int dim>
  void
  Model<dim>::resume()
  {
    mesh->discretization->finite_strain = finite_strain();
  }

  template <int dim>
  std::unique_ptr<Mechanics<dim>>
  Model<dim>::mechanics(const SolutionState<dim> &state)
  {
    if (finite_strain())
      return std::make_unique<FiniteMechanics<dim>>(
          discretization(), elasticity, t, [this]() { return covered_points(); });
    TimerOutput::Scope scope(timer, "assemble stiffness");
    if (elasticity.is_cleared())
      elasticity.assemble(state.displacement);
    update_loads(state);
    return std::make_unique<LinearMechanics<dim>>(elasticity, loads);
  }

  template <int dim>
  void
  Model<dim>::make_supports(const double now)
  {
    t        = now;
    supports = discretization().make_supports(t);
  }

  template <int dim>
  void
  Model<dim>::find_surfaces()
  {
    interfaces = make_interfaces(discretization(), mesh->first_is_slave);
    reaches.resize(interfaces.size(), 0.);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        interfaces[i].reach      = reaches[i];
        interfaces[i].t          = t;
        interfaces[i].collocated = mesh->collocated;
        for (const auto *surface : {interfaces[i].slave.get(), interfaces[i].master_surface.get()})
          if (surface != nullptr)
            mesh->discretization->add_relevant(surface->dofs());
      }
    make_supports(t);
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
    make_supports(now);
    if (!finite_strain())
      redeclare_gaps(discretization(), t, interfaces);
  }

  template <int dim>
  void
  Model<dim>::move_to(const SolutionState<dim> &state)
  {
    if (!finite_strain())
      return;
    TimerOutput::Scope scope(timer, "contact surfaces");
    for (unsigned int i = 0; i < state.contact.size(); ++i)
      if (state.contact[i].size() == interfaces[i].slave->nodes.size())
        {
          interfaces[i].carried.clear();
          for (const auto &node : state.contact[i])
            interfaces[i].carried.push_back(node.has_multiplier);
        }
    couple_moved(discretization(), supports, state.displacement, state.t, interfaces);
  }

  template <int dim>
  void
  Model<dim>::update_loads(const SolutionState<dim> &state)
  {
    loads = assemble_loads(
        discretization(), state.t, covered_points(), finite_strain() ? &state.displacement : nullptr);
  }

  // Points of faces where bodies lie on each other: pressure does not act there. Small strain: from the
  // start.
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
    for (const auto &interface : interfaces)
      for (const auto &p : interface.coupling.points)
        if (std::abs(gap_grows(interface) && !finite_strain()
                         ? interface.pair->initial_gap->value(as_3d(p.x_slave), 0)
                         : p.gap) <= 1e-6 * interface.slave->faces[p.slave_face].size)
          {
            add(*interface.slave, p.slave_face, p.xi_slave, p.weight);
            if (interface.master.surface != nullptr)
              add(*interface.master.surface, p.master_face, p.xi_master, p.weight);
          }
    return covered;
  }

  template <int dim>
  void
  Model<dim>::refine_where_bodies_are_close(const unsigned int times)
  {
    TimerOutput::Scope scope(timer, "mesh");
    for (unsigned int i = 0; i < times && mark_close_cells(discretization(), interfaces, 0.1) > 0; ++i)
      {
        mesh->geometry.triangulation.execute_coarsening_and_refinement();
        rebuild();
        couple_at_rest();
      }
  }

  // Two aims: the stress everywhere, on which contact forces and sizes depend, and the pressure itself.
  template <int dim>
  bool
  Model<dim>::mark_cells(const RefinementParameters &parameters, const ErrorEstimate<dim> &error)
  {
    const auto mark = [&](const Vector<float> &indicators) {
      return Amontons::mark_cells(discretization(), mesh->geometry, parameters, indicators);
    };
    const bool bulk = mark(error.cell_indicators);
    if (bulk && parameters.strategy == "adaptive")
      mark(error.contact_indicators);
    return bulk;
  }

  template <int dim>
  void
  Model<dim>::refine(const std::vector<LA::Vector *> &fields)
  {
    refine_and_transfer(*mesh->discretization, mesh->geometry, fields, [&]() {
      rebuild();
      if (!finite_strain())
        couple_at_rest();
    });
    ++mesh->n_refinements;
  }

  template <int dim>
  bool
  Model<dim>::widen_search(const SolutionState<dim> &state)
  {
    if (finite_strain()) // surfaces are searched wherever they are
      return false;
    const bool may_shrink = !discretization().scene.has_friction(); // else the path may need them again
    bool       too_short  = false;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (interfaces[i].pair->tied || interfaces[i].pair->initial_gap)
          continue; // a declared gap says nothing about the distance of the meshes
        double needed     = 0;
        bool   any_closed = false;
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto &node   = state.contact[i][row.node];
            const bool  closed = node.state != ContactState::open;
            any_closed         = any_closed || closed;
            needed             = std::max(needed, closed ? std::abs(row.gap) : row.gap - node.gap);
          }
        if (!any_closed)
          continue;
        const bool short_here = reaches[i] > 0 && needed > 0.75 * reaches[i];
        if (short_here || reaches[i] == 0 || (may_shrink && 4 * needed < reaches[i]))
          reaches[i] = 2 * needed + 1e-3 * interfaces[i].slave->mean_size;
        too_short = too_short || short_here;
      }
    if (!too_short)
      return false;
    TimerOutput::Scope scope(timer, "contact surfaces");
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      interfaces[i].reach = reaches[i];
    couple_at_rest();
    return true;
  }

  template struct BodyMesh<2>;
  template struct BodyMesh<3>;
  template class Model<2>;
  template class Model<3>;
} // namespace Amontons
