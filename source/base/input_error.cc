#include <amontons/base/input_error.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace Amontons
{
  namespace
  {
    // Bytes of the UTF-8 character at text[i]; 0: what stands there is none, or controls the terminal.
    std::size_t
    length_of_character(const std::string &text, const std::size_t i)
    {
      const auto        byte   = [&](const std::size_t k) { return static_cast<unsigned char>(text[k]); };
      const std::size_t length = byte(i) < 0x80   ? 1
                                 : byte(i) < 0xc2 ? 0
                                 : byte(i) < 0xe0 ? 2
                                 : byte(i) < 0xf0 ? 3
                                 : byte(i) < 0xf5 ? 4
                                                  : 0;
      if (i + length > text.size() || (length == 1 && (byte(i) < 0x20 || byte(i) == 0x7f)))
        return 0;
      for (std::size_t k = 1; k < length; ++k)
        if ((byte(i + k) & 0xc0) != 0x80)
          return 0;
      return length;
    }

    // One line of valid UTF-8: other bytes as \xNN; of what is quoted 80 characters, of paths more.
    std::string
    printable(const std::string &text)
    {
      constexpr unsigned int most_of_words = 80, most_of_paths = 400;
      unsigned int           most = most_of_words;
      std::string            result;
      unsigned int           quoted = 0; // characters since the opening quote, which is the first
      for (std::size_t i = 0; i < text.size();)
        {
          const std::size_t length = text[i] == '\n' ? 1 : length_of_character(text, i);
          if (text[i] == '\'')
            {
              if (quoted > most + 1)
                result += "...";
              quoted = quoted > 0 ? 0 : 1;
              most   = text.compare(i, 2, "'/") == 0 ? most_of_paths : most_of_words;
            }
          else if (quoted > 0)
            ++quoted;
          if (quoted <= most + 1)
            {
              constexpr char digits[] = "0123456789abcdef";
              const auto     byte     = static_cast<unsigned char>(text[i]);
              if (length == 0)
                result += std::string("\\x") + digits[byte / 16] + digits[byte % 16];
              else
                result += text[i] == '\n' ? " " : text.substr(i, length);
            }
          i += std::max<std::size_t>(1, length);
        }
      return result;
    }

    std::string
    shortened(const std::string &text, const std::size_t most)
    {
      if (text.size() <= most)
        return text;
      std::size_t end = most;
      while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
        --end;
      return text.substr(0, end) + " ...";
    }

    std::string
    message(const SourceLocation &where, const std::string &found, const std::string &allowed)
    {
      constexpr std::size_t most_of_file = 350, most_of_entry = 300, most_of_found = 540,
                            most_of_allowed = 800;
      std::string text                      = shortened(printable(where.file), most_of_file);
      if (where.line > 0)
        text += ":" + std::to_string(where.line);
      for (const auto &[part, most] :
           {std::pair{where.entry, most_of_entry}, std::pair{found, most_of_found}})
        if (!part.empty())
          text += (text.empty() ? "" : ": ") + shortened(printable(part), most);
      if (!allowed.empty())
        text += (allowed.rfind("allowed", 0) == 0 ? "; " : "; allowed: ") +
                shortened(printable(allowed), most_of_allowed);
      return text;
    }

    // Levenshtein's distance; upper and lower case count as the same letter.
    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const bool same = std::tolower(static_cast<unsigned char>(a[i])) ==
                                std::tolower(static_cast<unsigned char>(b[j]));
              const std::size_t replaced = diagonal + (same ? 0 : 1);
              diagonal                   = row[j + 1];
              row[j + 1]                 = std::min({replaced, row[j] + 1, row[j + 1] + 1});
            }
        }
      return row[b.size()];
    }
  } // namespace

  bool
  is_printable(const std::string &text)
  {
    std::size_t length = 1;
    for (std::size_t i = 0; i < text.size() && length > 0; i += length)
      length = length_of_character(text, i);
    return length > 0;
  }

  InputError::InputError(const SourceLocation &where, const std::string &found, const std::string &allowed)
      : std::runtime_error(message(where, found, allowed))
  {
  }

  std::string
  suggestion(const std::string &word, const std::vector<std::string> &candidates)
  {
    const std::string *nearest  = nullptr;
    std::size_t        distance = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const std::string &candidate : candidates)
      {
        const std::size_t d = edit_distance(word, candidate);
        if (d < distance && d < std::max(word.size(), candidate.size()))
          {
            nearest  = &candidate;
            distance = d;
          }
      }
    return nearest == nullptr ? "" : " (did you mean '" + *nearest + "'?)";
  }
} // namespace Amontons
