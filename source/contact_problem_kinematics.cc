// Finite strain, and Kinematics = auto: whether small strain was enough.
#include <amontons/adaptivity/model_selection.h>
#include <amontons/contact_problem.h>
#include <amontons/solver/stored_states.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    // Neglected terms up to this part of the tolerance are taken as harmless without a further look.
    constexpr double harmless = 0.1;

    // Sum of the nodal forces and largest nodal pressure of each pair.
    template <int dim>
    std::vector<double>
    contact_answer(const std::vector<ContactInterface<dim>> &interfaces, const SolutionState &state)
    {
      std::vector<double> answer;
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        {
          double force = 0, peak = 0;
          for (unsigned int r = 0; r < interfaces[i].coupling.rows.size(); ++r)
            {
              force += interfaces[i].coupling.rows[r].area * state.pressures[i][r];
              peak = std::max(peak, state.pressures[i][r]);
            }
          answer.push_back(force);
          answer.push_back(peak);
        }
      return answer;
    }

    template <int dim>
    bool
    any_free_rotation(const Discretization<dim> &discretization)
    {
      if (discretization.scene.kind != Kind::axisymmetric)
        for (const auto &carrier : discretization.geometry.carriers)
          for (unsigned int k = dim == 2 ? 2 : 0; k < 3; ++k)
            if (!carrier.motion.rotation[k])
              return true;
      return false;
    }
  } // namespace

  template <int dim>
  FollowerLoads
  ContactProblem<dim>::follower_loads() const
  {
    FollowerLoads follower;
    follower.forces = [this](const LA::Vector &u) {
      return assemble_loads(*discretization, state.t, covered_points(), &u);
    };
    follower.stiffness = [this](const LA::Vector &u) {
      std::vector<RectangularMatrix> matrices;
      for (auto &part : pressure_stiffness(*discretization, state.t, u))
        {
          part.matrix *= -1;
          matrices.push_back({part.dofs, part.dofs, part.matrix});
        }
      return matrices;
    };
    return follower;
  }

  template <int dim>
  NewtonReport
  ContactProblem<dim>::iterate_with_finite_strain(const typename SemismoothNewton<dim>::Observer &observer)
  {
    FiniteNewton<dim> newton(parameters.newton, parameters.linear_solver, *discretization, timer);
    const auto        follower = follower_loads();
    const auto        report =
        newton.solve(*elasticity, interfaces, supports, follower, state, observer, follow_motion);
    loads = follower.forces(state.displacement);
    return report;
  }

  // Finite strain: couples the surfaces where the displacement takes them.
  template <int dim>
  void
  ContactProblem<dim>::move_surfaces()
  {
    if (!finite_strain)
      return;
    TimerOutput::Scope scope(timer, "contact surfaces");
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      if (i < state.carried.size() && state.carried[i].size() == interfaces[i].slave->nodes.size())
        interfaces[i].carried = state.carried[i];
    couple_moved(*discretization, supports, state.displacement, interfaces);
    fit_states(interfaces, state);
  }

  // The iteration with finite strain goes on from the answer of small strain: the largest relative change of
  // contact forces, peak pressures and of the displacement; infinite if it does not converge. (With friction
  // the path of the load counts, too: an estimate then.)
  template <int dim>
  double
  ContactProblem<dim>::change_by_finite_strain()
  {
    SolutionState           trial  = state;
    const auto              before = contact_answer(interfaces, trial);
    ElasticityOperator<dim> finite(*discretization, true);
    FiniteNewton<dim>       newton(parameters.newton, parameters.linear_solver, *discretization, timer);
    const auto              report =
        newton.solve(finite, interfaces, supports, follower_loads(), trial, [](const auto &) {});
    if (!report.converged)
      return std::numeric_limits<double>::infinity();
    const auto after  = contact_answer(interfaces, trial);
    double     change = 0;
    for (unsigned int i = 0; i < before.size(); ++i)
      if (before[i] > 0)
        change = std::max(change, std::abs(after[i] / before[i] - 1));
    LA::Vector difference = discretization->make_owned_vector(), old = difference;
    difference = trial.displacement;
    old        = state.displacement;
    difference -= old;
    if (const double size = old.linfty_norm(); size > 0)
      change = std::max(change, difference.linfty_norm() / size);
    return change;
  }

  template <int dim>
  bool
  ContactProblem<dim>::needs_finite_strain()
  {
    TimerOutput::Scope scope(timer, "choice of the model");
    const double       tolerance =
        parameters.refinement.target_error > 0 ? parameters.refinement.target_error : 0.01;
    const auto neglected = neglected_terms(*discretization, supports, state, interfaces);
    neglected_checks     = {{"neglected_strain", neglected.strain}, {"neglected_contact", neglected.contact}};
    std::ostringstream text;
    text.precision(2);
    text << "small strain leaves out " << neglected.strain
         << " of the strain and moves surfaces that touch by " << neglected.contact
         << " of their motion from each other";
    bool needed = false;
    couple_surfaces();
    if (neglected.largest() > harmless * tolerance && !any_free_rotation(*discretization))
      {
        const double change                  = change_by_finite_strain();
        needed                               = !(change <= tolerance);
        neglected_checks["change_of_answer"] = change;
        if (std::isfinite(change))
          text << "; finite strain changes the answer by " << change;
        couple_surfaces();
      }
    else if (neglected.largest() > harmless * tolerance)
      text << "; finite strain has no free rotations, so that it was not tried";
    text << ": " << (needed ? "finite strain is used" : "small strain is enough") << " (allowed are "
         << tolerance << ")";
    summary.notes.push_back(text.str());
    terminal.note(text.str());
    return needed;
  }

  // On the mesh that small strain ended with.
  template <int dim>
  void
  ContactProblem<dim>::restart_with_finite_strain()
  {
    scene.kinematics = Kinematics::finite_strain;
    finite_strain    = true;
    incremental      = true;
    elasticity       = std::make_unique<ElasticityOperator<dim>>(*discretization, true);
    summary.meshes.clear();
    summary.newton.clear();
    path.clear();
    vtu.restart();
    state   = SolutionState();
    state.t = LoadProgram(scene, incremental).next();
    rebuild();
  }

  template FollowerLoads
  ContactProblem<2>::follower_loads() const;
  template FollowerLoads
  ContactProblem<3>::follower_loads() const;
  template NewtonReport
  ContactProblem<2>::iterate_with_finite_strain(const SemismoothNewton<2>::Observer &);
  template NewtonReport
  ContactProblem<3>::iterate_with_finite_strain(const SemismoothNewton<3>::Observer &);
  template void
  ContactProblem<2>::move_surfaces();
  template void
  ContactProblem<3>::move_surfaces();
  template bool
  ContactProblem<2>::needs_finite_strain();
  template bool
  ContactProblem<3>::needs_finite_strain();
  template void
  ContactProblem<2>::restart_with_finite_strain();
  template void
  ContactProblem<3>::restart_with_finite_strain();
} // namespace Amontons
