// Which pixels triangles and lines cover, in which colours, and what of them is seen.
#include "png_reader.h"

#include <amontons/output/rasteriser.h>

namespace test_rasteriser
{
using namespace Amontons;

const std::array<int, 3> white = {{255, 255, 255}};

RasterPoint
point(const double x, const double y, const double depth, const double value, const double keep = 1)
{
  RasterPoint p;
  p.x      = x;
  p.y      = y;
  p.depth  = depth;
  p.value  = value;
  p.normal = dealii::Tensor<1, 3>({0, 0, 1});
  p.keep   = keep;
  return p;
}

// A square that faces the viewer.
void
draw_square(Raster            &raster,
            const double       x,
            const double       y,
            const double       size,
            const double       depth,
            const double       value,
            const unsigned int part)
{
  const RasterPoint a = point(x, y, depth, value), b = point(x + size, y, depth, value),
                    c = point(x + size, y + size, depth, value), d = point(x, y + size, depth, value);
  raster.triangle({{a, b, c}}, part);
  raster.triangle({{a, d, c}}, part);
}

void
expect_colour(const std::array<int, 3> &found, const std::array<int, 3> &wanted, const std::string &what)
{
  for (unsigned int c = 0; c < 3; ++c)
    check::is_close(found[c], wanted[c], 1, what + ", channel " + std::to_string(c), 1.01);
}

// The triangle x + y < 8 of a picture of 12 x 10.
void
check_coverage()
{
  for (const bool turned : {false, true})
    {
      Raster            raster(12, 10);
      const RasterPoint a = point(0, 0, 0, 1), b = point(8, 0, 0, 1), c = point(0, 8, 0, 1);
      check::is_true(raster.is_empty() && raster.highest() == 0 && raster.lowest() == 0, "nothing yet");
      raster.triangle({{a, turned ? c : b, turned ? b : c}}, 0);
      check::is_true(!raster.is_empty(), "a triangle");
      const Image image = raster.image(0, 1);
      check::is_true(image.width == 12 && image.height == 10, "size");
      for (unsigned int y = 0; y < 10; ++y)
        for (unsigned int x = 0; x < 12; ++x)
          if (x + y != 7)
            check::is_true((check::pixel(image, x, y) == white) == (x + y > 7),
                           "pixel " + std::to_string(x) + ", " + std::to_string(y));
      // On the slanted side: three of four samples.
      for (const int channel : check::pixel(image, 4, 3))
        check::is_true(channel > 60 && channel < 255, "a pixel of the side is mixed");
    }
  Raster raster(4, 4);
  raster.triangle({{point(1, 1, 0, 1), point(2, 2, 0, 1), point(3, 3, 0, 1)}}, 0);
  raster.triangle({{point(NAN, 1, 0, 1), point(2, 2, 0, 1), point(3, 0, 0, 1)}}, 0);
  raster.triangle({{point(-9, 1, 0, 1), point(-5, 2, 0, 1), point(-7, 9, 0, 1)}}, 0);
  check::is_true(raster.is_empty(), "no area, no place, outside");
  for (const auto channel : raster.image(0, 1).rgb)
    check::is_true(channel == 255, "white");
}

// Viridis at 0, 1/2 and 1, in a light that a face to the viewer has 0.68 + 0.32 x 0.8 of.
void
check_colours()
{
  const std::array<std::array<int, 3>, 3> colours = {{{{68, 1, 84}}, {{33, 145, 140}}, {{253, 231, 37}}}};
  Raster                                  raster(60, 20);
  for (unsigned int i = 0; i < 3; ++i)
    draw_square(raster, 20 * i, 0, 20, 0, 100 + 50 * i, 0);
  check::is_close(raster.highest(), 200, 1e-6, "highest");
  check::is_close(raster.lowest(), 100, 1e-6, "lowest");
  const Image image = raster.image(100, 200);
  for (unsigned int i = 0; i < 3; ++i)
    {
      std::array<int, 3> wanted;
      for (unsigned int c = 0; c < 3; ++c)
        wanted[c] = std::lround(0.936 * colours[i][c]);
      expect_colour(
          check::pixel(image, 20 * i + 10, 10), wanted, "colour of " + std::to_string(100 + 50 * i));
    }
  // A face that looks away from the light is darker.
  Raster      turned(20, 20);
  RasterPoint a = point(0, 0, 0, 1), b = point(20, 0, 0, 1), c = point(0, 20, 0, 1);
  for (RasterPoint *const p : {&a, &b, &c})
    p->normal = dealii::Tensor<1, 3>({0.6, 0.8, 0});
  turned.triangle({{a, b, c}}, 0);
  expect_colour(check::pixel(turned.image(0, 1), 5, 5), {{172, 157, 25}}, "away from the light");
}

void
check_depth()
{
  for (const bool near_first : {false, true})
    {
      Raster raster(20, 20);
      for (const bool near : {near_first, !near_first})
        draw_square(raster, near ? 5 : 0, near ? 5 : 0, near ? 10 : 20, near ? 7 : 3, near ? 1 : 2, near);
      const Image image = raster.image(1, 2);
      expect_colour(check::pixel(image, 10, 10), {{64, 1, 79}}, "the nearer one");
      expect_colour(check::pixel(image, 2, 10), {{237, 216, 35}}, "beside it the other");
      check::is_true(check::pixel(image, 5, 10)[1] > 60,
                     "a light outline between them, as the nearer one is dark");
      check::is_true(raster.sees(point(10, 10, 7, 0), 0.1) && !raster.sees(point(10, 10, 3, 0), 0.1) &&
                         raster.sees(point(2, 10, 3, 0), 0.1) && raster.sees(point(10, 10, 3, 0), 4.1),
                     "what is seen");
      check::is_true(!raster.sees(point(21, 10, 9, 0), 0.1), "outside");
    }
  // What is hidden has no part in the range of values.
  Raster raster(20, 20);
  draw_square(raster, 5, 5, 10, 0, 99, 0);
  draw_square(raster, 0, 0, 20, 1, 2, 0);
  check::is_close(raster.highest(), 2, 1e-6, "a hidden peak");
}

void
check_cut()
{
  Raster            raster(20, 20);
  const RasterPoint a = point(0, 0, 0, 1, -5), b = point(20, 0, 0, 1, 15), c = point(20, 20, 0, 1, 15),
                    d = point(0, 20, 0, 1, -5); // keep = x - 5
  raster.triangle({{a, b, c}}, 0);
  raster.triangle({{a, c, d}}, 0);
  raster.line(point(0, 10, 0, 0, -5), point(20, 10, 0, 0, 15), 1);
  const Image image = raster.image(0, 1);
  check::is_true(check::pixel(image, 4, 15) == white && check::pixel(image, 4, 10) == white, "cut away");
  check::is_true(check::pixel(image, 6, 15) != white, "kept");
  expect_colour(check::pixel(image, 15, 15), {{237, 216, 35}}, "colour of what is kept");
}

void
check_lines()
{
  Raster raster(20, 20);
  raster.line(point(0, 3, 0, 0), point(20, 3, 0, 0), 1);
  check::is_true(raster.is_empty(), "no line over nothing");
  draw_square(raster, 0, 0, 20, 0, 1, 0);
  draw_square(raster, 12, 0, 8, 30, 1, 0);
  raster.line(point(0, 3, 0, 0), point(20, 3, 0, 0), 1);
  raster.line(point(5, 0, 0, 0), point(5, 20, 0, 0), 0.5);
  const Image image = raster.image(0, 1);
  check::is_true(check::pixel(image, 9, 3)[0] + check::pixel(image, 9, 2)[0] < 237 + 20, "a dark line");
  expect_colour(check::pixel(image, 16, 3), {{237, 216, 35}}, "hidden by what is before it");
  expect_colour(check::pixel(image, 9, 12), {{237, 216, 35}}, "beside it");
  const int light = check::pixel(image, 5, 12)[0] + check::pixel(image, 4, 12)[0];
  check::is_true(light > 237 + 100 && light < 237 + 140, "half as dark: " + std::to_string(light));
}

int
main(int, char **)
{
  check_coverage();
  check_colours();
  check_depth();
  check_cut();
  check_lines();
  return check::result();
}
} // namespace test_rasteriser
