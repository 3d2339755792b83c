/// Pictures of pixels as PNG files (ISO/IEC 15948): 8 bits of red, green and blue, without transparency.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace Amontons
{
  struct Image
  {
    unsigned int              width = 0, height = 0;
    std::vector<std::uint8_t> rgb; // 3 width height, row by row from the top
  };

  /// The bytes of the file; the same for the same picture and the same zlib.
  std::string
  png_of(const Image &image);

  /// "data:image/png;base64,...": the picture as an address within a page.
  std::string
  data_uri(const Image &image);
} // namespace Amontons
