// Convex polygons and bilinear quadrilaterals in a plane, as doubles or with derivatives.
#pragma once

#include <amontons/contact/components.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace Amontons
{
  using dealii::Point;
  using dealii::Tensor;

  template <typename Number>
  using Polygon = std::vector<Components<2, Number>>; // counter-clockwise
  template <typename Number>
  using Corners = std::array<Components<2, Number>, 4>; // lexicographic

  template <typename Number>
  double
  area(const Polygon<Number> &polygon)
  {
    double twice = 0;
    for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
      twice += value_of(cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]));
    return 0.5 * twice;
  }

  template <typename Number>
  Polygon<Number>
  around(const Corners<Number> &corners)
  {
    Polygon<Number> polygon = {corners[0], corners[1], corners[3], corners[2]};
    if (area(polygon) < 0)
      std::reverse(polygon.begin(), polygon.end());
    return polygon;
  }

  // The part to the left of the line from a to b (Sutherland and Hodgman 1974). Where edges lie on the line
  // but for rounding, they stay whole: rounding would else decide where to cut them.
  template <typename Number>
  Polygon<Number>
  cut(const Polygon<Number> &polygon, const Components<2, Number> &a, const Components<2, Number> &b)
  {
    Polygon<Number>    result;
    const auto         side = [&](const Components<2, Number> &p) { return cross(b - a, p - a); };
    const double       none = 1e-12 * value_of(dot(b - a, b - a));
    const unsigned int n    = polygon.size();
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto  &p = polygon[i], &q = polygon[(i + 1) % n];
        const Number s = side(p), t = side(q);
        if (s >= -none)
          result.push_back(p);
        if ((s > none && t < -none) || (s < -none && t > none))
          result.push_back(p + scaled(Number(s / (s - t)), q - p));
      }
    return result;
  }

  // Vertices that lie on the lines of the window's edges move along these: faces that match would else seem
  // to uncover the window as soon as they move, since slivers on its other side do not count.
  template <typename Number>
  void
  hold_on_edges(Polygon<Number> &polygon, const Polygon<Number> &window)
  {
    if constexpr (!std::is_same_v<Number, double>)
      for (auto &p : polygon)
        {
          std::vector<unsigned int> on;
          for (unsigned int i = 0; i < window.size(); ++i)
            {
              const auto   edge   = window[(i + 1) % window.size()] - window[i];
              const Number side   = cross(edge, p - window[i]);
              const Number square = dot(edge, edge);
              if (std::abs(value_of(side)) > 1e-10 * value_of(square))
                continue;
              const Number          excess = (side - value_of(side)) / square;
              Components<2, Number> inward;
              inward[0] = -edge[1];
              inward[1] = edge[0];
              p         = p - scaled(excess, inward);
              on.push_back(i);
            }
          if (on.size() == 2)
            {
              // an edge begins at the vertex of its number
              const unsigned int corner = on[1] - on[0] == 1 ? on[1] : on[0];
              const Point<2>     at     = value_of(p);
              p                         = window[corner];
              for (unsigned int d = 0; d < 2; ++d)
                p[d] += at[d] - value_of(p[d]);
            }
        }
  }

  template <typename Number, typename Place>
  Components<2, Number>
  bilinear(const Corners<Number> &corners, const Components<2, Place> &xi)
  {
    Components<2, Number> s;
    for (unsigned int v = 0; v < 4; ++v)
      {
        const Place a = v % 2 == 1 ? xi[0] : Place(1 - xi[0]), b = v / 2 == 1 ? xi[1] : Place(1 - xi[1]);
        s = s + scaled(Place(a * b), corners[v]);
      }
    return s;
  }

  // Columns ds/dxi_k.
  template <typename Number>
  std::array<Components<2, Number>, 2>
  bilinear_tangents(const Corners<Number> &corners, const Components<2, Number> &xi)
  {
    return {{scaled(Number(1 - xi[1]), corners[1] - corners[0]) + scaled(xi[1], corners[3] - corners[2]),
             scaled(Number(1 - xi[0]), corners[2] - corners[0]) + scaled(xi[0], corners[3] - corners[1])}};
  }

  // |ds/dxi|
  template <typename Number>
  Number
  area_ratio(const Corners<Number> &corners, const Components<2, Number> &xi)
  {
    const auto   t   = bilinear_tangents(corners, xi);
    const Number det = cross(t[0], t[1]);
    return value_of(det) < 0 ? Number(-det) : det;
  }

  template <typename Number>
  Corners<double>
  values_of(const Corners<Number> &corners)
  {
    Corners<double> values;
    for (unsigned int v = 0; v < 4; ++v)
      values[v] = Components<2, double>(value_of(corners[v]));
    return values;
  }

  // xi with bilinear(corners, xi) = s
  Components<2, double>
  pull_back(const Corners<double> &corners, const Components<2, double> &s);

  // The same with derivatives, by one more step of Newton's method.
  template <int n>
  Components<2, ADNumber<n>>
  pull_back(const Corners<ADNumber<n>> &corners, const Components<2, ADNumber<n>> &s)
  {
    const auto                 fixed = values_of(corners);
    const auto                 at    = pull_back(fixed, Components<2, double>(value_of(s)));
    const auto                 t     = bilinear_tangents(fixed, at);
    Components<2, ADNumber<n>> xi(value_of(at));
    const auto step = solve<2, ADNumber<n>>({{value_of(t[0]), value_of(t[1])}}, s - bilinear(corners, at));
    for (unsigned int k = 0; k < 2; ++k)
      xi[k] += step[k] - value_of(step[k]);
    return xi;
  }

  // How much the squared area element |ds/dxi|^2 of a bilinear face varies over a piece of it: (max -
  // min)/(max + min), 0 on parallelograms. xi(s) holds its square root.
  template <typename Number>
  double
  variation(const Corners<Number> &corners, const Polygon<Number> &piece)
  {
    const auto fixed    = values_of(corners);
    double     smallest = std::numeric_limits<double>::max(), largest = 0;
    for (const auto &s : piece)
      {
        const double square =
            std::pow(area_ratio(fixed, pull_back(fixed, Components<2, double>(value_of(s)))), 2);
        smallest = std::min(smallest, square);
        largest  = std::max(largest, square);
      }
    const double ratio = (largest - smallest) / (largest + smallest);
    return ratio >= 0 ? ratio : 1; // not a number where the face is turned inside out
  }
} // namespace Amontons
