// What a pair says of its gaps: `Initial gap` and `Adjust`.
#pragma once

#include <amontons/contact/mortar_integrator.h>
#include <amontons/contact/nodal_contact.h>

#include <map>
#include <optional>

namespace Amontons
{
  // `Initial gap` of a pair that has one, at time t, on its slave surface.
  template <int dim>
  class DeclaredGap
  {
  public:
    DeclaredGap(const PairData &pair, const ContactSurface<dim> &slave, const double t);

    double
    at(const Point<dim> &X) const;
    // Whether it changes by more than half of all that it does in this face within a small part of it (and,
    // beside a hanging node, as far as the nodes that it hangs from).
    bool
    jumps(const unsigned int face) const;
    // At xi of a face where it jumps: between its values at the nodes. Dual functions are negative in a part
    // of the face: of a jump they make gaps of the wrong sign beside it, a third of it large. Their weighted
    // gaps of g = sum_j B_j g(X_j), with the traces B_j of the unknowns, are the g(X_j).
    double
    ramp(const unsigned int face, const Point<dim - 1> &xi) const;
    // Whether its values at the nodes of a face reach from `least` to `most`.
    bool
    is_within_unknowns(const unsigned int face, const double least, const double most) const;

  private:
    const Expression                    &gap;
    const ContactSurface<dim>           &slave;
    const double                         t;
    mutable std::map<unsigned int, bool> known; // jumps(), by face
  };

  // Whether a geometric gap counts as none, by `Adjust` or as rounding.
  bool
  is_adjusted(const PairData &pair, const double gap, const double face_size);

  // From geometric gaps to those that the pair declares (`Initial gap`, at time t, and `Adjust`). Throws
  // InputError where the bodies overlap without a declared interference. Where the bodies have moved, gaps
  // may be negative, and a declared one is added to the geometric one.
  template <int dim>
  void
  declare_gaps(const PairData                 &pair,
               const ContactSurface<dim>      &slave,
               const double                    t,
               const bool                      moved,
               std::vector<OverlapPoint<dim>> &points);

  // Where `Adjust` makes a step in gaps that open evenly, from none to its size, beside a node that touches;
  // bodies that have not moved.
  template <int dim>
  std::optional<Point<dim>>
  step_by_adjust(const PairData                       &pair,
                 const ContactSurface<dim>            &slave,
                 const std::vector<OverlapPoint<dim>> &points,
                 const NodalContacts<dim>             &contact);
} // namespace Amontons
