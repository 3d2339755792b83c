#include <amontons/algebra/rigid_body_modes.h>
#include <amontons/solver/contact_compliance.h>
#include <amontons/solver/row_step.h>

namespace Amontons
{
  namespace
  {
    Constraints
    without_values(const Constraints &constraints)
    {
      Constraints result(constraints);
      for (const auto &line : constraints.get_lines())
        result.set_inhomogeneity(line.index, 0);
      return result;
    }

    LA::Vector
    owned_part(const LA::Vector &relevant, const LA::Vector &like)
    {
      LA::Vector result;
      result.reinit(like);
      result = relevant;
      return result;
    }
  } // namespace

  template <int dim>
  RowStep<dim>::RowStep(const ContactEquilibrium<dim> &problem,
                        MovingContact<dim>            &contact,
                        const double                   smallest_cell)
      : problem(problem), contact(contact), homogeneous(without_values(problem.supports)),
        system(problem.discretization.locally_owned,
               problem.discretization.relevant,
               dim,
               problem.discretization.geometry.communicator),
        solver(problem.solver_parameters, dim, problem.discretization.fe.degree, false, problem.gives_up),
        tangent(smallest_cell)
  {
  }

  template <int dim>
  bool
  RowStep<dim>::is_iterative() const
  {
    return !solver.is_direct(problem.discretization.dof_handler.n_dofs());
  }

  template <int dim>
  void
  RowStep<dim>::prepare(const LA::Vector *)
  {
    if (is_iterative())
      solver.set_near_null_space(rigid_body_modes(problem.discretization));
  }

  template <int dim>
  void
  RowStep<dim>::linearise(Iterate<dim> &now, const LA::Vector *springs, const Drag *drag)
  {
    const auto &steps = now.report.iterations;
    if (steps.size() > 1 && !has_drag)
      tangent.measure(now.u, steps.back().residual * now.force_scale);
    if (drag == nullptr && system_serves_again(now))
      {
        update_rows(now);
        return;
      }
    if (drag != nullptr || !tangent_serves_again(now))
      differentiate(now);
    const auto &u = problem.state.displacement;
    further       = contact.stiffness(now.states, now.answers, u, problem.penalty != nullptr);
    for (unsigned int k = 0; k < contact.nodes().size(); ++k)
      if (now.states[k] != ContactStatus::open && !problem.by_equations(k) &&
          problem.discretization.locally_owned.is_element(contact.nodes()[k].holding()[0]->candidates[0]))
        further.push_back(problem.penalty->stiffness(k, now.states));
    for (auto &matrix : problem.mechanics.stiffness_of_loads(u))
      further.push_back(std::move(matrix));
    write_rows(now);

    TimerOutput::Scope scope(problem.timer, "assemble condensed system");
    if (system.link(homogeneous, *now.constraints, further, rows))
      solver.matrix_changed(LinearSolver::all_rows); // lets go of the matrix
    else
      solver.values_changed();
    LA::Vector sum;
    if (drag != nullptr)
      {
        sum = drag->values;
        if (springs != nullptr)
          sum += *springs;
        springs = &sum;
      }
    system.assemble(problem.mechanics.bodies().tangent(),
                    homogeneous,
                    *now.constraints,
                    further,
                    springs,
                    rows,
                    is_iterative());
    assembled = now.constraints;
    has_drag  = drag != nullptr;
  }

  // Bodies and contact. The pattern of the system knows from the beginning what nodes beside closed ones
  // link: they may close soon.
  template <int dim>
  void
  RowStep<dim>::differentiate(Iterate<dim> &now)
  {
    {
      TimerOutput::Scope scope(problem.timer, "assemble stiffness");
      problem.mechanics.complete(problem.state.displacement);
    }
    tangent.made_at(now.u);
    TimerOutput::Scope scope(problem.timer, "differentiate contact");
    NodeStates<dim>    more(now.states);
    if (now.is_first())
      for (const unsigned int k : contact.neighbours(now.states))
        more.close(k);
    contact.differentiate(more);
    if (now.is_first())
      system.link(homogeneous, constraints_of(problem, homogeneous, more), contact.links(), {});
  }

  template <int dim>
  std::vector<std::optional<types::global_dof_index>>
  RowStep<dim>::pivots_of(const Iterate<dim> &now, const unsigned int k) const
  {
    const auto first = now.constraints->pivots().begin() + now.first_equation[k];
    return {first, first + (now.states[k] == ContactStatus::stick ? dim : 1)};
  }

  template <int dim>
  void
  RowStep<dim>::write_rows(const Iterate<dim> &now)
  {
    rows.clear();
    for (unsigned int k = 0; k < contact.nodes().size(); ++k)
      if (now.states[k] != ContactStatus::open && problem.by_equations(k))
        for (auto &row :
             contact.contact_rows(k, now.states[k], pivots_of(now, k), problem.state.displacement))
          rows.push_back(std::move(row));
  }

  // Their values alone, for the matrix as it is.
  template <int dim>
  void
  RowStep<dim>::update_rows(const Iterate<dim> &now)
  {
    auto row = rows.begin();
    for (unsigned int k = 0; k < contact.nodes().size(); ++k)
      if (now.states[k] != ContactStatus::open && problem.by_equations(k))
        {
          const auto pivots = pivots_of(now, k);
          const auto values = contact.row_values(k, now.states[k], problem.state.displacement);
          for (unsigned int c = 0; c < pivots.size(); ++c)
            if (pivots[c])
              (row++)->equation.value = values[c];
        }
  }

  // Where this is enough for the tolerance, the system stays as it is.
  template <int dim>
  bool
  RowStep<dim>::system_serves_again(const Iterate<dim> &now) const
  {
    return !now.is_first() && now.report.iterations.back().n_changes == 0 && !has_drag &&
           now.free_modes.empty() && now.constraints->pivots() == assembled->pivots() &&
           tangent.expected_contraction(now.u) * now.report.iterations.back().residual <
               0.5 * problem.parameters.tolerance;
  }

  // Where the set moves, residuals do not fall by more than 1e-3 anyway.
  template <int dim>
  bool
  RowStep<dim>::tangent_serves_again(const Iterate<dim> &now) const
  {
    return !now.is_first() && now.report.iterations.back().n_changes > 0 &&
           contact.is_differentiated(now.states) && tangent.strain_since(now.u) < 1e-3;
  }

  // The change of what supports prescribe since u was made.
  template <int dim>
  LA::Vector
  RowStep<dim>::prescribed_change(const Iterate<dim> &now) const
  {
    LA::Vector moved(now.u);
    problem.supports.distribute(moved);
    moved -= now.u;
    LA::Vector result = problem.discretization.make_relevant_vector();
    result            = moved;
    return result;
  }

  // K x with everything that the system holds but for springs and drag; x readable at relevant DoFs.
  template <int dim>
  LA::Vector
  RowStep<dim>::forces_of(const LA::Vector &x) const
  {
    const auto &bodies = problem.mechanics.bodies();
    LA::Vector  forces = problem.discretization.make_owned_vector();
    const auto  add = [&](const FullMatrix<double> &matrix, const auto &row_dofs, const auto &column_dofs) {
      Vector<double> from(column_dofs.size()), to(row_dofs.size());
      for (unsigned int j = 0; j < column_dofs.size(); ++j)
        from[j] = x(column_dofs[j]);
      if (from.all_zero())
        return;
      matrix.vmult(to, from);
      forces.add(row_dofs, to);
    };
    for (unsigned int c = 0; c < bodies.n_cells(); ++c)
      add(bodies.matrix(c), bodies.dofs(c), bodies.dofs(c));
    for (const auto &matrix : further)
      add(matrix.matrix, matrix.rows, matrix.columns);
    forces.compress(VectorOperation::add);
    return forces;
  }

  // Newton's residual goes like its square: the linear one need not be smaller, nor than what the tolerance
  // asks for.
  template <int dim>
  double
  RowStep<dim>::linear_tolerance(const Iterate<dim> &now, const LA::Vector &rhs) const
  {
    if (now.is_first())
      return 1e-4 * rhs.l2_norm();
    const auto  &last = now.report.iterations.back();
    const double r = last.residual, factor = last.n_changes > 0 ? 1e-2 : std::min(1e-3, r);
    return 0.1 * std::max(factor * r, problem.parameters.tolerance) * now.force_scale;
  }

  template <int dim>
  typename RowStep<dim>::Solved
  RowStep<dim>::solve(const Iterate<dim> &now, const Drag *drag)
  {
    const auto &owned    = problem.discretization.locally_owned;
    const auto  change   = prescribed_change(now);
    LA::Vector  residual = known_contact_forces(problem, now);
    residual -= problem.mechanics.unbalanced();
    residual -= *problem.mechanics.forces_of_excess();
    residual -= forces_of(change);
    if (drag != nullptr)
      residual -= drag->force(now.u);
    Solved result;
    result.push = condense(residual, now.constraints->test(), residual);
    zero_constrained(now.constraints->test(), owned, result.push);
    LA::Vector rhs(result.push);
    for (const auto &row : rows)
      if (owned.is_element(row.row))
        rhs(row.row) = system.row_scale(row.row) * (row.equation.value - evaluate(row.equation, change));
    rhs.compress(VectorOperation::insert);

    TimerOutput::Scope scope(problem.timer, "linear solve");
    result.change.reinit(rhs);
    const auto   form      = is_iterative() ? system.eliminated_form() : EliminatedForm();
    const double tolerance = linear_tolerance(now, rhs);
    const auto   report =
        solver.solve(system.matrix(), result.change, rhs, tolerance, is_iterative() ? &form : nullptr);
    tangent.solved(rhs.l2_norm(), tolerance);
    result.linear = report;
    homogeneous.distribute(result.change);
    if (drag != nullptr)
      {
        LA::Vector readable = problem.discretization.make_relevant_vector(), damped(result.change);
        readable            = result.change;
        damped.scale(drag->values);
        result.is_downhill = forces_of(readable) * result.change + damped * result.change > 0;
      }
    result.change += owned_part(change, rhs);
    return result;
  }

  template <int dim>
  bool
  RowStep<dim>::looks_ahead(const Iterate<dim> &now) const
  {
    const auto &steps = now.report.iterations;
    return dim == 2 && !contact.any_friction() && problem.penalty == nullptr && !has_drag &&
           !is_iterative() && now.free_modes.empty() && steps.size() >= 7 && steps.back().residual < 1e-3 &&
           now.constraints->pivots() == assembled->pivots();
  }

  // To a unit of gap of a closed node, or to the pressure node.c of an open one. Surfaces keep their normals:
  // enough to choose a set, which the next step puts to the test.
  template <int dim>
  NodalContacts<dim>
  RowStep<dim>::respond(const Iterate<dim> &now, const BaseSolution<dim> &base, const unsigned int k)
  {
    const auto        &owned = problem.discretization.locally_owned;
    const auto        &nodes = contact.nodes();
    LA::Vector         force = problem.discretization.make_owned_vector(), y = force, rhs = force;
    NodalContacts<dim> result(nodes.size());
    const bool         was_open = base.states[k] == ContactStatus::open;
    if (was_open)
      {
        for (const auto &[dof, weight] : nodes[k].closing.equation.coefficients)
          if (owned.is_element(dof))
            force(dof) -= nodes[k].area * nodes[k].c * weight;
        force.compress(VectorOperation::add);
        rhs = condense(force, assembled->test(), force);
        zero_constrained(assembled->test(), owned, rhs);
      }
    else if (const auto row = pivots_of(now, k)[0]; row && owned.is_element(*row))
      rhs(*row) = -system.row_scale(*row);
    rhs.compress(VectorOperation::insert);
    solver.solve(system.matrix(), y, rhs, 0.);
    homogeneous.distribute(y);
    LA::Vector readable = problem.discretization.make_relevant_vector();
    readable            = y;

    LA::Vector unbalanced = forces_of(readable);
    unbalanced -= force;
    const auto multipliers = multipliers_of(unbalanced, homogeneous, *assembled);
    for (unsigned int j = 0; j < nodes.size(); ++j)
      if (base.states[j] == ContactStatus::open)
        result[j].gap = -evaluate(nodes[j].closing.equation, readable);
      else if (nodes[j].area > 0)
        result[j].pressure = multipliers[now.first_equation[j]] / nodes[j].area;
    if (was_open)
      result[k].pressure += nodes[k].c;
    else
      result[k].gap = 1;
    return result;
  }

  template <int dim>
  unsigned int
  RowStep<dim>::look_ahead(Iterate<dim> &now, const std::vector<ContactStatus> &before, const double rounding)
  {
    if (!looks_ahead(now))
      return 0;
    const unsigned int      n_most = 200, n_most_updates = 1000; // which are dense and small
    TimerOutput::Scope      scope(problem.timer, "condensed contact");
    const BaseSolution<dim> base{
        contact.nodes(), before, now.laws, now.answers, std::vector<bool>(before.size(), true), now.u};
    Responses<dim>          responses;
    ActiveSetLookahead<dim> condensed(
        base,
        [&](const std::vector<ContactInput> &inputs) {
          std::vector<NodalContacts<dim>> answers;
          for (const auto &[k, input] : inputs)
            answers.push_back(respond(now, base, k));
          return answers;
        },
        n_most,
        responses);
    now.states.forget();
    if (!condensed.lead(now.states, before, now.laws, rounding, n_most_updates))
      now.states.update(now.answers, rounding);
    return condensed.n_asked();
  }

  template <int dim>
  std::function<bool(LA::Vector &, const LA::Vector &)>
  RowStep<dim>::inverse()
  {
    if (is_iterative())
      return {};
    return [this](LA::Vector &y, const LA::Vector &force) {
      LA::Vector rhs = condense(force, assembled->test(), force);
      zero_constrained(assembled->test(), problem.discretization.locally_owned, rhs);
      const auto report = solver.solve(system.matrix(), y, rhs, 0.);
      homogeneous.distribute(y);
      return report.success;
    };
  }

  template class RowStep<2>;
  template class RowStep<3>;
} // namespace Amontons
