// Pictures of the report: the same wherever the body lies, what is thin without edges, what is tiny once, the
// colours beside it; charts of nothing but zeros.
#include "text_checks.h"

#include <amontons/output/mesh_picture.h>
#include <amontons/output/svg_chart.h>

namespace test_svg
{
using namespace Amontons;

CellPicture
rectangle(const float x, const float y, const float width, const float height, const float value)
{
  return {{x, y, x + width, y, x + width, y + height, x, y + height}, value};
}

// 8 x 4 in 420 pixels, one to 1/52.5: a square, a sliver of 2 pixels and two cells of the same pixel.
std::string
picture(const float x, const float y)
{
  MeshPicture cells = {rectangle(x, y, 7.5, 4, 1), rectangle(x + 7.5, y, 0.03125, 4, 2)};
  for (const float h : {0.f, 0.0078125f})
    cells.push_back(rectangle(x + 8 - 0.015625f, y + 4 - 0.0078125f - h, 0.0078125f, 0.0078125f, 3));
  cells.push_back(rectangle(x + 7.96875f, y, 0.03125, 2, 4));
  return svg_mesh(cells, Window(), "title");
}

void
check_pictures()
{
  const std::string here = picture(0, 0);
  check::is_true(!here.empty() && here == picture(1024, -512), "a picture does not tell where the body lies");
  check::is_close(check::count(here, "stroke-opacity"), 1, 0, "one cell is wide enough for edges");
  check::is_close(check::count(here, "h1v1h-1Z"), 1, 0, "two cells of one pixel");
  // The picture ends at 12 + 420, the bar begins 14 beside it.
  check::is_close(check::count(here, "<rect x=\"446.0\""), 24, 0, "colours beside the picture");
}

// Of two cells the lower one has the first colour, and the bar numbers below zero; where all is zero it says
// so.
void
check_values()
{
  const MeshPicture tied = {rectangle(0, 0, 1, 1, -5), rectangle(1, 0, 1, 1, 0)},
                    none = {rectangle(0, 0, 1, 1, 0), rectangle(1, 0, 1, 1, 0)};
  const std::string svg  = svg_mesh(tied, Window(), "tied");
  for (const double place : {0., 1.})
    check::is_close(
        check::count(svg, "fill=\"" + colour_of(place) + "\" stroke"), 1, 0, "a cell of an end's colour", 1);
  check::is_true(svg.find(">-4</text>") != std::string::npos, "the bar numbers tension");
  check::is_close(check::count(svg_mesh(none, Window(), "none"), ">0</text>"), 1, 0, "the bar says zero");
}

// 8 x 4 with its lower left corner at (2, 0): x = 4 lies at a quarter, y = 2 at half of the height.
void
check_axes()
{
  const MeshPicture faces = {rectangle(2, 0, 8, 4, 1)};
  const std::string svg   = svg_mesh(faces, Window(), "faces", {{"x [mm]", "z [mm]"}});
  for (const char *const text : {">x [mm]</text>",
                                 ">z [mm]</text>",
                                 "x=\"157.0\" y=\"261.0\" text-anchor=\"middle\">4</text>",
                                 "y=\"143.0\" text-anchor=\"end\">2</text>"})
    check::contains(svg, text);
  check::is_true(svg_mesh(faces, Window(), "faces").find("text-anchor") == std::string::npos,
                 "no axes unless named");
}

void
check_chart_of_zeros()
{
  Chart chart;
  chart.curves = {{"nothing", {0, 1, 2}, {0, 0, 0}}};
  check::is_close(check::count(svg_chart(chart), "nan"), 0, 0, "a curve of zeros has its place", 1);
}

// From 74 to 514: room of a fiftieth of six decades on both sides, 10^0.12 = 1.318; a single value, which has
// no decades, lies in the middle of 1.3 times less and more.
void
check_logarithmic_axis()
{
  Chart chart;
  chart.log_x           = true;
  chart.curves          = {{"", {1, 1e6}, {1, 1}, false, true}};
  const std::string six = svg_chart(chart);
  for (const char *const place : {"cx=\"82.5\"", "cx=\"505.5\""})
    check::is_close(check::count(six, place), 1, 0, place);
  chart.curves = {{"", {10}, {1}, false, true}};
  check::is_close(check::count(svg_chart(chart), "cx=\"294.0\""), 1, 0, "a single value");
}

int
main(int, char **)
{
  check_pictures();
  check_values();
  check_axes();
  check_chart_of_zeros();
  check_logarithmic_axis();
  return check::result();
}
} // namespace test_svg
