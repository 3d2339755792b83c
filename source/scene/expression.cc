#include <amontons/base/silent_errors.h>
#include <amontons/scene/expression.h>
#include <amontons/scene/text.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace Amontons
{
  // deal.II's parser has room for four variables. Where the text has the pressure, p takes the place of t,
  // which is a constant: the text is parsed again whenever t changes, that is, once per increment.
  struct Expression::Parser
  {
    dealii::FunctionParser<3> function;
    std::string               text;
    bool                      of_pressure;
    double                    t;
    SourceLocation            where;

    void
    parse(const double time)
    {
      std::map<std::string, double> constants = {{"pi", dealii::numbers::PI}};
      if (of_pressure)
        constants["t"] = time;
      function.initialize(of_pressure ? "x,y,z,p" : "x,y,z,t", text, constants, true);
      t = time;
    }

    double
    value(const dealii::Point<3> &p, const double time, const double pressure)
    {
      if (of_pressure && time != t)
        parse(time);
      function.set_time(of_pressure ? pressure : time);
      return function.value(p);
    }
  };

  namespace
  {
    std::string
    allowed_expressions(const std::vector<std::string> &variables)
    {
      std::string list;
      for (const std::string &variable : variables)
        list += variable + (variable == "p" ? " (contact pressure), " : variable == "r" ? " (= x), " : ", ");
      return "an expression of " + list + "pi, and table(t: value, ...)";
    }

    // What is no variable here must not be taken for 0; random numbers are others at every call.
    void
    refuse_other_variables(const std::string              &text,
                           const std::vector<std::string> &variables,
                           const SourceLocation           &where)
    {
      for (const std::string name : {"x", "y", "z", "r", "t", "p", "rand", "rand_seed"})
        if (has_identifier(text, name) &&
            std::find(variables.begin(), variables.end(), name) == variables.end())
          throw InputError(where,
                           "'" + text + "' has the " + (name.size() > 1 ? "function " : "variable ") + name +
                               ", which has no meaning here",
                           allowed_expressions(variables));
    }

    // The parser takes the last of several values: 1,5 would be 5.
    void
    refuse_commas(const std::string              &text,
                  const std::vector<std::string> &variables,
                  const SourceLocation           &where)
    {
      std::vector<bool> of_function; // by open parenthesis
      char              before = ' ';
      for (const char c : text)
        {
          if (c == '(')
            of_function.push_back(std::isalnum(static_cast<unsigned char>(before)) || before == '_');
          else if (c == ')' && !of_function.empty())
            of_function.pop_back();
          else if (c == ',' && (of_function.empty() || !of_function.back()))
            throw InputError(where,
                             "'" + text + "' has a comma that does not divide arguments of a function",
                             allowed_expressions(variables) +
                                 "; with a decimal point in numbers, and ';' between components");
          if (!std::isspace(static_cast<unsigned char>(c)))
            before = c;
        }
    }

    struct TablePoint
    {
      double      t;
      std::string value;
    };

    std::vector<TablePoint>
    table_points(const std::string &arguments, const SourceLocation &where)
    {
      std::vector<TablePoint> points;
      for (const std::string &argument : split(arguments, ','))
        {
          const auto colon = argument.find(':');
          const auto t     = as_number(argument.substr(0, colon));
          if (colon == std::string::npos || !t || trim(argument.substr(colon + 1)).empty())
            throw InputError(where,
                             "found '" + argument + "' in table(" + arguments + ")",
                             "'time: value' with a number as time, as in table(0: 0, 1: 5)");
          if (!points.empty() && *t <= points.back().t)
            throw InputError(
                where, "the times of table(" + arguments + ") do not increase", "increasing times");
          points.push_back({*t, "(" + trim(argument.substr(colon + 1)) + ")"});
        }
      if (points.empty())
        throw InputError(where, "found a table without points", "table(t: value, ...)");
      return points;
    }

    // Nested conditions, from the last interval to the first.
    std::string
    piecewise_linear(const std::vector<TablePoint> &points)
    {
      std::string text = points.back().value;
      for (std::size_t i = points.size() - 1; i > 0; --i)
        {
          const TablePoint  &a = points[i - 1], &b = points[i];
          std::ostringstream piece;
          piece.precision(17);
          piece << "(t<=(" << b.t << ")?(" << a.value << "+(" << b.value << "-" << a.value << ")*(t-(" << a.t
                << "))/(" << b.t - a.t << ")):" << text << ")";
          text = piece.str();
        }
      std::ostringstream whole;
      whole.precision(17);
      whole << "(t<=(" << points.front().t << ")?" << points.front().value << ":" << text << ")";
      return whole.str();
    }

    // The text without tables; adds their times to `times`.
    std::string
    expand_tables(std::string text, const SourceLocation &where, std::vector<double> &times)
    {
      while (has_identifier(text, "table"))
        {
          // the last table stands inside of all others that contain it
          auto begin = text.rfind("table");
          while (begin != std::string::npos && begin > 0 &&
                 (std::isalnum(static_cast<unsigned char>(text[begin - 1])) || text[begin - 1] == '_'))
            begin = text.rfind("table", begin - 1);
          if (begin == std::string::npos)
            throw InputError(where,
                             "'" + text + "': 'table' right behind a number",
                             "an operator between them, as in 2*table(t: value, ...)");
          const auto open  = text.find_first_not_of(" \t", begin + 5);
          const auto close = open != std::string::npos && text[open] == '(' ? closing_parenthesis(text, open)
                                                                            : std::string::npos;
          if (close == std::string::npos)
            throw InputError(
                where, "'" + text + "': 'table' without its parentheses", "table(t: value, ...)");
          const auto points = table_points(text.substr(open + 1, close - open - 1), where);
          text.replace(begin, close + 1 - begin, piecewise_linear(points));
          for (const TablePoint &point : points)
            times.push_back(point.t);
        }
      std::sort(times.begin(), times.end());
      times.erase(std::unique(times.begin(), times.end()), times.end());
      return text;
    }

    std::string
    what_the_parser_said(const dealii::ExceptionBase &exception)
    {
      std::ostringstream info;
      exception.print_info(info);
      const std::string marker = "The parser said: ";
      const auto        said   = info.str().find(marker);
      return trim(said == std::string::npos ? info.str() : info.str().substr(said + marker.size()));
    }
  } // namespace

  Expression::Expression(const double constant) : constant_value(constant)
  {
    std::ostringstream text;
    text.precision(17);
    text << constant;
    source = text.str();
  }

  Expression::Expression(const std::string              &text,
                         const SourceLocation           &where,
                         const std::vector<std::string> &variables)
      : source(trim(text))
  {
    if (source.empty())
      throw InputError(where, "found nothing", allowed_expressions(variables));
    if (const auto number = as_number(source))
      {
        constant_value = *number;
        return;
      }

    refuse_commas(source, variables, where);
    refuse_other_variables(source, variables, where);
    const std::string plain =
        map_identifiers(expand_tables(source, where, table_times),
                        [](const std::string &word) { return word == "r" ? "x" : word; });
    parser              = std::make_shared<Parser>();
    parser->where       = where;
    parser->text        = plain;
    parser->of_pressure = has_identifier(plain, "p");
    double at_origin    = 0;
    try
      {
        const SilentErrors silence; // deal.II repeats there what the exception says
        parser->parse(0);
        at_origin = parser->value(dealii::Point<3>(), 0, 0);
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw InputError(where,
                         "'" + source + "' cannot be read: " + what_the_parser_said(exception),
                         allowed_expressions(variables));
      }

    for (const std::string variable : {"x", "y", "z", "t", "p"})
      constant = constant && !has_identifier(plain, variable);
    if (constant)
      {
        constant_value = at_origin;
        parser.reset();
        if (!std::isfinite(constant_value))
          throw InputError(where, "'" + source + "' is not a finite number", allowed_expressions(variables));
      }
  }

  double
  Expression::value(const dealii::Point<3> &p, const double t, const double pressure) const
  {
    if (t < 0)
      return (growth > 0 ? std::max(0., 1 + t / growth) : 1.) * value(p, 0, pressure);
    if (constant)
      return constant_value;
    const double value = parser->value(p, t, pressure);
    if (!std::isfinite(value))
      refuse(std::isnan(value) ? "not a number" : "infinite",
             p,
             t,
             pressure,
             "expressions with finite values where they are used");
    return value;
  }

  void
  Expression::grow_before_start(const double duration)
  {
    growth = duration;
  }

  void
  Expression::refuse_negative(const dealii::Point<3> &p, const double t, const double pressure) const
  {
    if (!constant && value(p, t, pressure) < 0)
      refuse("negative", p, t, pressure, "expressions that are not, as max(0, ...)");
  }

  void
  Expression::refuse(const std::string      &what,
                     const dealii::Point<3> &p,
                     const double            t,
                     const double            pressure,
                     const std::string      &allowed) const
  {
    std::ostringstream found;
    found << "'" << source << "' is " << what << " at x = " << p[0] << ", y = " << p[1] << ", z = " << p[2]
          << ", t = " << t;
    if (parser->of_pressure)
      found << ", p = " << pressure;
    throw InputError(parser->where, found.str(), allowed);
  }

  const std::string &
  Expression::text() const
  {
    return source;
  }

  const std::vector<double> &
  Expression::corners() const
  {
    return table_times;
  }

  bool
  Expression::is_zero() const
  {
    return constant && constant_value == 0;
  }

  bool
  Expression::is_constant() const
  {
    return constant;
  }

  bool
  Expression::depends_on_time() const
  {
    return !constant && has_identifier(parser->text, "t");
  }

  bool
  Expression::depends_on_place() const
  {
    return !constant && (has_identifier(parser->text, "x") || has_identifier(parser->text, "y") ||
                         has_identifier(parser->text, "z"));
  }

  bool
  Expression::may_jump() const
  {
    const auto has = [&](const std::string &name) { return has_identifier(parser->text, name); };
    return depends_on_place() && (parser->text.find_first_of("<>=?") != std::string::npos || has("if") ||
                                  has("sign") || has("rint") || has("int") || has("ceil") || has("floor"));
  }
} // namespace Amontons
