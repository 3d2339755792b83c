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
      : discretization(discretization), elasticity(elasticity), supports(supports), constraints(constraints),
        first_equation(first_equation), base(base), matrix(matrix), solver(solver)
  {
    for (const auto &pivot : constraints.pivots())
      if (pivot)
        equations_of_pivot[*pivot];
    for (unsigned int e = 0; e < constraints.equations().size(); ++e)
      for (const auto &[dof, coefficient] : constraints.equations()[e].equation.coefficients)
        if (const auto pivot = equations_of_pivot.find(dof); pivot != equations_of_pivot.end())
          pivot->second.emplace_back(e, coefficient);
  }

  template <int dim>
  NodalContacts<dim>
  ContactCompliance<dim>::respond(const unsigned int node, const NodeInput input, LA::Vector *motion) const
  {
    const auto &n      = base.nodes[node];
    const auto  state  = base.states[node];
    const bool  across = input == NodeInput::across;
    if (state == ContactStatus::stick || (state == ContactStatus::slip && across))
      return answers(displacement_of(node, across ? n.normal / n.normal.norm_square() : n.tangent()),
                     discretization.make_owned_vector(),
                     motion);
    const Tensor<1, dim> traction = n.c * (across ? n.normal : n.tangent());
    auto result = answers(discretization.make_owned_vector(), force_of(node, traction), motion);
    if (across)
      result[node].pressure += n.c;
    else
      result[node].shear += traction;
    return result;
  }

  template <int dim>
  LA::Vector
  ContactCompliance<dim>::internal_forces(const LA::Vector &w) const
  {
    LA::Vector readable = discretization.make_relevant_vector();
    readable            = w;
    return elasticity.internal_forces(readable);
  }

  template <int dim>
  NodalContacts<dim>
  ContactCompliance<dim>::answers(const LA::Vector &offset, const LA::Vector &force, LA::Vector *motion) const
  {
    LA::Vector unbalanced(force), dw = discretization.make_owned_vector(), rhs = dw;
    if (offset.linfty_norm() > 0)
      unbalanced -= internal_forces(offset);
    rhs = condense(unbalanced, constraints.test(), force);
    zero_constrained(constraints.test(), discretization.locally_owned, rhs);
    solver.solve(matrix, dw, rhs, 0);
    // The base obeys the constraints: what they add to it and dw is C dw.
    dw += base.displacement;
    constraints.trial().distribute(dw);
    dw -= base.displacement;
    dw += offset;
    if (motion != nullptr)
      *motion = dw;
    unbalanced = internal_forces(dw);
    unbalanced -= force;
    const auto mu       = multipliers_of(unbalanced, supports, constraints);
    LA::Vector readable = discretization.make_relevant_vector();
    readable            = dw;
    NodalContacts<dim> result;
    for (unsigned int k = 0; k < base.nodes.size(); ++k)
      result.push_back(answer(k, readable, mu));
    return result;
  }

  // Moves pivots so that the jump of a closed node changes and that of no other. An equation may contain
  // pivots of others (quadratic faces, chains of pairs): their nodes follow.
  template <int dim>
  LA::Vector
  ContactCompliance<dim>::displacement_of(const unsigned int node, const Tensor<1, dim> &jump) const
  {
    std::deque<std::pair<unsigned int, double>> missing; // equation and value
    if (base.states[node] == ContactStatus::slip)
      missing.emplace_back(first_equation[node], jump * base.nodes[node].normal);
    else
      for (unsigned int c = 0; c < dim; ++c)
        missing.emplace_back(first_equation[node] + c, jump * base.nodes[node].directions[c]);
    Coefficients moved;
    for (unsigned int n = 0; n < 1000 && !missing.empty(); ++n)
      {
        const auto [e, value] = missing.front();
        missing.pop_front();
        if (!constraints.pivots()[e] || std::abs(value) < 1e-14 * jump.norm())
          continue;
        const auto   pivot = *constraints.pivots()[e];
        const double step  = value / constraints.equations()[e].equation.coefficients.at(pivot);
        moved[pivot] += step;
        for (const auto &[other, coefficient] : equations_of_pivot.at(pivot))
          if (other != e)
            missing.emplace_back(other, -coefficient * step);
      }
    const auto motion = [&](const types::global_dof_index dof) {
      const auto pivot = moved.find(dof);
      return pivot == moved.end() ? 0. : pivot->second;
    };
    LA::Vector w = discretization.make_owned_vector();
    for (const auto dof : discretization.locally_owned)
      {
        double value = motion(dof);
        if (supports.is_constrained(dof))
          for (const auto &[other, weight] : *supports.get_constraint_entries(dof))
            value += weight * motion(other);
        if (value != 0)
          w(dof) = value;
      }
    w.compress(VectorOperation::insert);
    return w;
  }

  template <int dim>
  LA::Vector
  ContactCompliance<dim>::force_of(const unsigned int node, const Tensor<1, dim> &traction) const
  {
    const auto &n      = base.nodes[node];
    LA::Vector  forces = discretization.make_owned_vector();
    const auto  add    = [&](const ContactEquation &jump, const double t) {
      for (const auto &[dof, weight] : jump.equation.coefficients)
        if (discretization.locally_owned.is_element(dof))
          forces(dof) -= n.area * t * weight;
    };
    if (!n.frictional)
      add(n.closing, traction * n.normal / n.normal.norm_square());
    else
      for (unsigned int c = 0; c < dim; ++c)
        add(n.components[c], traction[c]);
    forces.compress(VectorOperation::add);
    return forces;
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
      result.shear = base.laws[k].slope * result.pressure * base.laws[k].direction;
    return result;
  }

  template class ContactCompliance<2>;
  template class ContactCompliance<3>;
} // namespace Amontons
