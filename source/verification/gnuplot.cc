#include <amontons/output/files.h>
#include <amontons/verification/gnuplot.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Amontons
{
  namespace
  {
    bool
    has_gnuplot()
    {
      return std::system("command -v gnuplot >/dev/null 2>&1") == 0;
    }
  } // namespace

  std::string
  in_shell(const std::string &text)
  {
    const auto is_plain = [](const char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("/._-+=:,", c) != nullptr;
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain))
      return text;
    std::string result = "'";
    for (const char c : text)
      result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
  }

  std::string
  in_gnuplot(const std::string &text)
  {
    std::string result = "'";
    for (const char c : text)
      result += c == '\'' ? std::string("''") : std::string(1, c == '_' ? ' ' : c);
    return result + "'";
  }

  void
  write_terminal(const std::string &study,
                 const std::string &stem,
                 const double       width,
                 const double       height,
                 std::ostream      &out)
  {
    out << "# Written by `amontons study " << study << "`; run with gnuplot, or gnuplot -e 'png = 1'.\n"
        << "if (exists('png')) set terminal pngcairo size " << width << ", " << height
        << " font 'Helvetica, Arial, sans-serif, 10' background rgb 'white' rounded; set output '" << stem
        << ".png'\n"
        << "if (!exists('png')) set terminal svg size " << width << ", " << height
        << " font 'Helvetica, Arial, sans-serif, 13' background 'white' rounded; set output '" << stem
        << ".svg'\n";
  }

  bool
  draw(const std::string &folder, const std::string &stem, std::ostream &out)
  {
    const std::filesystem::path path = std::filesystem::path(folder) / stem;
    out << "Wrote " << path.string() << ".csv and " << path.string() << ".gp";
    if (!has_gnuplot())
      {
        out << "; no chart, since there is no gnuplot." << std::endl;
        return true;
      }
    const std::string script = in_shell(stem + ".gp");
    const int         status = std::system(
        ("cd " + in_shell(folder) + " && gnuplot " + script + " && gnuplot -e 'png = 1' " + script).c_str());
    out << (status == 0 ? ", and the chart " + path.string() + ".svg and .png" : "; gnuplot failed") << '.'
        << std::endl;
    return status == 0;
  }

  std::string
  drawn_chart(const std::string &folder, const std::string &stem)
  {
    if (!has_gnuplot())
      return "";
    std::ifstream      in(std::filesystem::path(folder) / (stem + ".svg"), std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    const auto begin = text.str().find("<svg");
    return begin == std::string::npos ? "" : text.str().substr(begin);
  }

  bool
  draw(const std::string &folder, const std::string &stem, const std::string &script, std::ostream &out)
  {
    write_file((std::filesystem::path(folder) / (stem + ".gp")).string(), script);
    return draw(folder, stem, out);
  }

  void
  LogRange::add(const double value)
  {
    if (value > 0 && std::isfinite(value))
      {
        lower = std::min(lower, value);
        upper = std::max(upper, value);
      }
  }

  bool
  LogRange::is_empty() const
  {
    return !(upper > 0);
  }

  void
  LogRange::widen(const double factor)
  {
    lower /= factor;
    upper *= factor;
  }
} // namespace Amontons
