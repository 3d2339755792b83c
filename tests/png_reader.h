// Reads a PNG of 8 bits per colour back, by zlib; what is wrong with it is a failed check.
#pragma once

#include "check.h"

#include <amontons/output/png.h>

#include <zlib.h>

#include <array>
#include <cstdlib>

namespace check
{
inline std::uint32_t
number_at(const std::string &bytes, const std::size_t at)
{
  std::uint32_t n = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    n = 256 * n + static_cast<unsigned char>(bytes[i]);
  return n;
}

// used: how often each filter stands before a row.
inline Amontons::Image
read_png(const std::string &bytes, std::array<unsigned int, 5> *used = nullptr)
{
  Amontons::Image image;
  is_true(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n", "PNG: signature");
  std::string data, names;
  for (std::size_t at = 8; at + 12 <= bytes.size();)
    {
      const std::uint32_t size = number_at(bytes, at);
      const std::string   name = bytes.substr(at + 4, 4), content = bytes.substr(at + 8, size);
      const std::string   named = name + content;
      is_true(number_at(bytes, at + 8 + size) ==
                  crc32(0, reinterpret_cast<const Bytef *>(named.data()), named.size()),
              "PNG: CRC of " + name);
      names += name + " ";
      if (name == "IHDR")
        {
          image.width  = number_at(content, 0);
          image.height = number_at(content, 4);
          is_true(content.substr(8) == std::string("\x08\x02\0\0\0", 5), "PNG: 8 bits of three colours");
        }
      else if (name == "IDAT")
        data += content;
      at += 12 + size;
    }
  is_true(names == "IHDR IDAT IEND ", "PNG: parts " + names);
  const std::size_t n = 3 * image.width;
  std::string       rows((n + 1) * image.height, '\0');
  uLongf            size = rows.size();
  is_true(uncompress(reinterpret_cast<Bytef *>(&rows[0]),
                     &size,
                     reinterpret_cast<const Bytef *>(data.data()),
                     data.size()) == Z_OK &&
              size == rows.size(),
          "PNG: rows");
  image.rgb.assign(n * image.height, 0);
  for (std::size_t y = 0; y < image.height; ++y)
    {
      const int filter = rows[y * (n + 1)];
      is_true(filter >= 0 && filter < 5, "PNG: filter");
      if (used != nullptr)
        ++(*used)[filter];
      for (std::size_t i = 0; i < n; ++i)
        {
          const int a = i >= 3 ? image.rgb[y * n + i - 3] : 0, b = y > 0 ? image.rgb[(y - 1) * n + i] : 0,
                    c = i >= 3 && y > 0 ? image.rgb[(y - 1) * n + i - 3] : 0, p = a + b - c;
          const int nearest    = std::abs(p - a) <= std::abs(p - b) && std::abs(p - a) <= std::abs(p - c) ? a
                                 : std::abs(p - b) <= std::abs(p - c)                                     ? b
                                                                                                          : c;
          const int guess[]    = {0, a, b, (a + b) / 2, nearest};
          image.rgb[y * n + i] = static_cast<unsigned char>(rows[y * (n + 1) + 1 + i]) + guess[filter];
        }
    }
  return image;
}

inline std::array<int, 3>
pixel(const Amontons::Image &image, const unsigned int x, const unsigned int y)
{
  const std::size_t at = 3 * (std::size_t(y) * image.width + x);
  return {{image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]}};
}
} // namespace check
