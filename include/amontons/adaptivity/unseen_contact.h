// Contact that a mesh is too coarse to see.
#pragma once

#include <amontons/contact/smallest_gap.h>

namespace Amontons
{
  // By slave face: whether it may touch though no node there does. The gap g varies by r over the points of a
  // face; beyond the outermost one, at most 5 % of a face from its end, a smooth one falls by about r/400
  // (quadratic), and where that is near, the smallest one is looked for (smallest_gap.h). So g < r/100 says
  // that nobody knows. Nor where a declared gap dips so far between them that its errors (gap_error.h, by
  // face) count. Where the pair touches elsewhere, off the faces near that, overlaps d count whose force,
  // E* d (modulus, per length; in space times the face's size), is 1 % of the pair's.
  template <int dim>
  std::vector<bool>
  faces_of_unseen_contact(const ContactInterface<dim> &interface,
                          const SurfaceFields<dim>    &fields,
                          const SurfaceApproach<dim>  &approach,
                          const std::vector<double>   &gap_errors,
                          const std::vector<bool>     &near,
                          const double                 modulus,
                          const ProblemType            kind);

  // Anywhere on the surfaces, also between the points. The largest number if nothing is opposite.
  template <int dim>
  double
  smallest_gap_of(const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const SurfaceApproach<dim>  &approach);

  // By slave face: whether a node of it is closed.
  template <int dim>
  std::vector<bool>
  faces_that_press(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields);

  // By slave face: those that press and two faces around them. Beyond, there is no pressure, and none that is
  // wrong: stresses that are singular in a corner of the open part are errors of the stress alone.
  template <int dim>
  std::vector<bool>
  faces_near_contact(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields);

  // At nodes of the pairs that touch nowhere, and are not tied; the largest number if there are none.
  template <int dim>
  double
  smallest_gap_of_untouched(const std::vector<ContactInterface<dim>> &interfaces,
                            const std::vector<SurfaceFields<dim>>    &fields);

  template <int dim>
  unsigned int
  n_closed_nodes(const SurfaceFields<dim> &fields);

  // Closed nodes with which a mesh sees a contact.
  template <int dim>
  constexpr unsigned int enough_closed_nodes = dim == 2 ? 4 : 9;

  // Whether enough nodes are closed, or the contact is at a sharp edge of a side, where it is as small as any
  // mesh, or hardly wider than a point.
  template <int dim>
  bool
  contact_is_resolved(const ContactInterface<dim> &interface,
                      const SurfaceFields<dim>    &fields,
                      const double                 enough = enough_closed_nodes<dim>);

  // 0 if nothing is closed.
  template <int dim>
  double
  smallest_closed_face(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields);

  // By what bodies may stand too high or too low: where few nodes touch it is weighted gaps that are closed,
  // and gaps vary over the faces there by so much. (A beam on a roller that its faces hardly see.)
  template <int dim>
  double
  height_in_doubt(const std::vector<ContactInterface<dim>> &interfaces,
                  const std::vector<SurfaceFields<dim>>    &fields);

  // Of several pairs that touch with more than a millionth of the largest force: those that do so with a few
  // nodes only that are much farther apart than a point is wide. Tied pairs do not count; nor do contacts at
  // a sharp edge of a side, which are as small as any mesh.
  template <int dim>
  std::vector<bool>
  unresolved_pairs(const std::vector<ContactInterface<dim>> &interfaces,
                   const std::vector<SurfaceFields<dim>>    &fields);

  // There are none of those.
  template <int dim>
  bool
  small_contacts_are_resolved(const std::vector<ContactInterface<dim>> &interfaces,
                              const std::vector<SurfaceFields<dim>>    &fields);

  // Whether none of those that press is measured to be smaller than half of a face: where one node carries
  // nearly all, there is no size. Sharp edges and points: as above. Nor any zone that sticks to be smaller
  // than half of a face in it: where the bound is reached beside one node that sticks, the zone ends anywhere
  // in between. enough_to_stick: faces up to this size do.
  template <int dim>
  bool
  sizes_are_seen(const std::vector<ContactInterface<dim>> &interfaces,
                 const std::vector<SurfaceFields<dim>>    &fields,
                 const double enough_to_stick = std::numeric_limits<double>::infinity());

  // Whether contacts have as many closed nodes as their size to this relative error takes, which goes like
  // the square of the faces' part of it: two coarse meshes may agree by chance. Sharp edges: as above. In
  // space, where nodes are many, always.
  template <int dim>
  bool
  sizes_are_resolved(const std::vector<ContactInterface<dim>> &interfaces,
                     const std::vector<SurfaceFields<dim>>    &fields,
                     const double                              target);
} // namespace Amontons
