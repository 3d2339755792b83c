// Finite strain, and whether small strain was enough.
#include <amontons/contact_problem.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    // An answer of small strain that leaves out more than this is none.
    constexpr double too_much = 0.1;

    // By slave node: area and pressure.
    template <int dim>
    std::vector<std::map<unsigned int, std::array<double, 2>>>
    contact_answer(const std::vector<ContactInterface<dim>> &interfaces, const SolutionState<dim> &state)
    {
      std::vector<std::map<unsigned int, std::array<double, 2>>> answer(interfaces.size());
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        for (const auto &row : interfaces[i].coupling.rows)
          answer[i][row.node] = {{row.area, state.contact[i][row.node].pressure}};
      return answer;
    }

    // The larger one of: the largest change of a pair's force, against the largest force; the change of the
    // pressures of all pairs in the mean square.
    double
    change_of_contact(const std::vector<std::map<unsigned int, std::array<double, 2>>> &before,
                      const std::vector<std::map<unsigned int, std::array<double, 2>>> &after)
    {
      double force_change = 0, largest_force = 0, square_change = 0, square = 0;
      for (unsigned int i = 0; i < before.size(); ++i)
        {
          double                                        old_force = 0, new_force = 0;
          std::map<unsigned int, std::array<double, 3>> nodes; // area, pressure before and after
          for (const auto &[node, value] : after[i])
            {
              nodes[node] = {{value[0], 0, value[1]}};
              new_force += value[0] * value[1];
            }
          for (const auto &[node, value] : before[i])
            {
              nodes[node][0] = value[0];
              nodes[node][1] = value[1];
              old_force += value[0] * value[1];
            }
          for (const auto &[node, value] : nodes)
            {
              square_change += value[0] * std::pow(value[2] - value[1], 2);
              square += value[0] * value[1] * value[1];
            }
          force_change  = std::max(force_change, std::abs(new_force - old_force));
          largest_force = std::max(largest_force, std::abs(old_force));
        }
      return largest_force > 0 ? std::max(force_change / largest_force, std::sqrt(square_change / square))
                               : 0.;
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
  FiniteMechanics<dim>
  ContactProblem<dim>::finite_mechanics(ElasticityOperator<dim> &bodies) const
  {
    return FiniteMechanics<dim>(
        *discretization, bodies, history.state.t, [this]() { return covered_points(); });
  }

  // Finite strain: couples the surfaces where the displacement takes them.
  template <int dim>
  void
  ContactProblem<dim>::move_surfaces()
  {
    if (!finite_strain)
      return;
    TimerOutput::Scope scope(report.timer(), "contact surfaces");
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      if (!history.state.contact.empty() &&
          history.state.contact[i].size() == interfaces[i].slave->nodes.size())
        for (unsigned int n = 0; n < interfaces[i].slave->nodes.size(); ++n)
          interfaces[i].carried[n] = history.state.contact[i][n].has_multiplier;
    couple_moved(*discretization, supports, history.state.displacement, history.state.t, interfaces);
  }

  // The iteration with finite strain goes on from the answer of small strain: the largest relative change of
  // contact forces, pressures and of the displacement; none if it does not converge. (With friction the path
  // of the load counts, too: an estimate then.)
  template <int dim>
  std::optional<double>
  ContactProblem<dim>::change_by_finite_strain()
  {
    SolutionState<dim>      trial  = history.state;
    const auto              before = contact_answer(interfaces, trial);
    ElasticityOperator<dim> finite(*discretization, true);
    discretization->finite_strain = true; // rotations of platens are given exactly
    supports                      = discretization->make_supports(history.state.t);
    couple_moved(*discretization, supports, history.state.displacement, history.state.t, interfaces);
    auto       mechanics = finite_mechanics(finite);
    const auto result = contact_solver().solve(mechanics, interfaces, supports, trial, [](const auto &) {});
    std::optional<double> change;
    if (result.converged)
      {
        change                = change_of_contact(before, contact_answer(interfaces, trial));
        LA::Vector difference = discretization->make_owned_vector(), old = difference;
        difference = trial.displacement;
        old        = history.state.displacement;
        difference -= old;
        if (const double size = old.linfty_norm(); size > 0)
          change = std::max(*change, difference.linfty_norm() / size);
      }
    discretization->finite_strain = false;
    couple_surfaces();
    return change;
  }

  template <int dim>
  double
  ContactProblem<dim>::allowed_error() const
  {
    return parameters.refinement.target_error > 0 ? parameters.refinement.target_error : 0.01;
  }

  // What finite strain changes, where that was tried; else what small strain leaves out.
  template <int dim>
  double
  ContactProblem<dim>::kinematic_error() const
  {
    return change_of_answer.value_or(neglected.largest().largest());
  }

  template <int dim>
  std::string
  ContactProblem<dim>::describe_small_strain() const
  {
    std::ostringstream text;
    text.precision(2);
    text << "small strain leaves out " << neglected.largest().strain << " of the strain and "
         << neglected.largest().contact << " in the contact";
    if (neglected.largest().stiffening > allowed_error())
      text << ", and what stress does to the stiffness of slender bodies";
    if (change_of_answer)
      text << "; finite strain changes the answer by " << *change_of_answer;
    else if (tried_finite_strain)
      text << "; the iteration with finite strain does not converge from there";
    return text.str();
  }

  // After the load program with small strain. Finite strain is tried where small strain leaves out more than
  // is allowed, or, if the scene insists on it, more than any answer may. `auto` then runs the scene again
  // with it; should this fail, small strain may still be the better answer.
  template <int dim>
  bool
  ContactProblem<dim>::choose_kinematics(const bool success)
  {
    std::ostringstream allowed;
    allowed << " (allowed are " << allowed_error() << ")";
    const bool automatic = scene.kinematics == Kinematics::automatic;
    const bool stiffens  = automatic && neglected.largest().stiffening > allowed_error();
    {
      TimerOutput::Scope scope(report.timer(), "choice of the model");
      neglected.measure_gaps(*discretization, supports, interfaces);
      tried_finite_strain =
          success && !any_free_rotation(*discretization) &&
          (stiffens || neglected.largest().largest() > (automatic ? allowed_error() : too_much));
      if (tried_finite_strain)
        change_of_answer = change_by_finite_strain();
      neglected_checks = {{"neglected_strain", neglected.largest().strain},
                          {"neglected_contact", neglected.largest().contact},
                          {"neglected_stiffening", neglected.largest().stiffening}};
      if (tried_finite_strain)
        neglected_checks["change_of_answer"] = change_of_answer.value_or(unknown);
    }
    const bool harmless = (neglected.largest().largest() <= allowed_error() && !tried_finite_strain) ||
                          (change_of_answer && *change_of_answer <= allowed_error());
    if (automatic && !harmless && !any_free_rotation(*discretization))
      {
        report.announce(describe_small_strain() + ": finite strain is used" + allowed.str());
        restart(true);
        if (run_all_meshes())
          return true;
        if (!success || kinematic_error() > too_much)
          return false;
        report.announce("warning: finite strain failed (" + report.message() +
                        "): the answer is that of small strain");
        restart(false);
        return run_all_meshes();
      }
    if (!success)
      return false;
    if (harmless)
      {
        if (automatic)
          report.announce(describe_small_strain() + ": small strain is enough" + allowed.str());
        else if (neglected.largest().stiffening > 1)
          report.announce(
              "warning: stress may stiffen or buckle a slender body, which small strain leaves out "
              "('Kinematics = "
              "auto' looks)");
        return true;
      }
    const std::string advice = any_free_rotation(*discretization)
                                   ? "; finite strain needs rotations that are given or held, not free"
                                   : "; say 'Kinematics = finite strain' or 'auto'";
    if (kinematic_error() <= too_much)
      {
        report.announce("warning: " + describe_small_strain() + allowed.str() + advice);
        return true;
      }
    report.fail("kinematics: " + describe_small_strain() + advice);
    return false;
  }

  // On the mesh that the last one ended with.
  template <int dim>
  void
  ContactProblem<dim>::restart(const bool with_finite_strain)
  {
    finite_strain                 = with_finite_strain;
    discretization->finite_strain = finite_strain;
    incremental                   = has_history || finite_strain;
    elasticity                    = std::make_unique<ElasticityOperator<dim>>(*discretization, finite_strain);
    report.restart();
    history.path.clear();
    measured_increments = false;
    reaches.clear(); // how far surfaces see depends on how far they move
    history.state   = SolutionState<dim>();
    history.state.t = LoadProgram(scene, incremental).next();
    rebuild();
  }

  template FiniteMechanics<2>
  ContactProblem<2>::finite_mechanics(ElasticityOperator<2> &) const;
  template FiniteMechanics<3>
  ContactProblem<3>::finite_mechanics(ElasticityOperator<3> &) const;
  template void
  ContactProblem<2>::move_surfaces();
  template void
  ContactProblem<3>::move_surfaces();
  template double
  ContactProblem<2>::allowed_error() const;
  template double
  ContactProblem<3>::allowed_error() const;
  template double
  ContactProblem<2>::kinematic_error() const;
  template double
  ContactProblem<3>::kinematic_error() const;
  template bool
  ContactProblem<2>::choose_kinematics(const bool);
  template bool
  ContactProblem<3>::choose_kinematics(const bool);
} // namespace Amontons
