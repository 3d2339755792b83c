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

    // Over the landings of a program.
    struct Change
    {
      double change = 0, scale = 0, change_at_end = 0, scale_at_end = 0;

      void
      add(const double by, const double against)
      {
        change_at_end = by;
        scale_at_end  = against;
        change        = std::max(change, by);
        scale         = std::max(scale, against);
      }
      double
      largest() const
      {
        return relative(change, scale);
      }
      double
      at_end() const
      {
        return relative(change_at_end, scale_at_end);
      }
    };

    // What changes of the shear count against.
    double
    noteworthy(const Norms &sums, const bool tresca_alone)
    {
      return std::max(sums.shear,
                      noteworthy_shear * (tresca_alone ? sums.bound : std::min(sums.bound, sums.pressure)));
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

  std::vector<double>
  LoadRecord::closing_beyond(const double part) const
  {
    std::vector<double> ends;
    const unsigned int  n_pairs = breakpoints.empty() ? 0 : breakpoints[0].pairs.size();
    for (unsigned int l = 1; l < breakpoints.size(); ++l)
      for (unsigned int i = 0; i < n_pairs; ++i)
        if (const auto &pair = breakpoints[l].pairs[i];
            pair.closed > part * noteworthy(norms(pair, pair), pair.tresca_alone))
          {
            ends.push_back(breakpoints[l].t);
            break;
          }
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

  namespace
  {
    constexpr double IncrementErrors::*parts[] = {&IncrementErrors::pressure,
                                                  &IncrementErrors::shear,
                                                  &IncrementErrors::shear_on_path,
                                                  &IncrementErrors::stick_size,
                                                  &IncrementErrors::own_stick_size,
                                                  &IncrementErrors::normal_force,
                                                  &IncrementErrors::tangential_force,
                                                  &IncrementErrors::dissipation,
                                                  &IncrementErrors::own_dissipation};
  } // namespace

  IncrementErrors
  IncrementErrors::with(const IncrementErrors &others) const
  {
    IncrementErrors result = *this;
    for (const auto part : parts)
      result.*part += others.*part;
    const double left   = double(others.n_increments - others.n_of_few) / others.measured_with;
    result.n_of_few     = others.n_of_few;
    result.n_increments = result.n_of_few + static_cast<unsigned int>(std::lround(left * n_increments));
    return result;
  }

  IncrementErrors
  IncrementErrors::scaled(const double factor) const
  {
    IncrementErrors result = *this;
    for (const auto part : parts)
      result.*part *= factor;
    result.n_increments =
        n_of_few + static_cast<unsigned int>(std::lround((n_increments - n_of_few) / factor));
    return result;
  }

  IncrementErrors
  IncrementErrors::for_steps(const LoadRecord &record) const
  {
    const unsigned int n = n_increments - n_of_few, now = record.n_in_steps();
    if (n == now || n == 0 || now == 0)
      return *this;
    IncrementErrors result = scaled(double(n) / now);
    result.n_of_few        = record.n_of_few;
    result.n_increments    = record.n_increments;
    return result;
  }

  double
  IncrementErrors::of(const std::string &target_quantity) const
  {
    if (target_quantity == "contact pressure")
      return largest();
    if (target_quantity == "dissipation") // changes of both signs may cancel in the sum
      return std::max(own_dissipation, shear_on_path);
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
    errors.n_of_few      = run.n_of_few;
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
        // Changes and what they count against, each the largest of the program, and of tractions and stick
        // sizes that of the end.
        Change pressure, shear, stick, own_stick, normal, tangential;
        for (unsigned int l = 0; l < run.breakpoints.size(); ++l)
          {
            const auto  &a = run.breakpoints[l].pairs[i], &b = repeat.breakpoints[l].pairs[i];
            const Norms  sums        = norms(a, b);
            const double size_change = std::abs(b.stick_size - a.stick_size);
            pressure.add(sums.pressure_change, sums.pressure);
            shear.add(sums.shear_change, noteworthy(sums, a.tresca_alone));
            stick.add(size_change, a.contact_size);
            own_stick.add(size_change, std::max(a.stick_size, b.stick_size));
            normal.add((b.normal_force - a.normal_force).norm(), a.force);
            tangential.add((b.tangential_force - a.tangential_force).norm(),
                           a.tresca_alone ? sums.bound_force : std::min(sums.bound_force, a.force));
          }
        const bool is_loaded  = pressure.scale_at_end >= unloaded_part * pressure.scale;
        const auto keep       = [](double &error, const double of_pair) { error = std::max(error, of_pair); };
        const auto of_the_end = [&](const Change &change) {
          return is_loaded ? change.at_end() : change.largest();
        };
        keep(errors.pressure, of_the_end(pressure));
        keep(errors.shear, of_the_end(shear));
        keep(errors.shear_on_path, shear.largest());
        keep(errors.stick_size, of_the_end(stick));
        keep(errors.own_stick_size, of_the_end(own_stick));
        keep(errors.normal_force, normal.largest());
        keep(errors.tangential_force, tangential.largest());
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
    errors.n_increments    = repeat.n_increments;
    errors.n_of_few        = repeat.n_of_few;
    errors.measured_with   = run.n_increments;
    return errors;
  }
} // namespace Amontons
