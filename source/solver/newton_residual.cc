#include <amontons/solver/newton_residual.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    double
    relative_force(const ContactEquilibrium<dim>              &problem,
                   const Iterate<dim>                         &now,
                   const LA::Vector                           &forces,
                   const std::vector<types::global_dof_index> &pins)
    {
      const auto &test = now.constraints->test();
      LA::Vector  free = condense(forces, test, forces);
      zero_constrained(test, problem.discretization.locally_owned, free);
      for (const auto dof : pins)
        if (problem.discretization.locally_owned.is_element(dof))
          free(dof) = 0;
      free.compress(VectorOperation::insert);
      return now.force_scale == 0
                 ? 0
                 : std::hypot(free.l2_norm(), now.states.law_error(now.answers)) / now.force_scale;
    }
  } // namespace

  template <int dim>
  double
  relative_residual(const ContactEquilibrium<dim>              &problem,
                    const Iterate<dim>                         &now,
                    const LA::Vector                           &unbalanced,
                    const std::vector<types::global_dof_index> &pins)
  {
    const double plain  = relative_force(problem, now, unbalanced, pins);
    const auto  *excess = problem.mechanics.forces_of_excess();
    if (excess == nullptr)
      return plain;
    LA::Vector with_excess(unbalanced);
    with_excess += *excess;
    return std::max(plain, relative_force(problem, now, with_excess, pins));
  }

  template <int dim>
  double
  relative_excess(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now)
  {
    const auto *excess = problem.mechanics.forces_of_excess();
    return excess == nullptr || now.force_scale == 0 ? 0. : excess->l2_norm() / now.force_scale;
  }

  template <int dim>
  double
  largest_violation(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now)
  {
    double distance = 0;
    for (unsigned int k = 0; k < now.answers.size(); ++k)
      if (problem.by_equations(k))
        distance = std::max(distance,
                            problem.contact.violation(k, now.states[k], problem.state.displacement) /
                                problem.interfaces[problem.contact.nodes()[k].interface].slave->mean_size);
    return distance;
  }

#define INSTANTIATE(dim)                                                                                     \
  template double relative_residual(const ContactEquilibrium<dim> &,                                         \
                                    const Iterate<dim> &,                                                    \
                                    const LA::Vector &,                                                      \
                                    const std::vector<types::global_dof_index> &);                           \
  template double relative_excess(const ContactEquilibrium<dim> &, const Iterate<dim> &);                    \
  template double largest_violation(const ContactEquilibrium<dim> &, const Iterate<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Amontons
