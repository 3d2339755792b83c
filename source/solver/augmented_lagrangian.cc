#include <amontons/solver/augmented_lagrangian.h>

namespace Amontons
{
  // First multipliers: the tractions of the first guess, of the increment before if there is one.
  template <int dim>
  NewtonReport
  AugmentedLagrangian<dim>::run()
  {
    if (!newton.prepare())
      return newton.report();
    auto &report = newton.report();
    multipliers.resize(problem.contact.nodes().size());
    update_multipliers();
    double change = 0;
    while (report.goes_on())
      {
        newton.iterate();
        ++report.n_outer;
        if (!report.converged)
          break;
        change           = update_multipliers() / newton.now().force_scale;
        report.converged = change <= problem.parameters.tolerance;
        if (!report.converged && report.n_outer == problem.parameters.max_iterations)
          report.failure = Failure{Failure::Kind::multipliers_unsettled, report.n_outer, change};
        else if (!report.converged)
          newton.states().forget();
      }
    return newton.finish();
  }

  // By how much the forces of the multipliers change, sqrt sum (area |change|)^2: eps times what the gaps and
  // the slips of sticking nodes violate.
  template <int dim>
  double
  AugmentedLagrangian<dim>::update_multipliers()
  {
    const auto &now   = newton.now();
    const auto &nodes = problem.contact.nodes();
    double      sum   = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        typename Penalty<dim>::Multiplier next;
        if (now.states[k] != ContactStatus::open && !problem.by_equations(k))
          {
            next.pressure = std::max(0., now.answers[k].pressure);
            next.shear    = now.answers[k].shear;
          }
        if (problem.contact.is_opposite(k))
          sum += std::pow(nodes[k].area, 2) * (std::pow(next.pressure - multipliers[k].pressure, 2) +
                                               (next.shear - multipliers[k].shear).norm_square());
        multipliers[k] = next;
      }
    penalty.keep(multipliers);
    return std::sqrt(sum);
  }

  template class AugmentedLagrangian<2>;
  template class AugmentedLagrangian<3>;
} // namespace Amontons
