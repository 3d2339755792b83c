#include <amontons/scene/scene_input.h>
#include <amontons/scene/text.h>

namespace Amontons
{
  SectionInput::SectionInput(const SceneInput &input, const std::string &path, const std::string &name)
      : name(name), input(&input), path(path)
  {
  }

  SourceLocation
  SectionInput::where() const
  {
    const OutlineSection *const section = input->outline.find_section(path);
    return section != nullptr ? section->where : SourceLocation{input->file, 0, path};
  }

  SourceLocation
  SectionInput::where(const std::string &entry) const
  {
    if (const OutlineEntry *const found = input->outline.find_entry(path, entry))
      return found->where;
    SourceLocation place = where();
    place.entry          = path_of(path, entry);
    return place;
  }

  ProblemType
  SectionInput::kind() const
  {
    return input->kind;
  }

  int
  SectionInput::dim() const
  {
    return dimension_of(input->kind);
  }

  std::string
  SectionInput::scene_file() const
  {
    return input->file;
  }

  std::string
  SectionInput::text(const std::string &entry) const
  {
    const std::string        &default_value = input->declaration(path, entry).default_value;
    const OutlineEntry *const found         = input->outline.find_entry(path, entry);
    return found != nullptr ? found->value : default_value;
  }

  bool
  SectionInput::is_given(const std::string &entry) const
  {
    return text(entry) != input->declaration(path, entry).default_value;
  }

  void
  SectionInput::fail(const std::string &entry, const std::string &found, const std::string &allowed) const
  {
    throw InputError(where(entry), found, allowed);
  }

  void
  SectionInput::refuse(const std::vector<std::string> &entries, const std::string &context) const
  {
    for (const std::string &entry : entries)
      if (is_given(entry))
        fail(entry, "this entry has no meaning " + context, "leave it out");
  }

  void
  SectionInput::require(const std::vector<std::string> &entries, const std::string &context) const
  {
    for (const std::string &entry : entries)
      if (text(entry).empty())
        fail(entry, "this entry is missing", "a value: there is no default " + context);
  }

  double
  SectionInput::number(const std::string &entry) const
  {
    const auto value = as_number(text(entry));
    if (!value)
      fail(entry, "found '" + text(entry) + "'", "a number");
    return *value;
  }

  double
  SectionInput::positive_number(const std::string &entry) const
  {
    const double value = number(entry);
    if (!(value > 0))
      fail(entry, "found " + text(entry), "a positive number");
    return value;
  }

  bool
  SectionInput::flag(const std::string &entry) const
  {
    const std::string value = text(entry);
    return value == "true" || value == "yes" || value == "on";
  }

  std::vector<double>
  SectionInput::numbers(const std::string &entry) const
  {
    std::vector<double>            values;
    const std::vector<std::string> pieces = split(text(entry), ',');
    for (const std::string &piece : pieces)
      {
        const auto value = as_number(piece);
        if (!value)
          fail(entry, "found '" + piece + "'", "numbers separated by commas");
        values.push_back(*value);
      }
    if (static_cast<int>(values.size()) < dim() || values.size() > 3)
      fail(entry,
           "found '" + text(entry) + "', " + std::to_string(values.size()) + " number(s)",
           std::to_string(dim()) + " numbers separated by commas");
    return values;
  }

  Point<3>
  SectionInput::point(const std::string &entry) const
  {
    Point<3>                  point;
    const std::vector<double> values = numbers(entry);
    for (int i = 0; i < dim(); ++i)
      point[i] = values[i];
    return point;
  }

  Tensor<1, 3>
  SectionInput::direction(const std::string &entry) const
  {
    const Tensor<1, 3> direction = point(entry);
    if (!(direction.norm() > 0))
      fail(entry,
           "found '" + text(entry) + "', a vector without a direction",
           "a vector of any positive length");
    return direction / direction.norm();
  }

  Expression
  SectionInput::expression(const std::string &entry, const std::string &text, const Of of) const
  {
    std::vector<std::string> variables;
    if (of != Of::time)
      {
        if (kind() == ProblemType::axisymmetric)
          variables.push_back("r");
        variables.insert(variables.end(), {"x", "y"});
        if (dim() == 3)
          variables.push_back("z");
      }
    variables.push_back("t");
    if (of == Of::place_time_and_pressure)
      variables.push_back("p");
    return Expression(text, where(entry), variables);
  }

  std::vector<std::string>
  SectionInput::components(const std::string &entry, const unsigned int n) const
  {
    std::vector<std::string> pieces = split(text(entry), ';');
    // A third component that says nothing may stay in plane scenes.
    if (pieces.size() == n + 1 && n == 2 && (pieces.back() == "0" || pieces.back() == "free"))
      pieces.pop_back();
    if (!pieces.empty() && pieces.size() != n)
      fail(entry,
           "found '" + text(entry) + "', " + std::to_string(pieces.size()) + " component(s)",
           std::to_string(n) + " component(s)" + (n > 1 ? " separated by ';'" : ""));
    return pieces;
  }

  std::array<Expression, 3>
  SectionInput::expressions(const std::string &entry, const Of of) const
  {
    std::array<Expression, 3>      values;
    const std::vector<std::string> pieces = components(entry, dim());
    for (unsigned int i = 0; i < pieces.size(); ++i)
      values[i] = expression(entry, pieces[i], of);
    return values;
  }

  FieldData
  SectionInput::field(const std::string &entry) const
  {
    FieldData         data;
    const std::string value   = text(entry);
    const std::string allowed = "NAME(PARAMETER = NUMBER, ...)";
    data.where                = where(entry);
    if (value.find_first_of("( ;,") == std::string::npos)
      {
        data.name = value;
        return data;
      }
    const auto call = as_call(value);
    if (!call)
      fail(entry, "found '" + value + "'", allowed);
    data.name = call->name;
    for (const std::string &argument : call->arguments)
      {
        const auto        equals    = argument.find('=');
        const std::string parameter = trim(argument.substr(0, equals));
        if (equals == std::string::npos || parameter.empty())
          fail(entry, "found '" + argument + "'", allowed);
        const Expression number = expression(entry, argument.substr(equals + 1));
        if (!number.is_constant())
          fail(entry, "found '" + argument + "', which is no constant", allowed);
        if (!data.parameters.emplace(parameter, number.value(Point<3>(), 0)).second)
          fail(entry, "the parameter '" + parameter + "' stands twice in '" + value + "'", allowed);
      }
    return data;
  }
} // namespace Amontons
