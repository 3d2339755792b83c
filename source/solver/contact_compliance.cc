#include <amontons/solver/contact_compliance.h>

#include <deque>

namespace Amontons
{
  std::vector<double>
  multipliers_of(const LA::Vector         &unbalanced,
                 const Constraints        &supports,
                 const ContactConstraints &constraints)
  {
    const LA::Vector    on_supports = condense(unbalanced, supports, unbalanced);
    std::vector<double> at_pivots(constraints.pivots().size(), 0.);
    for (unsigned int e = 0; e < at_pivots.size(); ++e)
      if (const auto pivot = constraints.pivots()[e];
          pivot && unbalanced.locally_owned_elements().is_element(*pivot))
        at_pivots[e] = on_supports(*pivot);
    Utilities::MPI::sum(at_pivots, unbalanced.get_mpi_communicator(), at_pivots);
    return constraints.recover_multipliers(at_pivots);
  }

  template <int dim>
  ContactCompliance<dim>::ContactCompliance(const Discretization<dim>       &discretization,
                                            const ElasticityOperator<dim>   &elasticity,
                                            const Constraints               &supports,
                                            const ContactConstraints        &constraints,
                                            const std::vector<unsigned int> &first_equation,
                                            const BaseSolution<dim>         &base,
                                            const LA::SparseMatrix          &matrix,
                                            LinearSolver                    &solver)
      : discretization(discretization), elasticity(elasticity), constraints(constraints),
        first_equation(first_equation), base(base), matrix(matrix), solver(solver),
        readable(discretization.make_relevant_vector())
  {
    std::set<types::global_dof_index> at_pivots;
    for (const auto &pivot : constraints.pivots())
      if (pivot)
        {
          equations_of_pivot[*pivot];
          hanging_on_pivot[*pivot];
          at_pivots.insert(*pivot);
        }
    for (unsigned int e = 0; e < constraints.equations().size(); ++e)
      for (const auto &[dof, coefficient] : constraints.equations()[e].equation.coefficients)
        if (const auto pivot = equations_of_pivot.find(dof); pivot != equations_of_pivot.end())
          pivot->second.emplace_back(e, coefficient);
    for (const auto &line : supports.get_lines())
      for (const auto &[dof, weight] : line.entries)
        if (const auto pivot = hanging_on_pivot.find(dof); pivot != hanging_on_pivot.end())
          {
            pivot->second[line.index] = weight;
            at_pivots.insert(line.index);
          }
    cells_at_pivots = elasticity.cells_with(at_pivots);
  }

  template <int dim>
  std::vector<NodalContacts<dim>>
  ContactCompliance<dim>::respond(const std::vector<ContactInput> &inputs) const
  {
    constexpr unsigned int          n_at_once = 32; // more are not faster
    std::vector<NodalContacts<dim>> result;
    while (result.size() < inputs.size())
      {
        const unsigned int first = result.size();
        std::vector<Load>  loads(std::min<std::size_t>(n_at_once, inputs.size() - first));
        for (unsigned int i = 0; i < loads.size(); ++i)
          add(inputs[first + i], 1, loads[i]);
        const auto w = motions(loads);
        for (unsigned int i = 0; i < loads.size(); ++i)
          {
            const auto [node, input] = inputs[first + i];
            result.push_back(answers(loads[i], w[i]));
            if (loads[i].force.empty())
              continue;
            auto &own = result.back()[node];
            if (input == NodeInput::across)
              own.pressure += base.nodes[node].c;
            else
              own.shear += base.nodes[node].c * tangent_of(base.nodes[node], input);
          }
      }
    return result;
  }

  template <int dim>
  LA::Vector
  ContactCompliance<dim>::motion(const std::map<ContactInput, double> &inputs) const
  {
    std::vector<Load> all(1);
    for (const auto &[input, factor] : inputs)
      add(input, factor, all[0]);
    return motions(all)[0];
  }

  template <int dim>
  void
  ContactCompliance<dim>::add(const ContactInput &input, const double factor, Load &load) const
  {
    const auto [node, direction] = input;
    const auto &n                = base.nodes[node];
    const auto  state            = base.states[node];
    const bool  across           = direction == NodeInput::across;
    if (state == ContactStatus::stick || (state == ContactStatus::slip && across))
      add_offset(node,
                 factor * (across ? n.normal / n.normal.norm_square() : tangent_of(n, direction)),
                 load.offset);
    else
      add_force(node, factor * n.c * (across ? n.normal : tangent_of(n, direction)), load.force);
  }

  template <int dim>
  std::vector<LA::Vector>
  ContactCompliance<dim>::motions(const std::vector<Load> &loads) const
  {
    LA::Vector              unbalanced = discretization.make_owned_vector(), w(unbalanced);
    std::vector<LA::Vector> result;
    for (const Load &load : loads)
      {
        unbalanced = 0;
        if (!load.offset.empty())
          {
            w = 0;
            set(load.offset, w);
            readable = w;
            elasticity.add_internal_forces(cells_at_pivots, readable, unbalanced);
            add_shear_stiffness(readable, unbalanced);
            unbalanced *= -1;
          }
        for (const auto &[dof, value] : load.force)
          if (discretization.locally_owned.is_element(dof))
            unbalanced(dof) += value;
        unbalanced.compress(VectorOperation::add);
        result.push_back(condense(unbalanced, constraints.test(), unbalanced));
        zero_constrained(constraints.test(), discretization.locally_owned, result.back());
      }
    solver.solve(matrix, result);
    for (unsigned int i = 0; i < loads.size(); ++i)
      {
        distribute_change(constraints.trial(), result[i], readable);
        if (!loads[i].offset.empty())
          {
            w = 0;
            set(loads[i].offset, w);
            result[i] += w;
          }
      }
    return result;
  }

  template <int dim>
  NodalContacts<dim>
  ContactCompliance<dim>::answers(const Load &load, const LA::Vector &w) const
  {
    readable              = w;
    LA::Vector unbalanced = w;
    unbalanced            = 0;
    elasticity.add_internal_forces(cells_at_pivots, readable, unbalanced);
    add_shear_stiffness(readable, unbalanced);
    const auto at = [&](const types::global_dof_index dof) {
      const auto external = load.force.find(dof);
      return discretization.locally_owned.is_element(dof)
                 ? unbalanced(dof) - (external != load.force.end() ? external->second : 0)
                 : 0;
    };
    std::vector<double> at_pivots(constraints.pivots().size(), 0.);
    for (unsigned int e = 0; e < at_pivots.size(); ++e)
      if (const auto pivot = constraints.pivots()[e])
        {
          at_pivots[e] = at(*pivot);
          for (const auto &[dof, weight] : hanging_on_pivot.at(*pivot))
            at_pivots[e] += weight * at(dof);
        }
    Utilities::MPI::sum(at_pivots, w.get_mpi_communicator(), at_pivots);
    const auto         mu = constraints.recover_multipliers(at_pivots);
    NodalContacts<dim> result;
    for (unsigned int k = 0; k < base.nodes.size(); ++k)
      result.push_back(answer(k, readable, mu));
    return result;
  }

  // Moves pivots so that the jump of a closed node changes and that of no other. An equation may contain
  // pivots of others (quadratic faces, chains of pairs): their nodes follow.
  template <int dim>
  void
  ContactCompliance<dim>::add_offset(const unsigned int    node,
                                     const Tensor<1, dim> &jump,
                                     Coefficients         &offset) const
  {
    std::deque<std::pair<unsigned int, double>> missing; // equation and value
    if (base.states[node] == ContactStatus::slip)
      missing.emplace_back(first_equation[node], jump * base.nodes[node].normal);
    else
      for (unsigned int c = 0; c < dim; ++c)
        missing.emplace_back(first_equation[node] + c, jump * base.nodes[node].directions[c]);
    for (unsigned int n = 0; n < 1000 && !missing.empty(); ++n)
      {
        const auto [e, value] = missing.front();
        missing.pop_front();
        if (!constraints.pivots()[e] || std::abs(value) < 1e-14 * jump.norm())
          continue;
        const auto   pivot = *constraints.pivots()[e];
        const double step  = value / constraints.equations()[e].equation.coefficients.at(pivot);
        offset[pivot] += step;
        Amontons::add(offset, step, hanging_on_pivot.at(pivot));
        for (const auto &[other, coefficient] : equations_of_pivot.at(pivot))
          if (other != e)
            missing.emplace_back(other, -coefficient * step);
      }
  }

  template <int dim>
  void
  ContactCompliance<dim>::add_force(const unsigned int    node,
                                    const Tensor<1, dim> &traction,
                                    Coefficients         &force) const
  {
    const auto &n = base.nodes[node];
    if (!n.frictional)
      Amontons::add(
          force, -n.area * (traction * n.normal / n.normal.norm_square()), n.closing.equation.coefficients);
    else
      for (unsigned int c = 0; c < dim; ++c)
        Amontons::add(force, -n.area * traction[c], n.components[c].equation.coefficients);
  }

  template <int dim>
  void
  ContactCompliance<dim>::set(const Coefficients &values, LA::Vector &owned) const
  {
    for (const auto &[dof, value] : values)
      if (discretization.locally_owned.is_element(dof))
        owned(dof) = value;
    owned.compress(VectorOperation::insert);
  }

  template <int dim>
  void
  ContactCompliance<dim>::add_shear_stiffness(const LA::Vector &w, LA::Vector &unbalanced) const
  {
    for (unsigned int k = 0; dim == 3 && k < base.nodes.size(); ++k)
      {
        const auto &node = base.nodes[k];
        const auto &law  = base.laws[k];
        if (base.states[k] != ContactStatus::slip || !node.frictional || !(law.stiffness > 0))
          continue;
        const auto slip = node.tangential(node.jump(w));
        const auto q    = law.stiffness * (slip - (slip * law.direction) * law.direction);
        for (unsigned int c = 0; c < dim; ++c)
          for (const auto &[dof, weight] : node.components[c].equation.coefficients)
            if (discretization.locally_owned.is_element(dof))
              unbalanced(dof) += node.area * q[c] * weight;
      }
    unbalanced.compress(VectorOperation::add);
  }

  template <int dim>
  NodalContact<dim>
  ContactCompliance<dim>::answer(const unsigned int         k,
                                 const LA::Vector          &w,
                                 const std::vector<double> &mu) const
  {
    NodalContact<dim>     result;
    const SlaveNode<dim> &node = base.nodes[k];
    result.gap                 = -evaluate(node.closing.equation, w);
    if (node.frictional)
      result.slip = node.tangential(node.jump(w));
    if (base.states[k] == ContactStatus::open)
      return result;
    const unsigned int e = first_equation[k];
    if (base.states[k] == ContactStatus::stick)
      {
        set_traction_of_stick(node, &mu[e], result);
        return result;
      }
    result.pressure = mu[e] / node.area;
    if (node.frictional)
      result.shear = base.laws[k].traction(result.pressure, result.slip) -
                     base.laws[k].constant * base.laws[k].direction;
    return result;
  }

  template class ContactCompliance<2>;
  template class ContactCompliance<3>;
} // namespace Amontons
