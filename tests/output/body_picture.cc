// How bodies in space become pictures: cuts of tetrahedra, the side from which the contact is seen, how much
// displacements are enlarged, what is written beside the pixels.
#include "png_reader.h"
#include "text_checks.h"

#include <amontons/output/body_views.h>
#include <amontons/output/svg_chart.h>

#include <deal.II/base/utilities.h>

namespace test_body_picture
{
using namespace Amontons;

BodyPoint
at(const double x, const double y, const double z, const double stress = 0)
{
  BodyPoint point;
  point.X      = {{float(x), float(y), float(z)}};
  point.stress = stress;
  return point;
}

// The six faces of a box, each n x n points; stresses are z.
void
add_box(BodySurfaces                &surfaces,
        const unsigned char          body,
        const std::array<double, 3> &lower,
        const std::array<double, 3> &upper,
        const unsigned int           n = 2)
{
  for (unsigned int across = 0; across < 3; ++across)
    for (const double side : {lower[across], upper[across]})
      {
        BodyPatch patch;
        patch.body = body;
        patch.n    = n;
        for (unsigned int j = 0; j <= n; ++j)
          for (unsigned int i = 0; i <= n; ++i)
            {
              std::array<double, 3> X = lower;
              const unsigned int    a = (across + 1) % 3, b = (across + 2) % 3;
              X[across] = side;
              X[a] += (upper[a] - lower[a]) * i / n;
              X[b] += (upper[b] - lower[b]) * j / n;
              patch.points.push_back(at(X[0], X[1], X[2], X[2]));
            }
        surfaces.push_back(patch);
      }
}

double
area(const BodyCut &cut)
{
  double sum = 0;
  for (const auto &triangle : cut.triangles)
    {
      const auto a = place_of(triangle.corners[0], 0), b = place_of(triangle.corners[1], 0),
                 c = place_of(triangle.corners[2], 0);
      sum += 0.5 * cross_product_3d(b - a, c - a).norm();
    }
  return sum;
}

void
check_cuts()
{
  const std::array<BodyPoint, 4> corners = {{at(0, 0, 0, 1), at(1, 0, 0, 1), at(0, 1, 0, 1), at(0, 0, 1, 5)}};
  CutPlane                       plane;
  plane.point = {{0, 0, 0.25}};
  for (const double sign : {1., -1.})
    {
      plane.normal = {{0, 0, sign}};
      BodyCut cut;
      cut_tetrahedron(corners, 3, plane, cut);
      check::is_close(cut.triangles.size(), 1, 0, "one corner on one side: a triangle");
      check::is_close(area(cut), 0.75 * 0.75 / 2, 1e-6, "its area");
      check::is_true(cut.triangles[0].body == 3, "its body");
      for (const BodyPoint &point : cut.triangles[0].corners)
        check::is_close(point.stress, 2, 1e-6, "stress in the plane");
    }
  // x + y = 1/2: two corners on each side; a rectangle of sides 1/2 sqrt(2) and 1/2.
  plane.point  = {{0.5, 0, 0}};
  plane.normal = {{std::sqrt(0.5), std::sqrt(0.5), 0}};
  BodyCut cut;
  cut_tetrahedron(corners, 0, plane, cut);
  check::is_close(cut.triangles.size(), 2, 0, "two corners on each side: a quadrilateral");
  check::is_close(area(cut), 0.25 * std::sqrt(2.), 1e-6, "its area");
  plane.point = {{9, 0, 0}};
  cut         = BodyCut();
  cut_tetrahedron(corners, 0, plane, cut);
  check::is_true(cut.triangles.empty(), "beside it: nothing");

  cut         = BodyCut();
  plane.point = {{0.5, 0, 0}};
  cut_triangle({{corners[0], corners[1], corners[3]}}, plane, cut);
  check::is_true(cut.lines.size() == 1, "a line in a triangle");
  check::is_close(
      (place_of(cut.lines[0][0], 0) - place_of(cut.lines[0][1], 0)).norm(), 0.5, 1e-6, "its length");

  // Where displacements count.
  BodyPoint moved = at(1, 2, 3);
  moved.u         = {{0, 0, 0.5}};
  plane.point     = {{0, 0, 3}};
  plane.normal    = {{0, 0, 1}};
  check::is_close(plane.distance(moved), 0, 1e-6, "reference configuration", 1);
  plane.moved = 1;
  check::is_close(plane.distance(moved), 0.5, 1e-6, "current configuration");
}

std::vector<PressedPoint>
pressed_at(const std::vector<std::array<double, 3>> &places,
           const Tensor<1, 3>                       &force,
           const unsigned int                        pair = 0)
{
  std::vector<PressedPoint> pressed;
  for (const auto &place : places)
    {
      PressedPoint point;
      point.pair  = pair;
      point.place = at(place[0], place[1], place[2]);
      point.force = force;
      pressed.push_back(point);
    }
  return pressed;
}

void
check_warp()
{
  BodySurfaces surfaces;
  add_box(surfaces, 0, {{0, 0, 0}}, {{2, 3, 6}}); // diameter 7
  check::is_close(size_of(surfaces), 7, 1e-6, "size");
  check::is_close(warp_factor(surfaces, {}), 1, 0, "no displacement");
  surfaces[0].points[0].u = {{0, 7e-3f, 0}};
  check::is_close(warp_factor(surfaces, {}), 50, 1e-12, "a thousandth");
  surfaces[0].points[0].u = {{0, 7e-3f / 1.5f, 0}};
  check::is_close(warp_factor(surfaces, {}), 50, 1e-12, "75 is rounded down");
  surfaces[0].points[0].u = {{0, 7e-3f, 0}};
  auto pressed            = pressed_at({{{1, 1, 1}}}, Tensor<1, 3>({0, 0, 1}));
  check::is_close(warp_factor(surfaces, pressed), 50, 1e-12, "without a gap");
  pressed[0].gap = -7e-4; // enlarged it may be 0.004 of the size: 1 + 40
  check::is_close(warp_factor(surfaces, pressed), 20, 1e-12, "overlaps would be seen");
  surfaces[0].points[0].u = {{0, 0.5, 0}};
  check::is_close(warp_factor(surfaces, {}), 1, 0, "seen as it is");
}

void
check_views()
{
  // A box pressed from above in its middle.
  BodySurfaces box;
  add_box(box, 0, {{0, 0, 0}}, {{4, 4, 4}});
  const Tensor<1, 3> down({0, 0, -1});
  const ChosenView   above = choose_view(box, pressed_at({{{2, 2, 4}}, {{2.2, 2, 4}}}, down), 1);
  check::is_close(above.seen, 1, 1e-12, "seen from above");
  check::is_true(above.view.towards[2] > 0 && above.view.down[2] < 0, "z is up");
  check::is_true(above.view.towards[1] < 0 && above.view.right[0] > 0, "nothing else to see: from before");
  check::is_close((cross_product_3d(above.view.right, above.view.down) + above.view.towards).norm(),
                  0,
                  1e-12,
                  "axes of the view",
                  1);
  // From below: only where that shows it.
  const ChosenView below = choose_view(box, pressed_at({{{2, 2, 0}}, {{2.2, 2, 0}}}, -1. * down), 1);
  check::is_true(below.view.towards[2] < 0 && below.seen > 0.99, "seen from below");

  // A quarter of two bodies, the contact at their common edge x = y = 4.
  BodySurfaces quarter;
  add_box(quarter, 0, {{0, 0, 0}}, {{4, 4, 4}});
  add_box(quarter, 1, {{0, 0, 4}}, {{4, 4, 8}});
  const std::vector<std::array<double, 3>> corner = {
      {{4, 4, 4}}, {{3.9, 4, 4}}, {{4, 3.9, 4}}, {{3.9, 3.9, 4}}};
  const ChosenView side = choose_view(quarter, pressed_at(corner, down), 1);
  check::is_true(side.view.towards[0] > 0 && side.view.towards[1] > 0, "from where the quarter is cut");
  check::is_true(side.seen > 0.7, "the contact is seen: " + std::to_string(side.seen));

  // In the middle between them it is hidden, and the bodies are cut through it.
  const auto       hidden = pressed_at({{{2, 2, 4}}, {{2.2, 2, 4}}, {{1.8, 2, 4}}}, down);
  const ChosenView nobody = choose_view(quarter, hidden, 1);
  check::is_close(nobody.seen, 0, 1e-12, "hidden", 1);
  // Rounding that puts the contact behind the middle is no reason to look from elsewhere.
  const auto behind = pressed_at({{{2, 2.000001, 4}}, {{2.2, 2.000001, 4}}, {{1.8, 2.000001, 4}}}, down);
  check::is_close((choose_view(quarter, behind, 1).view.towards - nobody.view.towards).norm(),
                  0,
                  1e-12,
                  "rounding does not choose the view",
                  1);
  const auto place = contact_place(hidden, 0);
  check::is_true(place && std::abs(place->centre.X[0] - 2) < 1e-6, "centre of the contact");
  check::is_close(place->radius, std::sqrt(2.5 * 2 * 0.04 / 3), 1e-5, "its radius");
  const CutPlane plane = choose_cut(nobody.view, *place, 8, 0);
  check::is_close(plane.distance(at(7, 2, 9)), 0, 1e-3, "through the centre, across the view", 1);
  check::is_close(plane.distance(at(0, 3, 0)), 1, 1e-2, "what is behind is kept");

  // The pair that is pressed most; the axis of all forces.
  auto pressed = pressed_at({{{4, 2, 2}}}, Tensor<1, 3>({-5, 0, 0}), 1);
  pressed.insert(pressed.begin(), hidden.begin(), hidden.end());
  check::is_close(contact_place(pressed, 0)->centre.X[0], 4, 1e-6, "of two pairs one");
  check::is_true(choose_view(quarter, pressed, 1).view.down[0] < -0.5, "x is up");
  check::is_true(!contact_place({}, 0), "nothing is pressed");
}

Image
image_of(const std::string &svg)
{
  const std::string head  = "base64,";
  const auto        begin = svg.find(head) + head.size();
  const auto        bytes = Utilities::decode_base64(svg.substr(begin, svg.find('"', begin) - begin));
  return check::read_png(std::string(bytes.begin(), bytes.end()));
}

void
check_picture()
{
  BodySurfaces box;
  add_box(box, 0, {{0, 0, 0}}, {{1, 1, 3}}, 1);
  BodyView view; // along y, z up
  view.right          = Tensor<1, 3>({1, 0, 0});
  view.down           = Tensor<1, 3>({0, 0, -1});
  view.towards        = Tensor<1, 3>({0, -1, 0});
  const Camera camera = camera_of({&box}, view, 1, 206, 306);
  check::is_close(camera.scale, 100, 1e-5, "the height fits");
  check::is_true(camera.width == 106 && camera.height == 306, "as wide as it has to be");

  BodyPicture picture{"Two <boxes>", view, {{Raster(camera.width, camera.height), "label"}}, "A caption."};
  check::is_true(svg_bodies(picture).empty() && svg_bodies(BodyPicture()).empty(), "nothing to see");
  draw_bodies(box, {}, nullptr, camera, picture.panels[0].raster);
  check::is_close(picture.panels[0].raster.highest(), 3, 0.01, "stress at the top");
  const std::string svg = svg_bodies(picture);
  for (const std::string text :
       {">Two &lt;boxes&gt;<", ">label<", ">A caption.<", ">x</text>", ">y</text>", ">z</text>", ">2</text>"})
    check::contains(svg, text);
  const Image image = image_of(svg);
  check::is_true(image.width == 106 && image.height == 306, "size of the image");
  const std::array<int, 3> white = {{255, 255, 255}};
  check::is_true(check::pixel(image, 1, 150) == white && check::pixel(image, 53, 1) == white, "margin");
  // In the middle the green of half the stress, in full light but for 0.936.
  const auto middle = check::pixel(image, 53, 153);
  for (unsigned int c = 0; c < 3; ++c)
    check::is_close(middle[c], 0.936 * std::array<int, 3>{{33, 145, 140}}[c], 3, "colour of the middle", 1);
  check::is_true(check::pixel(image, 53, 20)[0] > 200 && check::pixel(image, 53, 280)[0] < 90,
                 "yellow above, violet below");
  check::is_true(check::pixel(image, 3, 153)[1] < 115, "an outline");

  // Behind a plane, with what lies in it.
  CutPlane plane;
  plane.point  = {{0.5, 0, 0}};
  plane.normal = {{1, 0, 0}};
  BodyCut cut;
  cut.triangles.push_back({0, {{at(0.5, 0, 0, 3), at(0.5, 1, 0, 3), at(0.5, 0, 3, 3)}}});
  Raster half(camera.width, camera.height);
  draw_bodies(box, cut, &plane, camera, half);
  const Image kept = half.image(0, 3);
  check::is_true(check::pixel(kept, 25, 153) == white && check::pixel(kept, 80, 153) != white,
                 "half is cut away");
}

int
main(int, char **)
{
  check_cuts();
  check_warp();
  check_views();
  check_picture();
  return check::result();
}
} // namespace test_body_picture
