#include <amontons/failed_increment.h>

namespace Amontons
{
  namespace
  {
    double
    square(const std::vector<double> &values)
    {
      return std::inner_product(values.begin(), values.end(), values.begin(), 0.);
    }

    // Not a scale times the other one.
    bool
    differs(const LA::Vector &a, LA::Vector b, const double scale)
    {
      b.sadd(-scale, 1, a);
      return b.l2_norm() > 1e-10 * a.l2_norm();
    }

    bool
    went_the_same_way(const NewtonReport &a, const NewtonReport &b)
    {
      return a.iterations.size() == b.iterations.size() &&
             std::equal(a.iterations.begin(),
                        a.iterations.end(),
                        b.iterations.begin(),
                        [](const auto &x, const auto &y) {
                          return x.n_open == y.n_open && x.n_slip == y.n_slip && x.n_changes == y.n_changes;
                        });
    }
  } // namespace

  template <int dim>
  FailedIncrement<dim>::FailedIncrement(const Model<dim> &model, const NewtonReport &report)
      : report(report), moves(model.finite_strain()), loads(model.loads),
        values(model.discretization().make_owned_vector())
  {
    for (const auto dof : model.discretization().locally_owned)
      if (model.supports.is_constrained(dof))
        values(dof) = model.supports.get_inhomogeneity(dof);
    values.compress(VectorOperation::insert);
    for (const auto &interface : model.interfaces)
      if (gap_grows(interface))
        for (const auto &row : interface.coupling.rows)
          gaps.push_back(row.gap);
  }

  template <int dim>
  bool
  FailedIncrement<dim>::is_alike(const FailedIncrement &before, const bool from_rest) const
  {
    if (moves || before.report.iterations.empty() || before.loads.size() != loads.size())
      return false;
    const double old    = before.loads.norm_sqr() + before.values.norm_sqr() + square(before.gaps),
                 now    = loads.norm_sqr() + values.norm_sqr() + square(gaps);
    const double scale  = old > 0 ? std::sqrt(now / old) : 1;
    auto         change = gaps;
    for (unsigned int i = 0; i < change.size(); ++i)
      change[i] -= scale * before.gaps[i];
    if (differs(loads, before.loads, scale) || differs(values, before.values, scale) ||
        square(change) > 1e-20 * square(gaps))
      return false;
    return std::abs(scale - 1) < 1e-10 || (from_rest && went_the_same_way(before.report, report));
  }

  template struct FailedIncrement<2>;
  template struct FailedIncrement<3>;
} // namespace Amontons
