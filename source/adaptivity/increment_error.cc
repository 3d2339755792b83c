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

  std::vector<double>
  LoadRecord::growing() const
  {
    std::vector<double> ends;
    for (unsigned int l = 0; l < breakpoints.size(); ++l)
      if (std::any_of(closing.begin(), closing.end(), [&](const auto &span) {
            const double begin = l > 0 ? breakpoints[l - 1].t : closing.front()[0];
            return (l > 0 ? span[0] >= begin : span[0] > begin) && span[1] <= breakpoints[l].t;
          }))
        ends.push_back(breakpoints[l].t);
    return ends;
  }

  bool
  LoadRecord::closes_beyond(const Closing &of_other) const
  {
    constexpr double good_part = 0.4;
    if (closing.empty())
      return false;
    std::vector<double> unseen(breakpoints.size(), 0.);
    for (const auto &[begin, end] : closing)
      {
        const double middle = (begin + end) / 2;
        if (std::any_of(of_other.begin(), of_other.end(), [&](const auto &span) {
              return span[0] <= middle && middle <= span[1];
            }))
          continue;
        for (unsigned int l = 0; l < breakpoints.size(); ++l)
          if (end <= breakpoints[l].t)
            {
              unseen[l] += end - begin;
              break;
            }
      }
    for (unsigned int l = 0; l < breakpoints.size(); ++l)
      if (unseen[l] > good_part * (breakpoints[l].t - (l > 0 ? breakpoints[l - 1].t : closing.front()[0])))
        return true;
    return false;
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
    result.n_increments =
        n_at_once + static_cast<unsigned int>(std::lround((n_increments - n_at_once) / factor));
    return result;
  }

  IncrementErrors
  IncrementErrors::for_steps(const LoadRecord &record) const
  {
    const unsigned int n = n_increments - n_at_once, now = record.n_in_steps();
    if (n == now || n == 0 || now == 0)
      return *this;
    IncrementErrors result = scaled(double(n) / now);
    result.n_at_once       = record.n_at_once;
    result.n_increments    = record.n_increments;
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
    const double n = run.n_in_steps(), other = repeat.n_in_steps();
    auto         errors =
        difference(run, repeat)
            .scaled(n == other ? 2 : 1 / std::abs(n / other - 1)); // equal: all pieces take a single one
    errors.n_increments  = run.n_increments;
    errors.n_at_once     = run.n_at_once;
    errors.measured_with = run.n_increments;
    errors.repeated_with = repeat.n_increments;
    return errors;
  }

  IncrementErrors
  difference(const LoadRecord &run, const LoadRecord &repeat)
  {
    IncrementErrors     errors;
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
        errors.pressure         = std::max(errors.pressure, relative(pressure, pressure_scale));
        errors.shear            = std::max(errors.shear, relative(shear, shear_scale));
        errors.stick_size       = std::max(errors.stick_size, relative(stick, size));
        errors.own_stick_size   = std::max(errors.own_stick_size, relative(stick, stick_scale));
        errors.normal_force     = std::max(errors.normal_force, relative(normal, normal_scale));
        errors.tangential_force = std::max(errors.tangential_force, relative(tangential, tangential_scale));
      }
    double change = 0, dissipation = noteworthy_dissipation * run.largest_work;
    for (unsigned int l = 0; l < run.breakpoints.size(); ++l)
      {
        const double of_run = run.breakpoints[l].dissipation;
        change              = std::max(change, std::abs(repeat.breakpoints[l].dissipation - of_run));
        dissipation         = std::max(dissipation, std::abs(of_run));
      }
    errors.dissipation     = relative(change, run.largest_work);
    errors.own_dissipation = relative(change, dissipation);
    return errors;
  }

  std::vector<double>
  pieces_of_steady_pressure(const LoadRecord &run)
  {
    constexpr double    steady = 0.05; // in the mean square
    std::vector<double> ends;
    const auto          growing = run.growing();
    for (unsigned int l = 1; l < run.breakpoints.size(); ++l)
      {
        const auto &before = run.breakpoints[l - 1].pairs, &after = run.breakpoints[l].pairs;
        bool is_steady = std::find(growing.begin(), growing.end(), run.breakpoints[l].t) == growing.end();
        for (unsigned int i = 0; i < after.size(); ++i)
          {
            const Norms sums = norms(after[i], before[i]);
            is_steady        = is_steady && sums.pressure_change <= steady * sums.pressure;
          }
        if (is_steady)
          ends.push_back(run.breakpoints[l].t);
      }
    return ends;
  }
} // namespace Amontons
