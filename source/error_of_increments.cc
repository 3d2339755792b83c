// ContactProblem: the error of the increments, in the end.
#include <amontons/contact_problem.h>

#include <sstream>

namespace Amontons
{
  // In the end. With friction the answer depends on the increments: by how much.
  template <int dim>
  void
  ContactProblem<dim>::add_error_of_increments()
  {
    if (!steps->has_measured_increments())
      {
        if (parameters.refinement.history == "transfer" && mesh->n_refinements > 0)
          report.set_error_of_increments(measure_increments_elsewhere());
        else
          steps->measure_increments();
      }
    else if (const auto &errors = report.error_of_increments();
             errors && parameters.refinement.history != "transfer")
      report.set_error_of_increments(errors->for_steps(steps->history.record));
    if (control.stop.is_there())
      return;
    if (!report.error_of_increments())
      return report.announce("warning: the error of the increments is not known: neither with half as many "
                             "nor with twice as many does "
                             "the iteration converge");
    const IncrementErrors &errors  = *report.error_of_increments();
    const double           allowed = small_strain.allowed_error();
    std::ostringstream     text;
    text.precision(2);
    if (errors.largest() > allowed)
      text << errors.shear << " of the shear traction, " << errors.stick_size << " of the stick size, "
           << std::max(errors.normal_force, errors.tangential_force) << " of the forces";
    if (errors.dissipation > allowed)
      text << (text.str().empty() ? "" : ", ") << errors.dissipation << " of the work, in that of friction";
    if (!text.str().empty())
      report.announce("warning: with " + std::to_string(errors.repeated_with) + " increments instead of " +
                      std::to_string(errors.measured_with) +
                      " the answer is another; what is wrong by the increments (" +
                      std::to_string(errors.n_increments) + ") is about " + text.str() +
                      "; it falls with their number ('Increments')");
  }

  // Where meshes were refined on the way: the load program on a mesh of its own.
  template <int dim>
  std::optional<IncrementErrors>
  ContactProblem<dim>::measure_increments_elsewhere()
  {
    TimerOutput::Scope scope(report.timer(), "error of the increments");
    Scene              part = scene;
    part.reference.reset();
    part.probes.clear();
    Parameters replay         = parameters;
    replay.refinement.history = "replay";
    if (replay.refinement.target_error > 0) // which would choose other increments
      {
        replay.refinement.cycles       = mesh->n_refinements;
        replay.refinement.target_error = 0;
      }
    // Where nothing touches in the end no mesh sees slip there.
    replay.refinement.max_dofs = mesh->discretization->dof_handler.n_dofs();
    replay.output.vtu          = false;
    return ContactProblem<dim>(part, replay, folder, true, control)
        .run_to_measure_increments(steps->model->finite_strain());
  }

  template <int dim>
  std::optional<IncrementErrors>
  ContactProblem<dim>::run_to_measure_increments(const bool finite_strain)
  {
    start_on_first_mesh(finite_strain);
    steps->run_to_measure_increments();
    return report.error_of_increments();
  }

  template void
  ContactProblem<2>::add_error_of_increments();
  template std::optional<IncrementErrors>
  ContactProblem<2>::run_to_measure_increments(const bool);
  template void
  ContactProblem<3>::add_error_of_increments();
  template std::optional<IncrementErrors>
  ContactProblem<3>::run_to_measure_increments(const bool);
} // namespace Amontons
