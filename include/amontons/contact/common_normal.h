// Small strain: one normal for both sides of a pair.
//
// Surfaces turn as they are pressed together, and each takes the pressure along its own normal of before, N
// of the slave or M of the master (both outward from the slave), as it turns with it. Along a common n the
// pressure p has shears p (n - N) and p (n - M) that nobody applies, and with compliances C, D of slave and
// master, (1 - nu^2)/E, slip is wrong by what a shear p (C (n - N) + D (n - M)) makes: none, to first order,
// for
//
//     n = (C N + D M)/(C + D),
//
// whichever side is the slave. (Half a disk on a block twice as stiff, pressed until contact is 0.13 of the
// radius wide and sheared to and fro: friction takes 8.8e-4 or 6.1e-4 with the normals of one side or the
// other, 7.58e-4 with these, 7.6e-4 with finite strain.) `Kinematics = small strain` is the theory of the
// textbooks, which has N; `auto` has n.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// n of a point that has its slave's normal. Where N and M are far from each other (by more than 45
  /// degrees) N remains.
  template <int dim>
  Tensor<1, dim>
  common_normal(const Scene &scene, const ContactInterface<dim> &interface, const OverlapPoint<dim> &point);

  /// Whether the coupling as it stands has common normals: not with finite strain, where surfaces are where
  /// they touch; of tied pairs, and against obstacles, they are those of the slave anyway.
  template <int dim>
  bool
  has_common_normals(const Discretization<dim> &discretization, const ContactInterface<dim> &interface)
  {
    return !discretization.finite_strain && discretization.scene.kinematics == Kinematics::automatic &&
           interface.master.surface != nullptr && !interface.pair->tied;
  }

  /// The normal that fields are split by at a point of a slave face: that of the face, n, turned as the nodal
  /// ones of the fields are against those of the surface. N: values of the face's nodes there.
  template <int dim>
  Tensor<1, dim>
  turned_normal(const ContactSurface<dim>         &slave,
                const unsigned int                 face,
                const std::vector<double>         &N,
                Tensor<1, dim>                     n,
                const std::vector<Tensor<1, dim>> &nodal)
  {
    for (unsigned int i = 0; i < N.size(); ++i)
      n += N[i] * (nodal[slave.faces[face].nodes[i]] - slave.nodes[slave.faces[face].nodes[i]].normal);
    return n / n.norm();
  }
} // namespace Amontons
