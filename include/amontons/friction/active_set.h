// Which nodes are closed: primal-dual active set with a safeguard that makes it finite.
#pragma once

#include <vector>

namespace Amontons
{
  // Complementarity p >= 0, g >= 0, p g = 0 as p - max(0, p - c g) = 0 (doc/introduction.md, (11)), whose
  // semismooth Newton step is: closed where p - c g > 0 (Hintermueller, Ito, Kunisch 2003; Hueber and
  // Wohlmuth 2005). All nodes change at once as long as the number of nodes to be changed falls to a new
  // minimum at least once in `patience` iterations; else only the node of highest index changes (Murty's
  // rule) until it does: finite for symmetric positive definite problems (Judice and Pires, Computers &
  // Operations Research 21 (1994) 587).
  class ActiveSetUpdate
  {
  public:
    explicit ActiveSetUpdate(const unsigned int patience = 8) : patience(patience), remaining(patience) {}

    // closed: the set that p and g were computed with, updated in place. c > 0, p and g in compatible units;
    // `tolerance`: |p - c g| below it leaves a node as it is (rounding must not make nodes flicker). Returns
    // the number of changes made.
    unsigned int
    update(const std::vector<double> &pressure,
           const std::vector<double> &gap,
           const std::vector<double> &c,
           const double               tolerance,
           std::vector<bool>         &closed);

    bool
    safeguarded() const
    {
      return single;
    } // the last update used Murty's rule

  private:
    unsigned int patience, remaining;
    std::size_t  fewest = static_cast<std::size_t>(-1);
    bool         single = false;
  };
} // namespace Amontons
