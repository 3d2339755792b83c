// Whether an equilibrium is stable: would the damped motion leave it?
#pragma once

#include <amontons/base/linear_algebra.h>

#include <functional>
#include <optional>

namespace Amontons
{
  struct UnstableMode
  {
    double     rate;  // of growth: motion ~ exp(rate tau)
    LA::Vector shape; // largest component 1
  };

  // Of  D du/dtau + K u = 0, where solve(y, x) solves K y = D x under the present contact: Arnoldi's method
  // for K^-1 D, whose eigenvalues next to K = 0 come first, in `n_steps` solves. Complex eigenvalues
  // (flutter) are left out, and those that have not converged to a tenth.
  std::optional<UnstableMode>
  find_unstable_mode(const std::function<bool(LA::Vector &y, const LA::Vector &x)> &solve,
                     const LA::Vector                                              &damping,
                     const unsigned int                                             n_steps = 12);

  // The largest |lambda| of S v = lambda K v, both symmetric and K positive, by a few steps of Lanczos'
  // method for K^-1 S: vectors v_i that are orthogonal in the energy of K, so that Ritz values are the
  // eigenvalues of the matrix of all products (v_i, S v_j).
  template <typename Vector>
  struct LargestRitzValue
  {
    std::function<Vector(const Vector &v)>     forces;   // S v
    std::function<Vector(const Vector &v)>     energies; // K v
    std::function<Vector(const Vector &force)> answer;   // about K^-1 force

    // noteworthy: less is not looked at more closely.
    double
    find(Vector start, const double noteworthy) const;
  };
} // namespace Amontons
