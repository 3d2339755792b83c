// JSON values to be written: numbers are written as numbers, members in the order in which they were added.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Amontons
{
  class Json
  {
  public:
    Json() = default;          // null
    Json(const double number); // 15 significant digits, 17 where these do not give the same number back; NaN,
                               // infinity: null
    Json(const std::string &text);
    Json(const char *text);

    // Integers and bool.
    template <typename T, typename = std::enable_if_t<std::is_integral_v<T>>>
    Json(const T value) : scalar(std::is_same_v<T, bool> ? (value ? "true" : "false") : std::to_string(value))
    {
    }

    template <typename T>
    Json(const std::vector<T> &values) : kind(Kind::array)
    {
      for (const T &value : values)
        push(Json(value));
    }

    static Json
    object();
    static Json
    array();

    Json &
    add(const std::string &name, const Json &value); // to an object
    Json &
    push(const Json &value); // to an array

    // Arrays of scalars on one line, everything else one member a line.
    std::string
    text(const unsigned int indent = 0) const;

  private:
    enum class Kind
    {
      scalar,
      array,
      object
    } kind             = Kind::scalar;
    std::string scalar = "null";

    std::vector<std::pair<std::string, Json>> members; // names are empty in arrays

    bool
    is_flat() const;
  };

  // Inverse of the constructor's formatting: the shortest text that keeps the number, for CSV files too
  // ("nan" for NaN).
  std::string
  number_text(const double number);
} // namespace Amontons
