// Errors that fall along a sequence of meshes are told from the differences of answers, whatever recovery is
// off by; and what a target takes.
#include "check.h"

#include <amontons/adaptivity/mesh_difference.h>
#include <amontons/adaptivity/mesh_sequence.h>
#include <amontons/adaptivity/quantity_sequence.h>

#include <limits>

namespace test_mesh_difference
{
using namespace Amontons;

int
main(int, char **)
{
  // Answers whose errors are orthogonal to the changes: d^2 = e^2 - e'^2.
  for (const double q : {0.3, 0.5, 0.7})
    for (const double e : {1e-4, 0.02, 0.5})
      {
        const double next = q * e, d = std::sqrt(e * e - next * next);
        check::is_close(error_by_difference(d, e, next), next, 1e-12, "a right estimate stays");
        for (const double factor : {0.05, 0.25, 0.5})
          check::is_close(error_by_difference(d, factor * e, factor * next),
                          next,
                          1e-12,
                          "too small an estimate is raised to the error");
        check::is_true(error_by_difference(d, 2 * e, 2 * next) >= 2 * next, "too large a one is not lowered");
        // It fell, the error did not.
        check::is_true(error_by_difference(0, e, 0.25 * e) == 0.5 * e,
                       "no change of the answer, half of the fall is believed");
      }
  check::is_true(error_by_difference(0.1, 0, 0.02) == 0.02, "nothing known before");
  check::is_close(error_by_difference(0.3, 0.1, 0.1),
                  0.4,
                  1e-12,
                  "an estimate that does not fall is believed to fall a little");

  // Errors fall by four, recovery is too large by three, six, five, and a hundred twice; the first comparison
  // stands alone, and a fall that is seen once only is not believed.
  const auto      change = [](const double e) { return std::sqrt(1 - 1. / 16) * e; };
  RecoveryFactors factors;
  check::is_close(error_by_comparisons(change(1), 3, 0.75, factors),
                  error_by_difference(change(1), 3, 0.75),
                  1e-14,
                  "the first comparison");
  check::is_close(factors.of_coarser, 1. / 3, 1e-12, "factor of the first mesh");
  check::is_close(
      error_by_comparisons(change(0.25), 1.5, 0.375, factors), 1.4 / 3 * 0.375, 1e-12, "the larger of both");
  check::is_close(factors.of_this, 1.4 / 3, 1e-12, "factor of this mesh");
  check::is_close(error_by_comparisons(change(1), 5, 1.25, factors),
                  1.4 * 0.25 * 1.25,
                  1e-12,
                  "from 1/6 to 1/5, and so on: less than the least");
  error_by_comparisons(change(1), 100, 25, factors);
  check::is_close(
      error_by_comparisons(change(1), 100, 25, factors), 1.4 * 0.25 * 25, 1e-12, "the least factor");
  factors = {1, 0.4};
  check::is_close(error_by_comparisons(change(1), 2, 0.5, factors),
                  1.4 * 0.5 * 0.5 / 0.4 * 0.5,
                  1e-12,
                  "growing factors");
  factors = {1, 0.4};
  check::is_close(
      error_by_comparisons(change(1), 2, 0.5, factors, false), 1.4 * 0.5 * 0.5, 1e-12, "factors that swing");
  check::is_true(error_by_comparisons(change(1), 0.8, 0.2, factors) >= 0.2, "too small again");
  check::is_true(error_by_comparisons(change(1), 3, 0.75, factors) >= 0.75, "once only");

  MeshSequence smooth, edge, short_one;
  for (unsigned int i = 0; i < 6; ++i)
    {
      const double n = 100 * std::pow(1.6, i);
      smooth.add(n, 0.7); // another increment on the same mesh
      smooth.add(n, 3 / std::sqrt(n));
      edge.add(n, 0.9 * std::pow(n, -0.04));
      if (i < 4)
        short_one.add(n, 1 / n);
    }
  const double last = 100 * std::pow(1.6, 5);
  check::is_close(smooth.order(), 0.5, 1e-12, "order");
  check::is_close(smooth.dofs_for(0.01), 9e4, 1e-10, "DoFs of a target");
  check::is_true(!smooth.is_hopeless(1e-5, 1e3), "what converges is not hopeless, however far");
  check::is_close(edge.order(), 0.04, 1e-12, "order at an edge");
  check::is_true(edge.is_hopeless(0.01, 1e6) && !edge.is_hopeless(0.9 * std::pow(1.5 * last, -0.04), 1e6),
                 "hopeless but for a target near by");
  check::is_true(std::isnan(short_one.order()) && std::isnan(short_one.dofs_for(0.1)) &&
                     !short_one.is_hopeless(0.1, 10),
                 "too few meshes");
  edge.add(4 * last, 1.);
  check::is_true(std::isinf(edge.dofs_for(0.01)) && edge.is_hopeless(0.01, 1e6), "an error that grows");

  MeshSequence falling, standing;
  for (const auto &[n, error] :
       {std::pair(4e3, 1.), std::pair(1e4, 0.35), std::pair(3e4, 0.349), std::pair(7e4, 0.348)})
    {
      falling.add(n, 10 * error / std::sqrt(n));
      standing.add(n, error);
    }
  check::is_true(standing.is_hopeless(0.05, 1e6) && !falling.is_hopeless(0.05, 1e6),
                 "after two refinements an error that stands still is hopeless");

  MeshSequence late; // nothing touches at first, and of what does later little is seen on three of the meshes
  for (const auto &[n, error] :
       {std::pair(1e3, -1.), std::pair(3e3, -1.), std::pair(1e4, -1.), std::pair(3e4, 0.7)})
    {
      late.add(n, 0);
      late.add(n, 0.7);
      late.add(n, error < 0 ? std::numeric_limits<double>::infinity() : error);
    }
  check::is_true(!late.is_hopeless(0.05, 1e5), "one mesh that knows its error");
  late.add(1e5, 0);
  late.add(3e5, 0);
  late.add(1.2e6, 0);
  check::is_true(!late.is_hopeless(0.05, 1e6), "errors of nothing do not stand still");

  // Numbers with an error of n^-1, on meshes that grow by 1.3 or 2: estimated within a factor.
  for (const double growth : {1.3, 2.})
    {
      QuantitySequence numbers;
      double           n = 1000;
      numbers.add(n, {5., 1.});
      check::is_true(std::isinf(numbers.error()), "one mesh says nothing");
      for (unsigned int i = 0; i < 12; ++i, n *= growth)
        numbers.add(n, {5. - 3 * 100 / n, 1. + 100 / n});
      const double error = 3 * 100 / (n / growth) / 5;
      check::is_true(numbers.error() > 0.99 * error && numbers.error() < 2.5 * error,
                     "error of numbers that converge");
      numbers.add(n / growth, {4., 1.}); // of the same mesh: instead
      check::is_true(numbers.error() > 0.2, "a number that jumps");

      QuantitySequence few;
      few.add(1000, {1.});
      check::is_true(few.change() == 0, "no change of a single mesh");
      few.add(3900, {1.});
      check::is_true(std::isinf(few.spread()), "no mesh of a quarter of the unknowns");
      few.add(7900, {1.1});
      check::is_close(few.spread(), 0.1 / 1.1, 1e-12, "the largest change since one");
      few.add(16000, {1.09});
      few.add(32000, {1.09});
      check::is_close(few.spread(), 0.01 / 1.09, 1e-12, "not of earlier ones");
      check::is_close(few.change(), 0.09 / 1.09, 1e-12, "of all of them");

      QuantitySequence repeated;
      double           last = 0;
      for (double m = 1000; m < n; m *= growth)
        {
          repeated.add(m, {5. - 3 * 100 / m});
          last = m;
        }
      const double before = repeated.error();
      repeated.repeat();
      for (const double value : {1., 4.5 - 3 * 100 / last}) // grows over the increments
        repeated.add(last, {value});
      check::is_close(
          repeated.error(), before * (5 - 3 * 100 / last) / (4.5 - 3 * 100 / last), 1e-9, "other increments");
      repeated.add(2 * last, {4.5 - 3 * 100 / (2 * last)});
      check::is_true(repeated.error() < before, "and a finer mesh with these");
    }

  // A peak that grows with the logarithm of the DoFs has no limit; one that converges, swings or rests may
  // have.
  const auto keeps_on = [](const std::function<double(const double)> &value) {
    QuantitySequence peak;
    for (double m = 1000; m < 5000; m *= 1.3)
      peak.add(m, {value(m)});
    return peak.keeps_on_changing();
  };
  check::is_true(keeps_on([](const double m) { return -2 * std::log(m); }), "no limit");
  check::is_true(!keeps_on([](const double m) { return 3 - 100 / m; }), "a limit");
  check::is_true(!keeps_on([](const double) { return 3.; }), "no change");
  check::is_true(!keeps_on([n = 0](const double) mutable { return 3. + (++n % 2); }), "swings");

  // What is less than worth telling counts against what is.
  QuantitySequence small;
  for (const double m : {1000., 2000., 4000.})
    small.add(m, {m * 1e-9}, 1e-3);
  check::is_true(small.error() > 0 && small.error() < 0.02 && !small.is_zero(), "little work");

  // Each number counts against itself, down to a thousandth of the largest.
  const auto error_of_two = [](const double least) {
    QuantitySequence two;
    for (const double m : {1000., 2000.})
      two.add(m, {1, least * (m == 1000 ? 0.9 : 1)});
    return two.error();
  };
  check::is_close(error_of_two(0.01), 0.1, 1e-12, "a small number");
  check::is_close(error_of_two(1e-5), 1e-3, 1e-12, "one that is hardly there");

  // A size whose ends no mesh refines agrees on all of them; refined ends tell.
  QuantitySequence coarse, refined;
  for (const double m : {1000., 2000., 4000.})
    {
      coarse.add(m, {0.5455}, 0, {0.02});
      refined.add(m, {0.5455}, 0, {20 / m});
    }
  check::is_close(coarse.error(), 0.02 / 0.5455, 1e-12, "ends as coarse as before");
  check::is_close(coarse.doubt(), coarse.error(), 1e-12, "is their doubt");
  check::is_true(refined.doubt() == 0 && refined.error() == 0, "ends that are refined");

  // Errors that swing, with increments that change on each mesh, so that no order is known.
  MeshSequence falls, restarted;
  double       m = 9404;
  for (const double error : {0.8, 2.1, 1.1, 1.2, 1.0, 1.1, 1.3, 8.3, 15.})
    {
      check::is_true(!restarted.is_hopeless(0.05, 1e6), "not yet");
      restarted.add(m, error);
      restarted.restart();
      restarted.add(m, error);
      m *= 1.18;
    }
  check::is_true(restarted.is_hopeless(0.05, 1e6) && std::isnan(restarted.order()), "swings for ever");
  check::is_true(restarted.trend() < 0, "grows");
  for (unsigned int i = 0; i < 9; ++i)
    falls.add(1000 * std::pow(1.5, i), std::pow(1.5, -0.3 * i));
  check::is_close(falls.trend(), 0.3, 1e-12, "least squares");
  check::is_true(!falls.is_hopeless(0.05, 1e6), "falls");

  // Estimates of numbers stand still between doublings of the unknowns, those of fields do not.
  MeshSequence of_field, of_number;
  for (unsigned int i = 0; i < 7; ++i)
    {
      of_field.add(1000 * std::pow(1.2, i), 0.04);
      of_number.add(1000 * std::pow(1.2, i), 0.04, 4);
    }
  check::is_true(of_field.is_hopeless(0.01, 1e5) && !of_number.is_hopeless(0.01, 1e5), "hopeless");

  // What cells that cannot be refined keep: on two meshes, not in two increments on one.
  MeshSequence at_points;
  at_points.add_lasting(1000, 0.5, 0.1);
  at_points.add_lasting(1000, 0.5, 0.1);
  check::is_true(!at_points.is_hopeless(0.1, 1e5), "increments on one mesh");
  at_points.add_lasting(2000, 0.3, 0.1);
  check::is_true(!at_points.is_hopeless(0.1, 1e5), "an error that falls");
  at_points.add_lasting(3000, 0.3, 0.1);
  check::is_true(at_points.is_hopeless(0.1, 1e5), "an error that stays");
  at_points.add_lasting(4000, 0.05, 0.1);
  check::is_true(!at_points.is_hopeless(0.1, 1e5), "a target that is reached");
  return check::result();
}
} // namespace test_mesh_difference
