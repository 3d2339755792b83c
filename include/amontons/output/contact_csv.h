// contact.csv: the slave surfaces node by node.
#pragma once

#include <amontons/contact/contact_interface.h>

#include <string>
#include <vector>

namespace Amontons
{
  // A slave node; vectors have three components, the third is 0 in 2D.
  struct ContactNode
  {
    std::string   pair;
    Point<3>      X, x;   // reference, current
    Tensor<1, 3>  normal; // outward from the slave
    double        area     = 0;
    double        pressure = 0; // of the surface projection
    Tensor<1, 3>  traction;     // tangential
    Tensor<1, 3>  force;        // on the slave body; their sum is the force of the pair
    double        gap = 0;      // NaN without a coupling row
    Tensor<1, 3>  slip;
    ContactStatus state = ContactStatus::open;
    double        arc   = 0; // 2D: arc length along the surface, from the first node; 3D: 0
    double        bound = 0; // friction: of the shear at this pressure; NaN without friction
  };

  // All slave nodes, pair by pair, in order. t: for bounds that depend on it.
  template <int dim>
  std::vector<ContactNode>
  contact_table(const std::vector<ContactInterface<dim>> &interfaces,
                const std::vector<SurfaceFields<dim>>    &fields,
                const double                              t);

  // To be called on rank 0.
  void
  write_contact_csv(const std::string &file, const std::vector<ContactNode> &table);

  std::string
  state_name(const ContactStatus state); // "open", "slip", "stick"
} // namespace Amontons
