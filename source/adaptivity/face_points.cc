#include <amontons/adaptivity/face_points.h>
#include <amontons/elasticity/kinematics.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  template <int dim>
  FacePoints<dim>::FacePoints(const ContactInterface<dim> &interface,
                              const QGauss<1>             &along_lines,
                              const Scene                 &scene)
      : interface(interface), quadrature(along_lines),
        polynomials(Polynomials::generate_complete_Lagrange_basis(along_lines.get_points())),
        kind(scene.kind), of_overlap(interface.slave->faces.size()), covered(of_overlap.size(), false),
        master_is_known(dim == 3 && master_deforms(interface, scene))
  {
    const auto &coupling = interface.coupling;
    for (const auto &point : coupling.points)
      covered[point.slave_face] = true;
    const auto       &slave = *interface.slave;
    std::vector<bool> beside(slave.nodes.size(), false);
    for (unsigned int f = 0; f < covered.size(); ++f)
      if (coupling.whole_faces.count(f) == 0)
        for (const unsigned int i : slave.faces[f].nodes)
          beside[i] = true;
    for (unsigned int i = 0; i < coupling.points.size(); ++i)
      {
        const unsigned int face  = coupling.points[i].slave_face;
        const auto        &nodes = slave.faces[face].nodes;
        if (coupling.whole_faces.count(face) == 0 ||
            (master_is_known &&
             std::any_of(nodes.begin(), nodes.end(), [&](const unsigned int n) { return beside[n]; })))
          of_overlap[face].push_back(i);
      }
  }

  template <int dim>
  std::vector<FacePoint<dim>>
  FacePoints<dim>::on_whole(const unsigned int face) const
  {
    std::vector<FacePoint<dim>> result;
    const auto                 &slave = *interface.slave;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const auto &xi = quadrature.point(q);
        double      jacobian;
        slave.face_normal(face, xi, &jacobian);
        result.push_back({xi,
                          quadrature.weight(q) * jacobian * measure<dim>(kind, slave.position(face, xi)),
                          std::vector<double>(quadrature.size(), 0.),
                          numbers::invalid_unsigned_int});
        result.back().interpolation[q] = 1;
      }
    return result;
  }

  template <int dim>
  std::vector<FacePoint<dim>>
  FacePoints<dim>::on(const unsigned int face) const
  {
    if (of_overlap[face].empty())
      return on_whole(face);
    std::vector<FacePoint<dim>> result;
    for (const unsigned int i : of_overlap[face])
      {
        const auto &point = interface.coupling.points[i];
        result.push_back({point.xi_slave, point.weight, {}, i});
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          result.back().interpolation.push_back(polynomials.compute_value(q, point.xi_slave));
      }
    return result;
  }

  template class FacePoints<2>;
  template class FacePoints<3>;
} // namespace Amontons
