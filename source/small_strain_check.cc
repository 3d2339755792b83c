#include <amontons/adaptivity/contact_change.h>
#include <amontons/adaptivity/slenderness.h>
#include <amontons/adaptivity/state_transfer.h>
#include <amontons/evaluation.h>
#include <amontons/finite_strain_model.h>
#include <amontons/load_path.h>
#include <amontons/output/summary.h>
#include <amontons/output/target_quantity.h>
#include <amontons/small_strain_check.h>
#include <amontons/solver/solve_contact.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    template <int dim>
    GivesUp
    gives_up_on(const Model<dim> &model, RunControl &control)
    {
      return [&control, communicator = model.mesh->geometry.communicator]() {
        return control.gives_up(communicator);
      };
    }

    // Obstacles and platens, which move as is prescribed or as the bodies do.
    template <int dim>
    void
    leave_out_carriers(const Discretization<dim> &discretization, LA::Vector &v)
    {
      std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.geometry.is_carrier(cell->material_id()))
          {
            cell->get_dof_indices(dofs);
            for (const auto dof : dofs)
              if (discretization.locally_owned.is_element(dof))
                v(dof) = 0;
          }
      v.compress(VectorOperation::insert);
    }

    // What small strain makes of a given rotation is no motion of a rigid body: carriers as they are
    // prescribed, all else as it is.
    template <int dim>
    void
    set_carriers(const Discretization<dim> &discretization, const Constraints &supports, LA::Vector &u)
    {
      LA::Vector old = discretization.make_owned_vector();
      old            = u;
      LA::Vector change(old);
      supports.distribute(change);
      change -= old;
      LA::Vector elsewhere(change);
      leave_out_carriers(discretization, elsewhere);
      change -= elsewhere;
      old += change;
      u = old;
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
  SmallStrainCheck<dim>::allowed_change() const
  {
    return stiffening > too_much ? 0.1 * allowed_part() : allowed_part();
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::allowed_part() const
  {
    const auto   by_shear = sensitivity_to_shear(parameters.refinement.target_quantity);
    const double of_mesh  = parameters.refinement.target_error > 0 ? error_of_mesh : 0;
    const double all      = allowed_error(),
                 allowed  = of_mesh <= all ? std::max(all / 4, all - of_mesh) : all; // else missed anyway
    if (!shear || !by_shear)
      return allowed;
    return std::max(0., (allowed / *by_shear - shear->directions) / shear->amplification);
  }

  // Where sharp edges press they are not, on any mesh, and what finite strain makes of them tells nothing.
  template <int dim>
  bool
  SmallStrainCheck<dim>::pressures_are_known() const
  {
    return error_of_mesh < 0.25;
  }

  // (Facets of coarse meshes make gaps uneven, too; what that comes to is an error of the mesh.)
  template <int dim>
  double
  SmallStrainCheck<dim>::error_by_uneven_gaps() const
  {
    const auto  &quantity = parameters.refinement.target_quantity;
    const double pressure = neglected.largest().pressure;
    return pressures_are_known() && pressure > error_of_mesh &&
                   (quantity == "contact pressure" || quantity == "peak pressure")
               ? pressure
               : 0;
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::neglected_part() const
  {
    return std::max(neglected.largest().largest(), error_by_uneven_gaps());
  }

  // Where pressures of both kinds are compared wherever they are (change_of_contact), a narrow peak is
  // little; gaps overestimate it by less than 2 (a pad with rounded ends, a dovetail).
  template <int dim>
  double
  SmallStrainCheck<dim>::error() const
  {
    return change ? std::max(change->largest, error_by_uneven_gaps() / 2) : neglected_part();
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::error_of_shear() const
  {
    const double of_strain = change ? change->largest : neglected.largest().largest();
    return shear ? shear->amplification * of_strain + shear->directions : unknown;
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::error_of_target() const
  {
    const auto by_shear = sensitivity_to_shear(parameters.refinement.target_quantity);
    return shear && by_shear ? std::max(error(), *by_shear * error_of_shear()) : error();
  }

  template <int dim>
  bool
  SmallStrainCheck<dim>::is_harmless() const
  {
    return !has_given_way && ((!tried && std::max(neglected_part(), stiffening) <= allowed_part()) ||
                              (change && error() <= allowed_change()));
  }

  template <int dim>
  bool
  SmallStrainCheck<dim>::calls_for_finite_strain() const
  {
    return scene.kinematics == Kinematics::automatic && has_alternative() && !is_harmless();
  }

  template <int dim>
  bool
  SmallStrainCheck<dim>::gives_way(const StressRecovery<dim> &recovery, const double energy)
  {
    has_given_way = scene.kinematics == Kinematics::automatic &&
                    (is_no_answer || recovery.energy_of_neglected_stress() > 2 * std::abs(energy));
    return has_given_way;
  }

  template <int dim>
  bool
  SmallStrainCheck<dim>::is_too_much() const
  {
    const auto  &terms = neglected.largest();
    const double limit = std::max(too_much, allowed_error()); // a coarse mesh makes more of it than there is
    if (!change) // (what is left out in the contact is a bound, often far too large)
      return (parameters.newton.collocates() ? terms.strain : terms.largest()) > limit || stiffening > 1;
    return change->without_pressures > limit ||
           (pressures_are_known() && change->largest > 0.5 && terms.contact > limit);
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
    if (error_by_uneven_gaps() > terms.largest())
      text << ", where uneven gaps make " << terms.pressure << " of the pressure";
    if (shear)
      text << ", which makes " << error_of_shear() << " of the shear traction";
    if (stiffening > allowed_part())
      text << ", and what stress does to the stiffness of slender bodies (" << stiffening << ")";
    if (neglected.came_back())
      text << " on a way that comes back";
    if (change)
      {
        text << "; finite strain changes the answer by " << change->largest;
        if (change->without_pressures < change->largest)
          text << " in the pressure, by " << change->without_pressures << " else";
      }
    else if (tried)
      text << "; the iteration with finite strain does not converge from there at once";
    return text.str();
  }

  template <int dim>
  std::string
  SmallStrainCheck<dim>::allowance() const
  {
    if (has_given_way)
      return ", as what small strain leaves out is not small beside the rest";
    std::ostringstream text;
    if (const double allowed = change ? allowed_change() : allowed_part(); allowed > 0)
      text << " (allowed are " << allowed << ")";
    else
      text << " (the shear alone takes what is allowed)";
    return text.str();
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::bound() const
  {
    return scene.kinematics == Kinematics::automatic ? allowed_part() : too_much;
  }

  // A bound, not an error: what exceeds it is worth a look whatever the scene says of its kinematics.
  template <int dim>
  double
  SmallStrainCheck<dim>::allowed_stiffening() const
  {
    return std::min(allowed_part(), too_much);
  }

  // What matters little on the first mesh that is not coarse does so on finer ones, too: seeing it there is a
  // small part of the work that it would be on the last one.
  template <int dim>
  void
  SmallStrainCheck<dim>::leave_mesh(Model<dim>                &model,
                                    const StressRecovery<dim> &recovery,
                                    const SolutionState<dim>  &state,
                                    const double               energy,
                                    TimerOutput               &timer,
                                    RunControl                &control)
  {
    constexpr unsigned int enough = 5000; // unknowns
    neglected.measure_gaps(model.discretization(),
                           model.supports,
                           model.interfaces,
                           parameters.refinement.history == "transfer");
    constexpr double clearly = 0.3;
    is_no_answer             = neglected.largest().strain > clearly && neglected.largest().contact > clearly;
    if (before || state.t < scene.end_time || model.discretization().dof_handler.n_dofs() < enough)
      return;
    TimerOutput::Scope scope(timer, "choice of the model");
    error_of_mesh = allowed_error(); // of the last one: it leaves least to the kinematics
    NeglectedTermsOfHistory<dim> here(neglected);
    shear =
        shear_kinematics(model.discretization(), model.interfaces, state.contact, neglected.largest().turn);
    here.add(model.discretization(), recovery, model.elasticity, state, model.interfaces, energy);
    const NeglectedTerms &terms = here.largest();
    // What may come to matter on finer ones: strain hardly grows, the bound of the stiffening does.
    const bool may_matter  = terms.strain > 0.8 * bound(),
               may_stiffen = terms.stiffening > allowed_stiffening() / 4;
    if (!may_matter && !may_stiffen)
      return;
    before = Findings{terms, {}, {}};
    if (may_stiffen)
      before->stiffening = stiffening_at(model, state, timer, control);
    rotations_are_held = holds_all_rotations(model.discretization());
    if (may_matter && has_alternative())
      before->change = change_nearby(model, state, timer, control, nullptr);
  }

  template <int dim>
  bool
  SmallStrainCheck<dim>::is_as_before() const
  {
    // The bound of the stiffening grows where meshes see a peak better, though it changes little itself.
    return before && neglected.largest().strain <= 1.5 * before->terms.strain &&
           neglected.largest().stiffening <= 4 * before->terms.stiffening;
  }

  template <int dim>
  void
  SmallStrainCheck<dim>::look(Model<dim>               &model,
                              const SolutionState<dim> &state,
                              const bool                converged,
                              const double              of_mesh,
                              TimerOutput              &timer,
                              RunControl               &control)
  {
    TimerOutput::Scope scope(timer, "choice of the model");
    error_of_mesh = of_mesh;
    neglected.measure_gaps(model.discretization(), model.supports, model.interfaces);
    const NeglectedTerms &terms = neglected.largest();
    rotations_are_held          = holds_all_rotations(model.discretization());
    shear =
        shear_kinematics(model.discretization(), model.interfaces, state.contact, neglected.largest().turn);
    const bool is_telling = converged && !neglected.came_back();
    if (is_telling && terms.stiffening <= allowed_stiffening())
      stiffening = terms.stiffening;
    else if (is_telling)
      stiffening = is_as_before() && before->stiffening && *before->stiffening <= allowed_stiffening() / 2
                       ? *before->stiffening
                       : stiffening_at(model, state, timer, control);
    tried =
        is_telling && has_alternative() && (neglected_part() > bound() || stiffening > allowed_stiffening());
    // A scene that insists on small strain asks only whether its answer is one at all.
    const double clear = (scene.kinematics == Kinematics::automatic ? allowed_change()
                                                                    : std::max(allowed_change(), too_much)) /
                         2;
    if (tried)
      change = is_as_before() && before->change && before->change->largest <= clear
                   ? before->change
                   : change_by_finite_strain(model, state, timer, control);
    what_was_seen = {{"neglected_strain", terms.strain},
                     {"neglected_contact", terms.contact},
                     {"neglected_pressure", terms.pressure},
                     {"neglected_stiffening", stiffening}};
    if (tried)
      what_was_seen["change_of_answer"] = change ? change->largest : unknown;
  }

  template <int dim>
  double
  SmallStrainCheck<dim>::stiffening_at(Model<dim>               &model,
                                       const SolutionState<dim> &state,
                                       TimerOutput              &timer,
                                       RunControl               &control) const
  {
    const auto               mechanics = model.mechanics(state);
    const GivesUp            gives_up  = gives_up_on(model, control);
    const ContactSolver<dim> solver    = {
           parameters.newton, parameters.linear_solver, model.discretization(), timer, gives_up};
    // A local stress, as at a corner, makes |lambda| a few times as large as its strain.
    const auto with_strains_to = [&](const double most_strain) {
      return solver.stress_stiffening(*mechanics, model.interfaces, model.supports, state, most_strain)
          .value_or(0);
    };
    const double found = with_strains_to(allowed_stiffening() / 6);
    return found > too_much ? std::max(found, with_strains_to(too_much / 6)) : found;
  }

  // The largest relative change of contact forces and, unless these have a resultant and are all that is
  // asked for, of pressures, of their place and of the displacement; of the energy if that is asked for,
  // which singular pressures hardly change.
  template <int dim>
  typename SmallStrainCheck<dim>::Change
  SmallStrainCheck<dim>::change_to(const Model<dim>         &finite,
                                   const SolutionState<dim> &finite_state,
                                   const Model<dim>         &model,
                                   const SolutionState<dim> &state) const
  {
    const auto &sizes    = model.mesh->geometry.body_sizes;
    const auto  contact  = change_of_contact(model.interfaces,
                                           state,
                                           finite.interfaces,
                                           finite_state,
                                           *std::max_element(sizes.begin(), sizes.end()));
    const auto &quantity = parameters.refinement.target_quantity;
    if (quantity == "total force" && contact.has_resultant)
      return {contact.forces, contact.forces};
    LA::Vector difference = model.discretization().make_owned_vector(), old = difference;
    difference = finite_state.displacement;
    old        = state.displacement;
    difference -= old;
    for (LA::Vector *v : {&difference, &old})
      leave_out_carriers(model.discretization(), *v);
    const double size = old.linfty_norm(), displacement = size > 0 ? difference.linfty_norm() / size : 0.,
                 rest = std::max({contact.forces, contact.shift, displacement});
    if (const double energy = model.elasticity.stored_energy(state.displacement);
        quantity == "energy" && energy > 0)
      {
        const double by = std::abs(finite.elasticity.stored_energy(finite_state.displacement) / energy - 1);
        return {by, std::max(rest, by)};
      }
    return {std::max(rest, contact.pressures), rest};
  }

  // The iteration with finite strain goes on from the answer of small strain. (With friction the path of the
  // load counts, too: an estimate then.) What it comes to is put into `nearby` where that is near and the
  // path does not matter.
  template <int dim>
  std::optional<typename SmallStrainCheck<dim>::Change>
  SmallStrainCheck<dim>::change_nearby(Model<dim>                        &model,
                                       const SolutionState<dim>          &state,
                                       TimerOutput                       &timer,
                                       RunControl                        &control,
                                       std::optional<SolutionState<dim>> *nearby) const
  {
    std::optional<Change> result;
    {
      SolutionState<dim>     trial = state;
      FiniteStrainModel<dim> finite(model, state, timer);
      set_carriers(model.discretization(), finite.supports, trial.displacement);
      finite.move_to(trial);
      const auto               mechanics = finite.mechanics(trial);
      const GivesUp            gives_up  = gives_up_on(model, control);
      const ContactSolver<dim> solver    = {
             parameters.newton, parameters.linear_solver, model.discretization(), timer, gives_up};
      const auto observer = [](const auto &) {};
      const auto report =
          solver.solve(*mechanics, finite.interfaces, finite.supports, trial, observer, FollowMotion::never);
      if (report.converged)
        {
          result = change_to(finite, trial, model, state);
          if (nearby != nullptr && result->largest <= too_much && !scene.has_friction())
            {
              Evaluation<dim> evaluation(false);
              evaluation.collect_fields(finite, trial);
              make_traction_field(model.discretization(), finite.interfaces, evaluation.fields, trial);
              *nearby = std::move(trial);
            }
        }
    }
    model.resume();
    return result;
  }

  // The answer of small strain may be too far from that of finite strain for the iteration: what bending
  // shortens is missing there, and what is held by little more than its weight may roll away from it (a
  // change of more than all that there was). If the scene insists on small strain, the load program on this
  // mesh tells. None if neither converges.
  template <int dim>
  std::optional<typename SmallStrainCheck<dim>::Change>
  SmallStrainCheck<dim>::change_by_finite_strain(Model<dim>               &model,
                                                 const SolutionState<dim> &state,
                                                 TimerOutput              &timer,
                                                 RunControl               &control)
  {
    auto result = change_nearby(model, state, timer, control, &found);
    if ((result && result->largest <= 1) || scene.kinematics != Kinematics::small_strain ||
        control.gives_up(model.mesh->geometry.communicator))
      return result;
    constexpr unsigned int most_cut_backs = 4; // below sharp edges increments are cut for ever

    LoadProgram program(scene, true);
    if (scene.is_loaded_at_start)
      program.start_before();
    LoadPath<dim> path(parameters, make_model(model.mesh, true, program.next(), timer), timer, control);
    if (path.run(program, most_cut_backs))
      result = change_to(*path.model, path.history.state, model, state);
    model.resume();
    return result;
  }

  template class SmallStrainCheck<2>;
  template class SmallStrainCheck<3>;
} // namespace Amontons
