// Contacts that are far smaller than the faces that carry them.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  template <int dim>
  struct SmallContact
  {
    unsigned int body;
    Point<dim>   place; // of its surface, undeformed
    double       size;  // radius
  };

  // In space, untied pairs: where one body touches another in less than half of a face, on both bodies (not
  // on obstacles). An indicator does not tell how small contacts are, and what is refined by it halves their
  // faces once for each solution; Hertz's formula tells at once,
  //   a^3 = 3 F R / (4 E*),
  // with F of a face that presses and those around it, and the curvature 1/R fitted to the gaps of its
  // points, g = g_0 + b . x + |x|^2/(2R). Of lines of contact the formula makes more than they are: faces are
  // refined by less than it takes. Those with less than 5 % of the largest force do not count.
  template <int dim>
  std::vector<SmallContact<dim>>
  small_contacts(const Discretization<dim>                &discretization,
                 const std::vector<ContactInterface<dim>> &interfaces,
                 const std::vector<SurfaceFields<dim>>    &fields);

  // Marks the cells of this rank that are larger than a contact and nearer to it than half of its size.
  // Returns how many there are on all ranks. Collective.
  template <int dim>
  unsigned int
  mark_cells_at(const Discretization<dim> &discretization, const std::vector<SmallContact<dim>> &contacts);
} // namespace Amontons
