// A value written by the user: an expression of x, y, z, t (muParser through deal.II) or with tables of (t,
// value); bounds of friction also have the contact pressure p.
#pragma once

#include <amontons/base/input_error.h>

#include <deal.II/base/point.h>

#include <memory>
#include <string>
#include <vector>

namespace Amontons
{
  // Copyable; copies share the parser (not thread safe, as muParser is not).
  // "table(0: 0, 1: 5, 2: 3)" anywhere in the text stands for the piecewise linear function of t through
  // these points (constant outside). Constants: pi. In axisymmetric scenes r may be written for x.
  class Expression
  {
  public:
    Expression() = default; // zero
    explicit Expression(const double constant);
    // Throws InputError at `where` if the text cannot be parsed or has other variables than these, of x, y,
    // z, r, t and p.
    Expression(const std::string              &text,
               const SourceLocation           &where,
               const std::vector<std::string> &variables = {"x", "y", "z", "t"});

    // Before t = 0: the value at t = 0, of which loads have the part 1 + t/duration.
    double
    value(const dealii::Point<3> &p, const double t, const double pressure = 0) const;
    // This is a load, which can be applied before t = 0.
    void
    grow_before_start(const double duration);
    // Throws InputError if the value is negative.
    void
    refuse_negative(const dealii::Point<3> &p, const double t, const double pressure) const;
    const std::string &
    text() const;
    const std::vector<double> &
    corners() const; // times of all tables in the text, increasing
    bool
    is_zero() const; // the text is the constant zero
    bool
    is_constant() const; // does not depend on x, y, z, t, p
    bool
    depends_on_time() const;
    bool
    depends_on_place() const;
    bool
    may_jump() const; // from place to place: it compares, chooses or rounds

  private:
    [[noreturn]] void
    refuse(const std::string      &what,
           const dealii::Point<3> &p,
           const double            t,
           const double            pressure,
           const std::string      &allowed) const;

    struct Parser;
    std::shared_ptr<Parser> parser;
    std::string             source = "0";
    std::vector<double>     table_times;
    double                  constant_value = 0;
    bool                    constant       = true;
    double                  growth         = 0; // time in which it grows before t = 0; 0: it does not
  };
} // namespace Amontons
