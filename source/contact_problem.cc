#include <amontons/base/independent_errors.h>
#include <amontons/contact/surface_search.h>
#include <amontons/contact_problem.h>
#include <amontons/geometry/body_parts.h>
#include <amontons/output/mirror_symmetry.h>
#include <amontons/output/output_folder.h>
#include <amontons/output/physics_checks.h>
#include <amontons/output/terminal.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    // The largest gap of the meshes that small strain closes by `Adjust` or takes `Initial gap` instead of,
    // which finite strain does not; 0: none.
    template <int dim>
    double
    gap_of_small_strain_alone(const ContactInterface<dim> &interface)
    {
      double largest = 0;
      for (const auto &p : interface.coupling.points)
        {
          const double gap = interface.pair->tied ? 0. : std::abs((p.x_master - p.x_slave) * p.normal);
          if (gap > 1e-6 * interface.slave->faces[p.slave_face].size &&
              (interface.pair->initial_gap || gap <= interface.pair->adjust))
            largest = std::max(largest, gap);
        }
      return largest;
    }

    // Forces jump across what lies between tied sides, without a lever.
    template <int dim>
    std::string
    gaps_of_ties(const std::vector<ContactInterface<dim>> &interfaces)
    {
      std::ostringstream text;
      text.precision(2);
      for (const auto &interface : interfaces)
        {
          double largest = 0;
          for (const auto &p : interface.coupling.points)
            if (const double gap = std::abs((p.x_master - p.x_slave) * p.normal);
                interface.pair->tied && gap > 1e-2 * interface.slave->faces[p.slave_face].size)
              largest = std::max(largest, gap);
          if (largest > 0)
            text
                << (text.str().empty() ? "" : "; ") << "pair '" << interface.pair->name
                << "' ties what lies up to " << largest
                << " apart: forces go across, and turn nothing by that distance; move the bodies together if "
                   "they are meant to touch";
        }
      return text.str();
    }

    // Bodies that have come far may do so because friction cannot hold them.
    template <int dim>
    std::string
    what_slides(const std::vector<ContactInterface<dim>> &interfaces,
                const std::vector<SurfaceFields<dim>>    &fields)
    {
      for (unsigned int i = 0; i < fields.size(); ++i)
        {
          const auto n = [&](const ContactStatus status) {
            return std::count(fields[i].state.begin(), fields[i].state.end(), status);
          };
          if (interfaces[i].pair->has_friction() && n(ContactStatus::slip) > 0 &&
              n(ContactStatus::stick) == 0)
            return "; all that touches of pair '" + interfaces[i].pair->name +
                   "' slips: see whether its friction can hold the load";
        }
      return "";
    }
  } // namespace

  template <int dim>
  ContactProblem<dim>::ContactProblem(const Scene              &scene,
                                      const Parameters         &parameters,
                                      const std::string        &output_folder,
                                      const bool                quiet,
                                      RunControl               &control,
                                      const MakeReference<dim> &make_reference)
      : scene(scene), parameters(parameters), folder(output_folder), control(control),
        report(this->scene, parameters.output, folder, quiet, control, make_reference),
        small_strain(this->scene, this->parameters)
  {
    const SourceLocation entry{scene.file, 0, "Contact solver/Method"};
    if (parameters.newton.collocates() && scene.kinematics != Kinematics::small_strain)
      throw InputError(entry,
                       parameters.newton.method + " where surfaces move",
                       "it with 'Kinematics = small strain' only");
    const SourceLocation target{scene.file, 0, "Refinement/Target quantity"};
    const std::string   &quantity = parameters.refinement.target_quantity;
    if ((quantity == "stick size" || quantity == "dissipation") && !scene.has_friction())
      throw InputError(target,
                       "the " + quantity + " of a scene without friction",
                       "another quantity, or friction in a pair");
    if (parameters.newton.method == "penalty" && scene.has_friction() &&
        parameters.refinement.most_cycles() > 0 && parameters.refinement.history == "transfer")
      throw InputError(entry,
                       "penalty with friction, whose history is carried from mesh to mesh",
                       "'Refinement/History = replay'");
  }

  template <int dim>
  RunSummary
  ContactProblem<dim>::run(const std::vector<std::string> &notes)
  {
    report.start();
    for (const auto &note : notes)
      report.announce(note);
    if (const auto &quantity = parameters.refinement.target_quantity;
        scene.has_friction() && parameters.refinement.history == "transfer" && quantity != "contact pressure")
      replay("the error of the " + quantity + " is told by whole histories on several meshes");
    //! [run]
    start_on_first_mesh(scene.kinematics == Kinematics::finite_strain);
    for (const auto &sentence : bodies_in_parts(scene, mesh->geometry))
      report.announce("warning: " + sentence);
    if (const auto gaps = gaps_of_ties(steps->model->interfaces); !gaps.empty())
      report.announce("warning: " + gaps);
    if (const auto slaves = contradicting_slaves(*mesh->discretization, mesh->first_is_slave);
        !slaves.empty())
      report.announce("warning: " + slaves);
    make_output_folder(folder, mesh->geometry.communicator, control.checkpoint.resumes());
    control.checkpoint.open();
    report.open_log();

    bool success = run_load_program();
    if (!control.stop.is_there() && !steps->model->finite_strain())
      success = choose_kinematics(success);
    if (success && scene.has_friction())
      add_error_of_increments();
    success = success && !is_stopped();
    if (success && small_strain.may_lose_symmetry())
      warn_of_halves();
    else if (success && parameters.refinement.target_error > 0 && !scene.full_model)
      for (const auto &plane : mirror_planes(
               steps->answer(), parameters.refinement.target_error / 10, steps->history.record.breakpoints))
        report.note("model: the scene is its own mirror image at " + plane +
                    ": half of it, with 'Type = symmetry' on the cut, has the same answer");
    Checks checks;
    if (report.has_answer() && !steps->is_carried())
      checks = check_physics(steps->answer(), report.largest_pressure());
    success = success && obeys_laws(checks);
    if (steps->ends_early())
      report.note("results are those of t = " + short_number(steps->history.state.t));
    return report.finish(steps->answer(), ending(success, std::move(checks)));
    //! [run]
  }

  template <int dim>
  bool
  ContactProblem<dim>::is_stopped()
  {
    if (!control.stop.is_there())
      return false;
    std::ostringstream text;
    text << control.stop.reason();
    if (!report.has_answer())
      text << " before any state had converged";
    else
      text << "; the last state that converged is that of t = " << steps->history.state.t << " of "
           << scene.end_time << " on mesh " << steps->mesh_of_state();
    if (report.has_answer() && steps->is_carried())
      text << " (files with fields show it carried to mesh " << mesh->n_refinements << ")";
    control.try_to([&]() { control.checkpoint.flush(); });
    if (Checkpoint::exists(folder))
      text << "; 'amontons --resume " << folder << "' goes on from there";
    report.fail(text.str(), "stopped");
    return true;
  }

  template <int dim>
  void
  ContactProblem<dim>::make_mesh()
  {
    TimerOutput::Scope scope(report.timer(), "mesh");
    mesh             = std::make_shared<BodyMesh<dim>>(scene, parameters.discretization);
    mesh->collocated = parameters.newton.collocates();
  }

  // On the present mesh. nearby: an answer there that is near: the load comes in one increment, from it.
  template <int dim>
  void
  ContactProblem<dim>::start(const bool finite_strain, const SolutionState<dim> *nearby)
  {
    steps.reset();
    const double t = nearby ? nearby->t : LoadProgram(scene, scene.has_friction() || finite_strain).next();
    steps          = std::make_unique<LoadStepping<dim>>(parameters,
                                                make_model(mesh, finite_strain, t, report.timer()),
                                                report,
                                                finite_strain ? nullptr : &small_strain);
    if (nearby)
      {
        steps->history.at_once = true;
        steps->history.path.push_back({t, nearby->displacement, nearby->traction, nearby->peaks});
      }
  }

  // walls_are_none: what would slide freely if the obstacles that it does not touch were not there is held
  // until it touches one.
  template <int dim>
  void
  ContactProblem<dim>::start_on_first_mesh(const bool finite_strain, const bool walls_are_none)
  {
    make_mesh();
    start(finite_strain);
    refuse_hidden_sides(steps->model->discretization(), steps->model->interfaces);
    if (const auto walls = walls_beside(mesh->geometry, steps->model->interfaces);
        finite_strain && walls_are_none && !walls.empty() &&
        find_free_slides(scene, mesh->geometry, true, walls).size() >
            find_free_slides(scene, mesh->geometry).size())
      {
        mesh->discretization->walls = walls;
        mesh->discretization->distribute_dofs();
        start(finite_strain);
      }
    steps->model->refine_where_bodies_are_close(parameters.refinement);
    n_first_dofs = mesh->discretization->dof_handler.n_dofs();
  }

  // Bodies that move by far more than their size leave nothing but rounding of their strain.
  template <int dim>
  bool
  ContactProblem<dim>::obeys_laws(Checks checks)
  {
    const double allowed = std::max(1e-3, 10 * parameters.newton.tolerance);
    if (parameters.newton.method == "penalty") // bodies overlap
      for (const char *const name : {"penetration", "complementarity", "overlap_behind"})
        checks.erase(name);
    const std::string broken = broken_laws(checks, allowed);
    if (broken.empty())
      return true;
    const auto        &sizes = mesh->geometry.body_sizes;
    std::ostringstream text;
    text << "the answer breaks laws: " << broken << " (allowed are " << allowed << ")";
    if (const double moved =
            steps->history.state.displacement.linfty_norm() / *std::max_element(sizes.begin(), sizes.end());
        moved > 1e3)
      text << "; it moves bodies by " << moved
           << " times their size, which leaves nothing but rounding of their strain";
    report.fail(text.str(), "broken laws");
    return false;
  }

  template <int dim>
  typename RunReport<dim>::Ending
  ContactProblem<dim>::ending(const bool success, Checks checks) const
  {
    const auto neglected = small_strain.checks();
    checks.insert(neglected.begin(), neglected.end());
    KinematicsErrors kinematics;
    if (!steps->model->finite_strain())
      kinematics = {small_strain.error(),
                    small_strain.error_of_shear(),
                    small_strain.error_of_target(),
                    small_strain.has_alternative()};
    return {success, steps->evaluation, steps->history, parameters.refinement, kinematics, checks};
  }

  // After the load program with small strain: whether its answer, or that of finite strain, is one.
  template <int dim>
  bool
  ContactProblem<dim>::choose_kinematics(const bool success)
  {
    small_strain.look(*steps->model,
                      steps->history.state,
                      success,
                      together(steps->evaluation.error.of_target(),
                               report.error_by_increments(parameters.refinement.target_quantity)),
                      report.timer(),
                      control);
    if (control.stop.is_there())
      return success;
    if (small_strain.calls_for_finite_strain())
      return run_with_finite_strain(success);
    return success && judge_small_strain();
  }

  // Should this fail, small strain may still be the better answer. Where that is none, neither is the mesh
  // that it was refined to: in sharp corners its cells would be turned inside out. Where the iteration did
  // not converge from it, whether there is an equilibrium shows sooner on a coarse mesh.
  template <int dim>
  bool
  ContactProblem<dim>::run_with_finite_strain(const bool small_strain_converged)
  {
    report.announce(small_strain.description() + ": finite strain is used" + small_strain.allowance());
    for (const auto &interface : steps->model->interfaces)
      if (const double gap = gap_of_small_strain_alone(interface); gap > 0)
        report.announce(
            "warning: pair '" + interface.pair->name + "': gaps of the meshes, up to " + short_number(gap) +
            (interface.pair->initial_gap
                 ? ", to which finite strain adds 'Initial gap', while small strain has it instead of them"
                 : ", which 'Adjust' closes with small strain, count with finite strain") +
            ": move the bodies as they are meant to lie, or say which 'Kinematics'");
    if (go_on_with_finite_strain())
      return true;
    if (control.stop.is_there())
      return false;
    const bool has_fallback = small_strain_converged && !small_strain.is_too_much() &&
                              small_strain.error_of_target() <= small_strain.too_much,
               is_near = has_fallback && small_strain.knows_change(),
               serves  = is_near && small_strain.keeps_meshes() && !steps->model->finite_strain();
    auto shown         = steps->take_experience();
    report.restart();
    if (!is_near && mesh->n_refinements > 0)
      start_on_first_mesh(true);
    else
      start(true);
    if (serves)
      steps->go_on_from(std::move(shown));
    if (has_fallback)
      steps->history.most_cut_backs = LoadHistory<dim>::many_cut_backs;
    if (run_load_program())
      return true;
    if (!has_fallback || control.stop.is_there())
      return false;
    report.announce("warning: finite strain failed (" + report.message() +
                    "): the answer is that of small strain");
    report.restart();
    start(false);
    return steps->run();
  }

  // From the answer of small strain, at once, where the scene asks for nothing on the way. What meshes have
  // shown with small strain holds where the contact stays: by how much kinematics change a number depends
  // little on the mesh. Should a finer mesh fail, the increments may find its answer.
  template <int dim>
  bool
  ContactProblem<dim>::go_on_with_finite_strain()
  {
    const auto *nearby = small_strain.answer_nearby();
    if (nearby == nullptr || scene.n_increments > 0 || !scene.output_times.empty() ||
        !scene.corner_times.empty())
      return false;
    auto shown = steps->take_experience();
    report.restart();
    start(true, nearby);
    if (small_strain.keeps_meshes())
      steps->go_on_from(std::move(shown));
    return steps->run();
  }

  // A half sees no motion that is not its own mirror image.
  template <int dim>
  void
  ContactProblem<dim>::warn_of_halves()
  {
    for (const auto &condition : scene.conditions)
      if (condition.type == ConditionData::Type::symmetry)
        return report.announce(
            "warning: slender bodies bear more than a cantilever of their size does before it buckles, and "
            "'Boundary condition " +
            condition.name +
            "' (symmetry) lets them move to both sides alike only: whether the whole scene buckles sideways "
            "shows in a run of the whole");
  }

  template <int dim>
  bool
  ContactProblem<dim>::judge_small_strain()
  {
    if (small_strain.is_harmless())
      {
        if (scene.kinematics == Kinematics::automatic)
          report.announce(small_strain.description() + ": small strain is enough" + small_strain.allowance());
        return true;
      }
    const std::string advice = small_strain.has_alternative() ? "; say 'Kinematics = finite strain' or 'auto'"
                               : parameters.newton.collocates()
                                   ? "; finite strain needs another 'Contact solver/Method'"
                                   : "; finite strain needs rotations that are given or held, not free";
    if (!small_strain.is_too_much())
      {
        report.announce("warning: " + small_strain.description() + small_strain.allowance() + advice);
        return true;
      }
    report.fail("kinematics: " + small_strain.description() + advice +
                    what_slides(steps->model->interfaces, steps->evaluation.fields),
                "small strain");
    return false;
  }

  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace Amontons
