// What of two surfaces lies opposite of each other, and whether they face each other at all.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  // The overlaps of the pair with the gaps that it declares. Chooses interface.reach where that is 0. Throws
  // InputError if bodies that have not moved overlap, if the sides look away from each other, or if they do
  // not face each other but must. Collective.
  template <int dim>
  std::vector<OverlapPoint<dim>>
  find_partners(const Discretization<dim> &discretization,
                ContactInterface<dim>     &interface,
                const bool                 moved);

  // Whether the two sides must face each other from the start: small strain and tied pairs keep the faces
  // opposite of which they were at first. (Kinematics = auto starts with small strain.)
  template <int dim>
  bool
  must_face(const Discretization<dim> &discretization, const PairData &pair);

  // The error of two surfaces that do not face each other, and why.
  template <int dim>
  InputError
  not_facing(const ContactInterface<dim> &interface, const std::string &why);

  // Throws InputError where the two sides must face each other, but one of their bodies lies between them all
  // over, as the wall of a ring if its inner side is named instead of the outer one. For coupled interfaces
  // of bodies that have not moved. Collective.
  template <int dim>
  void
  refuse_hidden_sides(const Discretization<dim>                &discretization,
                      const std::vector<ContactInterface<dim>> &interfaces);

  // By slave node: of the points of its faces that are opposite of something the nearest one, or none. They
  // are those of the interface.
  template <int dim>
  std::vector<const OverlapPoint<dim> *>
  nearest_points(const ContactInterface<dim> &interface);

  // Names of pairs whose obstacles stay where they are, some way off their bodies: walls, which may never be
  // touched. For coupled interfaces of bodies that have not moved.
  template <int dim>
  std::set<std::string>
  walls_beside(const Geometry<dim> &geometry, const std::vector<ContactInterface<dim>> &interfaces);
} // namespace Amontons
