#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/contact/surface_search.h>
#include <amontons/contact_problem.h>
#include <amontons/friction/shear_law.h>
#include <amontons/output/files.h>
#include <amontons/output/history.h>
#include <amontons/output/probes.h>
#include <amontons/output/report.h>

#include <sstream>

namespace Amontons
{
  void
  OutputParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("VTU", vtu, "Write .pvd and .vtu files of the bodies and of the contact surfaces.");
    prm.add_parameter("Report", report, "Write report.html, a self-contained page with pictures.");
    prm.leave_subsection();
  }

  template <int dim>
  ContactProblem<dim>::ContactProblem(const Scene              &scene,
                                      const Parameters         &parameters,
                                      const std::string        &output_folder,
                                      const bool                quiet,
                                      const MakeReference<dim> &make_reference)
      : scene(scene), finite_strain(scene.kinematics == Kinematics::finite_strain),
        has_history(std::any_of(scene.pairs.begin(),
                                scene.pairs.end(),
                                [](const PairData &pair) { return pair.has_friction(); })),
        incremental(has_history || finite_strain), parameters(parameters), folder(output_folder),
        communicator(MPI_COMM_WORLD), terminal(communicator, quiet),
        timer(std::cout, TimerOutput::never, TimerOutput::wall_times), geometry(communicator),
        make_reference(make_reference), vtu(output_folder, communicator)
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
    terminal.scene(scene, Utilities::MPI::n_mpi_processes(communicator));
    if (scene.reference)
      reference = make_reference(scene);
    history.state.t = LoadProgram(scene, incremental).next();
    //! [run]
    make_mesh();
    rebuild();
    refuse_hidden_sides(*discretization, interfaces);
    refine_where_bodies_are_close();
    make_output_folder(folder, communicator);

    bool success = run_all_meshes();
    if (!finite_strain)
      success = choose_kinematics(success);
    if (success && has_history)
      add_error_of_increments();
    summary.converged = success;
    finish();
    return summary;
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
    TimerOutput::Scope scope(timer, "mesh");
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
    TimerOutput::Scope scope(timer, "contact surfaces");
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
    const unsigned int             rank = Utilities::MPI::this_mpi_process(communicator);
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

  // Of the contact pressure; of the stress where nothing touches.
  template <int dim>
  double
  ContactProblem<dim>::estimated_error() const
  {
    return error.contact > 0 ? error.contact : error.bulk;
  }

  template <int dim>
  bool
  ContactProblem<dim>::solve_on_mesh(const LoadProgram &program)
  {
    Timer seconds;
    terminal.mesh(program.number(),
                  program.next(),
                  mesh_number,
                  geometry.triangulation.n_global_active_cells() - geometry.carriers.size(),
                  discretization->dof_handler.n_dofs());
    const auto   report        = iterate();
    const double solve_seconds = seconds.wall_time();
    collect_fields();
    if (!is_repeat)
      estimate();
    summarise_mesh(program, report, solve_seconds);
    add_notes(report);
    summary.message     = report.failure ? Diagnosis::sentence(*report.failure) : "";
    history.last_report = report;
    return report.converged;
  }

  // The semismooth Newton iteration at state.t on the present mesh.
  template <int dim>
  NewtonReport
  ContactProblem<dim>::iterate()
  {
    if (history.state.displacement.size() != discretization->dof_handler.n_dofs())
      history.state.displacement = discretization->make_relevant_vector();
    unsigned int iteration = 0;
    const auto   observer  = [&](const NewtonReport::Iteration &step) {
      IterationLine line;
      line.iteration         = ++iteration;
      line.residual          = step.residual;
      line.n_open            = step.n_open;
      line.n_stick           = step.n_stick;
      line.n_slip            = step.n_slip;
      line.changes           = step.n_changes;
      line.krylov_iterations = step.krylov;
      terminal.iteration(line);
    };
    if (finite_strain)
      {
        auto       mechanics = finite_mechanics(*elasticity);
        const auto report    = contact_solver().solve(
            mechanics, interfaces, supports, history.state, observer, history.follow_motion);
        loads = mechanics.loads_at(history.state.displacement);
        return report;
      }
    {
      TimerOutput::Scope scope(timer, "assemble stiffness");
      if (elasticity->n_cells() == 0)
        elasticity->assemble(history.state.displacement);
      loads = assemble_loads(*discretization, history.state.t, covered_points());
    }
    LinearMechanics<dim> mechanics(*elasticity, loads);
    return contact_solver().solve(mechanics, interfaces, supports, history.state, observer);
  }

  template <int dim>
  ContactSolver<dim>
  ContactProblem<dim>::contact_solver() const
  {
    return {parameters.newton, parameters.linear_solver, *discretization, timer};
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
    TimerOutput::Scope scope(timer, "error estimate");
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
    terminal.estimate({error.bulk, error.contact});
  }

  template <int dim>
  Answer<dim>
  ContactProblem<dim>::answer() const
  {
    return {*discretization, *elasticity, interfaces, fields, supports, loads, history.state};
  }

  template <int dim>
  void
  ContactProblem<dim>::summarise_mesh(const LoadProgram  &program,
                                      const NewtonReport &report,
                                      const double        seconds)
  {
    NewtonSummary newton;
    newton.increment  = program.number();
    newton.mesh       = mesh_number;
    newton.cells      = geometry.triangulation.n_global_active_cells() - geometry.carriers.size();
    newton.dofs       = discretization->dof_handler.n_dofs();
    newton.iterations = report.iterations.size();
    for (const auto &iteration : report.iterations)
      {
        newton.active_set_changes.push_back(iteration.n_changes);
        newton.krylov_iterations += iteration.krylov;
        newton.residuals.push_back(iteration.residual);
        newton.residual = iteration.residual;
      }
    summary.newton.push_back(newton);

    MeshSummary mesh;
    mesh.increment         = program.number();
    mesh.mesh              = mesh_number;
    mesh.t                 = history.state.t;
    mesh.cells             = newton.cells;
    mesh.dofs              = newton.dofs;
    mesh.iterations        = newton.iterations;
    mesh.krylov_iterations = newton.krylov_iterations;
    mesh.residual          = newton.residual;
    mesh.seconds           = wall.wall_time();
    mesh.pairs             = summarize_pairs(answer());
    mesh.error_estimate    = {error.bulk, error.contact, error.facets};
    mesh.energy            = stored_energy(answer());
    if (!scene.probes.empty() && !is_repeat)
      mesh.probes = evaluate_probes(*discretization, *recovery, history.state.displacement, summary.notes);
    if (reference && !is_repeat && !interfaces.empty() && program.is_last())
      mesh.reference = reference->compare(answer());
    if (incremental) // known when the increment is committed
      mesh.external_work = mesh.contact_work = mesh.dissipation = unknown;
    summary.meshes.push_back(mesh);
    summary.one_linear_solve_seconds = report.one_linear_solve_seconds;
    summary.finest_mesh_seconds      = seconds;
  }

  template <int dim>
  void
  ContactProblem<dim>::add_notes(const NewtonReport &report)
  {
    auto      &notes = summary.notes;
    const auto add   = [&](const std::string &text) {
      if (!text.empty() && std::find(notes.begin(), notes.end(), text) == notes.end())
        notes.push_back(text);
    };
    add(report.note);
    if (report.safeguarded)
      add("the active set repeated itself; single nodes were changed for a while (Murty's rule)");
    if (report.frozen)
      add("the states of friction repeated themselves; its bounds were held for a while (Tresca)");
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto &slave = *interfaces[i].slave;
        if (slave.sharpest_edge > 60)
          {
            std::ostringstream text;
            text << "pair '" << interfaces[i].pair->name << "': the slave surface has an edge of "
                 << std::lround(slave.sharpest_edge) << " degrees near (" << slave.sharpest_at
                 << "), where its normal is a mean of both sides: results there are not to be trusted; a "
                    "pair for each side is exact";
            add(text.str());
          }
        if (interfaces[i].n_without_multiplier > 0)
          add("pair '" + interfaces[i].pair->name +
              "': slave nodes that supports hold carry no multiplier; their neighbours take their share");
      }
  }

  template <int dim>
  void
  ContactProblem<dim>::write_increment()
  {
    if (!parameters.output.vtu || is_repeat)
      return;
    TimerOutput::Scope scope(timer, "output");
    vtu.write_bodies(
        BodyFields<dim>{*discretization, history.state.displacement, *recovery, error.cell_indicators},
        history.state.t);
    vtu.write_contact(interfaces, fields, history.state.t);
  }

  // The balance of W, the stored energy and the contact work, and dissipation >= 0, relative to the work.
  template <int dim>
  void
  ContactProblem<dim>::add_energy_checks()
  {
    const double negative =
        history.work.largest_work > 0 ? -history.work.smallest_dissipation / history.work.largest_work : 0;
    summary.checks["energy_balance"]       = history.work.energy_error;
    summary.checks["negative_dissipation"] = negative;
    std::ostringstream text;
    text.precision(3);
    if (history.work.energy_error > 1e-6 && !finite_strain)
      text << "the energy balance is violated by " << history.work.energy_error << " of the work";
    if (negative > 1e-9)
      text << (text.str().empty() ? "" : "; ") << "an increment had a negative dissipation, " << negative
           << " of the work";
    if (text.str() != "")
      summary.notes.push_back("warning: " + text.str());
    if (history.transfer_residual > 0)
      {
        summary.checks["transfer_residual"] = history.transfer_residual;
        std::ostringstream note;
        note.precision(3);
        note << "states transferred to refined meshes were up to " << history.transfer_residual
             << " of the forces out of equilibrium; solving them again changed the stored energy by "
             << history.work.transferred_energy << " in all";
        summary.notes.push_back(note.str());
      }
  }

  // Nothing that touches at the end may have touched before.
  template <int dim>
  void
  ContactProblem<dim>::note_untouched_pairs()
  {
    for (unsigned int i = 0; i < summary.pairs.size(); ++i)
      {
        PairSummary &pair = summary.pairs[i];
        pair.touched      = std::any_of(summary.meshes.begin(), summary.meshes.end(), [&](const auto &mesh) {
          return mesh.pairs[i].touched;
        });
        if (!pair.touched && summary.converged)
          summary.notes.push_back("warning: pair '" + pair.name + "' touched nothing in the whole run; " +
                                  without_contact(pair));
      }
  }

  template <int dim>
  void
  ContactProblem<dim>::note_facets()
  {
    for (unsigned int i = 0; i < error.facets_of.size(); ++i)
      if (const FacetError &facets = error.facets_of[i]; facets.pressure > noteworthy_facets)
        {
          std::ostringstream text;
          text.precision(2);
          text << "warning: pair '" << interfaces[i].pair->name
               << "' touches on facets, flat faces that stand for a curve: kinks of up to "
               << facets.angle * 180 / numbers::PI << " degrees between lengths of " << facets.size
               << " make an error of about " << facets.gap << " in the gap, of which the load closes "
               << facets.closed_gap << ", and of " << 100 * facets.pressure
               << " % in the pressure. Refinement does not mend it: declare 'Curved boundaries', give a mesh "
                  "of second "
                  "order (gmsh: Mesh.ElementOrder = 2), or a finer one";
          summary.notes.push_back(text.str());
        }
  }

  template <int dim>
  void
  ContactProblem<dim>::finish()
  {
    summary.scene = scene.file;
    summary.title = scene.title;
    summary.kind  = scene.kind;
    summary.ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (!summary.meshes.empty())
      {
        const MeshSummary &last = summary.meshes.back();
        summary.dofs            = last.dofs;
        summary.cells           = last.cells;
        summary.pairs           = last.pairs;
        summary.energy          = last.energy;
        summary.error_estimate  = last.error_estimate;
        summary.probes          = last.probes;
        summary.reference       = last.reference;
        summary.reactions       = compute_reactions(answer());
        summary.checks          = check_physics(answer());
        summary.checks.insert(neglected_checks.begin(), neglected_checks.end());
        if (!finite_strain)
          summary.error_estimate.kinematics = kinematic_error();
        if (summary.increments)
          summary.error_estimate.increments = summary.increments->largest();
        if (incremental)
          add_energy_checks();
      }
    note_untouched_pairs();
    note_facets();
    if (const double target = parameters.refinement.target_error;
        target > 0 && !(estimated_error() <= target))
      summary.notes.push_back(
          error.facets > target ? "the target error cannot be reached: facets alone make a larger one"
                                : "the target error was not reached: allow more 'Cycles' or 'Maximum DoFs'");
    if (scene.kind == Kind::axisymmetric)
      summary.notes.push_back("axisymmetric: forces are for the full turn");
    for (const auto &f : fields)
      if (f.symmetry_factor > 1)
        {
          summary.notes.push_back("symmetry planes cut the contact: forces are those of the meshed part");
          break;
        }
    for (const auto &[name, seconds] : timer.get_summary_data(TimerOutput::total_wall_time))
      summary.timing[name] = seconds;
    summary.wall_seconds = wall.wall_time();
    MeshPicture picture;
    if (parameters.output.report && recovery)
      picture = gather_mesh_picture(*discretization, *recovery, history.state.displacement);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        const auto table = contact_table(interfaces, fields, history.state.t);
        std::vector<std::pair<std::string, MeshPicture>> pressure_maps;
        for (unsigned int i = 0; i < interfaces.size(); ++i)
          pressure_maps.emplace_back(interfaces[i].pair->name,
                                     make_pressure_picture(interfaces[i], fields[i]));
        if (parameters.output.report)
          write_report(
              folder + "/report.html",
              summary,
              pressure_curves(
                  table, summary.pairs, dim, reference ? reference->tractions() : ReferenceTractions()),
              picture,
              pressure_maps);
        write_contact_csv(folder + "/contact.csv", table);
        write_history(folder + "/history.csv", summary.meshes, scene.kind);
        write_summary(summary, folder + "/summary.json");
      }
    terminal.answer(summary);
  }

  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace Amontons
