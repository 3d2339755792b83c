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
    constexpr unsigned int n_channels = 3, n_filters = 5;

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
    int
    predicted(const unsigned int filter, const int a, const int b, const int c)
    {
      switch (filter)
        {
          case 0:
            return 0;
          case 1:
            return a;
          case 2:
            return b;
          case 3:
            return (a + b) / 2;
          default:
            return paeth(a, b, c);
        }
    }

    // The row less what is predicted, modulo 256, after the number of the filter.
    std::string
    filtered_row(const Image &image, const unsigned int y, const unsigned int filter)
    {
      const std::size_t         n    = n_channels * image.width;
      const std::uint8_t *const here = image.rgb.data() + y * n, *const above = here - n;
      std::string row(n + 1, static_cast<char>(filter));
      for (std::size_t i = 0; i < n; ++i)
        {
          const bool left = i >= n_channels;
          row[i + 1]      = static_cast<char>(here[i] - predicted(filter,
                                                             left ? here[i - n_channels] : 0,
                                                             y > 0 ? above[i] : 0,
                                                             left && y > 0 ? above[i - n_channels] : 0));
        }
      return row;
    }

    // The sum of magnitudes, which tells how well a row will be compressed.
    unsigned long
    size_of(const std::string &row)
    {
      unsigned long sum = 0;
      for (const char c : row)
        sum += std::abs(static_cast<int>(static_cast<signed char>(c)));
      return sum;
    }

    std::string
    best_row(const Image &image, const unsigned int y)
    {
      std::string   best;
      unsigned long least = std::numeric_limits<unsigned long>::max();
      for (unsigned int filter = 0; filter < n_filters; ++filter)
        if (const std::string row = filtered_row(image, y, filter); size_of(row) < least)
          {
            best  = row;
            least = size_of(row);
          }
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
