/// Values on cells and faces for integrals of loads that the user writes as expressions of the place.
#pragma once

#include <amontons/base/points.h>
#include <amontons/discretization/discretization.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  /// What a load is at points of the unit cell or face.
  template <int d>
  using LoadAt = std::function<std::vector<Tensor<1, 3>>(const std::vector<Point<d>> &)>;

  /// The formula itself where it integrates the load to 1e-4 of what a lattice of boxes says (64 intervals, 8
  /// x 8, 4 x 4 x 4), and the trapezoidal rule on none of these is off by 5e-3 of it (a jump near an end), or
  /// both by what is negligible; else the formula on boxes that are halved where that changes the integral by
  /// 1e-6 (in space 1e-5) of the load on the cell or face, or where values vary as much as in twice the box.
  /// A load may end or jump anywhere, and no refinement of the mesh follows where nothing is loaded. What is
  /// narrower than the points of the lattice (1/300; 1/32; 1/16) may be missed.
  template <int d>
  Quadrature<d>
  adapted_quadrature(const Quadrature<d> &formula, const LoadAt<d> &load, const double negligible = 0);

  /// Polynomials through the points of Gauss' formula with n^d points.
  template <int d>
  class GaussPolynomials
  {
  public:
    explicit GaussPolynomials(const unsigned int n);

    const Quadrature<d> formula;

    /// At a point, of all polynomials, in the order of the formula's points.
    void
    evaluate(const Point<d> &point, std::vector<double> &values) const;
    /// At the points of the formula, the polynomial that has the moments of the load, from its values at the
    /// points of `quadrature`: in the mean square the nearest one.
    std::vector<Tensor<1, 3>>
    nearest(const Quadrature<d> &quadrature, const std::vector<Tensor<1, 3>> &load) const;

  private:
    const unsigned int  n;       // in each direction
    std::vector<double> nodes;   // along the unit interval
    std::vector<double> factors; // by node, 1/prod (its distances from the others)
  };

  /// A load at the points of `values`.
  template <typename Values>
  struct LoadOn
  {
    const Values             &values;
    std::vector<Tensor<1, 3>> load;
  };

  /// FEV: FEValues<dim> with d = dim, or FEFaceValues<dim> with d = dim - 1.
  template <template <int, int> class FEV, int dim, int d>
  class LoadValues
  {
  public:
    using Values = FEV<dim, dim>;

    LoadValues(const Discretization<dim> &discretization,
               const Quadrature<d>       &formula,
               const UpdateFlags          flags)
        : discretization(discretization), formula(formula), flags(flags),
          polynomials(discretization.fe.degree + 3),
          plain(discretization.load_mapping, discretization.fe, formula, flags)
    {
    }

    /// Before the first reinit() for a load: its size, over all cells or faces where it acts;
    /// for_each(action) calls action(cell) or action(cell, face) for those of this rank. Collective.
    template <typename ForEach>
    void
    measure(const std::array<Expression, 3> &load, const double t, const ForEach &for_each)
    {
      total = 0;
      if (!depends_on_place(load))
        return;
      for_each([&](const auto &cell, const auto... face) {
        plain.reinit(cell, face...);
        for (unsigned int q = 0; q < plain.n_quadrature_points; ++q)
          total += value(load, t, plain.quadrature_point(q)).norm() * plain.JxW(q);
      });
      total = Utilities::MPI::sum(total, discretization.geometry.communicator);
    }

    /// On a cell, or on a face of it (its number), for integrals of the load at time t, with test functions
    /// of the element. Where it is not smooth, a polynomial with the same moments takes its place. Valid
    /// until the next call.
    template <typename... Face>
    LoadOn<Values>
    reinit(const std::array<Expression, 3>                      &load,
           const double                                          t,
           const typename DoFHandler<dim>::active_cell_iterator &cell,
           const Face... face)
    {
      plain.reinit(cell, face...);
      if (depends_on_place(load))
        {
          if (!fine)
            fine = std::make_unique<Values>(
                discretization.load_mapping, discretization.fe, polynomials.formula, flags);
          fine->reinit(cell, face...);
          const auto at   = [&](const std::vector<Point<d>> &points) { return values_at(load, t, points); };
          double     size = 0; // of the cell or face
          for (unsigned int q = 0; q < plain.n_quadrature_points; ++q)
            size += plain.JxW(q);
          const Quadrature<d> here = adapted_quadrature<d>(formula, at, 1e-6 * total / size);
          if (here.size() != formula.size())
            return {*fine, polynomials.nearest(here, at(here.get_points()))};
        }
      LoadOn<Values> result{plain, {}};
      for (unsigned int q = 0; q < plain.n_quadrature_points; ++q)
        result.load.push_back(value(load, t, plain.quadrature_point(q)));
      return result;
    }

    /// Where nothing is loaded, with the formula.
    template <typename... Face>
    const Values &
    reinit(const typename DoFHandler<dim>::active_cell_iterator &cell, const Face... face)
    {
      plain.reinit(cell, face...);
      return plain;
    }

  private:
    static bool
    depends_on_place(const std::array<Expression, 3> &load)
    {
      return std::any_of(load.begin(), load.end(), [](const auto &f) { return f.depends_on_place(); });
    }
    static Tensor<1, 3>
    value(const std::array<Expression, 3> &load, const double t, const Point<dim> &x)
    {
      Tensor<1, 3> result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] = load[c].value(as_3d(x), t);
      return result;
    }
    // Places are polynomials of the element's degree in the unit cell: those through the points of `fine`.
    // (Values of deal.II at ten thousand points of a face are made for all faces in all orientations.)
    std::vector<Tensor<1, 3>>
    values_at(const std::array<Expression, 3> &load,
              const double                     t,
              const std::vector<Point<d>>     &points) const
    {
      std::vector<Tensor<1, 3>> result;
      std::vector<double>       basis;
      result.reserve(points.size());
      for (const auto &point : points)
        {
          polynomials.evaluate(point, basis);
          Point<dim> x;
          for (unsigned int q = 0; q < basis.size(); ++q)
            x += basis[q] * Tensor<1, dim>(fine->quadrature_point(q));
          result.push_back(value(load, t, x));
        }
      return result;
    }

    const Discretization<dim> &discretization;
    const Quadrature<d>        formula;
    const UpdateFlags          flags;
    const GaussPolynomials<d>  polynomials;
    Values                     plain;
    std::unique_ptr<Values>    fine;      // once a load depends on the place
    double                     total = 0; // see measure()
  };

  template <int dim>
  using LoadCellValues = LoadValues<FEValues, dim, dim>;
  template <int dim>
  using LoadFaceValues = LoadValues<FEFaceValues, dim, dim - 1>;
} // namespace Amontons
