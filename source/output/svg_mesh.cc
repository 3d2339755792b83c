#include <amontons/output/mesh_picture.h>
#include <amontons/output/svg_chart.h>
#include <amontons/output/terminal.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace Amontons
{
  namespace
  {
    constexpr double margin = 12, top = 34, largest = 420, bar_room = 90, axes_room = 52;
    constexpr int    n_colours = n_bar_colours;

    struct Box
    {
      double lower[2] = {1e300, 1e300}, upper[2] = {-1e300, -1e300};

      void
      include(const CellPicture &cell)
      {
        for (std::size_t i = 0; i < cell.outline.size(); ++i)
          {
            lower[i % 2] = std::min<double>(lower[i % 2], cell.outline[i]);
            upper[i % 2] = std::max<double>(upper[i % 2], cell.outline[i]);
          }
      }

      double
      size() const
      {
        return std::max(upper[0] - lower[0], upper[1] - lower[1]);
      }

      bool
      overlaps(const Box &other) const
      {
        for (int d = 0; d < 2; ++d)
          if (lower[d] > other.upper[d] || upper[d] < other.lower[d])
            return false;
        return true;
      }
    };

    Box
    box_of(const CellPicture &cell)
    {
      Box box;
      box.include(cell);
      return box;
    }

    Box
    visible_box(const MeshPicture &picture, const Window &window)
    {
      Box box;
      for (const CellPicture &cell : picture)
        box.include(cell);
      if (window.half_width > 0)
        for (int d = 0; d < 2; ++d)
          {
            box.lower[d] = std::max(box.lower[d], window.centre[d] - window.half_width);
            box.upper[d] = std::min(box.upper[d], window.centre[d] + window.half_width);
          }
      return box;
    }

    // Paths by colour: with edges (large cells), without, and pixels.
    class Painter
    {
    public:
      // left: of the picture, in pixels.
      Painter(
          const Box &box, const double left, const double scale, const double lowest, const double highest)
          : box(box), left(left), scale(scale), lowest(lowest), highest(highest)
      {
      }

      void
      draw(const CellPicture &cell)
      {
        const Box    cell_box = box_of(cell);
        const double width    = scale * (cell_box.upper[0] - cell_box.lower[0]);
        const double height   = scale * (cell_box.upper[1] - cell_box.lower[1]);
        const int    colour =
            highest > lowest ? std::lround((n_colours - 1) * (cell.value - lowest) / (highest - lowest)) : 0;
        if (std::max(width, height) < 1)
          draw_pixel(cell, colour);
        else
          (std::min(width, height) > 3 ? with_edges : without_edges)[colour] += outline(cell);
      }

      std::string
      svg() const
      {
        std::string result;
        for (const auto &[colour, path] : without_edges)
          result += "<path fill=\"" + name(colour) + "\" stroke=\"" + name(colour) +
                    "\" stroke-width=\"0.4\" d=\"" + path + "\"/>\n";
        for (const auto &[colour, path] : with_edges)
          result += "<path fill=\"" + name(colour) +
                    "\" stroke=\"#fff\" stroke-opacity=\"0.55\" stroke-width=\"0.5\" d=\"" + path + "\"/>\n";
        return result;
      }

      // Below and at the left of the picture.
      std::string
      axes(const std::array<std::string, 2> &names) const
      {
        const double x0 = px(box.lower[0]), x1 = px(box.upper[0]), y0 = py(box.lower[1]),
                     y1 = py(box.upper[1]);
        std::string svg =
            line_between(x0, y0, x1, y0, "#444") + line_between(x0, y0, x0, y1, "#444") +
            text_at((x0 + x1) / 2, y0 + 34, names[0], "text-anchor=\"middle\"") +
            text_at(16,
                    (y0 + y1) / 2,
                    names[1],
                    "text-anchor=\"middle\" transform=\"rotate(-90 16 " + pixels((y0 + y1) / 2) + ")\"");
        for (const double tick : nice_ticks(box.lower[0], box.upper[0], ticks_along(x1 - x0), false))
          svg += line_between(px(tick), y0, px(tick), y0 + 4, "#444") +
                 text_at(px(tick), y0 + 17, short_number(tick), "text-anchor=\"middle\"");
        for (const double tick : nice_ticks(box.lower[1], box.upper[1], ticks_along(y0 - y1), false))
          svg += line_between(x0 - 4, py(tick), x0, py(tick), "#444") +
                 text_at(x0 - 7, py(tick) + 4, short_number(tick), "text-anchor=\"end\"");
        return svg;
      }

    private:
      static unsigned int
      ticks_along(const double length)
      {
        return std::max(1, static_cast<int>(length / 60));
      }

      double
      px(const double x) const
      {
        return left + scale * (x - box.lower[0]);
      }

      double
      py(const double y) const
      {
        return top + scale * (box.upper[1] - y);
      }

      static std::string
      name(const int colour)
      {
        return colour_of(double(colour) / (n_colours - 1));
      }

      std::string
      outline(const CellPicture &cell) const
      {
        std::string path;
        for (std::size_t i = 0; i + 1 < cell.outline.size(); i += 2)
          path += (i == 0 ? "M" : "L") + pixels(px(cell.outline[i])) + " " + pixels(py(cell.outline[i + 1]));
        return path + "Z";
      }

      void
      draw_pixel(const CellPicture &cell, const int colour)
      {
        const int x = std::floor(px(cell.outline[0])), y = std::floor(py(cell.outline[1]));
        if (drawn.insert({x, y}).second)
          without_edges[colour] += "M" + std::to_string(x) + " " + std::to_string(y) + "h1v1h-1Z";
      }

      const Box                     box;
      const double                  left, scale, lowest, highest;
      std::map<int, std::string>    with_edges, without_edges;
      std::set<std::pair<int, int>> drawn;
    };
  } // namespace

  std::string
  svg_mesh(const MeshPicture                &picture,
           const Window                     &window,
           const std::string                &title,
           const std::array<std::string, 2> &axes)
  {
    const Box box = visible_box(picture, window), whole = visible_box(picture, Window());
    if (box.size() <= 0 || (window.half_width > 0 && box.size() > 0.7 * whole.size()))
      return "";
    const double scale  = largest / box.size();
    const double width  = scale * (box.upper[0] - box.lower[0]);
    const double height = scale * (box.upper[1] - box.lower[1]);

    std::vector<const CellPicture *> cells;
    double                           lowest = 0, highest = 0;
    for (const CellPicture &cell : picture)
      if (box_of(cell).overlaps(box))
        {
          cells.push_back(&cell);
          lowest  = std::min<double>(lowest, cell.value);
          highest = std::max<double>(highest, cell.value);
        }
    const bool   has_axes = !axes[0].empty();
    const double left     = has_axes ? axes_room : margin;
    Painter      painter(box, left, scale, lowest, highest);
    for (const CellPicture *cell : cells)
      painter.draw(*cell);

    const std::string w = pixels(left + margin + std::max(width + bar_room, 8.6 * title.size())),
                      h = pixels(std::max(height + (has_axes ? axes_room : margin), 160 + margin) + top);
    std::string id; // of this picture among those of a page
    for (const char c : title)
      id += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
    return svg_of(w,
                  h,
                  "<clipPath id=\"" + id + "\"><rect x=\"" + pixels(left) + "\" y=\"" + pixels(top) +
                      "\" width=\"" + pixels(width) + "\" height=\"" + pixels(height) +
                      "\"/></clipPath>\n<text x=\"" + pixels(left) +
                      "\" y=\"20\" font-size=\"14\" font-weight=\"600\">" + escaped(title) +
                      "</text>\n<g clip-path=\"url(#" + id + ")\">\n" + painter.svg() + "</g>\n" +
                      (has_axes ? painter.axes(axes) : "") +
                      colour_bar(left + width + 14, top, std::max(height, 120.), lowest, highest));
  }
} // namespace Amontons
