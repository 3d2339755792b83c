#include <amontons/output/rasteriser.h>
#include <amontons/output/svg_chart.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    // Twice the area of the triangle a, b, p, by sign.
    double
    cross(const RasterPoint &a, const RasterPoint &b, const double x, const double y)
    {
      return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    }

    // From behind the viewer's left shoulder.
    const dealii::Tensor<1, 3> light({-0.36, -0.48, 0.8});
    constexpr double           ambient = 0.74;

    // Samples about a point, within the picture.
    struct Range
    {
      int first, end;

      Range(const double lowest, const double highest, const double samples_per_pixel, const int size)
          : first(std::max(0., std::floor(std::min(lowest * samples_per_pixel, 1e6)))),
            end(std::min<double>(size, std::ceil(std::max(highest * samples_per_pixel, -1e6)) + 1))
      {
      }
    };

    using Colour = std::array<double, 3>;

    std::vector<Colour>
    colour_table()
    {
      std::vector<Colour> table;
      for (unsigned int i = 0; i < 256; ++i)
        {
          const std::string name = colour_of(i / 255.);
          table.push_back({{std::stoi(name.substr(1, 2), nullptr, 16) / 255.,
                            std::stoi(name.substr(3, 2), nullptr, 16) / 255.,
                            std::stoi(name.substr(5, 2), nullptr, 16) / 255.}});
        }
      return table;
    }
  } // namespace

  Raster::Raster(const unsigned int width, const unsigned int height)
      : width(n_samples * width), height(n_samples * height), samples(std::size_t(this->width) * this->height)
  {
  }

  // At each sample within, what is nearer than what is there.
  void
  Raster::triangle(const std::array<RasterPoint, 3> &corners, const unsigned char part)
  {
    const RasterPoint &a = corners[0], &b = corners[1], &c = corners[2];
    const double       area = cross(a, b, c.x, c.y);
    if (!(std::abs(area) > 0) || (a.keep < 0 && b.keep < 0 && c.keep < 0))
      return;
    const Range rows(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), n_samples, height);
    const Range columns(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), n_samples, width);
    for (int y = rows.first; y < rows.end; ++y)
      for (int x = columns.first; x < columns.end; ++x)
        {
          const double px = (x + 0.5) / n_samples, py = (y + 0.5) / n_samples;
          const double wa = cross(b, c, px, py) / area, wb = cross(c, a, px, py) / area, wc = 1 - wa - wb;
          if (wa < 0 || wb < 0 || wc < 0 || wa * a.keep + wb * b.keep + wc * c.keep < 0)
            continue;
          Sample     &sample = samples[std::size_t(y) * width + x];
          const float depth  = wa * a.depth + wb * b.depth + wc * c.depth;
          if (!(depth > sample.depth))
            continue;
          dealii::Tensor<1, 3> normal = wa * a.normal + wb * b.normal + wc * c.normal;
          normal *= (normal[2] < 0 ? -1 : 1) / std::max(normal.norm(), 1e-30);
          sample.depth = depth;
          sample.value = wa * a.value + wb * b.value + wc * c.value;
          sample.part  = part;
          for (unsigned int d = 0; d < 3; ++d)
            sample.normal[d] = std::lround(127 * normal[d]);
        }
  }

  // Two samples wide, in steps of one along the longer side. What lies on a surface is in front of it by a
  // little.
  void
  Raster::line(const RasterPoint &a, const RasterPoint &b, const double strength)
  {
    constexpr double in_front = 1.5; // pixels
    const double     dx = n_samples * (b.x - a.x), dy = n_samples * (b.y - a.y);
    const double     length   = std::max(std::abs(dx), std::abs(dy));
    const bool       is_steep = std::abs(dy) > std::abs(dx);
    const auto       darkness = static_cast<unsigned char>(std::lround(255 * std::clamp(strength, 0., 1.)));
    if (darkness == 0 || !(length < 1e5))
      return;
    const int n = std::max(1., std::ceil(length));
    for (int i = 0; i <= n; ++i)
      {
        const double s = static_cast<double>(i) / n;
        if ((1 - s) * a.keep + s * b.keep < 0)
          continue;
        const double px = n_samples * a.x + s * dx, py = n_samples * a.y + s * dy;
        const float  depth = (1 - s) * a.depth + s * b.depth + in_front;
        for (const double beside : {-0.5, 0.5})
          {
            const int x = std::floor(px + (is_steep ? beside : 0)),
                      y = std::floor(py + (is_steep ? 0 : beside));
            if (!is_inside(x, y))
              continue;
            Sample &sample = samples[std::size_t(y) * width + x];
            if (sample.part != no_part && depth >= sample.depth)
              sample.line = std::max(sample.line, darkness);
          }
      }
  }

  bool
  Raster::sees(const RasterPoint &point, const double tolerance) const
  {
    const int x = std::floor(n_samples * point.x), y = std::floor(n_samples * point.y);
    return is_inside(x, y) && point.depth >= at(x, y).depth - tolerance;
  }

  bool
  Raster::is_empty() const
  {
    return std::all_of(
        samples.begin(), samples.end(), [](const Sample &sample) { return sample.part == no_part; });
  }

  double
  Raster::highest() const
  {
    float result = -1e30f;
    for (const Sample &sample : samples)
      if (sample.part != no_part)
        result = std::max(result, sample.value);
    return result > -1e30f ? result : 0;
  }

  double
  Raster::lowest() const
  {
    float result = 1e30f;
    for (const Sample &sample : samples)
      if (sample.part != no_part)
        result = std::min(result, sample.value);
    return result < 1e30f ? result : 0;
  }

  // Strength of the line that separates a sample from its neighbours: another part or none (those behind),
  // a step in depth, an edge.
  double
  Raster::outline(const int x, const int y) const
  {
    constexpr float step     = 4;               // pixels
    constexpr int   edge     = 0.8 * 127 * 127; // cosine
    const Sample   &here     = at(x, y);
    double          strength = 0;
    for (const auto &[dx, dy] : {std::array<int, 2>{{1, 0}}, {{-1, 0}}, {{0, 1}}, {{0, -1}}})
      {
        if (!is_inside(x + dx, y + dy))
          continue; // where the picture ends
        const Sample &other = at(x + dx, y + dy);
        const float   fall  = here.depth - other.depth;
        if (other.part == no_part || (other.part != here.part && fall > 0))
          return 1;
        if (fall > step && fall > step + 3 * std::hypot(here.normal[0], here.normal[1]) /
                                             std::max<double>(here.normal[2], 8))
          return 1;
        int cosine = 0;
        for (unsigned int d = 0; d < 3; ++d)
          cosine += here.normal[d] * other.normal[d];
        if (other.part == here.part && cosine < edge)
          strength = 0.7;
      }
    return strength;
  }

  Colour
  Raster::colour(const int x, const int y, const double lowest, const double highest) const
  {
    static const std::vector<Colour> table  = colour_table();
    const Sample                    &sample = at(x, y);
    if (sample.part == no_part)
      return {{1, 1, 1}};
    double shine = 0;
    for (unsigned int d = 0; d < 3; ++d)
      shine += light[d] * sample.normal[d] / 127.;
    const double place  = highest > lowest ? (sample.value - lowest) / (highest - lowest) : 0;
    Colour       result = table[std::lround(255 * std::clamp(place, 0., 1.))];
    for (double &channel : result)
      channel *= ambient + (1 - ambient) * std::max(0., shine);
    // Lines are dark on what is light and light on what is dark.
    const double brightness = 0.3 * result[0] + 0.6 * result[1] + 0.1 * result[2];
    const double line       = std::max(0.75 * outline(x, y), sample.line / 255.);
    const double contrast   = 0.9 * std::clamp((0.42 - brightness) / 0.16, 0., 1.);
    for (double &channel : result)
      channel += line * (contrast - channel);
    return result;
  }

  Image
  Raster::image(const double lowest, const double highest) const
  {
    Image image;
    image.width  = width / n_samples;
    image.height = height / n_samples;
    image.rgb.reserve(3 * std::size_t(image.width) * image.height);
    for (unsigned int y = 0; y < image.height; ++y)
      for (unsigned int x = 0; x < image.width; ++x)
        {
          Colour sum = {{0, 0, 0}};
          for (int j = 0; j < n_samples; ++j)
            for (int i = 0; i < n_samples; ++i)
              {
                const Colour one = colour(n_samples * x + i, n_samples * y + j, lowest, highest);
                for (unsigned int c = 0; c < 3; ++c)
                  sum[c] += one[c];
              }
          for (const double channel : sum)
            image.rgb.push_back(std::lround(255 * channel / (n_samples * n_samples)));
        }
    return image;
  }
} // namespace Amontons
