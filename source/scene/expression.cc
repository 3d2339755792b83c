#include <amontons/scene/expression.h>
#include <amontons/scene/text.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <cmath>
#include <iostream>
#include <sstream>

namespace Amontons
{
  struct Expression::Parser
  {
    dealii::FunctionParser<3> function;
    Where                     where;
  };

  namespace
  {
    const std::string allowed_expressions =
        "an expression of x, y, z, t (axisymmetric: also r), pi, and table(t: value, ...)";

    // deal.II repeats muParser's message on std::cerr; the exception says it all.
    class SilentErrors
    {
    public:
      SilentErrors() : buffer(std::cerr.rdbuf(nullptr)) {}
      ~SilentErrors()
      {
        std::cerr.rdbuf(buffer);
        std::cerr.clear();
      }
      SilentErrors(const SilentErrors &) = delete;
      SilentErrors &
      operator=(const SilentErrors &) = delete;

    private:
      std::streambuf *buffer;
    };

    struct TablePoint
    {
      double      t;
      std::string value;
    };

    std::vector<TablePoint>
    table_points(const std::string &arguments, const Where &where)
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

    std::string
    expand_tables(std::string text, const Where &where)
    {
      while (has_identifier(text, "table"))
        {
          // the last table stands inside of all others that contain it
          auto begin = text.rfind("table");
          while (begin > 0 &&
                 (std::isalnum(static_cast<unsigned char>(text[begin - 1])) || text[begin - 1] == '_'))
            begin = text.rfind("table", begin - 1);
          const auto open  = text.find_first_not_of(" \t", begin + 5);
          const auto close = open != std::string::npos && text[open] == '(' ? closing_parenthesis(text, open)
                                                                            : std::string::npos;
          if (close == std::string::npos)
            throw InputError(
                where, "'" + text + "': 'table' without its parentheses", "table(t: value, ...)");
          const auto points = table_points(text.substr(open + 1, close - open - 1), where);
          text.replace(begin, close + 1 - begin, piecewise_linear(points));
        }
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

  Expression::Expression(const std::string &text, const Where &where) : source(trim(text))
  {
    if (source.empty())
      throw InputError(where, "found nothing", allowed_expressions);
    if (const auto number = as_number(source))
      {
        constant_value = *number;
        return;
      }

    const std::string plain = map_identifiers(
        expand_tables(source, where), [](const std::string &word) { return word == "r" ? "x" : word; });
    parser           = std::make_shared<Parser>();
    parser->where    = where;
    double at_origin = 0;
    try
      {
        const SilentErrors silence;
        parser->function.initialize("x,y,z,t", plain, {{"pi", dealii::numbers::PI}}, true);
        at_origin = parser->function.value(dealii::Point<3>());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw InputError(where,
                         "'" + source + "' cannot be read: " + what_the_parser_said(exception),
                         allowed_expressions);
      }

    for (const std::string variable : {"x", "y", "z", "t", "rand", "rand_seed"})
      constant = constant && !has_identifier(plain, variable);
    if (constant)
      {
        constant_value = at_origin;
        parser.reset();
        if (!std::isfinite(constant_value))
          throw InputError(where, "'" + source + "' is not a finite number", allowed_expressions);
      }
  }

  double
  Expression::value(const dealii::Point<3> &p, const double t) const
  {
    if (constant)
      return constant_value;
    parser->function.set_time(t);
    const double value = parser->function.value(p);
    if (!std::isfinite(value))
      {
        std::ostringstream found;
        found << "'" << source << "' is " << (std::isnan(value) ? "not a number" : "infinite") << " at x = " << p[0]
              << ", y = " << p[1] << ", z = " << p[2] << ", t = " << t;
        throw InputError(parser->where, found.str(), "expressions with finite values where they are used");
      }
    return value;
  }

  const std::string &
  Expression::text() const
  {
    return source;
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
} // namespace Amontons
