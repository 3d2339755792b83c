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

    // Of one face: int B_i over the covered part, by unknown; the same over the whole face; both areas.
    template <int dim>
    std::vector<double>
    covered_and_whole(const ContactSurface<dim> &slave,
                      const unsigned int         f,
                      const PointsView<dim>     &points,
                      const bool                 axisymmetric)
    {
      const auto         &face = slave.faces[f];
      const unsigned int  n    = face.unknowns.size();
      std::vector<double> sums(2 * n + 2, 0.);
      const auto          add = [&](const unsigned int part, const Point<dim - 1> &xi, const double weight) {
        const auto B = traces_of_unknowns(bernstein_values<dim - 1>(slave.degree, xi), face.subdivision);
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
  } // namespace

  template <int dim>
  std::vector<double>
  covered_shares(const ContactSurface<dim>  &slave,
                 const FacesWithPoints<dim> &points,
                 const bool                  axisymmetric,
                 const MPI_Comm              communicator,
                 std::set<unsigned int>     &whole_faces)
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

    std::vector<double> covered(slave.nodes.size(), 0.), whole(slave.nodes.size(), 0.);
    auto                next = sums.begin();
    for (const unsigned int f : faces)
      {
        for (auto *const by_node : {&covered, &whole})
          for (const unsigned int i : slave.faces[f].unknowns)
            (*by_node)[i] += *next++;
        const double covered_area = *next++, face_area = *next++;
        if (covered_area > 0.999 * face_area)
          whole_faces.insert(f);
      }
    for (unsigned int i = 0; i < whole.size(); ++i)
      covered[i] /= std::max(whole[i], 1e-300);
    return covered;
  }

  template std::vector<double>
  covered_shares(const ContactSurface<2> &,
                 const FacesWithPoints<2> &,
                 const bool,
                 const MPI_Comm,
                 std::set<unsigned int> &);
  template std::vector<double>
  covered_shares(const ContactSurface<3> &,
                 const FacesWithPoints<3> &,
                 const bool,
                 const MPI_Comm,
                 std::set<unsigned int> &);
} // namespace Amontons
