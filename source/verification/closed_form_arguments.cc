#include <amontons/verification/closed_form_arguments.h>
#include <amontons/scene/text.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Amontons
{
  namespace
  {
    // What a parameter's name says about its values: positions, signed forces and switches may be anything.
    std::string
    complaint(const std::string &parameter, const double value)
    {
      static const std::vector<std::string> any   = {"x",
                                                     "y",
                                                     "z",
                                                     "x0",
                                                     "y0",
                                                     "z0",
                                                     "Q",
                                                     "Q_max",
                                                     "shear_ratio",
                                                     "side",
                                                     "c",
                                                     "plane_stress",
                                                     "confined",
                                                     "angle"};
      static const std::vector<std::string> radii = {"R1x", "R1y", "R2x", "R2y"}; // negative: concave
      if (parameter.rfind("nu", 0) == 0)
        return value > -1 && value <= 0.5 ? "" : "a Poisson ratio more than -1, at most 0.5";
      if (std::find(any.begin(), any.end(), parameter) != any.end() || value > 0)
        return "";
      if (std::find(radii.begin(), radii.end(), parameter) != radii.end())
        return value == 0 ? "a radius that is not zero (left out: a plane)" : "";
      return parameter == "ri" || parameter == "R3" ? (value == 0 ? "" : "a number that is not negative")
                                                    : "a positive number";
    }
  } // namespace

  std::string
  ClosedFormDeclaration::signature() const
  {
    std::vector<std::string> optional_names;
    for (const auto &parameter : optional)
      optional_names.push_back(parameter.first);
    return name + "(" + join(required, ", ") +
           (optional.empty() ? "" : ", [" + join(optional_names, ", ") + "]") + ")";
  }

  ClosedFormArguments::ClosedFormArguments(const FieldData &data, const ClosedFormDeclaration &declaration)
      : name(declaration.name), where(data.where)
  {
    std::vector<std::string> names = declaration.required;
    for (const auto &parameter : declaration.optional)
      {
        names.push_back(parameter.first);
        values[parameter.first] = parameter.second;
      }
    for (const auto &[parameter, value] : data.parameters)
      {
        if (std::find(names.begin(), names.end(), parameter) == names.end())
          fail("found the parameter '" + parameter + "'" + suggestion(parameter, names),
               declaration.signature());
        const std::string allowed = complaint(parameter, value);
        if (!allowed.empty())
          {
            std::ostringstream text;
            text << value;
            fail("found " + parameter + " = " + text.str(), allowed);
          }
        values[parameter] = value;
      }
    for (const std::string &parameter : declaration.required)
      if (data.parameters.count(parameter) == 0)
        fail("the parameter '" + parameter + "' is missing", declaration.signature());
  }

  double
  ClosedFormArguments::operator()(const std::string &parameter) const
  {
    return values.at(parameter);
  }

  bool
  ClosedFormArguments::is_given(const std::string &parameter) const
  {
    const auto value = values.find(parameter);
    return value != values.end() && !std::isnan(value->second);
  }

  Point<3>
  ClosedFormArguments::centre() const
  {
    const auto coordinate = [&](const char *const c) { return is_given(c) ? values.at(c) : 0.; };
    return Point<3>(coordinate("x"), coordinate("y"), coordinate("z"));
  }

  void
  ClosedFormArguments::fail(const std::string &found, const std::string &allowed) const
  {
    throw InputError(where, "in the closed form '" + name + "' " + found, allowed);
  }
} // namespace Amontons
