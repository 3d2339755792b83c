#include <amontons/scene/text.h>

#include <cctype>
#include <cmath>
#include <cstdlib>

namespace Amontons
{
  namespace
  {
    bool
    is_letter(const char c)
    {
      return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
    }

    bool
    is_digit(const char c)
    {
      return std::isdigit(static_cast<unsigned char>(c)) != 0;
    }
  } // namespace

  std::string
  trim(const std::string &text)
  {
    const char *const blanks = " \t\r\n";
    const auto        first  = text.find_first_not_of(blanks);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
  }

  std::string
  with_single_blanks(const std::string &text)
  {
    std::string result;
    for (const char c : trim(text))
      if (std::isspace(static_cast<unsigned char>(c)) == 0)
        result += c;
      else if (result.back() != ' ')
        result += ' ';
    return result;
  }

  std::vector<std::string>
  split(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces;
    if (trim(text).empty())
      return pieces;
    int         depth = 0;
    std::string piece;
    for (const char c : text)
      {
        depth += (c == '(') - (c == ')');
        if (c == separator && depth == 0)
          {
            pieces.push_back(trim(piece));
            piece.clear();
          }
        else
          piece += c;
      }
    pieces.push_back(trim(piece));
    return pieces;
  }

  std::string
  join(const std::vector<std::string> &pieces, const std::string &separator)
  {
    std::string text;
    for (const std::string &piece : pieces)
      text += (&piece == &pieces.front() ? "" : separator) + piece;
    return text;
  }

  std::optional<double>
  as_number(const std::string &text)
  {
    const std::string word = trim(text);
    if (word.empty())
      return {};
    char        *end   = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value))
      return {};
    return value;
  }

  std::string
  map_identifiers(const std::string &text, const std::function<std::string(const std::string &)> &map)
  {
    std::string            result;
    std::string::size_type i = 0;
    while (i < text.size())
      {
        const auto begin = i;
        if (is_letter(text[i]))
          {
            while (i < text.size() && (is_letter(text[i]) || is_digit(text[i])))
              ++i;
            result += map(text.substr(begin, i - begin));
          }
        else if (is_digit(text[i]))
          {
            char *end = nullptr;
            std::strtod(text.c_str() + begin, &end);
            i = end - text.c_str();
            result += text.substr(begin, i - begin);
          }
        else
          result += text[i++];
      }
    return result;
  }

  bool
  has_identifier(const std::string &text, const std::string &identifier)
  {
    bool found = false;
    map_identifiers(text, [&](const std::string &word) {
      found = found || word == identifier;
      return word;
    });
    return found;
  }

  std::string::size_type
  closing_parenthesis(const std::string &text, const std::string::size_type open)
  {
    int depth = 0;
    for (auto i = open; i < text.size(); ++i)
      {
        depth += (text[i] == '(') - (text[i] == ')');
        if (depth == 0)
          return i;
      }
    return std::string::npos;
  }

  std::optional<Call>
  as_call(const std::string &text)
  {
    const std::string call = trim(text);
    const auto        open = call.find('(');
    if (open == std::string::npos || open == 0 || closing_parenthesis(call, open) != call.size() - 1)
      return {};
    const std::string name = trim(call.substr(0, open));
    for (const char c : name)
      if (!is_letter(c) && !is_digit(c))
        return {};
    return Call{name, split(call.substr(open + 1, call.size() - open - 2), ',')};
  }
} // namespace Amontons
