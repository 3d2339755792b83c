#include <amontons/output/probes.h>
#include <amontons/run_report.h>
#include <amontons/scene/text.h>

#include <set>
#include <sstream>

namespace Amontons
{
  namespace
  {
    // Without those of carriers.
    template <int dim>
    unsigned long long
    n_cells(const Discretization<dim> &discretization)
    {
      const auto &geometry = discretization.geometry;
      return geometry.triangulation.n_global_active_cells() - geometry.carriers.size();
    }

    template <int dim>
    EstimateSummary
    summarise_estimate(const ErrorEstimate<dim> &error, const bool has_friction)
    {
      EstimateSummary result{error.bulk, error.contact};
      result.facets = error.facets;
      if (has_friction)
        result.shear = error.shear;
      if (error.quantity && std::isfinite(*error.quantity))
        result.quantity = *error.quantity;
      return result;
    }
  } // namespace

  template <int dim>
  RunReport<dim>::RunReport(const Scene              &scene,
                            const OutputParameters   &parameters,
                            const std::string        &folder,
                            const bool                quiet,
                            RunControl               &control,
                            const MakeReference<dim> &make_reference)
      : control(control), scene(scene), parameters(parameters), folder(folder), communicator(MPI_COMM_WORLD),
        make_reference(make_reference), terminal(communicator, quiet),
        phases(std::cout, TimerOutput::never, TimerOutput::wall_times), vtu(folder, communicator)
  {
  }

  template <int dim>
  void
  RunReport<dim>::start()
  {
    terminal.scene(scene, Utilities::MPI::n_mpi_processes(communicator));
    if (scene.reference && !make_reference)
      throw InputError(
          {scene.file, 0, "Reference"}, "a closed form, where none are known", "the scene without it");
    if (scene.reference)
      reference = make_reference(scene);
  }

  template <int dim>
  void
  RunReport<dim>::replay()
  {
    vtu.restart();
    bodies.restart();
    n_tables = 0;
  }

  template <int dim>
  void
  RunReport<dim>::restart()
  {
    summary.meshes.clear();
    summary.newton.clear();
    summary.increments.reset();
    replay();
  }

  template <int dim>
  void
  RunReport<dim>::say(const std::string &text)
  {
    terminal.note(text);
  }

  template <int dim>
  void
  RunReport<dim>::note(const std::string &text)
  {
    auto &notes = summary.notes;
    if (!text.empty() && std::find(notes.begin(), notes.end(), text) == notes.end())
      notes.push_back(text);
  }

  template <int dim>
  void
  RunReport<dim>::announce(const std::string &text)
  {
    note(text);
    say(text);
  }

  template <int dim>
  void
  RunReport<dim>::progress(const LoadProgram &program)
  {
    fraction = std::max(0., program.time() / scene.end_time);
    if (!program.finished())
      terminal.progress("load increments", fraction);
  }

  template <int dim>
  void
  RunReport<dim>::fail(const std::string &message, const std::string &kind)
  {
    summary.message = message;
    if (!kind.empty())
      summary.failure = kind;
  }

  template <int dim>
  void
  RunReport<dim>::begin_solve(const LoadProgram         &program,
                              const unsigned int         mesh,
                              const Discretization<dim> &discretization)
  {
    terminal.mesh(
        program.number(), program.next(), mesh, n_cells(discretization), discretization.dof_handler.n_dofs());
  }

  template <int dim>
  std::function<void(const NewtonReport::Iteration &)>
  RunReport<dim>::observer()
  {
    return [this, iteration = 0u](const NewtonReport::Iteration &step) mutable {
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
  }

  template <int dim>
  void
  RunReport<dim>::add_estimate(const ErrorEstimate<dim> &error)
  {
    terminal.estimate(summarise_estimate(error, scene.has_friction()));
  }

  template <int dim>
  void
  RunReport<dim>::end_solve(const Answer<dim> &answer, const Solve &solve)
  {
    announce_checkpoint();
    const auto         &error  = solve.evaluation.error;
    const NewtonSummary newton = summarise(solve, answer.discretization);
    summary.newton.push_back(newton);

    MeshSummary mesh;
    mesh.increment         = newton.increment;
    mesh.mesh              = newton.mesh;
    mesh.t                 = answer.state.t;
    mesh.cells             = newton.cells;
    mesh.dofs              = newton.dofs;
    mesh.iterations        = newton.iterations;
    mesh.krylov_iterations = newton.krylov_iterations;
    mesh.residual          = newton.residual;
    mesh.seconds           = control.wall.wall_time();
    mesh.pairs             = summarize_pairs(answer);
    mesh.error_estimate    = summarise_estimate(error, scene.has_friction());
    mesh.energy            = stored_energy(answer);
    if (!scene.probes.empty())
      {
        std::vector<std::string> notes;
        mesh.probes = evaluate_probes(
            answer.discretization, *solve.evaluation.recovery, answer.state.displacement, notes);
        for (const std::string &text : notes)
          note(text);
      }
    if (reference && !answer.interfaces.empty() && solve.program.is_last())
      mesh.reference = reference->compare(answer);
    if (solve.program.is_incremental()) // known when this one is committed
      mesh.external_work = mesh.contact_work = mesh.dissipation = unknown;
    summary.meshes.push_back(mesh);
    summary.cost.one_linear_solve_seconds = solve.newton.one_linear_solve_seconds;
    summary.cost.finest_mesh_seconds      = solve.seconds;
    add_notes(solve.newton, answer);
    summary.message = solve.newton.failure ? Diagnosis::sentence(*solve.newton.failure) : "";
    summary.failure = solve.newton.failure ? Diagnosis::kind(*solve.newton.failure) : "";
  }

  template <int dim>
  NewtonSummary
  RunReport<dim>::summarise(const Solve &solve, const Discretization<dim> &discretization) const
  {
    NewtonSummary newton;
    newton.increment        = solve.program.number();
    newton.mesh             = solve.mesh;
    newton.cells            = n_cells(discretization);
    newton.dofs             = discretization.dof_handler.n_dofs();
    newton.iterations       = solve.newton.iterations.size();
    newton.outer_iterations = solve.newton.n_outer;
    for (const auto &iteration : solve.newton.iterations)
      {
        newton.active_set_changes.push_back(iteration.n_changes);
        newton.krylov_iterations += iteration.krylov;
        newton.residuals.push_back(iteration.residual);
        newton.residual = iteration.residual;
      }
    return newton;
  }

  template <int dim>
  void
  RunReport<dim>::announce_checkpoint()
  {
    for (const std::string &text : control.checkpoint.take_notes())
      announce(text);
  }

  template <int dim>
  double
  RunReport<dim>::largest_pressure() const
  {
    double largest = 0;
    for (const auto &mesh : summary.meshes)
      for (const auto &pair : mesh.pairs)
        largest = std::max(largest, pair.peak_pressure);
    return largest;
  }

  namespace
  {
    // Whether nodes are closed in faces where others carry no multiplier.
    template <int dim>
    bool
    closes_beside_held_nodes(const ContactInterface<dim> &interface, const NodalContacts<dim> &contact)
    {
      const auto &faces = interface.slave->faces;
      return std::any_of(faces.begin(), faces.end(), [&](const auto &face) {
        const auto any = [&](const auto &is) {
          return std::any_of(face.unknowns.begin(), face.unknowns.end(), is);
        };
        return any([&](const unsigned int i) { return !interface.carries[i]; }) &&
               any([&](const unsigned int i) { return contact[i].state != ContactStatus::open; });
      });
    }
  } // namespace

  template <int dim>
  void
  RunReport<dim>::add_notes(const NewtonReport &newton, const Answer<dim> &answer)
  {
    note(newton.note);
    if (newton.safeguarded)
      note("the active set repeated itself; single nodes were changed for a while (Murty's rule)");
    if (newton.frozen)
      note("the states of friction repeated themselves; its bounds were held for a while (Tresca)");
    if (newton.pivoted)
      note("states of contact that the iteration did not find were found by pivoting (Lemke's method)");
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      {
        const auto &interface = answer.interfaces[i];
        const auto &slave     = *interface.slave;
        if (slave.sharpest_edge > 60)
          {
            std::ostringstream text;
            text << "pair '" << interface.pair->name << "': the slave surface has an edge of "
                 << std::lround(slave.sharpest_edge) << " degrees near (" << slave.sharpest_at
                 << "), where its normal is a mean of both sides: results there are not to be trusted; a "
                    "pair for each side is exact";
            note(text.str());
          }
        if (interface.n_without_multiplier > 0 &&
            closes_beside_held_nodes(interface, answer.state.contact[i]))
          note("pair '" + interface.pair->name +
               "': slave nodes that supports or other pairs hold carry no multiplier; their neighbours take "
               "their share");
      }
  }

  template <int dim>
  void
  RunReport<dim>::commit(const Answer<dim>     &answer,
                         const WorkDone<dim>   &work,
                         const Evaluation<dim> &evaluation)
  {
    summary.meshes.back().error_estimate = summarise_estimate(evaluation.error, scene.has_friction());
    if (auto &mesh = summary.meshes.back(); mesh.external_work)
      {
        mesh.external_work = work.external_work;
        mesh.contact_work  = work.contact_work;
        mesh.dissipation   = work.dissipation;
        if (mesh.reference)
          reference->compare_dissipation(answer, work.dissipation, *mesh.reference);
      }
    write_increment(answer, evaluation);
  }

  template <int dim>
  void
  RunReport<dim>::drop_last_solve()
  {
    summary.meshes.pop_back();
  }

  template <int dim>
  void
  RunReport<dim>::add_snap(const std::vector<Diagnosis::Snap> &snaps)
  {
    auto      &notes  = summary.notes;
    const auto before = std::vector<Diagnosis::Snap>(snaps.begin(), snaps.end() - 1);
    for (const bool far : {true, false})
      {
        notes.erase(std::remove(notes.begin(), notes.end(), Diagnosis::snapped(before, far)), notes.end());
        if (const std::string text = Diagnosis::snapped(snaps, far); !text.empty())
          note(text);
      }
  }

  template <int dim>
  const RunSummary &
  RunReport<dim>::finish(const Answer<dim> &answer, const Ending &ending)
  {
    announce_checkpoint();
    summary.converged = ending.converged;
    if (ending.converged)
      summary.failure.clear();
    summary.n_cut_backs = ending.history.n_cut_backs;
    summary.scene       = scene.file;
    summary.title       = scene.title;
    summary.kind        = scene.kind;
    summary.units       = scene.units;
    summary.ranks       = Utilities::MPI::n_mpi_processes(communicator);
    if (has_answer())
      add_answer(answer, ending);
    note_rough_pressure(ending);
    note_small_tractions(answer, ending);
    note_untouched_pairs();
    note_facets(answer.interfaces, ending.evaluation.error);
    note_limits(answer, ending);
    for (const auto &[name, seconds] : phases.get_summary_data(TimerOutput::total_wall_time))
      summary.cost.timing[name] = seconds;
    const auto calls           = phases.get_summary_data(TimerOutput::n_calls);
    const auto linear_solves   = calls.find("linear solve");
    summary.cost.linear_solves = linear_solves == calls.end() ? 0 : linear_solves->second;
    summary.cost.wall_seconds  = control.wall.wall_time();
    terminal.answer(summary); // whatever becomes of the files
    if (has_answer())
      write_files(answer, ending.evaluation.recovery.get());
    else
      write_files_without_answer();
    return summary;
  }

  // That of the last mesh.
  template <int dim>
  void
  RunReport<dim>::add_answer(const Answer<dim> &answer, const Ending &ending)
  {
    const MeshSummary &last           = summary.meshes.back();
    summary.dofs                      = last.dofs;
    summary.cells                     = last.cells;
    summary.pairs                     = last.pairs;
    summary.energy                    = last.energy;
    summary.error_estimate            = last.error_estimate;
    summary.probes                    = last.probes;
    summary.reference                 = last.reference;
    summary.reactions                 = compute_reactions(answer);
    summary.checks                    = ending.checks;
    summary.error_estimate.kinematics = ending.kinematics;
    if (summary.increments)
      summary.error_estimate.increments = summary.increments->of(ending.refinement.target_quantity);
    if (last.external_work)
      add_energy_checks(ending, answer.elasticity.finite_strain());
  }

  // The balance of W, the stored energy and the contact work, and dissipation >= 0, relative to the work.
  template <int dim>
  void
  RunReport<dim>::add_energy_checks(const Ending &ending, const bool finite_strain)
  {
    const auto  &history  = ending.history;
    const auto  &work     = history.work;
    const double negative = work.largest_work > 0 ? -work.smallest_dissipation / work.largest_work : 0;
    summary.checks["energy_balance"]       = work.energy_error;
    summary.checks["negative_dissipation"] = negative;
    std::ostringstream text;
    text.precision(3);
    if (work.energy_error > 1e-6 && !finite_strain)
      text << "the energy balance is violated by " << work.energy_error << " of the work";
    if (negative > 1e-9)
      text << (text.str().empty() ? "" : "; ") << "an increment had a negative dissipation, " << negative
           << " of the work";
    if (text.str() != "")
      note("warning: " + text.str());
    note_sums_of_work(ending);
    if (history.transfer_residual > 0)
      {
        summary.checks["transfer_residual"] = history.transfer_residual;
        std::ostringstream transfer;
        transfer.precision(3);
        transfer << "states transferred to refined meshes were up to " << history.transfer_residual
                 << " of the forces out of equilibrium; solving them again changed the stored energy by "
                 << work.transferred_energy << " in all";
        note(transfer.str());
      }
  }

  template class RunReport<2>;
  template class RunReport<3>;
} // namespace Amontons
