#include <amontons/base/points.h>
#include <amontons/contact/contact_edge.h>
#include <amontons/contact_problem.h>
#include <amontons/output/files.h>
#include <amontons/output/history.h>
#include <amontons/output/probes.h>
#include <amontons/output/report.h>

#include <deal.II/numerics/data_out.h>

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
  ContactProblem<dim>::ContactProblem(const Scene       &scene,
                                      const Parameters  &parameters,
                                      const std::string &output_folder,
                                      const bool         quiet)
      : scene(scene), parameters(parameters), folder(output_folder), communicator(MPI_COMM_WORLD),
        terminal(communicator, quiet), timer(std::cout, TimerOutput::never, TimerOutput::wall_times),
        geometry(communicator), vtu(output_folder, communicator)
  {
  }

  template <int dim>
  RunSummary
  ContactProblem<dim>::run()
  {
    terminal.scene(scene, Utilities::MPI::n_mpi_processes(communicator));
    if (scene.reference)
      reference = make_reference_solution(scene.reference->solution, scene);
    state.t = scene.end_time / scene.n_increments;
    make_mesh();
    rebuild();
    refine_where_bodies_are_close();
    make_output_folder(folder, communicator);

    bool success = true;
    for (unsigned int increment = 1; increment <= scene.n_increments && success; ++increment)
      {
        set_load_factor(scene.end_time * increment / scene.n_increments);
        success = solve_increment(increment);
        write_increment();
        if (scene.n_increments > 1)
          terminal.progress("load increments", double(increment) / scene.n_increments);
      }
    summary.status = success ? "converged" : "not converged";
    finish();
    return summary;
  }

  template <int dim>
  void
  ContactProblem<dim>::make_mesh()
  {
    TimerOutput::Scope scope(timer, "mesh");
    make_geometry(scene, geometry);
    discretization = std::make_unique<Discretization<dim>>(scene, geometry, parameters.discretization.degree);
    elasticity     = std::make_unique<ElasticityOperator<dim>>(*discretization);
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
    interfaces = make_interfaces(*discretization, first_is_slave);
    reaches.resize(interfaces.size(), 0.);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      interfaces[i].reach = reaches[i];
    for (const auto &interface : interfaces)
      for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
        if (surface != nullptr)
          discretization->add_relevant(surface->dofs());
    supports = discretization->make_supports(state.t);
    integrate_couplings(*discretization, supports, interfaces);
    recovery.reset();
  }

  // Surfaces that touch in a small part of what faces each other are refined there before the first solve.
  template <int dim>
  void
  ContactProblem<dim>::refine_where_bodies_are_close()
  {
    for (unsigned int i = 0; i < parameters.refinement.initial_refinements; ++i)
      {
        TimerOutput::Scope scope(timer, "mesh");
        if (mark_close_cells(*discretization, interfaces, 0.1) == 0)
          break;
        geometry.triangulation.execute_coarsening_and_refinement();
        rebuild();
      }
  }

  template <int dim>
  void
  ContactProblem<dim>::set_load_factor(const double t)
  {
    state.t  = t;
    supports = discretization->make_supports(t);
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
        if (std::abs(p.gap) <= 1e-6 * interface.slave->faces[p.slave_face].size)
          {
            add(*interface.slave, p.slave_face, p.xi_slave, p.weight);
            if (interface.master.surface != nullptr)
              add(*interface.master.surface, p.master_face, p.xi_master, p.weight);
          }
    return covered;
  }

  template <int dim>
  bool
  ContactProblem<dim>::solve_increment(const unsigned int increment)
  {
    const bool last = increment == scene.n_increments;
    for (unsigned int cycle = 0;; ++cycle)
      {
        do
          if (!solve_on_mesh(increment))
            return false;
        while (widen_reach());
        if (!last || cycle >= parameters.refinement.cycles)
          return true;
        if (parameters.refinement.target_error > 0 && estimated_error() <= parameters.refinement.target_error)
          return true;
        if (!refine())
          return true;
      }
  }

  // Gaps that are far larger than what displacements close never matter. Of those of the nodes that are
  // closed and of what displacements closed elsewhere, the next meshes take twice the largest into account;
  // if that was not enough here, the surfaces are coupled again with more (returns true).
  template <int dim>
  bool
  ContactProblem<dim>::widen_reach()
  {
    bool too_short = false;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (interfaces[i].pair->tied)
          continue;
        double needed     = 0;
        bool   any_closed = false;
        for (unsigned int r = 0; r < interfaces[i].coupling.rows.size(); ++r)
          {
            const double initial = interfaces[i].coupling.rows[r].gap, now = state.gaps[i][r];
            const bool   closed = state.states[i][r] != ContactState::open;
            any_closed          = any_closed || closed;
            needed              = std::max(needed, closed ? std::abs(initial) : initial - now);
          }
        if (!any_closed)
          continue;
        const bool short_here = reaches[i] > 0 && needed > 0.75 * reaches[i];
        if (short_here || reaches[i] == 0 || 4 * needed < reaches[i])
          reaches[i] = 2 * needed + 1e-3 * interfaces[i].slave->mean_size;
        too_short = too_short || short_here;
      }
    if (too_short)
      {
        TimerOutput::Scope scope(timer, "contact surfaces");
        for (unsigned int i = 0; i < interfaces.size(); ++i)
          interfaces[i].reach = reaches[i];
        integrate_couplings(*discretization, supports, interfaces);
        state.states.clear(); // they fit the rows no more
      }
    return too_short;
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
  ContactProblem<dim>::solve_on_mesh(const unsigned int increment)
  {
    Timer seconds;
    terminal.mesh(increment,
                  scene.n_increments,
                  mesh_number,
                  geometry.triangulation.n_global_active_cells() - geometry.carriers.size(),
                  discretization->dof_handler.n_dofs());
    if (state.displacement.size() != discretization->dof_handler.n_dofs())
      state.displacement = discretization->make_relevant_vector();
    {
      TimerOutput::Scope scope(timer, "assemble stiffness");
      if (elasticity->n_cells() == 0)
        elasticity->assemble();
      loads = assemble_loads(*discretization, state.t, covered_points());
    }
    SemismoothNewton<dim> newton(parameters.newton, parameters.linear_solver, *discretization, timer);
    unsigned int          iteration = 0;
    const auto            report    = newton.solve(
        *elasticity, interfaces, supports, loads, state, [&](const NewtonReport::Iteration &step) {
          IterationLine line;
          line.iteration         = ++iteration;
          line.residual          = step.residual;
          line.n_open            = step.n_open;
          line.n_stick           = step.n_stick;
          line.n_slip            = step.n_slip;
          line.changes           = step.n_changes;
          line.krylov_iterations = step.krylov;
          terminal.iteration(line);
        });
    const double solve_seconds = seconds.wall_time();
    collect_fields();
    estimate();
    summarise_mesh(increment, report, solve_seconds);
    add_notes(report);
    summary.message = report.message;
    return report.converged;
  }

  template <int dim>
  void
  ContactProblem<dim>::collect_fields()
  {
    fields.clear();
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      fields.push_back(make_surface_fields(*discretization,
                                           interfaces[i],
                                           state.states[i],
                                           state.pressures[i],
                                           state.gaps[i],
                                           state.tied_multipliers[i],
                                           state.displacement));
  }

  template <int dim>
  void
  ContactProblem<dim>::estimate()
  {
    TimerOutput::Scope scope(timer, "error estimate");
    recovery = std::make_unique<StressRecovery<dim>>(*discretization, *elasticity);
    recovery->recover(state.displacement);
    error = estimate_error(*discretization, *elasticity, *recovery, interfaces, fields, state.displacement);
    terminal.estimate({error.bulk, error.contact});
  }

  template <int dim>
  bool
  ContactProblem<dim>::refine()
  {
    TimerOutput::Scope scope(timer, "mesh");
    // Two aims: the stress everywhere, on which contact forces and sizes depend, and the pressure itself.
    const bool bulk = mark_cells(*discretization, geometry, parameters.refinement, error.cell_indicators);
    const bool contact =
        bulk && parameters.refinement.strategy == "adaptive" &&
        mark_cells(*discretization, geometry, parameters.refinement, error.contact_indicators);
    if (!bulk && !contact)
      {
        terminal.note("no further refinement: the limit of 'Maximum DoFs' is reached");
        return false;
      }
    LA::Vector traction = discretization->make_owned_vector();
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto edge = signed_pressure_square(interfaces[i], fields[i]);
        for (unsigned int n = 0; n < interfaces[i].slave->nodes.size(); ++n)
          for (unsigned int c = 0; c < dim; ++c)
            if (const auto dof = interfaces[i].slave->nodes[n].dofs[c];
                discretization->locally_owned.is_element(dof))
              traction(dof) += edge[n] * fields[i].normal[n][c];
      }
    traction.compress(VectorOperation::add);
    state.traction = discretization->make_relevant_vector();
    state.traction = traction;
    refine_and_transfer(*discretization, geometry, state, [&]() { rebuild(); });
    ++mesh_number;
    carry_active_set();
    return true;
  }

  // Nodes of the new mesh start closed where the old mesh's pressure, continued beyond its last node, is
  // positive.
  template <int dim>
  void
  ContactProblem<dim>::carry_active_set()
  {
    state.states.assign(interfaces.size(), {});
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (const auto &row : interfaces[i].coupling.rows)
        {
          const auto &node = interfaces[i].slave->nodes[row.node];
          double      edge = 0;
          for (unsigned int c = 0; c < dim; ++c)
            edge += state.traction(node.dofs[c]) * node.normal[c];
          state.states[i].push_back(interfaces[i].pair->tied ? ContactState::stick
                                    : edge > 0               ? ContactState::slip
                                                             : ContactState::open);
        }
  }

  template <int dim>
  Answer<dim>
  ContactProblem<dim>::answer() const
  {
    return {*discretization, *elasticity, interfaces, fields, supports, loads, state};
  }

  template <int dim>
  void
  ContactProblem<dim>::summarise_mesh(const unsigned int  increment,
                                      const NewtonReport &report,
                                      const double        seconds)
  {
    NewtonSummary newton;
    newton.increment  = increment;
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
    mesh.increment         = increment;
    mesh.mesh              = mesh_number;
    mesh.t                 = state.t;
    mesh.cells             = newton.cells;
    mesh.dofs              = newton.dofs;
    mesh.iterations        = newton.iterations;
    mesh.krylov_iterations = newton.krylov_iterations;
    mesh.residual          = newton.residual;
    mesh.seconds           = wall.wall_time();
    mesh.pairs             = summarize_pairs(answer());
    mesh.error_estimate    = {error.bulk, error.contact};
    mesh.energy            = stored_energy(answer());
    if (!scene.probes.empty())
      mesh.probes = evaluate_probes(*discretization, *recovery, state.displacement, summary.notes);
    if (reference && !interfaces.empty())
      {
        ReferenceData data = *scene.reference;
        mesh.reference     = compare(answer(), data, *reference);
      }
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
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      if (interfaces[i].n_without_multiplier > 0)
        add("pair '" + interfaces[i].pair->name +
            "': slave nodes that supports hold carry no multiplier; their neighbours take their share");
  }

  template <int dim>
  void
  ContactProblem<dim>::write_increment()
  {
    if (!parameters.output.vtu)
      return;
    TimerOutput::Scope scope(timer, "output");
    vtu.write_bodies(BodyFields<dim>{*discretization, state.displacement, *recovery, error.cell_indicators},
                     state.t);
    vtu.write_contact(interfaces, fields, state.t);
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
      }
    if (parameters.refinement.target_error > 0 && !(estimated_error() <= parameters.refinement.target_error))
      summary.notes.push_back("the target error was not reached: allow more 'Cycles' or 'Maximum DoFs'");
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
      picture = gather_mesh_picture(*discretization, *recovery, state.displacement);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        const auto table = contact_table(interfaces, fields);
        std::vector<std::pair<std::string, MeshPicture>> pressure_maps;
        for (unsigned int i = 0; i < interfaces.size(); ++i)
          pressure_maps.emplace_back(interfaces[i].pair->name,
                                     make_pressure_picture(interfaces[i], fields[i]));
        if (parameters.output.report)
          write_report(folder + "/report.html",
                       summary,
                       pressure_curves(table,
                                       summary.pairs,
                                       dim,
                                       reference ? &*reference : nullptr,
                                       scene.reference ? scene.reference->pair : ""),
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
