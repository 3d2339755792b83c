#include <amontons/base/input_error.h>

#include <algorithm>
#include <cctype>

namespace Amontons
{
  namespace
  {
    std::string
    message(const SourceLocation &where, const std::string &found, const std::string &allowed)
    {
      std::string text = where.file;
      if (where.line > 0)
        text += ":" + std::to_string(where.line);
      for (const std::string &part : {where.entry, found})
        if (!part.empty())
          text += (text.empty() ? "" : ": ") + part;
      if (!allowed.empty())
        text += (allowed.rfind("allowed", 0) == 0 ? "; " : "; allowed: ") + allowed;
      std::replace(text.begin(), text.end(), '\n', ' ');
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
