// As many increments as make their error half of the target; fewer than at first only where that is so.
#include "check.h"

#include <amontons/adaptivity/increment_choice.h>
#include <amontons/solver/load_program.h>

namespace test_increment_choice
{
using namespace Amontons;

constexpr double at_first = LoadProgram::increments_at_first, most = LoadProgram::increments_by_default;

// Of n increments, with a shear that is off by as much of itself.
LoadRecord
record(const unsigned int n, const double shear_error)
{
  LoadRecord::Pair pair;
  pair.force             = 1;
  pair.nodes[0]          = {1, 1, 1, {}};
  pair.nodes[0].shear[0] = 1 + shear_error;
  LoadRecord result;
  result.breakpoints.push_back({{pair}, 0});
  result.n_increments = n;
  result.largest_work = 1;
  return result;
}

IncrementErrors
error_of_shear(const double error)
{
  IncrementErrors result;
  result.shear = result.shear_on_path = error;
  result.n_increments                 = static_cast<unsigned int>(at_first);
  return result;
}

int
main(int, char **)
{
  RefinementParameters parameters;
  parameters.target_error  = 0.02;
  const LoadRecord run     = record(4, 0.);
  unsigned int     n_tries = 0;
  const auto       fails   = [&](const IncrementLengths &) -> std::optional<LoadRecord> {
    ++n_tries;
    return {};
  };

  check::is_close(IncrementChoice(parameters, false).lengths().times, 1, 0, "as the scene says");
  IncrementChoice choice(parameters, true);
  check::is_close(choice.lengths().times, most / at_first, 1e-15, "at first");

  // An error of 0.017 with 4 takes 7 for 0.01.
  auto errors = choice.choose(error_of_shear(0.017), run, true, fails);
  check::is_true(errors.has_value() && n_tries == 0, "more of them need no trial");
  check::is_close(choice.lengths().times, most / 7, 1e-15, "more");
  check::is_close(errors->shear, 0.017 * 4 / 7, 1e-12, "their error");
  check::is_close(errors->n_increments, 7, 0, "their number");
  IncrementErrors single = error_of_shear(0.001); // single ones in one of two pieces
  single.n_increments    = 5;
  single.n_of_few        = 1;
  single.measured_with   = 8;
  IncrementErrors whole  = error_of_shear(0.02);
  whole.n_increments     = 16;
  const auto with_few    = whole.with(single);
  check::is_close(with_few.shear, 0.021, 1e-12, "error with few increments");
  check::is_close(with_few.n_of_few, 1, 0, "the few");
  check::is_close(with_few.n_increments, 9, 0, "what is left of the others");
  IncrementChoice another(parameters, true);
  another.take_lengths(choice);
  check::is_close(another.lengths().times, most / 7, 1e-15, "those of another run");
  check::is_true(!another.wants_more(), "which were all");
  IncrementErrors of_cut = error_of_shear(0.017);
  of_cut.n_increments    = 8;
  errors                 = choice.choose(of_cut, run, true, fails);
  check::is_close(choice.lengths().times, most / 14, 1e-15, "as they were cut to eight");
  check::is_close(errors->n_increments, 14, 0, "their number then");
  choice.choose(error_of_shear(1), run, true, fails);
  check::is_close(choice.lengths().times, 0.2, 1e-15, "no more than five times as many as by default");
  parameters.target_is_given = false;
  choice.choose(error_of_shear(1), run, true, fails);
  check::is_close(
      choice.lengths().times, 1, 1e-15, "no more than by default for a target that nobody asked for");
  parameters.target_is_given = true;
  choice.choose(error_of_shear(1), run, false, fails);
  check::is_close(choice.lengths().times, 1, 1e-15, "no more than by default on the way");
  check::is_true(choice.take_all() && !choice.take_all(), "more once");
  check::is_close(choice.lengths().times, 0.2, 1e-15, "all in the end");

  // Measured once more on a finer mesh.
  choice.choose(error_of_shear(0.017), run, false, fails);
  check::is_true(!choice.wants_more(), "fewer than by default are taken at once");
  choice.choose(error_of_shear(0.05), run, false, fails);
  check::is_true(choice.wants_more(), "more than by default in the end");
  check::is_true(!choice.keep(error_of_shear(0.015), 0.014) && choice.wants_more(),
                 "these are off by more than the mesh leaves");
  check::is_true(choice.keep(error_of_shear(0.015), 0.013) && !choice.wants_more(), "and these are not");
  check::is_true(choice.keep(error_of_shear(0.01), 0.02), "half of the target is theirs");

  // Few errors: on the last mesh nothing is to be gained; before, fewer are tried.
  IncrementChoice fewer(parameters, true);
  check::is_true(!fewer.choose(error_of_shear(0.004), run, true, fails) && n_tries == 0, "they stay");
  errors = fewer.choose(error_of_shear(0.004), run, false, fails);
  check::is_true(n_tries == 1 && errors->shear == 0.004, "fewer fail");
  check::is_close(fewer.lengths().times, most / at_first, 1e-15, "and are not taken");

  double     length  = 0;
  const auto repeats = [&](const double shear_error) {
    return [&, shear_error](const IncrementLengths &tried) -> std::optional<LoadRecord> {
      length = tried.times;
      return record(2, shear_error);
    };
  };
  errors = fewer.choose(error_of_shear(0.004), run, false, repeats(0.0045));
  check::is_close(length, most / 2, 1e-15, "two are tried");
  check::is_close(fewer.lengths().times, most / 2, 1e-15, "and taken");
  check::is_close(errors->shear, 0.009, 1e-12, "the larger of what is expected and found");
  fewer.choose(error_of_shear(0.004), run, false, repeats(0.02));
  check::is_close(fewer.lengths().times, most / at_first, 1e-15, "unless their error is larger than allowed");

  fewer.choose(error_of_shear(0.0002), run, false, repeats(0.));
  check::is_close(fewer.lengths().times, most, 1e-15, "one where ten times its error would do");
  fewer.choose(error_of_shear(0.0004), run, false, repeats(0.));
  check::is_close(fewer.lengths().times, most / 2, 1e-15, "else two");

  // In the second of four pieces next to nothing closes, nor in the last one, in the third some does. Single
  // increments there, if they change the end by a tenth at most of what increments may, or more of them.
  LoadRecord path = record(12, 0.);
  path.breakpoints.resize(4, path.breakpoints[0]);
  for (unsigned int l = 0; l < 4; ++l)
    path.breakpoints[l].t = l + 1;
  path.breakpoints[2].pairs[0].closed = 0.021;
  path.breakpoints[3].pairs[0].closed = 0.019;
  std::vector<unsigned int> numbers;
  const auto                changes_by = [&](const double of_single, const double power) {
    numbers.clear();
    return [&, of_single, power](const IncrementLengths &tried) -> std::optional<LoadRecord> {
      check::is_true(tried.few == std::vector<double>({2., 4.}), "not the first, and not where much closes");
      numbers.push_back(tried.n_of_each);
      LoadRecord other = path;
      other.breakpoints[0].pairs[0].nodes[0].shear[0] += 1;
      other.breakpoints[3].pairs[0].nodes[0].shear[0] += of_single / std::pow(tried.n_of_each, power);
      return other;
    };
  };
  IncrementChoice saves(parameters, true);
  IncrementErrors change;
  const auto      does = [&](const IncrementChoice::Repeat &repeat) {
    return saves.try_fewer_in_pieces(path, most / at_first, repeat, change);
  };
  check::is_true(!does(changes_by(0.0021, 1)) && numbers.size() == 1, "three of four are too many");
  check::is_close(change.shear, 0.0021, 1e-12, "of the end");
  check::is_close(change.shear_on_path, 1, 1e-12, "and on the way");
  check::is_true(!does(changes_by(0.0019, 0.5)) && numbers == std::vector<unsigned int>({1, 2}),
                 "two do not as much as expected");
  check::is_true(saves.lengths().few.empty(), "all as before");
  check::is_true(does(changes_by(0.0019, 1)), "two do");
  check::is_true(saves.lengths().n_of_each == 2 && saves.lengths().few == std::vector<double>({2., 4.}),
                 "these from now on");
  check::is_true(does(changes_by(0.0009, 1)) && saves.lengths().n_of_each == 1, "single ones do");
  check::is_true(!saves.divide(path), "as little closes as before");
  // 4 pieces, of which two are single: four in each of the others.
  IncrementErrors of_rest = error_of_shear(0.017);
  of_rest.n_increments    = 10;
  of_rest.n_of_few        = 2;
  errors                  = saves.choose(of_rest, path, true, fails);
  check::is_close(saves.lengths().times, most / 7, 1e-15, "seven for four");
  check::is_close(errors->n_increments, 16, 0, "and the single ones");
  LoadRecord finer                     = path;
  finer.breakpoints[1].pairs[0].closed = 0.021;
  check::is_true(saves.divide(finer) && saves.lengths().few == std::vector<double>{4.},
                 "more closes there after all");

  // Where contact grows, whatever it does there.
  path.closing = {{{0., 0.2}}, {{3.1, 3.2}}};
  check::is_true(path.growing() == std::vector<double>{4.}, "contact grows in the last piece only");
  path.closing.push_back({{0.2, 0.4}});
  check::is_true(path.growing() == std::vector<double>({1., 4.}),
                 "and in the first, after its first increment");
  check::is_true(!path.closes_beyond(path.closing), "the same is seen");
  finer.closing = path.closing;
  finer.closing.push_back({{1.1, 1.4}});
  check::is_true(!finer.closes_beyond(path.closing), "a short while more");
  finer.closing.push_back({{1.4, 1.8}});
  check::is_true(finer.closes_beyond(path.closing), "a good part of a piece");

  // A pair that is unloaded in the end: what it had.
  LoadRecord unloaded                                 = path;
  unloaded.breakpoints[3].pairs[0].nodes[0].pressure  = 0.04;
  unloaded.breakpoints[3].pairs[0].nodes[0].shear[0]  = 0.01;
  LoadRecord otherwise                                = unloaded;
  otherwise.breakpoints[0].pairs[0].nodes[0].shear[0] = 1.3;
  check::is_close(difference(unloaded, otherwise).shear, 0.3, 1e-12, "unloaded");
  unloaded.breakpoints[3].pairs[0].nodes[0].pressure = 0.06;
  check::is_close(difference(unloaded, otherwise).shear, 0, 1e-12, "hardly loaded");

  // Compared with twice as many: what is divided counts.
  LoadRecord few = record(13, 0.), many = record(26, 0.01);
  few.n_of_few  = 1;
  many.n_of_few = 2;
  check::is_close(error_of_increments(few, many).shear, 0.02, 1e-12, "half of the error is gone");
  many.n_increments = 8;
  check::is_close(error_of_increments(few, many).shear, 0.01, 1e-12, "or once more is there");

  parameters.target_quantity = "dissipation";
  // Its changes of both signs may cancel: what shears make of it.
  check::is_true(
      IncrementChoice(parameters, true).choose(error_of_shear(0.017), run, true, fails).has_value(),
      "dissipation: shears count");
  // Friction's work of 0.012 instead of 0.01, in a work of 1: 0.2 % of that, 20 % of itself, and that is what
  // counts.
  LoadRecord with_work = record(4, 0.), with_less = record(2, 0.);
  with_work.breakpoints[0].dissipation = 0.01;
  with_less.breakpoints[0].dissipation = 0.012;
  const auto of_work                   = error_of_increments(with_work, with_less);
  check::is_close(of_work.dissipation, 0.002, 1e-12, "dissipation: of the work");
  check::is_close(of_work.own_dissipation, 0.2, 1e-12, "dissipation: of itself");
  IncrementChoice by_dissipation(parameters, true);
  by_dissipation.choose(of_work, with_work, true, fails);
  check::is_close(by_dissipation.lengths().times, 0.2, 1e-15, "dissipation: as many as may be");
  // Less than 1e-4 of the work counts against that.
  with_work.breakpoints[0].dissipation = 1e-6;
  with_less.breakpoints[0].dissipation = 3e-6;
  check::is_close(
      error_of_increments(with_work, with_less).own_dissipation, 0.02, 1e-12, "dissipation: hardly any");

  // A zone that sticks of 0.1 instead of 0.08, in a contact of 1: what counts is 20 % of itself.
  LoadRecord sticks = record(4, 0.), less = record(2, 0.);
  sticks.breakpoints[0].pairs[0].contact_size = less.breakpoints[0].pairs[0].contact_size = 1;
  sticks.breakpoints[0].pairs[0].stick_size                                               = 0.1;
  less.breakpoints[0].pairs[0].stick_size                                                 = 0.08;
  const auto of_zone = error_of_increments(sticks, less);
  for (unsigned int node = 0; node < 9; ++node)
    {
      check::is_true(!sticks.resolves_stick(), "a few nodes stick");
      sticks.breakpoints[0].pairs[0].nodes[node] = {1, 1, 1, {}};
    }
  check::is_true(sticks.resolves_stick(), "a zone sticks");
  check::is_close(of_zone.stick_size, 0.02, 1e-12, "stick size: of the contact");
  check::is_close(of_zone.own_stick_size, 0.2, 1e-12, "stick size: of itself");
  check::is_close(of_zone.of("stick size"), 0.2, 1e-12, "which counts");
  return check::result();
}
} // namespace test_increment_choice
