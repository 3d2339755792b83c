#include <amontons/finite_strain_model.h>
#include <amontons/output/summary.h>
#include <amontons/small_strain_check.h>
#include <amontons/solver/solve_contact.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
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

    // The larger one of: the largest change of a pair's force, against the largest force; and unless these
    // alone count, the change of the pressures of all pairs in the mean square.
    double
    change_of_contact(const std::vector<std::map<unsigned int, std::array<double, 2>>> &before,
                      const std::vector<std::map<unsigned int, std::array<double, 2>>> &after,
                      const bool                                                        forces_alone)
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
      if (largest_force <= 0)
        return 0;
      return std::max(force_change / largest_force, forces_alone ? 0. : std::sqrt(square_change / square));
    }

    template <int dim>
    bool
    holds_all_rotations(const Discretization<dim> &discretization)
    {
      if (discretization.scene.kind != ProblemType::axisymmetric)
        for (const auto &carrier : discretization.geometry.carriers)
          for (unsigned int k = dim == 2 ? 2 : 0; k < 3; ++k)
            if (!carrier.motion.rotation[k])
              return false;
      return true;
    }
  } // namespace

  template <int dim>
  SmallStrainCheck<dim>::SmallStrainCheck(const Scene &scene, const Parameters &parameters)
      : scene(scene), parameters(parameters)
  {
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::allowed_error() const
  {
    return parameters.refinement.target_error > 0 ? parameters.refinement.target_error : 0.01;
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::error() const
  {
    return change.value_or(neglected.largest().largest());
  }

  template <int dim>
  bool
  SmallStrainCheck<dim>::is_harmless() const
  {
    return (!tried && neglected.largest().largest() <= allowed_error()) ||
           (change && *change <= allowed_error());
  }

  template <int dim>
  std::string
  SmallStrainCheck<dim>::description() const
  {
    const NeglectedTerms &terms = neglected.largest();
    std::ostringstream    text;
    text.precision(2);
    text << "small strain leaves out " << terms.strain << " of the strain and " << terms.contact
         << " in the contact";
    if (terms.stiffening > allowed_error())
      text << ", and what stress does to the stiffness of slender bodies";
    if (neglected.came_back())
      text << " on a way that comes back";
    if (change)
      text << "; finite strain changes the answer by " << *change;
    else if (tried)
      text << "; the iteration with finite strain does not converge from there";
    return text.str();
  }

  template <int dim>
  std::string
  SmallStrainCheck<dim>::allowance() const
  {
    std::ostringstream text;
    text << " (allowed are " << allowed_error() << ")";
    return text.str();
  }

  template <int dim>
  void
  SmallStrainCheck<dim>::look(Model<dim>               &model,
                              const SolutionState<dim> &state,
                              const bool                converged,
                              TimerOutput              &timer)
  {
    TimerOutput::Scope scope(timer, "choice of the model");
    neglected.measure_gaps(model.discretization(), model.supports, model.interfaces);
    const NeglectedTerms &terms     = neglected.largest();
    const bool            automatic = scene.kinematics == Kinematics::automatic;
    const double          bound     = automatic ? allowed_error() : too_much;
    rotations_are_held              = holds_all_rotations(model.discretization());
    tried                           = converged && rotations_are_held && !neglected.came_back() &&
            (terms.largest() > bound || (automatic && terms.stiffening > bound));
    if (tried)
      change = change_by_finite_strain(model, state, timer);
    what_was_seen = {{"neglected_strain", terms.strain},
                     {"neglected_contact", terms.contact},
                     {"neglected_stiffening", terms.stiffening}};
    if (tried)
      what_was_seen["change_of_answer"] = change.value_or(unknown);
  }

  // The iteration with finite strain goes on from the answer of small strain: the largest relative change of
  // contact forces and, unless the total force is all that is asked for, of pressures and of the
  // displacement; none if it does not converge. (With friction the path of the load counts, too: an estimate
  // then.)
  template <int dim>
  std::optional<double>
  SmallStrainCheck<dim>::change_by_finite_strain(Model<dim>               &model,
                                                 const SolutionState<dim> &state,
                                                 TimerOutput              &timer) const
  {
    SolutionState<dim>       trial = state;
    FiniteStrainModel<dim>   finite(model, state, timer);
    const auto               mechanics = finite.mechanics(state);
    const ContactSolver<dim> solver    = {
           parameters.newton, parameters.linear_solver, model.discretization(), timer};
    const auto result =
        solver.solve(*mechanics, finite.interfaces, finite.supports, trial, [](const auto &) {});
    model.resume();
    if (!result.converged)
      return {};
    LA::Vector difference = model.discretization().make_owned_vector(), old = difference;
    difference = trial.displacement;
    old        = state.displacement;
    difference -= old;
    const bool   forces_alone = parameters.refinement.target_quantity == "total force";
    const double contact      = change_of_contact(
        contact_answer(model.interfaces, state), contact_answer(finite.interfaces, trial), forces_alone);
    const double size = old.linfty_norm();
    return size > 0 && !forces_alone ? std::max(contact, difference.linfty_norm() / size) : contact;
  }

  template class SmallStrainCheck<2>;
  template class SmallStrainCheck<3>;
} // namespace Amontons
