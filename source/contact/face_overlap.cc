#include <amontons/contact/face_overlap.h>
#include <amontons/contact/overlap_piece.h>
#include <amontons/contact/segment_clipping.h>

#include <boost/math/tools/toms748_solve.hpp>

namespace Amontons
{
  namespace
  {
    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    // Root of f in [0, 1] for f(0) f(1) < 0, to rounding. Of a bracket, the end with the smaller |f|: beside
    // 0 or 1 the other one comes nearer by bisection only, and is far from the root when the evaluations are
    // used up.
    template <typename Function>
    double
    root(const Function &f, const double f0, const double f1)
    {
      if (f0 == 0)
        return 0;
      if (f1 == 0)
        return 1;
      boost::uintmax_t iterations = 100;
      const auto       bracket    = boost::math::tools::toms748_solve(
          f,
          0.,
          1.,
          f0,
          f1,
          [](const double a, const double b) { return b - a <= std::numeric_limits<double>::epsilon(); },
          iterations);
      return std::abs(f(bracket.first)) < std::abs(f(bracket.second)) ? bracket.first : bracket.second;
    }
  } // namespace

  double
  project_to_slave(const ContactSurface<2> &slave, const unsigned int face, const Point<2> &y)
  {
    const auto miss = [&](const double xi) {
      return cross(y - slave.position(face, Point<1>(xi)), slave.nodal_normal(face, Point<1>(xi)));
    };
    // sign f grows along the face for points that are closer than the centre of its curvature.
    const double f0 = miss(0), f1 = miss(1), sign = slave.faces[face].sign;
    if (sign * f0 >= 0 && sign * f1 <= 0)
      return f0 == 0 ? 0 : f1 == 0 ? 1 : std::numeric_limits<double>::quiet_NaN();
    return sign * f0 >= 0 ? 0 : sign * f1 <= 0 ? 1 : root(miss, f0, f1);
  }

  std::optional<double>
  project_to_master(const ContactSurface<2> &master,
                    const unsigned int       face,
                    const Point<2>          &x,
                    const Tensor<1, 2>      &n)
  {
    const auto   miss = [&](const double eta) { return cross(master.position(face, Point<1>(eta)) - x, n); };
    const double f0 = miss(0), f1 = miss(1);
    // Ends shared with the neighbouring face may be missed by rounding.
    const double tolerance = 1e-12 * master.faces[face].size;
    if (std::abs(f0) <= tolerance)
      return 0.;
    if (std::abs(f1) <= tolerance)
      return 1.;
    if (f0 * f1 > 0)
      return {};
    return root(miss, f0, f1);
  }

  void
  overlap_faces(const ContactSurface<2>         &slave,
                const unsigned int               slave_face,
                const ContactSurface<2>         &master,
                const std::vector<unsigned int> &master_faces,
                const double                     search_distance,
                const double                     least_opposed,
                std::vector<OverlapPoint<2>>    &points)
  {
    append_overlaps<2>(slave, slave_face, master, master_faces, search_distance, least_opposed, points);
  }

  void
  overlap_obstacle(const ContactSurface<2>      &slave,
                   const unsigned int            slave_face,
                   const ObstacleData           &obstacle,
                   const AffineMap<2>           &motion,
                   const double                  search_distance,
                   std::vector<OverlapPoint<2>> &points)
  {
    const auto opposite = [&](const double xi) {
      return project_to_obstacle(obstacle,
                                 motion,
                                 slave.position(slave_face, Point<1>(xi)),
                                 slave.nodal_normal(slave_face, Point<1>(xi)));
    };
    // Ends of the covered parts: sampled, then bisected. A part smaller than a sample interval inside one
    // face is missed.
    const unsigned int  n_samples = 16;
    std::vector<double> ends;
    bool                inside = opposite(0).has_value();
    if (inside)
      ends.push_back(0);
    for (unsigned int i = 1; i <= n_samples; ++i)
      {
        const double xi        = double(i) / n_samples;
        const bool   inside_xi = opposite(xi).has_value();
        if (inside_xi != inside)
          {
            double lo = double(i - 1) / n_samples, hi = xi;
            for (unsigned int k = 0; k < 60; ++k)
              {
                const double middle                                = 0.5 * (lo + hi);
                (opposite(middle).has_value() == inside ? lo : hi) = middle;
              }
            ends.push_back(0.5 * (lo + hi));
          }
        inside = inside_xi;
      }
    if (inside)
      ends.push_back(1);

    for (unsigned int i = 0; i + 1 < ends.size(); i += 2)
      if (ends[i + 1] - ends[i] > 1e-12)
        integrate_segment<double>(
            {slave, slave_face}, ends[i], ends[i + 1], [&](const unsigned int n, const auto &slave_point) {
              append_piece<2>(
                  n, slave_face, slave_point, project_to(obstacle, motion), search_distance, points);
            });
  }
} // namespace Amontons
