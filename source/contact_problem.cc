#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/contact/surface_search.h>
#include <amontons/contact_problem.h>
#include <amontons/friction/shear_law.h>
#include <amontons/output/files.h>

namespace Amontons
{
  template <int dim>
  ContactProblem<dim>::ContactProblem(const Scene              &scene,
                                      const Parameters         &parameters,
                                      const std::string        &output_folder,
                                      const bool                quiet,
                                      const MakeReference<dim> &make_reference)
      : scene(scene), finite_strain(scene.kinematics == Kinematics::finite_strain),
        has_history(scene.has_friction()), incremental(has_history || finite_strain), parameters(parameters),
        folder(output_folder), report(this->scene, parameters.output, folder, quiet, make_reference),
        geometry(MPI_COMM_WORLD)
  {
    const Where entry{scene.file, 0, "Contact solver/Method"};
    if (parameters.newton.method == "node-to-segment" && scene.kinematics != Kinematics::small_strain)
      throw InputError(
          entry, "node-to-segment where surfaces move", "it with 'Kinematics = small strain' only");
    if (parameters.newton.method == "penalty" && has_history && parameters.refinement.cycles > 0 &&
        parameters.refinement.history == "transfer")
      throw InputError(entry,
                       "penalty with friction, whose history is carried from mesh to mesh",
                       "'Refinement/History = replay'");
  }

  template <int dim>
  RunSummary
  ContactProblem<dim>::run()
  {
    report.start();
    history.state.t = LoadProgram(scene, incremental).next();
    //! [run]
    make_mesh();
    rebuild();
    refuse_hidden_sides(*discretization, interfaces);
    refine_where_bodies_are_close();
    make_output_folder(folder, geometry.communicator);

    bool success = run_all_meshes();
    if (!finite_strain)
      success = choose_kinematics(success);
    if (success && has_history)
      add_error_of_increments();
    return report.finish(answer(), ending(success));
    //! [run]
  }

  template <int dim>
  bool
  ContactProblem<dim>::run_all_meshes()
  {
    bool success, enough;
    do
      {
        success = run_load_program();
        if (success && has_history && !measured_increments && parameters.refinement.history == "replay" &&
            resolves_friction())
          measure_increments();
        enough = only_increments && measured_increments;
      }
    while (success && !enough && replay_refined());
    return success;
  }

  template <int dim>
  void
  ContactProblem<dim>::make_mesh()
  {
    TimerOutput::Scope scope(report.timer(), "mesh");
    make_geometry(scene, geometry);
    discretization = std::make_unique<Discretization<dim>>(scene, geometry, parameters.discretization.degree);
    elasticity     = std::make_unique<ElasticityOperator<dim>>(*discretization, finite_strain);
    discretization->distribute_dofs();
    first_is_slave = choose_slaves(*discretization);
  }

  // All that depends on the mesh, after start and after refinement.
  template <int dim>
  void
  ContactProblem<dim>::rebuild()
  {
    TimerOutput::Scope scope(report.timer(), "contact surfaces");
    discretization->distribute_dofs();
    elasticity->clear();
    couple_surfaces();
    recovery.reset();
  }

  // Where they are undeformed; with finite strain on refined meshes move_surfaces() follows instead.
  template <int dim>
  void
  ContactProblem<dim>::couple_surfaces()
  {
    interfaces = make_interfaces(*discretization, first_is_slave);
    reaches.resize(interfaces.size(), 0.);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        interfaces[i].reach      = reaches[i];
        interfaces[i].t          = history.state.t;
        interfaces[i].collocated = parameters.newton.method == "node-to-segment";
      }
    for (const auto &interface : interfaces)
      for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
        if (surface != nullptr)
          discretization->add_relevant(surface->dofs());
    supports         = discretization->make_supports(history.state.t);
    time_of_supports = history.state.t;
    if (!finite_strain || history.state.displacement.size() == 0)
      integrate_couplings(*discretization, supports, interfaces);
  }

  template <int dim>
  void
  ContactProblem<dim>::set_time(const double t)
  {
    history.state.t = t;
    if (time_of_supports == t)
      return;
    supports         = discretization->make_supports(t);
    time_of_supports = t;
    if (!finite_strain)
      redeclare_gaps(*discretization, t, interfaces);
  }

  // Points of faces where bodies lie on each other from the start: pressure does not act there.
  template <int dim>
  std::vector<CoveredPoint<dim>>
  ContactProblem<dim>::covered_points() const
  {
    const unsigned int             rank = Utilities::MPI::this_mpi_process(geometry.communicator);
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
        if (std::abs(gap_grows(interface) && !finite_strain
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
  typename ContactProblem<dim>::Increment
  ContactProblem<dim>::solve_increment(const LoadProgram &program)
  {
    //! [increment]
    for (;;)
      {
        do
          if (!solve_on_mesh(program))
            return Increment::failed;
        while (widen_reach());
        if (!refine_now(program) || !refine())
          return Increment::converged;
        if (has_history && program.time() > 0 && !rebalance(program))
          return Increment::lost;
        //! [increment]
      }
  }

  template <int dim>
  bool
  ContactProblem<dim>::solve_on_mesh(const LoadProgram &program)
  {
    Timer seconds;
    report.begin_solve(program, mesh_number, *discretization);
    history.last_report        = iterate();
    const double solve_seconds = seconds.wall_time();
    collect_fields();
    if (!is_repeat)
      estimate();
    report.end_solve(answer(),
                     {program, mesh_number, history.last_report, error, recovery.get(), solve_seconds});
    return history.last_report.converged;
  }

  // The semismooth Newton iteration at state.t on the present mesh.
  template <int dim>
  NewtonReport
  ContactProblem<dim>::iterate()
  {
    if (history.state.displacement.size() != discretization->dof_handler.n_dofs())
      history.state.displacement = discretization->make_relevant_vector();
    const auto observer = report.observer();
    if (finite_strain)
      {
        auto       mechanics = finite_mechanics(*elasticity);
        const auto result    = contact_solver().solve(
            mechanics, interfaces, supports, history.state, observer, history.follow_motion);
        loads = mechanics.loads_at(history.state.displacement);
        return result;
      }
    {
      TimerOutput::Scope scope(report.timer(), "assemble stiffness");
      if (elasticity->n_cells() == 0)
        elasticity->assemble(history.state.displacement);
      loads = assemble_loads(*discretization, history.state.t, covered_points());
    }
    LinearMechanics<dim> mechanics(*elasticity, loads);
    return contact_solver().solve(mechanics, interfaces, supports, history.state, observer);
  }

  template <int dim>
  ContactSolver<dim>
  ContactProblem<dim>::contact_solver()
  {
    return {parameters.newton, parameters.linear_solver, *discretization, report.timer()};
  }

  template <int dim>
  void
  ContactProblem<dim>::collect_fields()
  {
    fields.clear();
    const auto unused = unused_shears();
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      fields.push_back(make_surface_fields(
          *discretization, interfaces[i], history.state.contact[i], unused[i], history.state.displacement));
  }

  // What the shear leaves of the bound of friction, by pair and row.
  template <int dim>
  std::vector<std::vector<double>>
  ContactProblem<dim>::unused_shears() const
  {
    std::vector<std::vector<double>> unused(interfaces.size());
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (const auto &row : interfaces[i].coupling.rows)
        {
          const auto  &node  = history.state.contact[i][row.node];
          const auto   X     = as_3d(interfaces[i].slave->nodes[row.node].X);
          const double bound = shear_bound(*interfaces[i].pair, X, history.state.t, node.pressure).value;
          unused[i].push_back(node.state == ContactState::stick ? std::max(0., bound - node.shear.norm())
                                                                : 0);
        }
    return unused;
  }

  template <int dim>
  void
  ContactProblem<dim>::estimate()
  {
    TimerOutput::Scope scope(report.timer(), "error estimate");
    recovery = std::make_unique<StressRecovery<dim>>(*discretization, *elasticity);
    recovery->recover(history.state.displacement);
    const auto before = error;
    error             = estimate_error(*discretization, *recovery, interfaces, fields);
    // What the load history needs is the worst of its increments.
    const auto keep_largest = [](const Vector<float> &old, Vector<float> &now) {
      for (unsigned int c = 0; c < now.size() && old.size() == now.size(); ++c)
        now[c] = std::max(now[c], old[c]);
    };
    if (has_history)
      {
        keep_largest(before.cell_indicators, error.cell_indicators);
        keep_largest(before.contact_indicators, error.contact_indicators);
      }
    report.add_estimate(error);
  }

  template <int dim>
  Answer<dim>
  ContactProblem<dim>::answer() const
  {
    return {*discretization, *elasticity, interfaces, fields, supports, loads, history.state};
  }

  template <int dim>
  typename RunReport<dim>::Ending
  ContactProblem<dim>::ending(const bool success) const
  {
    typename RunReport<dim>::Ending ending = {
        success, error, recovery.get(), history, parameters.refinement.target_error, {}, neglected_checks};
    if (!finite_strain)
      ending.kinematic_error = kinematic_error();
    return ending;
  }

  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace Amontons
