#include <amontons/contact/face_moments.h>
#include <amontons/contact/ad_numbers.h>

namespace Amontons
{
  namespace
  {
    // Rows of derivatives by n variables.
    template <int n>
    class Rows
    {
    public:
      explicit Rows(const unsigned int n_rows) : numbers(n_rows * n, 0.) {}

      // row += a da + b db
      void
      add(const unsigned int row,
          const double       a,
          const ADNumber<n> &da,
          const double       b,
          const ADNumber<n> &db)
      {
        double *const       to = &numbers[row * n];
        const double *const x = da.dx(), *const y = db.dx();
        for (unsigned int v = 0; v < n; ++v)
          to[v] += a * x[v] + b * y[v];
      }

      double
      operator()(const unsigned int row, const unsigned int variable) const
      {
        return numbers[row * n + variable];
      }

    private:
      std::vector<double> numbers;
    };

    // The part of the moments above one master face.
    template <int dim, int n>
    struct MomentSums
    {
      MomentSums(const unsigned int n_basis, const unsigned int n_master)
          : G(n_basis), N(n_basis, n_master), P(n_basis), H(n_basis), dG(n_basis * n_basis),
            dN(n_basis * n_master), dP(n_basis * dim), dH(n_basis * dim), dL(n_basis), dwL(n_basis)
      {
      }

      // Each term is the product of w L_k with a second factor.
      void
      add(const CoveredBasis<dim - 1> &basis, const PointAD<dim, n> &p)
      {
        const Point<dim - 1>         xi     = value_of(p.xi);
        const auto                   L      = basis.values(xi);
        const auto                   slopes = basis.gradients(xi);
        const double                 w      = p.weight.val();
        Components<dim, ADNumber<n>> gn     = scaled(p.gap, p.normal);
        for (unsigned int k = 0; k < L.size(); ++k)
          {
            dL[k] = slopes[k][0] * p.xi[0];
            for (unsigned int d = 1; d < dim - 1; ++d)
              dL[k] += slopes[k][d] * p.xi[d];
            dwL[k] = L[k] * p.weight + w * dL[k];
          }
        for (unsigned int k = 0; k < L.size(); ++k)
          {
            const double wL = w * L[k];
            for (unsigned int l = 0; l <= k; ++l)
              {
                G(k, l) += wL * L[l];
                dG.add(k * L.size() + l, L[l], dwL[k], wL, dL[l]);
              }
            for (unsigned int c = 0; c < dim; ++c)
              {
                P[k][c] += wL * p.normal[c].val();
                H[k][c] += wL * gn[c].val();
                dP.add(k * dim + c, p.normal[c].val(), dwL[k], wL, p.normal[c]);
                dH.add(k * dim + c, gn[c].val(), dwL[k], wL, gn[c]);
              }
            for (unsigned int q = 0; q < p.master.size(); ++q)
              {
                N(k, q) += wL * p.master[q].val();
                dN.add(k * p.master.size() + q, p.master[q].val(), dwL[k], wL, p.master[q]);
              }
          }
      }

      FullMatrix<double>          G, N;
      std::vector<Tensor<1, dim>> P, H;
      Rows<n>                     dG, dN, dP, dH;

    private:
      std::vector<ADNumber<n>> dL, dwL;
    };

    // Adds the part above one master face, whose nodes have the places `master` among those of the moments.
    template <int dim, int n>
    void
    add_part(const MomentSums<dim, n>        &part,
             const std::vector<unsigned int> &master,
             const unsigned int               n_slave_variables,
             FaceMoments<dim>                &moments)
    {
      std::vector<unsigned int> column;
      for (unsigned int v = 0; v < n_slave_variables; ++v)
        column.push_back(v);
      for (const unsigned int q : master)
        for (unsigned int c = 0; c < dim; ++c)
          column.push_back(n_slave_variables + q * dim + c);
      const auto add_row = [&](const Rows<n>      &from,
                               const unsigned int  row,
                               FullMatrix<double> &to,
                               const unsigned int  to_row) {
        for (unsigned int v = 0; v < column.size(); ++v)
          to(to_row, column[v]) += from(row, v);
      };
      for (unsigned int k = 0; k < moments.n; ++k)
        {
          for (unsigned int l = 0; l <= k; ++l)
            {
              moments.G(k, l) += part.G(k, l);
              add_row(part.dG, k * moments.n + l, moments.dG, k * moments.n + l);
            }
          moments.P[k] += part.P[k];
          moments.H[k] += part.H[k];
          for (unsigned int c = 0; c < dim; ++c)
            {
              add_row(part.dP, k * dim + c, moments.dP, k * dim + c);
              add_row(part.dH, k * dim + c, moments.dH, k * dim + c);
            }
          for (unsigned int q = 0; q < master.size(); ++q)
            {
              moments.N(k, master[q]) += part.N(k, q);
              add_row(part.dN, k * master.size() + q, moments.dN, k * moments.master.size() + master[q]);
            }
        }
    }

    template <typename Number>
    void
    fill_upper_half(const unsigned int n, FullMatrix<Number> &G, FullMatrix<Number> &dG)
    {
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = k + 1; l < n; ++l)
          {
            G(k, l) = G(l, k);
            for (unsigned int v = 0; v < dG.n(); ++v)
              dG(k * n + l, v) = dG(l * n + k, v);
          }
    }

    // Points that lie above one master face, one group after the other.
    template <int dim>
    std::vector<PointsView<dim>>
    by_master_face(const PointsView<dim> &points)
    {
      std::vector<PointsView<dim>> groups;
      for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end)
        {
          while (end < points.size() && points[end].master_face == points[begin].master_face)
            ++end;
          groups.emplace_back(&points[begin], end - begin);
        }
      return groups;
    }

    template <int dim, int degree>
    FaceMoments<dim>
    compute(const Discretization<dim>   &discretization,
            const ContactInterface<dim> &interface,
            const PointsView<dim>       &points)
    {
      constexpr unsigned int      n = n_variables(dim, degree), n_slave = 2 * dim * n_face_nodes(dim, degree);
      std::vector<Point<dim - 1>> xi;
      for (const auto &p : points)
        xi.push_back(p.xi_slave);
      const CoveredBasis<dim - 1> basis(degree, xi);

      FaceMoments<dim>                       moments;
      std::vector<std::vector<unsigned int>> places;
      std::map<NodeDofs<dim>, unsigned int>  place_of;
      for (const auto &group : by_master_face(points))
        {
          places.emplace_back();
          for (const auto &dofs : master_dofs(discretization, interface.master, group[0]))
            {
              const auto place = place_of.emplace(dofs, place_of.size());
              if (place.second)
                moments.master.push_back(dofs);
              places.back().push_back(place.first->second);
            }
        }
      moments.n           = n_face_nodes(dim, degree);
      moments.n_variables = n_slave + dim * moments.master.size();
      moments.R           = basis.R;
      moments.G.reinit(moments.n, moments.n);
      moments.N.reinit(moments.n, moments.master.size());
      moments.P.resize(moments.n);
      moments.H.resize(moments.n);
      moments.dG.reinit(moments.n * moments.n, moments.n_variables);
      moments.dN.reinit(moments.n * moments.master.size(), moments.n_variables);
      moments.dP.reinit(moments.n * dim, moments.n_variables);
      moments.dH.reinit(moments.n * dim, moments.n_variables);

      const Clipper<dim, ADNumber<n>> clipper({*interface.slave, points[0].slave_face, 0, n_slave / 2});
      unsigned int                    next = 0;
      for (const auto &group : by_master_face(points))
        {
          const auto        &master = places[next++];
          MomentSums<dim, n> part(moments.n, master.size());
          vary_points<dim, n>(discretization, interface, clipper, group, [&](const PointAD<dim, n> &p) {
            part.add(basis, p);
          });
          add_part(part, master, n_slave, moments);
        }
      fill_upper_half(moments.n, moments.G, moments.dG);
      return moments;
    }
  } // namespace

  template <int dim>
  FaceMoments<dim>
  make_face_moments(const Discretization<dim>   &discretization,
                    const ContactInterface<dim> &interface,
                    const PointsView<dim>       &points)
  {
    return interface.slave->degree == 1 ? compute<dim, 1>(discretization, interface, points)
                                        : compute<dim, 2>(discretization, interface, points);
  }

  template FaceMoments<2>
  make_face_moments(const Discretization<2> &, const ContactInterface<2> &, const PointsView<2> &);
  template FaceMoments<3>
  make_face_moments(const Discretization<3> &, const ContactInterface<3> &, const PointsView<3> &);
} // namespace Amontons
