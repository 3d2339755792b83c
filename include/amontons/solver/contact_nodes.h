// The nodes that may close, with what closing means for displacements.
#pragma once

#include <amontons/algebra/contact_constraints.h>
#include <amontons/contact/contact_interface.h>
#include <amontons/solver/floating_bodies.h>

namespace Amontons
{
  // One coupling row of one interface with its statements: frictionless, one with the normal; tied, one per
  // component.
  struct CandidateNode
  {
    unsigned int interface, row;
    bool         tied;
    double rounding; // a pressure that is none: 1e-14 times the modulus
    double       area, c; // c: complementarity parameter, scaling x E/(1 - nu^2) / mean face size
    std::vector<ContactEquation> equations;
  };

  template <int dim>
  std::vector<CandidateNode>
  collect_contact_nodes(const Discretization<dim>                &discretization,
                        const std::vector<ContactInterface<dim>> &interfaces,
                        const double                              scaling);

  // sum coefficient u
  double
  evaluate(const LinearEquation &equation, const LA::Vector &u);

  // First guess without a history: what the prescribed displacements press together, and, for bodies that
  // only contact holds, the nodes that will touch first (linear kinematics close their gap exactly, whatever
  // its size).
  template <int dim>
  std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<CandidateNode>         &nodes,
                              const std::vector<ContactInterface<dim>> &interfaces,
                              const FloatingBodies<dim>                &floating,
                              const LA::Vector                         &u);
} // namespace Amontons
