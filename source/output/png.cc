#include <amontons/output/png.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <zlib.h>

#include <array>
#include <cmath>
#include <limits>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int n_channels = 3;

    std::string
    big_endian(const std::uint32_t n)
    {
      std::string bytes;
      for (const unsigned int shift : {24, 16, 8, 0})
        bytes += static_cast<char>((n >> shift) & 255);
      return bytes;
    }

    // Length, name, data, and the CRC of the two latter.
    std::string
    chunk(const std::string &name, const std::string &data)
    {
      const std::string named = name + data;
      const auto        crc   = crc32(0, reinterpret_cast<const Bytef *>(named.data()), named.size());
      return big_endian(data.size()) + named + big_endian(crc);
    }

    // Of the neighbours at the left (a), above (b) and above the left (c), the one nearest to a + b - c.
    int
    paeth(const int a, const int b, const int c)
    {
      const int to_a = std::abs(b - c), to_b = std::abs(a - c), to_c = std::abs(a + b - 2 * c);
      return to_a <= to_b && to_a <= to_c ? a : (to_b <= to_c ? b : c);
    }

    // What a filter predicts: nothing, the left, above, their mean, Paeth's.
    template <unsigned int filter>
    int
    predicted(const int a, const int b, const int c)
    {
      return filter == 0 ? 0 : filter == 1 ? a : filter == 2 ? b : filter == 3 ? (a + b) / 2 : paeth(a, b, c);
    }

    // The row less what is predicted, modulo 256, after the number of the filter, takes the place of `best`
    // if its magnitudes have a smaller sum, which tells how well it will be compressed.
    template <unsigned int filter>
    void
    try_filter(const Image &image, const unsigned int y, std::string &best, unsigned long &least)
    {
      const std::size_t         n    = n_channels * image.width;
      const std::uint8_t *const here = image.rgb.data() + y * n, *const above = here - n;
      std::string   row(n + 1, static_cast<char>(filter));
      unsigned long sum = 0;
      for (std::size_t i = 0; i < n; ++i)
        {
          const bool left = i >= n_channels;
          const auto byte = static_cast<signed char>(
              here[i] - predicted<filter>(left ? here[i - n_channels] : 0,
                                          y > 0 ? above[i] : 0,
                                          left && y > 0 ? above[i - n_channels] : 0));
          row[i + 1] = byte;
          sum += std::abs(static_cast<int>(byte));
        }
      if (sum >= least)
        return;
      best  = row;
      least = sum;
    }

    std::string
    best_row(const Image &image, const unsigned int y)
    {
      std::string   best;
      unsigned long least = std::numeric_limits<unsigned long>::max();
      try_filter<0>(image, y, best, least);
      try_filter<1>(image, y, best, least);
      try_filter<2>(image, y, best, least);
      try_filter<3>(image, y, best, least);
      try_filter<4>(image, y, best, least);
      return best;
    }

    std::string
    deflated(const std::string &data)
    {
      uLongf      size = compressBound(data.size());
      std::string result(size, '\0');
      const int   status = compress2(reinterpret_cast<Bytef *>(&result[0]),
                                   &size,
                                   reinterpret_cast<const Bytef *>(data.data()),
                                   data.size(),
                                   6);
      AssertThrow(status == Z_OK, dealii::ExcMessage("zlib has no memory"));
      result.resize(size);
      return result;
    }
  } // namespace

  std::string
  png_of(const Image &image)
  {
    AssertThrow(image.width > 0 && image.height > 0 &&
                    image.rgb.size() == n_channels * std::size_t(image.width) * image.height,
                dealii::ExcMessage("no picture of this size"));
    std::string rows;
    for (unsigned int y = 0; y < image.height; ++y)
      rows += best_row(image, y);
    // 8 bits, colours, deflate, adaptive filters, not interlaced
    const std::string header =
        big_endian(image.width) + big_endian(image.height) + std::string("\x08\x02\0\0\0", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", deflated(rows)) + chunk("IEND", "");
  }

  std::string
  data_uri(const Image &image)
  {
    const std::string bytes = png_of(image);
    return "data:image/png;base64," +
           dealii::Utilities::encode_base64(std::vector<unsigned char>(bytes.begin(), bytes.end()));
  }
} // namespace Amontons
