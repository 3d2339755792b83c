#include <amontons/solver/diagnosis.h>
#include <amontons/solver/newton_residual.h>
#include <amontons/solver/pseudo_transient.h>

namespace Amontons
{
  namespace
  {
    // Of the nodes of quadratic elements between vertices: how far they are from where the vertices would
    // have them, against how far they move; root mean squares.
    template <int dim>
    double
    swing_between_vertices(const Discretization<dim> &discretization, const LA::Vector &shape)
    {
      const auto &fe    = discretization.fe;
      LA::Vector  moved = discretization.make_relevant_vector();
      moved             = shape;
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      std::vector<double>                  squares(2, 0.);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = dim * GeometryInfo<dim>::vertices_per_cell; i < dofs.size(); ++i)
              {
                double by_vertices = 0;
                for (const unsigned int v : cell->vertex_indices())
                  by_vertices += GeometryInfo<dim>::d_linear_shape_function(fe.unit_support_point(i), v) *
                                 moved(cell->vertex_dof_index(v, fe.system_to_component_index(i).first));
                squares[0] += std::pow(moved(dofs[i]) - by_vertices, 2);
                squares[1] += std::pow(moved(dofs[i]), 2);
              }
          }
      Utilities::MPI::sum(squares, discretization.geometry.communicator, squares);
      return squares[1] > 0 ? std::sqrt(squares[0] / squares[1]) : 0;
    }
  } // namespace

  template <int dim>
  PseudoTransient<dim>::PseudoTransient(const ContactEquilibrium<dim> &problem,
                                        NewtonStep<dim>               &step,
                                        Newton<dim>                   &newton)
      : problem(problem), step(step), newton(newton)
  {
  }

  template <int dim>
  NewtonReport
  PseudoTransient<dim>::run(const FollowMotion when)
  {
    if (!newton.prepare())
      return newton.report();
    const LA::Vector start         = newton.now().u;
    const auto       first_answers = newton.now().answers;
    if (when == FollowMotion::from_start)
      follow_motion(1);
    else
      newton.iterate();
    for (unsigned int n = 0; n < 4 && newton.report().converged; ++n)
      {
        const auto mode = unstable_mode();
        if (!mode)
          break;
        if (swing_between_vertices(problem.discretization, mode->shape) > 1)
          {
            newton.report().add_note("a mode of the mesh is unstable, in which nodes between vertices swing "
                                     "along a curved surface under high pressure: it is not followed");
            break;
          }
        newton.report().unstable = true;
        if (when == FollowMotion::never)
          {
            newton.report().converged = false;
            newton.report().failure   = Failure{Failure::Kind::still_moving};
            break;
          }
        if (newton.report().moved)
          leave_along(*mode);
        else
          {
            newton.put(start);
            newton.guess_again(first_answers);
            follow_motion(1);
          }
      }
    return newton.finish();
  }

  // From here on, until nothing moves.
  template <int dim>
  void
  PseudoTransient<dim>::follow_motion(const double first_step)
  {
    constexpr unsigned int max_iterations  = 300;
    auto                  &report          = newton.report();
    const unsigned int     first           = report.iterations.size();
    double                 residual        = 0;
    auto                   no_balance_here = Diagnosis::friction_beyond_limit(newton.now().states);
    if (!no_balance_here)
      no_balance_here = Diagnosis::friction_at_limit(newton.now().states);
    report.converged = false;
    report.moved     = true;
    damping          = lumped_damping(problem.discretization);
    steps.emplace(first_step);
    newton.set_drag(&drag);
    while (report.goes_on())
      {
        const LA::Vector start = newton.now().u;
        if (report.iterations.size() > first + max_iterations)
          report.failure = newton.now().free_modes.empty()
                               ? Failure{Failure::Kind::still_moving, max_iterations, residual}
                               : Diagnosis::moves_apart(newton.now().states, newton.now().free_modes);
        else if (move_on())
          {
            const double now = report.iterations.back().residual;
            newton.stop_or_go_on();
            steps->accept(residual / now);
            residual = now;
          }
        else
          go_back(start);
      }
    newton.set_drag(nullptr);
    if (!report.converged && no_balance_here) // it may move to where there is one
      report.failure = no_balance_here;
  }

  // One step of implicit Euler,  D (u - start)/dtau + internal - contact forces = loads, with the states of
  // its end; false: it is too long.
  template <int dim>
  bool
  PseudoTransient<dim>::move_on()
  {
    constexpr unsigned int max_iterations = 8;
    drag.reference                        = newton.now().u;
    drag.values                           = damping.values;
    drag.values /= steps->size();
    newton.states().forget();
    for (unsigned int n = 0; n < max_iterations; ++n)
      {
        const auto goes_downhill = [&](const auto &solved) { return n > 0 || solved.is_downhill; };
        const auto is_short      = [&]() {
          LA::Vector way(newton.now().u);
          way -= drag.reference;
          return way.linfty_norm() <= 0.1 * damping.length;
        };
        if (!newton.turn(1, goes_downhill, is_short))
          return false;
        const auto &last = newton.report().iterations.back();
        if (!std::isfinite(last.residual))
          return false;
        if (last.n_changes == 0 &&
            newton.error_with_drag() <= std::max(0.1 * last.residual, problem.parameters.tolerance) &&
            largest_violation(problem, newton.now()) <= 1e-4)
          return true;
      }
    return false;
  }

  template <int dim>
  void
  PseudoTransient<dim>::go_back(const LA::Vector &start)
  {
    auto &failure = newton.report().failure;
    if (failure && failure->kind == Failure::Kind::given_up)
      return;
    failure.reset();
    if (!newton.put(start) || !steps->reject())
      {
        failure = Failure{Failure::Kind::motion_lost};
        if (newton.last_inversion())
          failure->cell = newton.last_inversion()->cell;
      }
  }

  // With nodes that slip and rub, motion backwards meets another stiffness: not looked at.
  template <int dim>
  std::optional<UnstableMode>
  PseudoTransient<dim>::unstable_mode()
  {
    const auto &nodes = problem.contact.nodes();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (nodes[k].frictional && newton.now().states[k] == ContactStatus::slip)
        return {};
    const auto inverse = step.inverse();
    if (!newton.now().free_modes.empty() || !inverse)
      return {};
    TimerOutput::Scope scope(problem.timer, "stability");
    damping = lumped_damping(problem.discretization);
    if (newton.report().moved)
      {
        newton.linearise();
        if (!newton.solve()) // factorises
          return {};
      }
    return find_unstable_mode(
        [&](LA::Vector &y, const LA::Vector &x) {
          LA::Vector force(x);
          force.scale(damping.values);
          return inverse(y, force);
        },
        damping.values);
  }

  // From an unstable equilibrium that the motion itself led to: the way that the increment pushes, if any.
  template <int dim>
  void
  PseudoTransient<dim>::leave_along(const UnstableMode &mode)
  {
    LA::Vector kick(mode.shape);
    kick *= (newton.first_push() * kick < 0 ? -1e-3 : 1e-3) * damping.length;
    if (newton.advance(kick))
      follow_motion(0.5 / mode.rate);
    else
      newton.report().converged = false;
  }

  template class PseudoTransient<2>;
  template class PseudoTransient<3>;
} // namespace Amontons
