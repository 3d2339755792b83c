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
//
// Where the slave's end comes first, a corner on a face, n = M with any kinematics and stiffness. The corner
// does not turn to the face as a round surface does: along N all of the force would be inclined to the face
// (by 8.7 % of it, of a block tilted by 5 degrees, on all meshes). But what presses on a half space has its
// force along M, whatever presses: the mean of the slopes of its surface, weighted by the pressure, is 0
// (int int p(x) p(s)/(x - s) = 0). With finite strain faces do turn to each other, and only the end itself,
// whose normal is that of the last face, is inclined: against obstacles its nodes have M, too.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// n of a point that has its slave's normal. Where N and M are far from each other (by more than 45
  /// degrees, where an end presses 60) N remains.
  template <int dim>
  Tensor<1, dim>
  common_normal(const Scene &scene, const ContactInterface<dim> &interface, const OverlapPoint<dim> &point);

  /// Whether what is closest of the slave, before anything has moved, is an end of it that leans on the other
  /// side. points: all of the coupling.
  template <int dim>
  bool
  slave_end_presses(const ContactInterface<dim> &interface, const std::vector<OverlapPoint<dim>> &points);

  /// Outward from the other side, at a point that has its slave's normal.
  template <int dim>
  Tensor<1, dim>
  normal_of_other_side(const MasterSide<dim> &master, const OverlapPoint<dim> &point);

  template <int dim>
  bool
  end_presses(const ContactInterface<dim> &interface)
  {
    return interface.first_gap && interface.first_gap->is_at_end;
  }

  /// Finite strain, surfaces that have just moved: nodes at the end get the normal of the obstacle (that they
  /// are opposite of, and not more than 60 degrees from), and hold it.
  template <int dim>
  void
  hold_end_normals(ContactInterface<dim> &interface);

  /// Whether the coupling as it stands has common normals: not with finite strain, where surfaces are where
  /// they touch; of tied pairs they are those of the slave anyway, and against obstacles, unless its end
  /// presses.
  template <int dim>
  bool
  has_common_normals(const Discretization<dim> &discretization, const ContactInterface<dim> &interface)
  {
    return !discretization.finite_strain && !interface.pair->tied &&
           (end_presses(interface) || (discretization.scene.kinematics == Kinematics::automatic &&
                                       interface.master.surface != nullptr));
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
