/// Triangles and lines in space as pixels: a buffer of depths, values that become colours at the end, light,
/// outlines, and 2 x 2 samples per pixel.
#pragma once

#include <amontons/output/png.h>

#include <deal.II/base/tensor.h>

#include <array>

namespace Amontons
{
  /// In pixels from the upper left corner, y downwards; the larger `depth` (pixels, too) is seen.
  struct RasterPoint
  {
    double               x = 0, y = 0, depth = 0;
    double               value = 0;
    dealii::Tensor<1, 3> normal;   // unit, of either side; z towards the viewer
    double               keep = 1; // what is interpolated to less than 0 is cut away
  };

  class Raster
  {
  public:
    /// Size in pixels; nothing is drawn yet.
    Raster(const unsigned int width, const unsigned int height);

    /// Values between 0 and n_parts - 1 tell parts apart, between which there is an outline.
    void
    triangle(const std::array<RasterPoint, 3> &corners, const unsigned char part);

    /// A thin line, dark on light and light on dark, where nothing is before it; after all triangles.
    /// strength: 0 (unseen) to 1.
    void
    line(const RasterPoint &a, const RasterPoint &b, const double strength);

    /// Whether a point is seen, or no deeper than `tolerance` (pixels) behind what is.
    bool
    sees(const RasterPoint &point, const double tolerance) const;

    bool
    is_empty() const;

    /// The largest and smallest value that is seen; 0 where there is none.
    double
    highest() const;
    double
    lowest() const;

    /// Values from `lowest` to `highest` take the colours of colour_of(); the rest is white.
    Image
    image(const double lowest, const double highest) const;

  private:
    static constexpr int n_samples = 2; // per pixel and direction

    struct Sample
    {
      float                      depth = -1e30f, value = 0;
      std::array<signed char, 3> normal = {{0, 0, 0}};
      unsigned char              part = no_part, line = 0; // line: strength, 0 to 255
    };
    static constexpr unsigned char no_part = 255;

    bool
    is_inside(const int x, const int y) const
    {
      return x >= 0 && y >= 0 && x < width && y < height;
    }
    const Sample &
    at(const int x, const int y) const
    {
      return samples[std::size_t(y) * width + x];
    }
    double
    outline(const int x, const int y) const;
    std::array<double, 3>
    colour(const int x, const int y, const double lowest, const double highest) const;

    const int           width, height; // samples
    std::vector<Sample> samples;
  };
} // namespace Amontons
