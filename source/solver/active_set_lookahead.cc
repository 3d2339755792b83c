#include <amontons/solver/active_set_lookahead.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace Amontons
{
  namespace
  {
    // The side of an equation that depends on the answer, as a length.
    template <int dim>
    double
    statement(const SlaveNode<dim>    &node,
              const ContactStatus      state,
              const SlipLaw<dim>      &law,
              const NodalContact<dim> &answer,
              const NodeInput          input)
    {
      if (input == NodeInput::across)
        return state == ContactStatus::open ? answer.pressure / node.c : answer.gap;
      const auto tangent = tangent_of(node, input);
      if (state == ContactStatus::stick)
        return answer.slip * tangent;
      auto beyond = answer.shear;
      if (state == ContactStatus::slip)
        beyond -= law.traction(answer.pressure, answer.slip) - law.constant * law.direction;
      return beyond * tangent / node.c;
    }

    template <int dim>
    double
    required(const SlaveNode<dim> &node,
             const ContactStatus   state,
             const SlipLaw<dim>   &law,
             const NodeInput       input)
    {
      const bool slips = input != NodeInput::across && state == ContactStatus::slip;
      return slips ? law.constant * (law.direction * tangent_of(node, input)) / node.c : 0.;
    }

    template <int dim>
    bool
    differ(const SlipLaw<dim> &a, const SlipLaw<dim> &b)
    {
      return (a.direction - b.direction).norm() > 1e-10 || std::abs(a.slope - b.slope) > 1e-10 ||
             std::abs(a.constant - b.constant) > 1e-10 * std::abs(a.constant) ||
             std::abs(a.stiffness - b.stiffness) > 1e-10 * std::abs(a.stiffness);
    }

    // Inputs that lead from some states and laws to these.
    template <int dim>
    std::vector<ContactInput>
    inputs_between(const BaseSolution<dim>          &base,
                   const std::vector<ContactStatus> &from,
                   const std::vector<SlipLaw<dim>>  &laws,
                   const NodeStates<dim>            &to)
    {
      std::vector<ContactInput> result;
      for (unsigned int k = 0; k < from.size(); ++k)
        {
          const bool slips_otherwise = to[k] == ContactStatus::slip && differ(to.law(k), laws[k]);
          if ((to[k] == ContactStatus::open) != (from[k] == ContactStatus::open))
            result.emplace_back(k, NodeInput::across);
          const auto &node = base.nodes[k];
          if (node.frictional && (base.movable[k] || (dim == 3 && !node.planes.empty())) &&
              (to[k] != from[k] || slips_otherwise))
            for (const auto input : {NodeInput::along, NodeInput::beside})
              if ((dim == 3 || input == NodeInput::along) && tangent_of(node, input).norm() > 0)
                result.emplace_back(k, input);
        }
      return result;
    }

    template <int dim>
    void
    add(const double factor, const NodalContacts<dim> &response, NodalContacts<dim> &sum)
    {
      for (unsigned int k = 0; k < sum.size(); ++k)
        {
          sum[k].pressure += factor * response[k].pressure;
          sum[k].gap += factor * response[k].gap;
          sum[k].shear += factor * response[k].shear;
          sum[k].slip += factor * response[k].slip;
        }
    }

    // Inputs that do nothing, since a support owns the node there, are zero.
    bool
    solve(FullMatrix<double> &matrix, Vector<double> &x)
    {
      LAPACKFullMatrix<double> factors(matrix.m());
      for (unsigned int i = 0; i < matrix.m(); ++i)
        {
          double largest = 0;
          for (unsigned int j = 0; j < matrix.n(); ++j)
            largest = std::max(largest, std::abs(matrix(i, j)));
          if (largest == 0)
            {
              matrix(i, i) = 1;
              x[i]         = 0;
            }
        }
      factors = matrix;
      try
        {
          factors.compute_lu_factorization();
          factors.solve(x);
        }
      catch (const LACExceptions::ExcSingular &)
        {
          return false;
        }
      return true;
    }
  } // namespace

  template <int dim>
  ActiveSetLookahead<dim>::ActiveSetLookahead(const BaseSolution<dim> &base,
                                              const Respond           &respond,
                                              const unsigned int       n_most,
                                              Responses<dim>          &responses)
      : base(base), respond(respond), n_most(n_most), responses(responses)
  {
  }

  template <int dim>
  unsigned int
  ActiveSetLookahead<dim>::n_unknown(const NodeStates<dim> &states) const
  {
    const auto all = inputs_between(base, base.states, base.laws, states);
    return std::count_if(
        all.begin(), all.end(), [&](const ContactInput &input) { return responses.count(input) == 0; });
  }

  template <int dim>
  std::optional<std::map<ContactInput, double>>
  ActiveSetLookahead<dim>::inputs(const NodeStates<dim> &states)
  {
    const auto                rows = inputs_between(base, base.states, base.laws, states);
    std::vector<ContactInput> unknown;
    for (const auto &input : rows)
      if (responses.count(input) == 0)
        unknown.push_back(input);
    if (responses.size() + unknown.size() > n_most)
      return {};
    if (!unknown.empty())
      {
        auto found = respond(unknown);
        for (unsigned int i = 0; i < unknown.size(); ++i)
          responses.emplace(unknown[i], std::move(found[i]));
        n_new += unknown.size();
      }
    std::vector<const NodalContacts<dim> *> columns;
    columns.reserve(rows.size());
    for (const auto &input : rows)
      columns.push_back(&responses.at(input));
    FullMatrix<double> matrix(rows.size());
    Vector<double>     x(rows.size());
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        const auto [k, input] = rows[i];
        const auto &node      = base.nodes[k];
        x[i]                  = required(node, states[k], states.law(k), input) -
               statement(node, states[k], states.law(k), base.answers[k], input);
        for (unsigned int j = 0; j < rows.size(); ++j)
          matrix(i, j) = statement(node, states[k], states.law(k), (*columns[j])[k], input);
      }
    if (!rows.empty() && !solve(matrix, x))
      return {};
    std::map<ContactInput, double> result;
    for (unsigned int i = 0; i < rows.size(); ++i)
      result[rows[i]] = x[i];
    return result;
  }

  template <int dim>
  std::optional<NodalContacts<dim>>
  ActiveSetLookahead<dim>::answers(const NodeStates<dim> &states)
  {
    const auto x = inputs(states);
    if (!x)
      return {};
    auto result = base.answers;
    for (const auto &[input, factor] : *x)
      add(factor, responses.at(input), result);
    return result;
  }

  template <int dim>
  bool
  ActiveSetLookahead<dim>::lead(NodeStates<dim>                  &states,
                                const std::vector<ContactStatus> &before,
                                const std::vector<SlipLaw<dim>>  &laws_before,
                                const double                      rounding,
                                const unsigned int                n_most_updates)
  {
    bool goes_on = true;
    for (unsigned int n = 0; n < n_most_updates && goes_on && states.free_rigid_modes().empty(); ++n)
      {
        const auto next = answers(states);
        goes_on         = next && (states.update(*next, rounding) > 0 || states.frozen());
      }
    return !inputs_between(base, before, laws_before, states).empty();
  }

  template class ActiveSetLookahead<2>;
  template class ActiveSetLookahead<3>;
} // namespace Amontons
