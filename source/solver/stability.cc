#include <amontons/solver/stability.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <complex>

namespace Amontons
{
  namespace
  {
    double
    product(const LA::Vector &a, const LA::Vector &damping, const LA::Vector &b)
    {
      LA::Vector scaled(b);
      scaled.scale(damping);
      return a * scaled;
    }

    // Numbers between -1 and 1 that look random and do not depend on the ranks.
    LA::Vector
    irregular(const LA::Vector &like)
    {
      LA::Vector result;
      result.reinit(like);
      for (const auto dof : result.locally_owned_elements())
        result(dof) = std::fmod((dof + 1) * 0.6180339887498949 * 2, 2.) - 1;
      result.compress(VectorOperation::insert);
      return result;
    }

    // Of the leading n x n block.
    std::vector<std::complex<double>>
    eigenvalues(const FullMatrix<double> &H, const unsigned int n)
    {
      LAPACKFullMatrix<double> block(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          block(i, j) = H(i, j);
      block.compute_eigenvalues();
      std::vector<std::complex<double>> result;
      for (unsigned int k = 0; k < n; ++k)
        result.push_back(block.eigenvalue(k));
      return result;
    }

    // Of the real ones; 0: none is negative.
    double
    most_negative_eigenvalue(const FullMatrix<double> &H, const unsigned int n)
    {
      double result = 0;
      for (const auto &value : eigenvalues(H, n))
        if (value.imag() == 0)
          result = std::min(result, value.real());
      return result;
    }

    // By inverse iteration; of length 1.
    Vector<double>
    eigenvector(const FullMatrix<double> &H, const unsigned int n, const double value)
    {
      FullMatrix<double> shifted(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          shifted(i, j) = H(i, j) - (i == j ? value * (1 + 1e-7) : 0.);
      shifted.gauss_jordan();
      Vector<double> x(n), y(n);
      x = 1;
      for (unsigned int step = 0; step < 3; ++step)
        {
          shifted.vmult(y, x);
          x.equ(1 / y.l2_norm(), y);
        }
      return x;
    }
  } // namespace

  std::optional<UnstableMode>
  find_unstable_mode(const std::function<bool(LA::Vector &y, const LA::Vector &x)> &solve,
                     const LA::Vector                                              &damping,
                     const unsigned int                                             n_steps)
  {
    // The first solve brings the start into the space that supports and contact leave.
    std::vector<LA::Vector> basis(1, irregular(damping));
    if (LA::Vector x(basis[0]); !solve(basis[0], x))
      return {};
    double norm = std::sqrt(product(basis[0], damping, basis[0]));
    if (!(norm > 0))
      return {};
    basis[0] /= norm;
    FullMatrix<double> H(n_steps, n_steps);
    unsigned int       n = 0;
    while (n < n_steps)
      {
        LA::Vector y(damping);
        if (!solve(y, basis[n]))
          return {};
        const double before = std::sqrt(product(y, damping, y));
        for (const bool again : {false, true})
          {
            (void)again;
            for (unsigned int i = 0; i <= n; ++i)
              {
                const double h = product(basis[i], damping, y);
                H(i, n) += h;
                y.add(-h, basis[i]);
              }
          }
        norm = std::sqrt(product(y, damping, y));
        ++n;
        if (norm <= 1e-10 * before || n == n_steps)
          break;
        H(n, n - 1) = norm;
        y /= norm;
        basis.push_back(y);
      }
    const double value = most_negative_eigenvalue(H, n);
    if (!(value < 0))
      return {};
    const auto vector = eigenvector(H, n, value);
    if (norm * std::abs(vector[n - 1]) > -0.1 * value)
      return {};
    UnstableMode mode;
    mode.rate = -1 / value;
    mode.shape.reinit(damping);
    for (unsigned int i = 0; i < n; ++i)
      mode.shape.add(vector[i], basis[i]);
    mode.shape /= mode.shape.linfty_norm();
    return mode;
  }

  template <typename Vector>
  double
  LargestRitzValue<Vector>::find(Vector next, const double noteworthy) const
  {
    constexpr unsigned int n_steps = 8;
    std::vector<Vector>    basis, basis_energies;
    FullMatrix<double>     ritz(n_steps);
    double                 found = 0;
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        for (unsigned int twice = 0; twice < 2; ++twice)
          for (unsigned int j = 0; j < k; ++j)
            next.add(-(next * basis_energies[j]), basis[j]);
        Vector       energy = energies(next);
        const double square = next * energy;
        if (!(square > 0))
          break;
        next /= std::sqrt(square);
        energy /= std::sqrt(square);
        basis.push_back(next);
        basis_energies.push_back(energy);
        const Vector force = forces(next);
        for (unsigned int i = 0; i <= k; ++i)
          ritz(i, k) = ritz(k, i) = basis[i] * force;
        const double before = found; // the largest grows with the space
        for (const auto &value : eigenvalues(ritz, k + 1))
          found = std::max(found, std::abs(value));
        if ((k > 2 && found - before <= 0.02 * found) || (k > 1 && found < noteworthy))
          break;
        next = answer(force);
      }
    return found;
  }

  template struct LargestRitzValue<LA::Vector>;
} // namespace Amontons
