#include <amontons/output/body_picture.h>
#include <amontons/output/svg_chart.h>
#include <amontons/output/terminal.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    // Faces with edges of some pixels have lines around them; the darker, the longer.
    double
    strength_of_lines(const std::array<RasterPoint, 4> &corners)
    {
      double shortest = 1e300;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const RasterPoint &a = corners[i], &b = corners[(i + 1) % 4];
          shortest = std::min(shortest, std::hypot(a.x - b.x, a.y - b.y));
        }
      return 0.3 * std::clamp((shortest - 2.5) / 5, 0., 1.);
    }

    // The points of a face in the picture, with normals by differences of their neighbours.
    std::vector<RasterPoint>
    project(const BodyPatch &patch, const CutPlane *plane, const Camera &camera)
    {
      std::vector<RasterPoint> points;
      for (const BodyPoint &point : patch.points)
        {
          points.push_back(camera.project(point));
          if (plane != nullptr)
            points.back().keep = plane->distance(point);
        }
      const unsigned int n  = patch.n;
      const auto         at = [&](const unsigned int i, const unsigned int j) -> RasterPoint         &{
        return points[j * (n + 1) + i];
      };
      const auto along = [](const RasterPoint &a, const RasterPoint &b) {
        return Tensor<1, 3>({b.x - a.x, b.y - a.y, b.depth - a.depth});
      };
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          {
            const Tensor<1, 3> normal =
                cross_product_3d(along(at(i > 0 ? i - 1 : 0, j), at(std::min(i + 1, n), j)),
                                 along(at(i, j > 0 ? j - 1 : 0), at(i, std::min(j + 1, n))));
            at(i, j).normal = normal / std::max(normal.norm(), 1e-300);
            // Of both sides the one that is seen.
            if (at(i, j).normal[2] < 0)
              at(i, j).normal *= -1.;
          }
      return points;
    }

    void
    draw_faces(const BodyPatch &patch, const std::vector<RasterPoint> &points, Raster &raster)
    {
      for (unsigned int j = 0; j < patch.n; ++j)
        for (unsigned int i = 0; i < patch.n; ++i)
          {
            const RasterPoint &a = points[j * (patch.n + 1) + i], &b = points[j * (patch.n + 1) + i + 1],
                              &c = points[(j + 1) * (patch.n + 1) + i],
                              &d = points[(j + 1) * (patch.n + 1) + i + 1];
            raster.triangle({{a, b, d}}, patch.body);
            raster.triangle({{a, d, c}}, patch.body);
          }
    }

    void
    draw_edges(const BodyPatch &patch, const std::vector<RasterPoint> &points, Raster &raster)
    {
      const unsigned int n  = patch.n;
      const auto         at = [&](const unsigned int i, const unsigned int j) -> const RasterPoint         &{
        return points[j * (n + 1) + i];
      };
      const double strength = strength_of_lines({{at(0, 0), at(n, 0), at(n, n), at(0, n)}});
      for (unsigned int i = 0; i < n && strength > 0; ++i)
        for (const unsigned int side : {0u, n})
          {
            raster.line(at(i, side), at(i + 1, side), strength);
            raster.line(at(side, i), at(side, i + 1), strength);
          }
    }

    // Triangles of the cut are seen from before.
    void
    draw_cut(const BodyCut &cut, const CutPlane &plane, const Camera &camera, Raster &raster)
    {
      const Tensor<1, 3> normal({plane.normal[0], plane.normal[1], plane.normal[2]});
      const Tensor<1, 3> seen(
          {camera.view.right * normal, camera.view.down * normal, camera.view.towards * normal});
      for (const BodyCut::Triangle &triangle : cut.triangles)
        {
          std::array<RasterPoint, 3> corners;
          for (unsigned int i = 0; i < 3; ++i)
            {
              corners[i]        = camera.project(triangle.corners[i]);
              corners[i].normal = seen[2] < 0 ? -seen : seen;
            }
          raster.triangle(corners, triangle.body);
        }
    }

    void
    draw_cut_lines(const BodyCut &cut, const Camera &camera, Raster &raster)
    {
      double length = 0;
      for (const auto &line : cut.lines)
        {
          const RasterPoint a = camera.project(line[0]), b = camera.project(line[1]);
          length += std::hypot(a.x - b.x, a.y - b.y) / cut.lines.size();
        }
      const double strength = 0.3 * std::clamp((2 * length - 2.5) / 5, 0., 1.);
      for (const auto &line : cut.lines)
        raster.line(camera.project(line[0]), camera.project(line[1]), strength);
    }
  } // namespace

  Tensor<1, 3>
  place_of(const BodyPoint &point, const double moved)
  {
    Tensor<1, 3> x;
    for (unsigned int d = 0; d < 3; ++d)
      x[d] = point.X[d] + moved * point.u[d];
    return x;
  }

  RasterPoint
  Camera::project(const BodyPoint &point) const
  {
    const Tensor<1, 3> place = place_of(point, warp);
    RasterPoint        result;
    result.x     = scale * (view.right * place - x);
    result.y     = scale * (view.down * place - y);
    result.depth = scale * (view.towards * place);
    result.value = point.stress;
    return result;
  }

  Camera
  camera_of(const std::vector<const BodySurfaces *> &states,
            const BodyView                          &view,
            const double                             warp,
            const unsigned int                       width,
            const unsigned int                       height)
  {
    constexpr double margin   = 3; // pixels
    double           lower[2] = {1e300, 1e300}, upper[2] = {-1e300, -1e300};
    for (const BodySurfaces *surfaces : states)
      for (const BodyPatch &patch : *surfaces)
        for (const BodyPoint &point : patch.points)
          {
            const Tensor<1, 3> place = place_of(point, warp);
            for (unsigned int d = 0; d < 2; ++d)
              {
                const double at = (d == 0 ? view.right : view.down) * place;
                lower[d]        = std::min(lower[d], at);
                upper[d]        = std::max(upper[d], at);
              }
          }
    Camera camera;
    camera.view = view;
    camera.warp = warp;
    if (!(upper[0] > lower[0]) || !(upper[1] > lower[1]))
      return camera;
    camera.scale =
        std::min((width - 2 * margin) / (upper[0] - lower[0]), (height - 2 * margin) / (upper[1] - lower[1]));
    camera.x      = lower[0] - margin / camera.scale;
    camera.y      = lower[1] - margin / camera.scale;
    camera.width  = std::lround(camera.scale * (upper[0] - lower[0]) + 2 * margin);
    camera.height = std::lround(camera.scale * (upper[1] - lower[1]) + 2 * margin);
    return camera;
  }

  void
  draw_bodies(const BodySurfaces &surfaces,
              const BodyCut      &cut,
              const CutPlane     *plane,
              const Camera       &camera,
              Raster             &raster)
  {
    std::vector<std::vector<RasterPoint>> points;
    for (const BodyPatch &patch : surfaces)
      {
        points.push_back(project(patch, plane, camera));
        draw_faces(patch, points.back(), raster);
      }
    if (plane != nullptr)
      draw_cut(cut, *plane, camera, raster);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      draw_edges(surfaces[i], points[i], raster);
    draw_cut_lines(cut, camera, raster);
  }

  namespace
  {
    constexpr double edge = 12, under_title = 34, gap_between = 14, bar_room = 92, triad_room = 92,
                     line_height = 16;

    std::string
    label_at(const double x, const double y, const std::string &text, const std::string &more = "")
    {
      return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\"" + more + ">" + escaped(text) +
             "</text>\n";
    }

    // Arrows along the axes from a point; those towards the viewer last.
    std::string
    triad(const BodyView &view, const double x, const double y)
    {
      static const std::array<const char *, 3> names   = {{"x", "y", "z"}},
                                               colours = {{"#c0392b", "#2a8a55", "#1f6fb4"}};
      constexpr double            length               = 26;
      std::array<unsigned int, 3> order                = {{0, 1, 2}};
      std::sort(order.begin(), order.end(), [&](const unsigned int a, const unsigned int b) {
        return view.towards[a] < view.towards[b];
      });
      std::string svg;
      for (const unsigned int d : order)
        {
          const double dx = view.right[d], dy = view.down[d], size = std::hypot(dx, dy);
          svg += "<path d=\"M" + pixels(x) + " " + pixels(y) + "L" + pixels(x + length * dx) + " " +
                 pixels(y + length * dy) + "\" stroke=\"" + colours[d] + "\" stroke-width=\"2\"/>\n";
          // The name beyond the end, but not far where the axis points at the viewer.
          const double beyond = (length * size + 9) / std::max(size, 0.3);
          svg += label_at(x + beyond * dx,
                          y + beyond * dy + 4,
                          names[d],
                          std::string(" text-anchor=\"middle\" fill=\"") + colours[d] + "\"");
        }
      return svg;
    }

    // Of at most so many letters.
    std::vector<std::string>
    lines_of(const std::string &text, const std::size_t most)
    {
      std::vector<std::string> lines;
      std::string              rest = text;
      while (rest.size() > most)
        {
          std::size_t end = rest.rfind(' ', most);
          if (end == std::string::npos || end == 0)
            end = most;
          lines.push_back(rest.substr(0, end));
          rest = rest.substr(std::min(rest.size(), end + 1));
        }
      if (!rest.empty())
        lines.push_back(rest);
      return lines;
    }

    std::string
    image_at(const Image &image, const double x, const double y)
    {
      return "<image x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" width=\"" + std::to_string(image.width) +
             "\" height=\"" + std::to_string(image.height) + "\" href=\"" + data_uri(image) + "\"/>\n";
    }

    struct Row
    {
      std::string svg;
      double      width = 0, height = 0;
    };

    // Side by side, in the middle of the height; labels below.
    Row
    row_of(const BodyPicture &picture, const double lowest, const double highest)
    {
      std::vector<Image> images;
      Row                row;
      row.height = 110 + triad_room;
      for (const auto &panel : picture.panels)
        {
          images.push_back(panel.raster.image(lowest, highest));
          row.height = std::max<double>(row.height, images.back().height);
        }
      for (std::size_t i = 0; i < images.size(); ++i)
        {
          const std::string &label = picture.panels[i].label;
          const double room = std::max<double>(images[i].width, 6.8 * label.size()), x = edge + row.width;
          row.svg += image_at(
              images[i], x + (room - images[i].width) / 2, under_title + (row.height - images[i].height) / 2);
          if (!label.empty())
            row.svg += label_at(
                x + room / 2, under_title + row.height + line_height, label, " text-anchor=\"middle\"");
          row.width += room + gap_between;
        }
      return row;
    }
  } // namespace

  std::string
  svg_bodies(const BodyPicture &picture)
  {
    double lowest = 0, highest = 0;
    bool   has_labels = false;
    for (const auto &panel : picture.panels)
      {
        if (panel.raster.is_empty())
          return "";
        lowest  = std::min(lowest, panel.raster.lowest());
        highest = std::max(highest, panel.raster.highest());
        has_labels |= !panel.label.empty();
      }
    if (picture.panels.empty())
      return "";
    const Row    row     = row_of(picture, lowest, highest);
    const double right   = edge + row.width;
    const double total   = std::max(right + bar_room, 2 * edge + 8.6 * picture.title.size());
    const double under   = under_title + row.height + (has_labels ? line_height + 6 : 0);
    const auto   lines   = lines_of(picture.caption, (total - 2 * edge) / 6.2);
    std::string  content = label_at(edge, 20, picture.title, " font-size=\"14\" font-weight=\"600\"") +
                          row.svg + colour_bar(right, under_title, row.height - triad_room, lowest, highest) +
                          triad(picture.view, right + 34, under_title + row.height - 40);
    for (std::size_t i = 0; i < lines.size(); ++i)
      content += label_at(edge, under + (i + 1) * line_height, lines[i], " fill=\"#666\"");
    return svg_of(pixels(total), pixels(under + lines.size() * line_height + edge), content);
  }
} // namespace Amontons
