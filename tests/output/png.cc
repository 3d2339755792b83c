// A picture that is written as PNG is read back as it was, by any of the five filters; its address holds the
// same bytes.
#include "png_reader.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

namespace test_png
{
using namespace Amontons;

Image
picture(const unsigned int width, const unsigned int height)
{
  Image        image{width, height, {}};
  unsigned int noise = 1;
  for (unsigned int y = 0; y < height; ++y)
    for (unsigned int x = 0; x < width; ++x)
      for (unsigned int c = 0; c < 3; ++c)
        {
          noise = 1664525 * noise + 1013904223;
          // in turn: flat, noise, along x, along y, along both, curved
          const unsigned int kinds[] = {
              7, noise >> 24, 5 * x + 40 * c, 9 * y + x % 2, 5 * x + 7 * y, x * y / 3 + (noise >> 30)};
          image.rgb.push_back(kinds[y / 6 % 6]);
        }
  return image;
}

int
main(int, char **)
{
  std::array<unsigned int, 5> used = {};
  for (const auto &[width, height] : {std::array<unsigned int, 2>{{61, 72}}, {{1, 1}}, {{300, 7}}})
    {
      const Image image = picture(width, height), read = check::read_png(png_of(image), &used);
      check::is_true(read.width == width && read.height == height && read.rgb == image.rgb,
                     "read back: " + std::to_string(width) + " x " + std::to_string(height));
    }
  for (const unsigned int n : used)
    check::is_true(n > 0, "a filter that no row has");

  const Image       image = picture(5, 4);
  const std::string head = "data:image/png;base64,", uri = data_uri(image);
  const auto        bytes = dealii::Utilities::decode_base64(uri.substr(head.size()));
  check::is_true(uri.substr(0, head.size()) == head &&
                     std::string(bytes.begin(), bytes.end()) == png_of(image),
                 "address");

  dealii::deal_II_exceptions::disable_abort_on_exception();
  for (const Image &wrong : {Image(), Image{2, 2, {1, 2, 3}}})
    try
      {
        png_of(wrong);
        check::is_true(false, "a picture without its pixels");
      }
    catch (const std::exception &)
      {
      }
  return check::result();
}
} // namespace test_png
