#include <amontons/solver/contact_compliance.h>
#include <amontons/solver/newton_step.h>

namespace Amontons
{
  void
  NewtonParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact solver");
    prm.add_parameter("Maximum iterations",
                      max_iterations,
                      "Of the active-set (semismooth Newton) iteration on one mesh.",
                      Patterns::Integer(1));
    prm.declare_entry(
        "Tolerance",
        "0",
        Patterns::Double(0, 1e-2),
        "Residual of the equilibrium relative to the internal forces. 0: 1e-9; in space 1e-5 of "
        "the target error, 1e-9 to 1e-6. At least 1e-14.");
    prm.add_action("Tolerance", [this](const std::string &text) {
      if (const double value = Utilities::string_to_double(text); value > 0)
        {
          tolerance          = std::max(value, 1e-14);
          tolerance_is_given = true;
        }
    });
    prm.add_parameter(
        "Complementarity factor",
        scaling,
        "Multiplies the complementarity parameter c = E/h; neither the result nor the number of "
        "iterations should depend on it.",
        Patterns::Double(1e-8, 1e8));
    prm.add_parameter(
        "Method",
        method,
        "How surfaces are coupled: mortar (dual multipliers), or, to compare with, penalty (bodies "
        "overlap), augmented Lagrangian (penalty, and multipliers that Uzawa's iteration updates), "
        "fixed-point friction (bounds of friction from the solve before), node-to-segment (nodes touch "
        "faces; small strain) or seed (the iteration of Siminiati's paper; small strain).",
        Patterns::Selection("mortar|penalty|augmented Lagrangian|fixed-point friction|node-to-segment|seed"));
    prm.add_parameter("Penalty factor",
                      penalty,
                      "Penalty and augmented Lagrangian: contact stiffness over E/((1 - nu^2) h), h the size "
                      "of slave faces.",
                      Patterns::Double(1e-8, 1e12));
    prm.leave_subsection();
  }

  void
  NewtonParameters::suit_target(const double target_error)
  {
    if (!tolerance_is_given && method == "mortar")
      tolerance = std::clamp(1e-5 * target_error, tolerance, 1e-6);
  }

  template <int dim>
  ContactConstraints
  constraints_of(const ContactEquilibrium<dim> &problem,
                 const Constraints             &supports,
                 const NodeStates<dim>         &states,
                 std::vector<unsigned int>     *first)
  {
    const auto                  &contact = problem.contact;
    std::vector<ContactEquation> equations;
    if (first != nullptr)
      first->assign(contact.nodes().size(), numbers::invalid_unsigned_int);
    for (unsigned int k = 0; k < contact.nodes().size(); ++k)
      if (states[k] != ContactStatus::open && problem.by_equations(k))
        {
          if (first != nullptr)
            (*first)[k] = equations.size();
          for (auto &equation : contact.equations(k, states[k], states.law(k)))
            equations.push_back(std::move(equation));
        }
    return ContactConstraints(supports, equations);
  }

  template <int dim>
  LA::Vector
  known_contact_forces(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now)
  {
    const auto &contact = problem.contact;
    LA::Vector  forces  = problem.discretization.make_owned_vector();
    for (unsigned int k = 0; k < now.laws.size(); ++k)
      if (now.states[k] != ContactStatus::open && !problem.by_equations(k))
        problem.penalty->add_forces(k, now.states, forces);
      else if (contact.nodes()[k].frictional && now.states[k] == ContactStatus::slip &&
               contact.is_opposite(k))
        add_known_shear_forces(contact.nodes()[k],
                               now.laws[k],
                               contact.slip(k, problem.state.displacement),
                               problem.discretization.locally_owned,
                               forces);
    forces.compress(VectorOperation::add);
    return forces;
  }

  namespace
  {
    template <int dim>
    NodalContact<dim>
    nodal_answer(const ContactEquilibrium<dim> &problem,
                 const Iterate<dim>            &now,
                 const unsigned int             k,
                 const std::vector<double>     &multipliers)
    {
      const auto &node = problem.contact.nodes()[k];
      const auto &u    = problem.state.displacement;
      if (!problem.by_equations(k))
        return problem.penalty->answer(k, now.states);
      if (now.states[k] == ContactStatus::open)
        {
          NodalContact<dim> result;
          result.gap = problem.contact.open_gap(k, u);
          if (node.frictional && problem.contact.is_opposite(k)) // where its law starts if it closes
            result.slip = problem.contact.slip(k, u);
          return result;
        }
      const unsigned int e           = now.first_equation[k];
      const bool         has_a_pivot = now.constraints->pivots()[e].has_value();
      return answer_of_closed(node,
                              now.states[k],
                              now.laws[k],
                              node.frictional ? problem.contact.slip(k, u) : Tensor<1, dim>(),
                              has_a_pivot ? 0. : problem.contact.gap(k, u),
                              has_a_pivot,
                              &multipliers[e]);
    }
  } // namespace

  template <int dim>
  NodalContacts<dim>
  nodal_answers(const ContactEquilibrium<dim> &problem,
                const Iterate<dim>            &now,
                const Constraints             &supports,
                const LA::Vector              &unbalanced)
  {
    const auto         multipliers = multipliers_of(unbalanced, supports, *now.constraints);
    NodalContacts<dim> result;
    for (unsigned int k = 0; k < problem.contact.nodes().size(); ++k)
      result.push_back(nodal_answer(problem, now, k, multipliers));
    return result;
  }

  template <int dim>
  LA::Vector
  what_rounding_sees(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now)
  {
    const auto &u = problem.state.displacement;
    if (!problem.mechanics.is_linear())
      return u;
    LA::Vector  result = now.u, readable = problem.discretization.make_relevant_vector();
    const auto &pivots = now.constraints->pivots();
    for (unsigned int e = 0; e < pivots.size(); ++e)
      if (pivots[e] && problem.discretization.locally_owned.is_element(*pivots[e]))
        {
          const auto &equation = now.constraints->equations()[e].equation;
          double      sum      = std::abs(equation.value);
          for (const auto &[dof, weight] : equation.coefficients)
            sum += std::abs(weight * u(dof));
          sum /= std::abs(equation.coefficients.at(*pivots[e]));
          result(*pivots[e]) = std::max(sum, std::abs(u(*pivots[e])));
        }
    result.compress(VectorOperation::insert);
    readable = result;
    return readable;
  }

  template <int dim>
  std::optional<double>
  turns_to_contact(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now, const LA::Vector &change)
  {
    LA::Vector readable = problem.discretization.make_relevant_vector();
    readable            = change;
    std::optional<double> turns;
    for (unsigned int k = 0; k < now.answers.size(); ++k)
      if (now.states[k] == ContactStatus::open)
        if (const double nearer = evaluate(problem.contact.nodes()[k].closing.equation, readable);
            nearer > 1e-6 * change.linfty_norm())
          turns = std::min(turns.value_or(std::numeric_limits<double>::max()), now.answers[k].gap / nearer);
    return turns;
  }

  template <int dim>
  std::optional<Flight>
  flight_to_contact(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now, const LA::Vector &change)
  {
    LA::Vector readable          = problem.discretization.make_relevant_vector();
    readable                     = change;
    bool                overlaps = false;
    std::vector<double> parts(now.answers.size(), std::numeric_limits<double>::infinity());
    for (unsigned int k = 0; k < now.answers.size(); ++k)
      if (now.states[k] == ContactStatus::open)
        {
          const auto  &node = problem.contact.nodes()[k];
          const double gap = now.answers[k].gap, nearer = evaluate(node.closing.equation, readable);
          if (nearer <= 0 || nearer <= gap)
            continue;
          parts[k] = std::max(gap / nearer, 0.);
          overlaps = overlaps || nearer - gap > problem.interfaces[node.interface].slave->mean_size;
        }
    if (!overlaps)
      return {};
    Flight flight;
    flight.part = *std::min_element(parts.begin(), parts.end());
    for (unsigned int k = 0; k < parts.size(); ++k)
      if (parts[k] <= (1 + 1e-6) * flight.part)
        flight.nodes.push_back(k);
    return flight;
  }

  template <int dim>
  void
  count_states(const ContactEquilibrium<dim> &problem,
               const NodeStates<dim>         &states,
               NewtonReport::Iteration       &line)
  {
    for (unsigned int k = 0; k < problem.contact.nodes().size(); ++k)
      if (problem.contact.is_opposite(k))
        (states[k] == ContactStatus::open    ? line.n_open
         : states[k] == ContactStatus::stick ? line.n_stick
                                             : line.n_slip) += 1;
  }

  template ContactConstraints
  constraints_of(const ContactEquilibrium<2> &,
                 const Constraints &,
                 const NodeStates<2> &,
                 std::vector<unsigned int> *);
  template ContactConstraints
  constraints_of(const ContactEquilibrium<3> &,
                 const Constraints &,
                 const NodeStates<3> &,
                 std::vector<unsigned int> *);
  template LA::Vector
  known_contact_forces(const ContactEquilibrium<2> &, const Iterate<2> &);
  template LA::Vector
  known_contact_forces(const ContactEquilibrium<3> &, const Iterate<3> &);
  template NodalContacts<2>
  nodal_answers(const ContactEquilibrium<2> &, const Iterate<2> &, const Constraints &, const LA::Vector &);
  template NodalContacts<3>
  nodal_answers(const ContactEquilibrium<3> &, const Iterate<3> &, const Constraints &, const LA::Vector &);
  template LA::Vector
  what_rounding_sees(const ContactEquilibrium<2> &, const Iterate<2> &);
  template LA::Vector
  what_rounding_sees(const ContactEquilibrium<3> &, const Iterate<3> &);
  template std::optional<double>
  turns_to_contact(const ContactEquilibrium<2> &, const Iterate<2> &, const LA::Vector &);
  template std::optional<Flight>
  flight_to_contact(const ContactEquilibrium<2> &, const Iterate<2> &, const LA::Vector &);
  template void
  count_states(const ContactEquilibrium<2> &, const NodeStates<2> &, NewtonReport::Iteration &);
  template std::optional<double>
  turns_to_contact(const ContactEquilibrium<3> &, const Iterate<3> &, const LA::Vector &);
  template std::optional<Flight>
  flight_to_contact(const ContactEquilibrium<3> &, const Iterate<3> &, const LA::Vector &);
  template void
  count_states(const ContactEquilibrium<3> &, const NodeStates<3> &, NewtonReport::Iteration &);
} // namespace Amontons
