// Small operations on the texts of a scene.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Amontons
{
  std::string
  trim(const std::string &text);

  // Trimmed, with one blank for each run of blanks.
  std::string
  with_single_blanks(const std::string &text);

  // The trimmed pieces between `separator`s that are outside of all parentheses; an empty text has no pieces.
  std::vector<std::string>
  split(const std::string &text, const char separator);

  std::string
  join(const std::vector<std::string> &pieces, const std::string &separator);

  // The whole text as a finite number, or nothing.
  std::optional<double>
  as_number(const std::string &text);

  // The text with each identifier ([A-Za-z_][A-Za-z_0-9]*, not the exponent of a number) replaced by what
  // `map` returns.
  std::string
  map_identifiers(const std::string &text, const std::function<std::string(const std::string &)> &map);

  bool
  has_identifier(const std::string &text, const std::string &identifier);

  // "circle(0, 0)" -> {"circle", {"0", "0"}}; nothing if the text is not of the form word(...).
  struct Call
  {
    std::string              name;
    std::vector<std::string> arguments;
  };
  std::optional<Call>
  as_call(const std::string &text);

  // Position of the parenthesis that closes the one at `open`, or npos.
  std::string::size_type
  closing_parenthesis(const std::string &text, const std::string::size_type open);
} // namespace Amontons
