// JSON keeps numbers to the last bit, has null for what is unknown, and quotes text.
#include "check.h"

#include <amontons/output/files.h>
#include <amontons/output/json.h>

#include <cmath>
#include <cstdlib>

namespace test_json
{
using namespace Amontons;

int
main(int, char **)
{
  check::is_true(number_text(0.1) == "0.1", "short numbers stay short");
  check::is_true(std::strtod(number_text(1. / 3).c_str(), nullptr) == 1. / 3, "numbers come back exactly");
  check::is_true(number_text(std::nan("")) == "nan", "NaN in CSV");
  check::is_true(Json(std::nan("")).text() == "null", "NaN in JSON");
  check::is_true(Json(INFINITY).text() == "null", "infinity in JSON");
  check::is_true(Json(3u).text() == "3" && Json(true).text() == "true", "integers and bool");
  check::is_true(Json("a\"b\\\n").text() == "\"a\\\"b\\\\\\n\"", "quoting");
  check::is_true(Json(std::vector<double>{1, 2.5}).text() == "[1, 2.5]", "flat arrays on one line");
  check::is_true(Json(std::vector<double>()).text() == "[]" && Json::object().text() == "{}", "empty");

  const Json json = Json::object()
                        .add("b", 1)
                        .add("a", Json::array().push(Json::object().add("x", Json())))
                        .add("names", std::vector<std::string>{"n"});
  check::is_true(json.text() == "{\n  \"b\": 1,\n  \"a\": [\n    {\n      \"x\": null\n    }\n  ],\n  "
                                "\"names\": [\n    \"n\"\n  ]\n}",
                 "members in their order, nested: " + json.text());

  check::is_true(csv_field("plain") == "plain" && csv_field("a,\"b\"") == "\"a,\"\"b\"\"\"", "CSV fields");
  return check::result();
}
} // namespace test_json
