// The arguments of a closed form that a user wrote, "hertz_line(P = 1, R = 2)", checked against its
// declaration.
#pragma once

#include <amontons/scene/scene.h>

namespace Amontons
{
  // Declares a closed form: `required` and `optional` parameters (with defaults; NaN: unset) in the order of
  // reading.
  struct ClosedFormDeclaration
  {
    std::string                                 name, meaning;
    std::vector<std::string>                    required;
    std::vector<std::pair<std::string, double>> optional;

    std::string
    signature() const; // "hertz_line(P, R, E1, nu1, [E2, nu2, x, y])"
  };

  class ClosedFormArguments
  {
  public:
    // Throws InputError for parameters that are missing or unknown, and for values that no closed form
    // allows: nu* not in [0, 0.5], moduli and lengths (E*, R*, P, a, ...) not positive.
    ClosedFormArguments(const FieldData &data, const ClosedFormDeclaration &declaration);

    double
    operator()(const std::string &parameter) const;
    bool
    is_given(const std::string &parameter) const;
    // (x, y, z) of the optional parameters; those that are not declared are zero.
    Point<3>
    centre() const;

    [[noreturn]] void
    fail(const std::string &found, const std::string &allowed) const;

  private:
    std::map<std::string, double> values;
    std::string                   name;
    SourceLocation                where;
  };
} // namespace Amontons
