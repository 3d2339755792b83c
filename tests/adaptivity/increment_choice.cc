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
  result.shear        = error;
  result.n_increments = static_cast<unsigned int>(at_first);
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
  check::is_true(!choice.keep(error_of_shear(0.015), 0.006) && choice.wants_more(),
                 "these are off by more than the mesh leaves");
  check::is_true(choice.keep(error_of_shear(0.015), 0.004) && !choice.wants_more(), "and these are not");
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

  // Single increments where pressures stay from one landing to the next, if they change a tenth at most of
  // what increments may.
  LoadRecord steady = record(12, 0.);
  steady.breakpoints.resize(4, steady.breakpoints[0]);
  for (unsigned int l = 0; l < 4; ++l)
    {
      steady.breakpoints[l].t                          = l + 1;
      steady.breakpoints[l].pairs[0].nodes[0].pressure = l == 2 ? 1.1 : 1.;
    }
  const auto changes_by = [&](const double shear_error) {
    return [&, shear_error](const IncrementLengths &tried) -> std::optional<LoadRecord> {
      check::is_true(tried.few == std::vector<double>{2.}, "not the first, and not where it changes");
      LoadRecord other = steady;
      other.breakpoints[1].pairs[0].nodes[0].shear[0] += shear_error;
      return other;
    };
  };
  steady.closing = {{{0., 0.2}}, {{3.1, 3.2}}};
  check::is_true(steady.growing() == std::vector<double>{4.}, "contact grows in the last piece only");
  steady.closing.push_back({{0.2, 0.4}});
  check::is_true(steady.growing() == std::vector<double>({1., 4.}),
                 "and in the first, after its first increment");
  check::is_true(!steady.closes_beyond(steady.closing), "the same is seen");
  LoadRecord finer = steady;
  finer.closing.push_back({{1.1, 1.4}});
  check::is_true(!finer.closes_beyond(steady.closing), "a short while more");
  finer.closing.push_back({{1.4, 1.8}});
  check::is_true(finer.closes_beyond(steady.closing), "a good part of a piece");
  IncrementChoice saves(parameters, true);
  IncrementErrors change;
  check::is_true(!saves.try_fewer_in_pieces(steady, most / at_first, changes_by(0.0011), change),
                 "more than a tenth");
  check::is_close(change.shear, 0.0011, 1e-12, "which is told");
  check::is_true(saves.lengths().few.empty(), "all as before");
  check::is_true(saves.try_fewer_in_pieces(steady, most / at_first, changes_by(0.0009), change), "less");
  check::is_true(saves.lengths().few == std::vector<double>{2.}, "these from now on");
  check::is_true(!saves.divide({1., 4.}), "contact grows elsewhere");
  // 4 pieces, of which one is single: four in each of the others.
  IncrementErrors of_rest = error_of_shear(0.017);
  of_rest.n_increments    = 13;
  of_rest.n_of_few       = 1;
  errors                  = saves.choose(of_rest, steady, true, fails);
  check::is_close(saves.lengths().times, most / 7, 1e-15, "seven for four");
  check::is_close(errors->n_increments, 22, 0, "and the single one");
  check::is_true(saves.divide({2.}) && saves.lengths().few.empty(), "contact grows there after all");
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
