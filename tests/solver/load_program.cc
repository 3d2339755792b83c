// Increments land on the output times and corners, shrink after failures and grow again.
#include "check.h"

#include <amontons/solver/load_program.h>

namespace test_load_program
{
using namespace Amontons;

std::vector<double>
run(LoadProgram program, const unsigned int iterations = 3)
{
  std::vector<double> times;
  while (!program.finished() && times.size() < 1000)
    {
      times.push_back(program.next());
      program.accept(iterations);
    }
  return times;
}

bool
holds(const std::vector<double> &times, const double t)
{
  return std::find(times.begin(), times.end(), t) != times.end();
}

int
main(int, char **)
{
  Scene scene;
  scene.end_time = 3;
  check::is_true(run(LoadProgram(scene, false)) == std::vector<double>{3.}, "no history: one increment");
  const auto ten = run(LoadProgram(scene, true));
  check::is_close(ten.size(), 10, 0, "history: ten increments");
  for (unsigned int k = 0; k < 10; ++k)
    check::is_close(ten[k], 3 * std::pow(0.1 * (k + 1), 1.5), 1e-12, "the first piece: growing increments");

  scene.corner_times   = {1, 2.5};
  scene.output_times   = {0.3, 3};
  const auto automatic = run(LoadProgram(scene, true));
  check::is_close(automatic.size(), 40, 0, "ten for each piece");
  for (unsigned int k = 10; k < 20; ++k)
    check::is_close(automatic[k], 0.3 + 0.07 * (k - 9), 1e-12, "later ones: equal increments");
  for (const double t : {0.3, 1., 2.5, 3.})
    check::is_true(holds(automatic, t), "lands on " + std::to_string(t));
  check::is_true(run(LoadProgram(scene, false)) == std::vector<double>({0.3, 3.}), "no history: no corners");

  scene.n_increments = 3;
  const auto three   = run(LoadProgram(scene, true));
  check::is_close(three.size(), 5, 0, "increments no longer than asked for");
  check::is_true(three.back() == 3 && holds(three, 0.3) && holds(three, 1.), "lands on the same times");

  // Loads that go on unevenly: equal steps of what they do, in the first piece growing ones.
  {
    Scene uneven;
    uneven.end_time     = 2;
    uneven.corner_times = {1};
    const auto share    = [](const double t) { return t <= 1 ? t / 2 : 0.5 + (t - 1) * (t - 1) / 2; };
    for (unsigned int i = 0; i <= 1000; ++i)
      uneven.load_progress.push_back(share(0.002 * i));
    const auto times = run(LoadProgram(uneven, true));
    check::is_close(times.size(), 20, 0, "ten for each piece, however its loads go on");
    for (unsigned int k = 0; k < 10; ++k)
      {
        check::is_close(times[k], std::pow(0.1 * (k + 1), 1.5), 1e-12, "as the time where loads do so");
        check::is_close(times[10 + k], 1 + std::sqrt(0.1 * (k + 1)), 1e-5, "equal steps of the loads");
      }
    uneven.corner_times = {};
    const auto growing  = run(LoadProgram(uneven, true));
    for (unsigned int k = 0; k < 10; ++k)
      check::is_close(share(growing[k]), std::pow(0.1 * (k + 1), 1.5), 1e-5, "growing steps of the loads");
    uneven.n_increments = 10;
    check::is_close(run(LoadProgram(uneven, true))[6], 1.4, 1e-12, "given increments: equal times");
  }

  // A piece that takes a single one, or two where that is tried.
  scene.n_increments = 0;
  LoadProgram         saves(scene, true, {1, {1., 3.}});
  std::vector<double> single;
  while (!saves.finished())
    {
      saves.accept(3);
      if (saves.is_of_few())
        single.push_back(saves.time());
    }
  check::is_close(saves.number() - 1, 22, 0, "ten in two pieces, one in each of the others");
  check::is_true(single == std::vector<double>({1., 3.}), "which they know");
  const auto halves = run(LoadProgram(scene, true, {2, {1., 3.}, 2}));
  check::is_close(halves.size(), 14, 0, "five in two pieces, two in each of the others");
  check::is_true(holds(halves, 2.75), "half of a piece");

  // A later piece that begins in two.
  const auto later = run(LoadProgram(scene, true, {1, {}, 1, {{2.5}}}));
  check::is_close(later.size(), 41, 0, "ten in each of four pieces, and one more");
  check::is_true(std::any_of(later.begin(),
                             later.end(),
                             [](const double t) { return std::abs(t - 1 - 0.15 / 8) < 1e-12; }),
                 "an eighth of its first one");
  check::is_true(
      std::any_of(later.begin(), later.end(), [](const double t) { return std::abs(t - 1.15) < 1e-12; }),
      "which ends as before");

  // Half of the way to the end, whatever the law of the increments.
  scene = Scene();
  LoadProgram growing(scene, true);
  growing.accept(3);
  check::is_true(growing.cut_back(), "a second increment that failed");
  check::is_close(growing.next(), std::pow(0.15, 1.5), 1e-12, "half of its step");

  // The first one is begun by a shorter one.
  scene           = Scene();
  const auto rubs = run(LoadProgram(scene, true, {1, {}, 1, {{1.}}}));
  check::is_close(rubs.size(), 11, 0, "begun by a shorter one: one more");
  check::is_close(rubs[0], std::pow(0.1, 1.5) / 8, 1e-12, "an eighth of the first one");
  for (unsigned int k = 0; k < 10; ++k)
    check::is_close(rubs[k + 1], std::pow(0.1 * (k + 1), 1.5), 1e-12, "then as before");
  check::is_close(run(LoadProgram(scene, true, {2.5, {}, 1, {{1.}}})).size(), 5, 0, "likewise of four");
  LoadProgram beginning(scene, true, {1, {}, 1, {{1.}}});
  check::is_true(beginning.is_beginning(), "nothing is done");
  beginning.accept(3);
  check::is_true(beginning.is_beginning(), "the first one is begun");
  beginning.accept(3);
  check::is_true(!beginning.is_beginning(), "and done");

  // Failures
  scene                   = Scene();
  scene.n_increments      = 1;
  scene.minimum_increment = 0.1;
  LoadProgram program(scene, true);
  check::is_true(program.at_corner(), "the start is a corner");
  check::is_true(program.cut_back() && program.next() == 0.5, "half");
  check::is_true(program.cut_back() && program.next() == 0.25, "a quarter");
  check::is_true(program.cut_back() && program.next() == 0.125, "an eighth");
  check::is_true(program.cut_back(), "down to the smallest");
  check::is_close(program.next(), 0.1, 1e-12, "the smallest");
  check::is_true(!program.cut_back(), "no smaller one");
  program.accept(3);
  check::is_close(program.time(), 0.1, 1e-12, "accepted");
  check::is_true(!program.at_corner(), "no corner");
  const auto grown = run(program);
  check::is_true(grown.size() < 6 && grown.back() == 1, "grows again");
  check::is_true(run(program, 30).size() >= 9, "does not grow when the iteration is slow");
  return check::result();
}
} // namespace test_load_program
