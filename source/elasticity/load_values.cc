#include <amontons/elasticity/load_values.h>

#include <boost/container/small_vector.hpp>

namespace Amontons
{
  namespace
  {
    // A part of the unit interval, square or cube.
    template <int d>
    struct Box
    {
      Point<d> lower;
      double   size;
    };

    template <int d>
    std::vector<Box<d>>
    parts_of(const Box<d> &box, const unsigned int n)
    {
      std::vector<Box<d>> parts;
      const unsigned int  n_all = Utilities::fixed_power<d>(n);
      for (unsigned int i = 0; i < n_all; ++i)
        {
          Box<d>       part{box.lower, box.size / n};
          unsigned int rest = i;
          for (unsigned int c = 0; c < d; ++c, rest /= n)
            part.lower[c] += part.size * (rest % n);
          parts.push_back(part);
        }
      return parts;
    }

    template <int d>
    std::vector<Point<d>>
    points_in(const std::vector<Box<d>> &boxes, const Quadrature<d> &formula)
    {
      std::vector<Point<d>> points;
      for (const auto &box : boxes)
        for (const auto &point : formula.get_points())
          points.push_back(box.lower + box.size * Tensor<1, d>(point));
      return points;
    }

    // Of the load over a box, by the formula; how far the trapezoidal rule, which sees the corners, is from
    // that; and by how much values at the points of both differ, here and in the box that this one is a part
    // of. A jump may lie outside of the formula's points, or in the middle, where the integrals over the
    // halves add up to that over the whole, right or not; but values differ by as much in ever smaller boxes.
    struct Integral
    {
      Tensor<1, 3> load;
      double       mismatch = 0, range = 0, range_around = 0;
    };

    template <int d>
    std::vector<Integral>
    integrals(const std::vector<Box<d>> &boxes, const Quadrature<d> &formula, const LoadAt<d> &load)
    {
      const QTrapezoid<d> corners;
      const auto          values = load(points_in(boxes, formula)), ends = load(points_in<d>(boxes, corners));
      const unsigned int  n = formula.size(), n_ends = corners.size();
      std::vector<Integral> results(boxes.size());
      for (unsigned int b = 0; b < boxes.size(); ++b)
        {
          const double volume = std::pow(boxes[b].size, d);
          Tensor<1, 3> by_corners;
          const auto   look = [&](const Tensor<1, 3> &value, const double weight, Tensor<1, 3> &sum) {
            sum += volume * weight * value;
            results[b].range = std::max(results[b].range, (value - values[b * n]).norm());
          };
          for (unsigned int q = 0; q < n; ++q)
            look(values[b * n + q], formula.weight(q), results[b].load);
          for (unsigned int q = 0; q < n_ends; ++q)
            look(ends[b * n_ends + q], corners.weight(q), by_corners);
          results[b].mismatch = (by_corners - results[b].load).norm();
        }
      return results;
    }

    template <int d>
    Quadrature<d>
    formula_on(const std::vector<Box<d>> &boxes, const Quadrature<d> &formula)
    {
      std::vector<double> weights;
      for (const auto &box : boxes)
        for (const double weight : formula.get_weights())
          weights.push_back(weight * std::pow(box.size, d));
      return Quadrature<d>(points_in(boxes, formula), weights);
    }

    // Halves of the boxes where the load is smooth go to the leaves, the others are the new boxes.
    template <int d>
    void
    halve(const Quadrature<d>   &formula,
          const LoadAt<d>       &load,
          const double           allowed, // change of a box
          std::vector<Box<d>>   &boxes,
          std::vector<Integral> &of_boxes,
          std::vector<Box<d>>   &leaves)
    {
      const unsigned int  n = Utilities::fixed_power<d>(2u);
      std::vector<Box<d>> parts, rough;
      for (const auto &box : boxes)
        for (const auto &part : parts_of(box, 2))
          parts.push_back(part);
      const auto            of_parts = integrals(parts, formula, load);
      std::vector<Integral> of_rough;
      for (unsigned int i = 0; i < boxes.size(); ++i)
        {
          Tensor<1, 3> change = of_boxes[i].load;
          for (unsigned int k = i * n; k < (i + 1) * n; ++k)
            change -= of_parts[k].load;
          const auto &here = of_boxes[i];
          const bool  smooth =
              change.norm() <= allowed &&
              (here.range <= 0.75 * here.range_around || here.range * std::pow(boxes[i].size, d) <= allowed);
          for (unsigned int k = i * n; k < (i + 1) * n; ++k)
            {
              (smooth ? leaves : rough).push_back(parts[k]);
              if (!smooth)
                {
                  of_rough.push_back(of_parts[k]);
                  of_rough.back().range_around = here.range;
                }
            }
        }
      boxes    = std::move(rough);
      of_boxes = std::move(of_rough);
    }
  } // namespace

  template <int d>
  Quadrature<d>
  adapted_quadrature(const Quadrature<d> &formula, const LoadAt<d> &load, const double negligible)
  {
    const unsigned int  n_levels = d == 1 ? 21 : d == 2 ? 7 : 3; // a jump crosses ever more boxes
    const Box<d>        all{Point<d>(), 1};
    std::vector<Box<d>> boxes    = parts_of(all, d == 1 ? 64 : d == 2 ? 8 : 4), leaves;
    auto                of_boxes = integrals(boxes, formula, load);
    const Integral      of_all   = integrals<d>({all}, formula, load)[0];
    Tensor<1, 3>        change   = of_all.load;
    double              scale = 0, mismatch = 0, range = of_all.range;
    for (const auto &integral : of_boxes)
      {
        change -= integral.load;
        scale += integral.load.norm();
        mismatch = std::max(mismatch, integral.mismatch);
        range    = std::max(range, integral.range);
      }
    if (change.norm() <= std::max(1e-4 * scale, negligible) && mismatch <= std::max(5e-3 * scale, negligible))
      return formula;
    for (auto &integral : of_boxes)
      integral.range_around = range;

    const double allowed = std::max((d == 3 ? 1e-5 : 1e-6) * scale, negligible);
    for (unsigned int level = 0; level < n_levels && !boxes.empty(); ++level)
      halve(formula, load, allowed, boxes, of_boxes, leaves);
    leaves.insert(leaves.end(), boxes.begin(), boxes.end());
    return formula_on(leaves, formula);
  }

  template <int d>
  GaussPolynomials<d>::GaussPolynomials(const unsigned int n) : formula(QGauss<d>(n)), n(n), factors(n, 1.)
  {
    const QGauss<1> line(n);
    for (const auto &point : line.get_points())
      nodes.push_back(point[0]);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (j != i)
          factors[i] /= nodes[i] - nodes[j];
  }

  // Products of L_i(x) = factor_i prod_{j != i} (x - x_j).
  template <int d>
  void
  GaussPolynomials<d>::evaluate(const Point<d> &point, std::vector<double> &values) const
  {
    values.resize(Utilities::fixed_power<d>(n));
    values[0]                                   = 1;
    unsigned int                              m = 1; // values of the directions so far
    boost::container::small_vector<double, 8> along(n);
    for (unsigned int c = d; c-- > 0; m *= n)
      {
        std::copy(factors.begin(), factors.end(), along.begin());
        double before = 1, behind = 1; // products
        for (unsigned int i = 0; i < n; ++i)
          {
            along[i] *= before;
            before *= point[c] - nodes[i];
            along[n - 1 - i] *= behind;
            behind *= point[c] - nodes[n - 1 - i];
          }
        for (unsigned int k = m; k-- > 0;)
          for (unsigned int i = n; i-- > 0;)
            values[k * n + i] = values[k] * along[i]; // values[k] last
      }
  }

  // They are orthogonal, the integral of the square of each being its weight.
  template <int d>
  std::vector<Tensor<1, 3>>
  GaussPolynomials<d>::nearest(const Quadrature<d> &quadrature, const std::vector<Tensor<1, 3>> &load) const
  {
    std::vector<double>       basis;
    std::vector<Tensor<1, 3>> result(formula.size());
    for (unsigned int i = 0; i < load.size(); ++i)
      {
        evaluate(quadrature.point(i), basis);
        for (unsigned int q = 0; q < result.size(); ++q)
          result[q] += quadrature.weight(i) * basis[q] / formula.weight(q) * load[i];
      }
    return result;
  }

  template Quadrature<1>
  adapted_quadrature(const Quadrature<1> &, const LoadAt<1> &, const double);
  template Quadrature<2>
  adapted_quadrature(const Quadrature<2> &, const LoadAt<2> &, const double);
  template Quadrature<3>
  adapted_quadrature(const Quadrature<3> &, const LoadAt<3> &, const double);
  template class GaussPolynomials<1>;
  template class GaussPolynomials<2>;
  template class GaussPolynomials<3>;
} // namespace Amontons
