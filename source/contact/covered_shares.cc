#include <amontons/base/gather.h>
#include <amontons/contact/covered_shares.h>
#include <amontons/contact/face_basis.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    // Faces at nodes of faces with points.
    template <int dim>
    std::vector<unsigned int>
    faces_around(const ContactSurface<dim> &slave, const FacesWithPoints<dim> &points)
    {
      std::vector<bool> is_met(slave.nodes.size(), false);
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        if (points.meets(f))
          for (const unsigned int i : slave.faces[f].unknowns)
            is_met[i] = true;
      std::vector<unsigned int> faces;
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        if (const auto &nodes = slave.faces[f].unknowns;
            std::any_of(nodes.begin(), nodes.end(), [&](const unsigned int i) { return is_met[i]; }))
          faces.push_back(f);
      return faces;
    }

    // Of one face: int B_i over the covered part, by place in the face; the same over the whole face; both
    // areas.
    template <int dim>
    std::vector<double>
    covered_and_whole(const ContactSurface<dim> &slave,
                      const unsigned int         f,
                      const PointsView<dim>     &points,
                      const bool                 axisymmetric)
    {
      const unsigned int  n = slave.faces[f].nodes.size();
      std::vector<double> sums(2 * n + 2, 0.);
      const auto          add = [&](const unsigned int part, const Point<dim - 1> &xi, const double weight) {
        const auto B = bernstein_values<dim - 1>(slave.degree, xi);
        for (unsigned int j = 0; j < n; ++j)
          sums[part * n + j] += weight * B[j];
        sums[2 * n + part] += weight;
      };
      for (const auto &p : points)
        add(0, p.xi_slave, p.weight);
      const QGauss<dim - 1> gauss(slave.degree + 2);
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          double jacobian;
          slave.face_normal(f, gauss.point(q), &jacobian);
          add(1,
              gauss.point(q),
              gauss.weight(q) * jacobian * area_factor(axisymmetric, slave.position(f, gauss.point(q))));
        }
      return sums;
    }

    // From D_i = int B_i, with the Lagrange polynomials N = T^T B and int B_i = area/n on a plane face.
    template <int dim>
    bool
    is_positive(const ContactSurface<dim> &slave,
                const unsigned int         f,
                const std::vector<double> &D,
                const double               area,
                const bool                 axisymmetric)
    {
      const auto         T = control_matrix(slave.degree, dim - 1);
      const unsigned int n = T.size();
      for (unsigned int j = 0; j < n; ++j)
        {
          double N = 0, plane = 0;
          for (unsigned int i = 0; i < n; ++i)
            {
              N += T[i][j] * D[i];
              plane += T[i][j] * area / n;
            }
          if (!(axisymmetric && is_on_axis(slave, slave.faces[f].nodes[j])) && N < 0.2 * plane)
            return false;
        }
      return true;
    }
  } // namespace

  template <int dim>
  Coverage
  covered_shares(const ContactSurface<dim>  &slave,
                 const FacesWithPoints<dim> &points,
                 const bool                  axisymmetric,
                 const MPI_Comm              communicator)
  {
    const auto          faces = faces_around(slave, points);
    std::vector<double> mine, sums;
    for (const unsigned int f : faces)
      if (points.is_mine(f))
        {
          const auto of_face = covered_and_whole(slave, f, points[f], axisymmetric);
          mine.insert(mine.end(), of_face.begin(), of_face.end());
        }
    for (const auto &part : gather_on_all(communicator, std::move(mine)))
      sums.insert(sums.end(), part.begin(), part.end());

    Coverage            coverage;
    std::vector<double> whole(slave.nodes.size(), 0.);
    coverage.shares.assign(slave.nodes.size(), 0.);
    coverage.positive_faces.assign(slave.faces.size(), false);
    auto next = sums.begin();
    for (const unsigned int f : faces)
      {
        const auto         &face = slave.faces[f];
        std::vector<double> covered_part;
        for (auto *const by_node : {&coverage.shares, &whole})
          {
            const std::vector<double> D(next, next + face.nodes.size());
            const auto                of_unknowns = traces_of_unknowns(D, face.subdivision);
            for (unsigned int k = 0; k < D.size(); ++k)
              (*by_node)[face.unknowns[k]] += of_unknowns[k];
            if (covered_part.empty())
              covered_part = D;
            next += D.size();
          }
        const double covered_area = *next++, face_area = *next++;
        if (covered_area > 0.999 * face_area)
          coverage.whole_faces.insert(f);
        coverage.positive_faces[f] = is_positive(slave, f, covered_part, face_area, axisymmetric);
      }
    for (unsigned int i = 0; i < whole.size(); ++i)
      coverage.shares[i] /= std::max(whole[i], 1e-300);
    return coverage;
  }

  template Coverage
  covered_shares(const ContactSurface<2> &, const FacesWithPoints<2> &, const bool, const MPI_Comm);
  template Coverage
  covered_shares(const ContactSurface<3> &, const FacesWithPoints<3> &, const bool, const MPI_Comm);
} // namespace Amontons
