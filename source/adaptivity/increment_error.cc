#include <amontons/adaptivity/error_estimator.h>
#include <amontons/adaptivity/increment_error.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    // Norms over the surface, and their differences between two programs.
    struct Norms
    {
      double pressure = 0, pressure_change = 0, shear = 0, shear_change = 0, bound = 0, bound_force = 0;
    };

    Norms
    norms(const LoadRecord::Pair &a, const LoadRecord::Pair &b)
    {
      auto nodes = a.nodes;
      nodes.insert(b.nodes.begin(), b.nodes.end());
      const auto at = [](const LoadRecord::Pair &pair, const unsigned int node) {
        const auto found = pair.nodes.find(node);
        return found == pair.nodes.end() ? LoadRecord::Node() : found->second;
      };
      Norms sums;
      for (const auto &[number, node] : nodes)
        {
          const auto one = at(a, number), other = at(b, number);
          sums.pressure += node.area * one.pressure * one.pressure;
          sums.pressure_change += node.area * std::pow(other.pressure - one.pressure, 2);
          sums.shear += node.area * one.shear.norm_square();
          sums.shear_change += node.area * (other.shear - one.shear).norm_square();
          sums.bound += node.area * one.bound * one.bound;
          sums.bound_force += node.area * one.bound;
        }
      for (double *const sum :
           {&sums.pressure, &sums.pressure_change, &sums.shear, &sums.shear_change, &sums.bound})
        *sum = std::sqrt(*sum);
      return sums;
    }

    double
    largest_force(const LoadRecord &record, const unsigned int pair)
    {
      double force = 0;
      for (const auto &landing : record.breakpoints)
        force = std::max(force, landing.pairs[pair].force);
      return force;
    }

    double
    relative(const double change, const double scale)
    {
      return scale > 0 ? change / scale : 0;
    }
  } // namespace

  bool
  LoadRecord::resolves_stick() const
  {
    constexpr int enough = 9; // with 5 two numbers of increments had it alike by chance
    return std::any_of(breakpoints.begin(), breakpoints.end(), [](const Landing &landing) {
      return std::any_of(landing.pairs.begin(), landing.pairs.end(), [](const Pair &pair) {
        return std::count_if(pair.nodes.begin(), pair.nodes.end(), [](const auto &node) {
                 return node.second.shear.norm() < (1 - 1e-9) * node.second.bound;
               }) >= enough;
      });
    });
  }

  IncrementErrors
  IncrementErrors::scaled(const double factor) const
  {
    IncrementErrors result = *this;
    for (double *const part : {&result.pressure,
                               &result.shear,
                               &result.stick_size,
                               &result.own_stick_size,
                               &result.normal_force,
                               &result.tangential_force,
                               &result.dissipation,
                               &result.own_dissipation})
      *part *= factor;
    result.n_increments = static_cast<unsigned int>(std::lround(n_increments / factor));
    return result;
  }

  double
  IncrementErrors::of(const std::string &target_quantity) const
  {
    if (target_quantity == "contact pressure")
      return largest();
    if (target_quantity == "dissipation") // changes of both signs may cancel in the sum
      return std::max(own_dissipation, shear);
    if (target_quantity == "total force")
      return std::max(normal_force, tangential_force);
    if (target_quantity == "stick size")
      return own_stick_size;
    return std::max(pressure, normal_force);
  }

  IncrementErrors
  error_of_increments(const LoadRecord &run, const LoadRecord &repeat)
  {
    IncrementErrors errors;
    errors.n_increments  = run.n_increments;
    errors.measured_with = run.n_increments;
    errors.repeated_with = repeat.n_increments;
    const double factor  = 1 / std::abs(double(run.n_increments) / repeat.n_increments - 1);

    const unsigned int  n_pairs = run.breakpoints.empty() ? 0 : run.breakpoints[0].pairs.size();
    std::vector<double> forces(1, 0.);
    for (unsigned int i = 0; i < n_pairs; ++i)
      forces.push_back(largest_force(run, i));
    const double least = 1e-6 * *std::max_element(forces.begin(), forces.end()); // rounding has no digits
    for (unsigned int i = 0; i < n_pairs; ++i)
      {
        if (forces[i + 1] <= least)
          continue;
        // Changes and what they count against, each the largest of the program.
        double pressure = 0, pressure_scale = 0, shear = 0, shear_scale = 0, stick = 0, size = 0,
               stick_scale = 0;
        double normal = 0, normal_scale = 0, tangential = 0, tangential_scale = 0;
        for (unsigned int l = 0; l < run.breakpoints.size(); ++l)
          {
            const auto &a = run.breakpoints[l].pairs[i], &b = repeat.breakpoints[l].pairs[i];
            const Norms sums = norms(a, b);
            pressure         = std::max(pressure, sums.pressure_change);
            pressure_scale   = std::max(pressure_scale, sums.pressure);
            shear            = std::max(shear, sums.shear_change);
            shear_scale      = std::max(
                {shear_scale,
                      sums.shear,
                      noteworthy_shear * (a.tresca_alone ? sums.bound : std::min(sums.bound, sums.pressure))});
            stick            = std::max(stick, std::abs(b.stick_size - a.stick_size));
            stick_scale      = std::max({stick_scale, a.stick_size, b.stick_size});
            size             = std::max(size, a.contact_size);
            normal           = std::max(normal, (b.normal_force - a.normal_force).norm());
            normal_scale     = std::max(normal_scale, a.force);
            tangential       = std::max(tangential, (b.tangential_force - a.tangential_force).norm());
            tangential_scale = std::max(
                tangential_scale, a.tresca_alone ? sums.bound_force : std::min(sums.bound_force, a.force));
          }
        errors.pressure       = std::max(errors.pressure, factor * relative(pressure, pressure_scale));
        errors.shear          = std::max(errors.shear, factor * relative(shear, shear_scale));
        errors.stick_size     = std::max(errors.stick_size, factor * relative(stick, size));
        errors.own_stick_size = std::max(errors.own_stick_size, factor * relative(stick, stick_scale));
        errors.normal_force   = std::max(errors.normal_force, factor * relative(normal, normal_scale));
        errors.tangential_force =
            std::max(errors.tangential_force, factor * relative(tangential, tangential_scale));
      }
    double change = 0, dissipation = noteworthy_dissipation * run.largest_work;
    for (unsigned int l = 0; l < run.breakpoints.size(); ++l)
      {
        const double of_run = run.breakpoints[l].dissipation;
        change              = std::max(change, std::abs(repeat.breakpoints[l].dissipation - of_run));
        dissipation         = std::max(dissipation, std::abs(of_run));
      }
    errors.dissipation     = factor * relative(change, run.largest_work);
    errors.own_dissipation = factor * relative(change, dissipation);
    return errors;
  }
} // namespace Amontons
