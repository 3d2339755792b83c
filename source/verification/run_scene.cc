#include <amontons/contact_problem.h>
#include <amontons/model_reduction.h>
#include <amontons/output/output_folder.h>
#include <amontons/scene/scene_reader.h>
#include <amontons/verification/comparison.h>
#include <amontons/verification/reference_solution.h>
#include <amontons/verification/run_scene.h>

#include <deal.II/base/mpi.templates.h>

#include <filesystem>

namespace Amontons
{
  namespace
  {
    // With less model, if the target allows it and the answer is found.
    template <int dim>
    RunSummary
    solve(const Scene                    &scene,
          const Parameters               &parameters,
          const SceneRun                 &run,
          const std::vector<std::string> &notes,
          RunControl                     &control)
    {
      const ReducedScene reduced = reduce_model<dim>(scene, parameters, control);
      if (!reduced.notes.empty() && !control.stop.is_there())
        {
          auto all = notes;
          all.insert(all.end(), reduced.notes.begin(), reduced.notes.end());
          try
            {
              RunSummary summary =
                  ContactProblem<dim>(reduced.scene, parameters, run.folder, run.quiet, control).run(all);
              if (summary.converged || control.stop.is_there())
                return summary;
            }
          catch (const InputError &)
            {
              // nothing may hold a body without friction; what else is wrong the scene itself will show
            }
        }
      return ContactProblem<dim>(scene, parameters, run.folder, run.quiet, control, make_reference<dim>)
          .run(notes);
    }

    // All that changes the answer.
    StoredRun
    describe(const SceneRun &run, const Scene &scene)
    {
      StoredRun what = {"", std::filesystem::absolute(run.scene).string(), run.overrides, scene.entries};
      std::vector<std::string> contents;
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        for (const std::string &file : scene.files())
          contents.push_back(describe_contents(file));
      contents = Utilities::MPI::broadcast(MPI_COMM_WORLD, contents);
      what.entries.insert(what.entries.end(), contents.begin(), contents.end());
      return what;
    }

    // What there is to say of an unfinished run of this scene.
    std::vector<std::string>
    prepare_checkpoint(const SceneRun   &run,
                       const Scene      &scene,
                       const Parameters &parameters,
                       Checkpoint       &checkpoint)
    {
      const auto intervals = parameters.output.checkpoint_intervals();
      if (run.resumes)
        {
          checkpoint.resume(run.folder, describe(run, scene), intervals);
          return {"the run in " + run.folder + " goes on: " + std::to_string(checkpoint.n_known()) +
                  " solves are known"};
        }
      std::vector<std::string> notes;
      if (Checkpoint::exists(run.folder))
        notes.push_back(
            "in " + run.folder +
            " there was a run that has not ended; 'amontons --resume' would have gone on with it, "
            "this one starts anew");
      if (!intervals.never())
        checkpoint.start(run.folder, describe(run, scene), intervals);
      return notes;
    }
  } // namespace

  RunSummary
  run_scene(const SceneRun &run, RunControl &control)
  {
    control.wall.restart();
    Parameters  parameters;
    const Scene scene = read_scene(
        run.scene, run.overrides, parameters.groups(), {make_displacement_field, displacement_field_corners});
    parameters.refinement.choose_target(scene.has_friction() ||
                                        scene.kinematics == Kinematics::finite_strain);
    const auto &refinement                 = parameters.refinement;
    parameters.discretization.for_pressure = refinement.target_quantity == "contact pressure" &&
                                             refinement.target_error >= 5e-3 && refinement.most_cycles() > 0;
    if (scene.kind == ProblemType::three_dimensional && refinement.most_cycles() > 0)
      parameters.newton.suit_target(refinement.target_error);
    auto notes = prepare_checkpoint(run, scene, parameters, control.checkpoint);
    notes.insert(notes.end(), scene.notes.begin(), scene.notes.end());
    const auto save = [&]() { control.checkpoint.flush(); };
    try
      {
        RunSummary summary   = scene.kind == ProblemType::three_dimensional
                                   ? solve<3>(scene, parameters, run, notes, control)
                                   : solve<2>(scene, parameters, run, notes, control);
        const bool has_ended = !control.stop.is_there() && control.stop.own_reason().empty();
        if (has_ended)
          control.checkpoint.remove();
        else
          control.try_to(save);
        keep_output_folder(has_ended);
        return summary;
      }
    catch (const std::bad_alloc &)
      {
        control.try_to(save);
        throw;
      }
  }
} // namespace Amontons
