#include <amontons/solver/fixed_point_friction.h>

namespace Amontons
{
  template <int dim>
  NewtonReport
  FixedPointFriction<dim>::run()
  {
    if (!newton.prepare())
      return newton.report();
    auto &report = newton.report();
    bounds.assign(problem.contact.nodes().size(), needs_friction() ? std::numeric_limits<double>::max() : 0.);
    if (!problem.state.contact.empty())
      update_bounds();
    newton.states().give_bounds(bounds);
    double change = 0;
    while (report.goes_on())
      {
        newton.iterate();
        ++report.n_outer;
        if (report.failure)
          break;
        change           = update_bounds() / newton.now().force_scale;
        report.converged = report.converged && change <= problem.parameters.tolerance;
        if (!report.converged && report.n_outer == problem.parameters.max_iterations)
          report.failure = Failure{Failure::Kind::bounds_unsettled, report.n_outer, change};
        else if (!report.converged)
          {
            newton.states().forget();
            newton.states().give_bounds(bounds);
          }
      }
    return newton.finish();
  }

  // Whether rigid motions are left where all nodes touch and none rubs.
  template <int dim>
  bool
  FixedPointFriction<dim>::needs_friction() const
  {
    NodeStates<dim> all(newton.now().states);
    for (unsigned int k = 0; k < problem.contact.nodes().size(); ++k)
      if (!problem.contact.nodes()[k].tied)
        all.impose(k, ContactStatus::slip);
    return !all.free_rigid_modes().empty();
  }

  // By how much the forces of the bounds change, sqrt sum (area (new - old))^2.
  template <int dim>
  double
  FixedPointFriction<dim>::update_bounds()
  {
    const auto &now   = newton.now();
    const auto &nodes = problem.contact.nodes();
    double      sum   = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (nodes[k].frictional)
        {
          const double next = shear_bound(*problem.interfaces[nodes[k].interface].pair,
                                          nodes[k].X,
                                          problem.state.t,
                                          now.answers[k].pressure)
                                  .value;
          sum += std::pow(nodes[k].area * (next - bounds[k]), 2);
          bounds[k] = next;
        }
    return std::sqrt(sum);
  }

  template class FixedPointFriction<2>;
  template class FixedPointFriction<3>;
} // namespace Amontons
