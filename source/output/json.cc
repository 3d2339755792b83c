#include <amontons/output/json.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace Amontons
{
  namespace
  {
    std::string
    quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        if (c == '"' || c == '\\')
          result += std::string("\\") + c;
        else if (c == '\n')
          result += "\\n";
        else if (c == '\t')
          result += "\\t";
        else if (static_cast<unsigned char>(c) < 0x20)
          {
            char code[8];
            std::snprintf(code, sizeof(code), "\\u%04x", c);
            result += code;
          }
        else
          result += c;
      return result + "\"";
    }
  } // namespace

  std::string
  number_text(const double number)
  {
    if (std::isnan(number))
      return "nan";
    char text[40];
    std::snprintf(text, sizeof(text), "%.15g", number);
    if (std::strtod(text, nullptr) != number)
      std::snprintf(text, sizeof(text), "%.17g", number);
    return text;
  }

  Json::Json(const double number) : scalar(std::isfinite(number) ? number_text(number) : "null") {}

  Json::Json(const std::string &text) : scalar(quoted(text)) {}

  Json::Json(const char *text) : scalar(quoted(text)) {}

  Json
  Json::object()
  {
    Json json;
    json.kind = Kind::object;
    return json;
  }

  Json
  Json::array()
  {
    Json json;
    json.kind = Kind::array;
    return json;
  }

  Json &
  Json::add(const std::string &name, const Json &value)
  {
    members.emplace_back(name, value);
    return *this;
  }

  Json &
  Json::push(const Json &value)
  {
    members.emplace_back("", value);
    return *this;
  }

  bool
  Json::is_flat() const
  {
    return kind == Kind::array && std::all_of(members.begin(), members.end(), [](const auto &member) {
             return member.second.kind == Kind::scalar && member.second.scalar[0] != '"';
           });
  }

  std::string
  Json::text(const unsigned int indent) const
  {
    if (kind == Kind::scalar)
      return scalar;
    const bool is_object = kind == Kind::object;
    if (members.empty())
      return is_object ? "{}" : "[]";

    const bool        flat = is_flat();
    const std::string gap  = flat ? " " : "\n" + std::string(indent + 2, ' ');
    std::string       result(is_object ? "{" : "[");
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        result += (i == 0 ? (flat ? "" : gap) : "," + gap);
        if (is_object)
          result += quoted(members[i].first) + ": ";
        result += members[i].second.text(indent + 2);
      }
    return result + (flat ? "" : "\n" + std::string(indent, ' ')) + (is_object ? "}" : "]");
  }
} // namespace Amontons
