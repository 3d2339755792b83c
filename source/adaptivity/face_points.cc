#include <amontons/adaptivity/face_points.h>
#include <amontons/elasticity/kinematics.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  template <int dim>
  FacePoints<dim>::FacePoints(const ContactInterface<dim> &interface,
                              const QGauss<1>             &along_lines,
                              const ProblemType            kind)
      : interface(interface), quadrature(along_lines),
        polynomials(Polynomials::generate_complete_Lagrange_basis(along_lines.get_points())), kind(kind),
        of_cut_faces(interface.slave->faces.size()), covered(of_cut_faces.size(), false)
  {
    const auto &coupling = interface.coupling;
    for (const auto &point : coupling.points)
      covered[point.slave_face] = true;
    for (unsigned int i = 0; i < coupling.points.size(); ++i)
      if (coupling.whole_faces.count(coupling.points[i].slave_face) == 0)
        of_cut_faces[coupling.points[i].slave_face].push_back(i);
  }

  template <int dim>
  std::vector<FacePoint<dim>>
  FacePoints<dim>::on(const unsigned int face) const
  {
    std::vector<FacePoint<dim>> result;
    const auto                 &slave = *interface.slave;
    if (of_cut_faces[face].empty())
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const auto &xi = quadrature.point(q);
          double      jacobian;
          slave.face_normal(face, xi, &jacobian);
          result.push_back({xi,
                            quadrature.weight(q) * jacobian * measure<dim>(kind, slave.position(face, xi)),
                            std::vector<double>(quadrature.size(), 0.)});
          result.back().interpolation[q] = 1;
        }
    for (const unsigned int i : of_cut_faces[face])
      {
        const auto &point = interface.coupling.points[i];
        result.push_back({point.xi_slave, point.weight, {}});
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          result.back().interpolation.push_back(polynomials.compute_value(q, point.xi_slave));
      }
    return result;
  }

  template class FacePoints<2>;
  template class FacePoints<3>;
} // namespace Amontons
