#include <amontons/solver/stored_states.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    Tensor<1, 3>
    padded(const Tensor<1, dim> &vector)
    {
      Tensor<1, 3> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = vector[d];
      return result;
    }

    // (shear + c slip)/bound; bounded, as it will be interpolated: where the pressure vanishes the ratio has
    // none.
    template <int dim>
    Tensor<1, dim>
    trial_over_bound(const CandidateNode<dim> &node, const NodeAnswer<dim> &answer, const double bound)
    {
      if (bound <= 0)
        return Tensor<1, dim>();
      const auto trial = (answer.shear + node.c * answer.slip) / bound;
      return trial * std::min(1., 3 / std::max(trial.norm(), 1e-100));
    }
  } // namespace

  template <int dim>
  void
  store_states(const std::vector<CandidateNode<dim>>    &nodes,
               const NodeStates<dim>                    &states,
               const std::vector<NodeAnswer<dim>>       &answers,
               const std::vector<ContactInterface<dim>> &interfaces,
               SolutionState                            &state)
  {
    const auto clear = [&](auto &lists) {
      lists.assign(interfaces.size(), {});
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        lists[i].resize(interfaces[i].coupling.rows.size());
    };
    clear(state.states);
    clear(state.pressures);
    clear(state.gaps);
    clear(state.shears);
    clear(state.trials);
    clear(state.slips);
    state.carried.clear();
    for (const auto &interface : interfaces)
      state.carried.push_back(interface.carried);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (const unsigned int r = nodes[k].row; r != numbers::invalid_unsigned_int)
        {
          const unsigned int    i      = nodes[k].interface;
          const NodeAnswer<dim> answer = std::isfinite(answers[k].pressure) ? answers[k] : NodeAnswer<dim>();
          state.states[i][r]           = states[k];
          state.gaps[i][r]             = answer.gap;
          state.pressures[i][r]        = answer.pressure;
          state.shears[i][r]           = padded(answer.shear);
          state.slips[i][r]            = padded(answer.slip);
          if (nodes[k].frictional && states[k] != ContactState::open)
            state.trials[i][r] =
                padded(trial_over_bound(nodes[k], answer, states.bound(k, answer.pressure).value));
        }
  }

  template <int dim>
  void
  fit_states(const std::vector<ContactInterface<dim>> &interfaces, SolutionState &state)
  {
    const auto carried_before = state.carried;
    state.carried.clear();
    for (const auto &interface : interfaces)
      state.carried.push_back(interface.carried);
    if (carried_before.size() != interfaces.size() || carried_before == state.carried)
      return;
    const auto fit = [&](auto &lists) {
      for (unsigned int i = 0; i < interfaces.size() && lists.size() == interfaces.size(); ++i)
        {
          const auto &rows = interfaces[i].coupling.rows;
          const auto  old  = lists[i];
          lists[i].assign(rows.size(), {});
          std::vector<unsigned int> place(carried_before[i].size()); // rows are in the order of the nodes
          for (unsigned int n = 0, r = 0; n < place.size(); ++n)
            place[n] = carried_before[i][n] ? r++ : numbers::invalid_unsigned_int;
          for (unsigned int r = 0; r < rows.size(); ++r)
            if (rows[r].node < place.size() && place[rows[r].node] < old.size())
              lists[i][r] = old[place[rows[r].node]];
        }
    };
    fit(state.states);
    fit(state.pressures);
    fit(state.gaps);
    fit(state.shears);
    fit(state.trials);
    fit(state.slips);
  }

  template void
  fit_states(const std::vector<ContactInterface<2>> &, SolutionState &);
  template void
  fit_states(const std::vector<ContactInterface<3>> &, SolutionState &);
  template void
  store_states(const std::vector<CandidateNode<2>> &,
               const NodeStates<2> &,
               const std::vector<NodeAnswer<2>> &,
               const std::vector<ContactInterface<2>> &,
               SolutionState &);
  template void
  store_states(const std::vector<CandidateNode<3>> &,
               const NodeStates<3> &,
               const std::vector<NodeAnswer<3>> &,
               const std::vector<ContactInterface<3>> &,
               SolutionState &);
} // namespace Amontons
