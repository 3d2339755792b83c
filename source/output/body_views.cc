#include <amontons/output/body_views.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Amontons
{
  namespace
  {
    Tensor<1, 3>
    unit_vector(const unsigned int d)
    {
      Tensor<1, 3> e;
      e[d] = 1;
      return e;
    }

    // The axis of the largest force; of axes that are alike z, then y.
    unsigned int
    upward_axis(const std::vector<PressedPoint> &pressed)
    {
      std::array<double, 3> force = {{0, 0, 1e-300}};
      for (const PressedPoint &point : pressed)
        for (unsigned int d = 0; d < 3; ++d)
          force[d] += std::abs(point.force[d]);
      unsigned int up = 2;
      for (const unsigned int d : {1, 0})
        if (force[d] > 1.1 * force[up])
          up = d;
      return up;
    }

    // Angles in degrees: about `up` from the axis that follows it, and above the horizon.
    BodyView
    view_from(const unsigned int up, const double azimuth, const double elevation)
    {
      const double       a = azimuth * numbers::PI / 180, e = elevation * numbers::PI / 180;
      const Tensor<1, 3> first = unit_vector((up + 1) % 3), second = unit_vector((up + 2) % 3);
      BodyView           view;
      view.towards =
          std::cos(e) * (std::cos(a) * first + std::sin(a) * second) + std::sin(e) * unit_vector(up);
      view.right = -std::sin(a) * first + std::cos(a) * second;
      view.down  = -1. * cross_product_3d(view.towards, view.right);
      return view;
    }

    // Part of the force that acts within `depth` (lengths) behind what is seen.
    double
    seen_part(const BodySurfaces              &surfaces,
              const std::vector<PressedPoint> &pressed,
              const BodyView                  &view,
              const double                     warp,
              const double                     depth)
    {
      const Camera camera = camera_of({&surfaces}, view, warp, 120, 120);
      Raster       raster(camera.width, camera.height);
      draw_bodies(surfaces, {}, nullptr, camera, raster);
      double seen = 0, all = 0;
      for (const PressedPoint &point : pressed)
        {
          all += point.force.norm();
          if (raster.sees(camera.project(point.place), 1.5 + camera.scale * depth))
            seen += point.force.norm();
        }
      return all > 0 ? seen / all : 0;
    }

    // Corners of the bounding box, reference configuration.
    std::pair<Tensor<1, 3>, Tensor<1, 3>>
    box_of(const BodySurfaces &surfaces)
    {
      Tensor<1, 3> lower({1e300, 1e300, 1e300}), upper = -lower;
      for (const BodyPatch &patch : surfaces)
        for (const BodyPoint &point : patch.points)
          for (unsigned int d = 0; d < 3; ++d)
            {
              lower[d] = std::min<double>(lower[d], point.X[d]);
              upper[d] = std::max<double>(upper[d], point.X[d]);
            }
      return {lower, upper};
    }

    Tensor<1, 3>
    middle_of(const BodySurfaces &surfaces)
    {
      const auto [lower, upper] = box_of(surfaces);
      return 0.5 * (lower + upper);
    }

    // Corners alone.
    BodySurfaces
    coarse(const BodySurfaces &surfaces)
    {
      BodySurfaces result;
      for (const BodyPatch &patch : surfaces)
        result.push_back(
            {patch.body,
             1,
             {patch.at(0, 0), patch.at(patch.n, 0), patch.at(0, patch.n), patch.at(patch.n, patch.n)}});
      return result;
    }

    // 1, 2 or 5 times a power of ten; floats may miss that by a little.
    double
    rounded_down(const double factor)
    {
      const double f     = factor * (1 + 1e-5);
      const double power = std::pow(10., std::floor(std::log10(f)));
      return f >= 5 * power ? 5 * power : (f >= 2 * power ? 2 * power : power);
    }
  } // namespace

  std::vector<PressedPoint>
  pressed_points(const std::vector<ContactInterface<3>> &interfaces,
                 const std::vector<SurfaceFields<3>>    &fields)
  {
    std::vector<PressedPoint> result;
    for (unsigned int i = 0; i < std::min(interfaces.size(), fields.size()); ++i)
      {
        const auto         &nodes = interfaces[i].slave->nodes;
        std::vector<double> gap(nodes.size(), 0.);
        if (interfaces[i].master_surface)
          for (const auto &row : interfaces[i].coupling.rows)
            gap[row.node] = row.gap;
        for (unsigned int n = 0; n < nodes.size(); ++n)
          if (const double force = fields[i].area[n] * fields[i].pressure[n];
              force > 0 && fields[i].state[n] != ContactStatus::open)
            {
              PressedPoint point;
              point.pair = i;
              for (unsigned int d = 0; d < 3; ++d)
                {
                  point.place.X[d] = nodes[n].X[d];
                  point.place.u[d] = fields[i].displacement[n][d];
                }
              point.force = force * fields[i].normal[n];
              point.gap   = gap[n];
              result.push_back(point);
            }
      }
    return result;
  }

  double
  size_of(const BodySurfaces &surfaces)
  {
    const auto [lower, upper] = box_of(surfaces);
    return surfaces.empty() ? 0 : (upper - lower).norm();
  }

  double
  warp_factor(const BodySurfaces &surfaces, const std::vector<PressedPoint> &pressed)
  {
    const double size    = size_of(surfaces);
    double       largest = 0, gap = 0;
    for (const BodyPatch &patch : surfaces)
      for (const BodyPoint &point : patch.points)
        largest = std::max(largest, (place_of(point, 1) - place_of(point, 0)).norm());
    for (const PressedPoint &point : pressed)
      gap = std::max(gap, std::abs(point.gap));
    if (!(largest > 1e-12 * size))
      return 1;
    const double wanted = 0.05 * size / largest, allowed = 1 + 0.004 * size / std::max(gap, 1e-12 * size);
    return rounded_down(std::max(1., std::min(wanted, allowed)));
  }

  std::optional<ContactPlace>
  contact_place(const std::vector<PressedPoint> &pressed, const double moved)
  {
    std::vector<double> force;
    for (const PressedPoint &point : pressed)
      {
        force.resize(std::max<std::size_t>(force.size(), point.pair + 1), 0.);
        force[point.pair] += point.force.norm();
      }
    const auto most = std::max_element(force.begin(), force.end());
    if (most == force.end() || !(*most > 0))
      return {};
    const unsigned int pair = most - force.begin();
    ContactPlace       place;
    Tensor<1, 3>       X, u;
    for (const PressedPoint &point : pressed)
      if (point.pair == pair)
        {
          const double part = point.force.norm() / *most;
          X += part * place_of(point.place, 0);
          u += part * (place_of(point.place, 1) - place_of(point.place, 0));
        }
    for (unsigned int d = 0; d < 3; ++d)
      {
        place.centre.X[d] = X[d];
        place.centre.u[d] = u[d];
      }
    double square = 0; // of the radius of a Hertz pressure, 2.5 times the mean of r^2
    for (const PressedPoint &point : pressed)
      if (point.pair == pair)
        square += 2.5 * point.force.norm() / *most *
                  (place_of(point.place, moved) - place_of(place.centre, moved)).norm_square();
    place.radius = std::sqrt(square);
    return place;
  }

  ChosenView
  choose_view(const BodySurfaces &surfaces, const std::vector<PressedPoint> &pressed, const double warp)
  {
    constexpr double   much = 0.05, far = 0.3;
    const unsigned int up = upward_axis(pressed);
    ChosenView         best;
    best.view        = view_from(up, -60, 25);
    const auto place = contact_place(pressed, warp);
    if (!place)
      return best;
    // Of views that show as much, the one from the side on which the contact is.
    const Tensor<1, 3> off     = (place_of(place->centre, 0) - middle_of(surfaces)) / size_of(surfaces);
    const BodySurfaces corners = coarse(surfaces);
    double             most    = -std::numeric_limits<double>::infinity();
    for (const double elevation : {25., -25.})
      for (const double azimuth : {-60., 30., 120., 210.})
        {
          if (elevation < 0 && best.seen > 1 - far)
            continue; // nothing to gain
          const BodyView view  = view_from(up, azimuth, elevation);
          const double   seen  = seen_part(corners, pressed, view, warp, 0.3 * place->radius);
          const double   worth = seen + 0.5 * (view.towards * off);
          if (worth > most + (elevation > 0 ? much : far))
            {
              best = {view, seen};
              most = worth;
            }
        }
    return best;
  }

  CutPlane
  choose_cut(const BodyView &view, const ContactPlace &contact, const double size, const double moved)
  {
    // `up` is the axis along which the picture goes up; of the two others the one towards the viewer.
    unsigned int up = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(view.down[d]) > std::abs(view.down[up]))
        up = d;
    const unsigned int first = (up + 1) % 3, second = (up + 2) % 3;
    const unsigned int across =
        std::abs(view.towards[first]) > std::abs(view.towards[second]) ? first : second;
    CutPlane plane;
    plane.moved               = moved;
    plane.normal              = {{0, 0, 0}};
    plane.normal[across]      = view.towards[across] > 0 ? -1 : 1;
    const Tensor<1, 3> centre = place_of(contact.centre, moved);
    for (unsigned int d = 0; d < 3; ++d)
      plane.point[d] = centre[d] + 1e-4 * size * plane.normal[d]; // not along faces of cells
    return plane;
  }
} // namespace Amontons
