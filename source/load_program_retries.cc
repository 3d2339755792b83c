// ContactProblem: the load program, and what is tried where it fails.
#include <amontons/contact_problem.h>

#include <sstream>

namespace Amontons
{
  // What is held until it touches a wall has touched it: the loads are to be followed anew, without.
  template <int dim>
  bool
  ContactProblem<dim>::lets_go_at_wall(const bool finite_strain)
  {
    const auto &failure = steps->history.last_report.failure;
    if (!failure || failure->kind != Failure::Kind::wall_touched || is_stopped())
      return false;
    report.announce(report.message() + ": the loads are followed anew, and nothing else holds it");
    report.restart();
    start_on_first_mesh(finite_strain, false);
    return true;
  }

  // Where it stopped at facets: once more, with quadratic elements, whose arcs leave out next to nothing.
  template <int dim>
  bool
  ContactProblem<dim>::run_without_facets()
  {
    if (is_stopped() || !steps->wants_arcs())
      return true;
    std::ostringstream text;
    text.precision(2);
    text << "model: quadratic elements ('Discretization/Degree'): facets of linear ones leave out "
         << steps->evaluation.error.sections << " of round bodies, by their strain energy";
    report.announce(text.str());
    report.restart();
    parameters.discretization.degree = "2";
    start_on_first_mesh(steps->model->finite_strain());
    return steps->run();
  }

  // Instead of a history that goes from mesh to mesh.
  template <int dim>
  void
  ContactProblem<dim>::replay(const std::string &reason)
  {
    report.announce("'Refinement/History = replay' instead of 'transfer': " + reason);
    parameters.refinement.history = "replay";
  }

  // What was carried from mesh to mesh may be far from any equilibrium there, and what is fine behind a
  // contact stays so: where that fails, the loads are followed on one mesh after the other.
  template <int dim>
  bool
  ContactProblem<dim>::run_load_program()
  {
    const bool         finite_strain = steps->model->finite_strain();
    const unsigned int first         = mesh->n_refinements;
    const bool         ran           = steps->run(true) && run_without_facets(),
               was_held              = !ran && lets_go_at_wall(finite_strain);
    if (ran || (was_held && steps->run()))
      return true;
    if (is_stopped() || parameters.refinement.target_error <= 0)
      return false;
    if (parameters.refinement.history == "transfer" && mesh->n_refinements > first)
      {
        replay(report.message());
        report.restart();
        start_on_first_mesh(finite_strain, !was_held);
        return run_load_program();
      }
    return run_on_other_mesh(first, finite_strain, !was_held);
  }

  // Should a mesh fail that a target asked for, the answer is that of the one before, or of finer ones that
  // begin with a finer one. first: of the run that failed.
  template <int dim>
  bool
  ContactProblem<dim>::run_on_other_mesh(const unsigned int first,
                                         const bool         finite_strain,
                                         const bool         walls_are_none)
  {
    const unsigned int failed  = mesh->n_refinements;
    const std::string  message = "on mesh " + std::to_string(failed) + " " + report.message();
    if (first == 0 && may_be_too_coarse())
      {
        report.announce(message +
                        ": the loads are followed anew, from a first mesh that is once more refined");
        report.restart();
        for (auto &body : scene.bodies)
          ++body.refinements;
        is_finer                  = true;
        const auto most_cut_backs = steps->history.most_cut_backs;
        start_on_first_mesh(finite_strain, walls_are_none);
        steps->history.most_cut_backs = most_cut_backs;
        if (steps->run())
          return true;
        for (auto &body : scene.bodies)
          --body.refinements;
      }
    if (is_stopped() || failed == first)
      return false;
    report.announce("warning: " + message + ": the answer is that of the mesh before");
    report.restart_coarser();
    const int cycles             = parameters.refinement.cycles;
    parameters.refinement.cycles = failed - 1;
    start_on_first_mesh(finite_strain, walls_are_none);
    const bool success           = steps->run();
    parameters.refinement.cycles = cycles;
    return success;
  }

  // Where surfaces move far a facet may be longer than the way from one state to the next one: the iteration
  // then finds none, or one behind the other surface. (Of a strip that a pin bends aside: with 20 cells along
  // it at no increment, with 10 and 40 at all.) Finer meshes whose cost is unlike that of the first one are
  // not worth a try that may fail as well; nor is it worth one where several meshes have passed, and a finer
  // one turns a cell inside out: so do sharp edges.
  template <int dim>
  bool
  ContactProblem<dim>::may_be_too_coarse() const
  {
    using Kind          = Failure::Kind;
    const auto &failure = steps->history.last_report.failure;
    const auto  kinds   = {
           Kind::inverted_cell, Kind::passed_through, Kind::motion_lost, Kind::no_states, Kind::still_moving};
    return !is_finer && steps->model->finite_strain() && failure &&
           (failure->kind != Kind::inverted_cell || mesh->n_refinements < 4) &&
           std::find(kinds.begin(), kinds.end(), failure->kind) != kinds.end() &&
           std::pow(2, dim) * n_first_dofs <= std::min(20000., double(parameters.refinement.max_dofs));
  }

  template void
  ContactProblem<2>::replay(const std::string &);
  template bool
  ContactProblem<2>::run_load_program();
  template void
  ContactProblem<3>::replay(const std::string &);
  template bool
  ContactProblem<3>::run_load_program();
} // namespace Amontons
