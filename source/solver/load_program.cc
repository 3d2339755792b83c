#include <amontons/solver/load_program.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    // Few iterations: the next increment may be longer. Many: shorter.
    constexpr unsigned int few = 6, many = 20;
    // The exponent of the first piece. With 2 a Hertzian contact grows evenly, but the last increments, after
    // which it is compared, become twice as long; measured (doc/introduction.md), 1.5 leaves the smallest
    // errors.
    constexpr double growth = 1.5;
    // How many times the time of one increment that of the next may be in a piece that is begun in two.
    constexpr double at_most = 8;
  } // namespace

  LoadProgram::LoadProgram(const Scene &scene, const bool incremental, const IncrementLengths &lengths)
      : incremental(incremental), breakpoints(scene.output_times), lengths(lengths),
        constant_size(scene.end_time / std::max(1u, scene.n_increments)),
        smallest(scene.minimum_increment * scene.end_time)
  {
    breakpoints.push_back(scene.end_time);
    if (incremental)
      {
        corners       = scene.corner_times;
        load_progress = scene.load_progress;
        breakpoints.insert(breakpoints.end(), corners.begin(), corners.end());
        if (scene.n_increments == 0)
          constant_size = 0;
      }
    else if (scene.kinematics == Kinematics::automatic) // what small strain leaves out there counts, too
      breakpoints.insert(breakpoints.end(), scene.corner_times.begin(), scene.corner_times.end());
    std::sort(breakpoints.begin(), breakpoints.end());
    const double same = 1e-12 * scene.end_time;
    breakpoints.erase(std::unique(breakpoints.begin(),
                                  breakpoints.end(),
                                  [&](const double a, const double b) { return std::abs(a - b) <= same; }),
                      breakpoints.end());
    breakpoints.back() = scene.end_time;
  }

  void
  LoadProgram::start_before()
  {
    t = -breakpoints.back();
    breakpoints.insert(breakpoints.begin(), 0.);
  }

  void
  LoadProgram::follow(const std::vector<double> &times)
  {
    followed = times;
  }

  // Of the whole program.
  double
  LoadProgram::Piece::of_loads(const double t) const
  {
    const double       at = std::clamp(t / end_time, 0., 1.) * (loads->size() - 1);
    const unsigned int i  = std::min<unsigned int>(at, loads->size() - 2);
    return (*loads)[i] + (at - i) * ((*loads)[i + 1] - (*loads)[i]);
  }

  double
  LoadProgram::Piece::progress(const double t) const
  {
    const double share = loads == nullptr
                             ? (t - begin) / (end - begin)
                             : (of_loads(t) - of_loads(begin)) / (of_loads(end) - of_loads(begin));
    return std::pow(share, 1 / exponent);
  }

  double
  LoadProgram::Piece::time(const double progress) const
  {
    const double share = std::pow(progress, exponent);
    if (loads == nullptr)
      return begin + (end - begin) * share;
    const double sought = of_loads(begin) + share * (of_loads(end) - of_loads(begin));
    const auto   after = std::upper_bound(loads->begin() + 1, loads->end() - 1, sought), before = after - 1;
    const double i = (before - loads->begin()) + (sought - *before) / (*after - *before);
    return std::clamp(end_time * i / (loads->size() - 1), begin, end);
  }

  bool
  LoadProgram::Piece::is_even() const
  {
    constexpr double   near = 0.01;
    constexpr unsigned n    = 64;
    for (unsigned int i = 1; i < n; ++i)
      if (const double share = double(i) / n;
          std::abs(progress(begin + share * (end - begin)) - share) > near)
        return false;
    return true;
  }

  LoadProgram::Piece
  LoadProgram::piece() const
  {
    const auto   end   = std::upper_bound(breakpoints.begin(), breakpoints.end(), t);
    const bool   first = end == breakpoints.begin();
    const double begin = !first ? *(end - 1) : t < 0 ? -breakpoints.back() : 0.;
    Piece        result{begin,
                 *end,
                 1.,
                 load_progress.empty() || t < 0 || constant_size > 0 ? nullptr : &load_progress,
                 breakpoints.back()};
    if (result.loads != nullptr && result.is_even())
      result.loads = nullptr;
    if (incremental && first && constant_size == 0 && t >= 0)
      result.exponent = growth;
    return result;
  }

  double
  LoadProgram::longest(const Piece &here) const
  {
    if (is_one_of(lengths.few, here.end))
      return 1. / lengths.n_of_each;
    if (t >= 0 && constant_size > 0)
      return lengths.times * constant_size / (here.end - here.begin);
    return lengths.times / increments_by_default;
  }

  double
  LoadProgram::next() const
  {
    if (const auto given = std::upper_bound(followed.begin(), followed.end(), t); given != followed.end())
      return *given;
    const Piece  here = piece();
    const double done = here.progress(t);
    const double n    = std::ceil((1 - done) / (factor * longest(here)) * (1 - 1e-9));
    if (n <= 1)
      return here.end;
    const double equal = t + (here.end - t) / n;
    const double end = here.exponent == 1 && here.loads == nullptr ? equal : here.time(done + (1 - done) / n);
    const double most = is_begun_in_two(here) ? here.begin + std::max(at_most * (t - here.begin),
                                                                      (first(here) - here.begin) / at_most)
                                              : here.end;
    return std::min(here.end, std::max(std::min(most, end), t + smallest));
  }

  bool
  LoadProgram::is_begun_in_two(const Piece &here) const
  {
    return lengths.begins_in_two && is_one_of(*lengths.begins_in_two, here.end) &&
           !is_one_of(lengths.few, here.end);
  }

  bool
  LoadProgram::is_one_of(const std::vector<double> &ends, const double end_of_piece) const
  {
    return std::any_of(ends.begin(), ends.end(), [&](const double end) {
      return std::abs(end - end_of_piece) <= 1e-12 * breakpoints.back();
    });
  }

  bool
  LoadProgram::is_of_few() const
  {
    const auto end = std::lower_bound(breakpoints.begin(), breakpoints.end(), t);
    return end != breakpoints.end() && is_one_of(lengths.few, *end);
  }

  double
  LoadProgram::first(const Piece &here) const
  {
    return here.time(std::min(1., longest(here)));
  }

  bool
  LoadProgram::is_beginning() const
  {
    if (finished()) // there is no piece
      return false;
    const Piece here = piece();
    return is_begun_in_two(here) && t < first(here) * (1 - 1e-9);
  }

  bool
  LoadProgram::is_at_breakpoint() const
  {
    return std::find(breakpoints.begin(), breakpoints.end(), t) != breakpoints.end();
  }

  bool
  LoadProgram::at_corner() const
  {
    return t <= 0 || std::any_of(corners.begin(), corners.end(), [&](const double corner) {
             return std::abs(corner - t) <= 1e-12 * breakpoints.back();
           });
  }

  void
  LoadProgram::accept(const unsigned int iterations)
  {
    t = next();
    ++n_accepted;
    if (iterations <= few)
      factor = std::min(1., 2 * factor);
    else if (iterations > many)
      factor /= 2;
  }

  bool
  LoadProgram::cut_back()
  {
    if (!incremental || is_smallest())
      return false;
    const Piece here = piece();
    factor           = (here.progress(next()) - here.progress(t)) / longest(here) / 2;
    return true;
  }
} // namespace Amontons
