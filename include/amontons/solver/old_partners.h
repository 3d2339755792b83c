/// What was opposite of the slave nodes in the last converged state: did they pass through it, or go past it?
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/solver/solution_state.h>

#include <optional>

namespace Amontons
{
  template <int dim>
  class OldPartners
  {
  public:
    OldPartners() = default;
    /// Where the interfaces are now.
    explicit OldPartners(const std::vector<ContactInterface<dim>> &interfaces);

    /// Reference positions of nodes that were outside of the other side then, are open in `state`, and would
    /// lie within what was opposite of them, having come there along their normal rather than along the
    /// surface: the increment was so large that they passed through. interfaces: the same, at `state`.
    std::vector<Point<dim>>
    passed_through(const std::vector<ContactInterface<dim>> &interfaces,
                   const SolutionState<dim>                 &state) const;

    /// Reference positions of nodes of either side that moved into the other one since then although no part
    /// of their own faces is opposite of it: at a corner that meets a corner no normal of one side finds the
    /// other, and contact does not see them.
    std::vector<Point<dim>>
    entered(const std::vector<ContactInterface<dim>> &interfaces) const;

  private:
    // Material points that were opposite of each other.
    struct Partners
    {
      unsigned int   slave_face, master_face;
      Point<dim - 1> xi_slave, xi_master;
      Point<dim>     on_obstacle;    // at rest
      double         gap, of_facets; // the latter: what the weighted gap is more
    };
    struct Distance
    {
      double gap, sideways;
    };
    static Point<dim>
    other_side(const ContactInterface<dim> &interface, const Partners &partners);
    static Distance
    distance(const ContactInterface<dim> &interface, const Partners &partners);

    // Whether contact sees the node outside of where its partner of old is now.
    static bool
    is_still_opposite(const ContactInterface<dim> &interface, const unsigned int node, const Partners &old);

    // Nodes of one side, and points that move with the faces of the other.
    struct Places
    {
      std::vector<Point<dim>> nodes, faces;
    };
    static Places
    places_of_sides(const ContactSurface<dim> &side, const ContactSurface<dim> &other);
    static bool
    enters(const ContactSurface<dim> &side,
           const unsigned int         node,
           const ContactSurface<dim> &other,
           const Places              &old);

    std::vector<std::vector<std::optional<Partners>>> partners; // by interface and slave node
    std::vector<std::array<Places, 2>> places; // by interface: slave to master, master to slave
  };
} // namespace Amontons
