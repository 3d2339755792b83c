// The nodes that may close, with what their states mean for displacements.
#pragma once

#include <amontons/algebra/eliminated_system.h>
#include <amontons/contact/contact_interface.h>
#include <amontons/friction/shear_law.h>
#include <amontons/solver/floating_bodies.h>

namespace Amontons
{
  // One coupling row of one interface. Its jump is Delta = sum slave weight u - sum master weight u.
  template <int dim>
  struct SlaveNode
  {
    unsigned int   interface, node, row; // node: of the slave surface; row: invalid where nothing is opposite
    bool           tied, frictional;
    bool           wedged = false; // see is_wedged(): it never sticks
    double         rounding;       // a pressure that is none: 1e-14 times the modulus
    double         area, c;        // c: complementarity parameter, scaling x E/(1 - nu^2) / mean face size
    double         gap;
    Tensor<1, dim> normal; // not of unit length on curved surfaces
    Point<3>       X;
    // Unit normals of the symmetry planes that it lies on, which supports keep it in; unless it is tied or at
    // a ridge, of those alone that the surface crosses.
    std::vector<Tensor<1, dim>> planes;
    // Both surfaces make a kink at a plane: no slip is across it, and what the support takes there cannot be
    // told from shear, so that there is none; pressure is along the normal, as it is without friction.
    bool at_ridge = false;
    // What stick holds it along: the axes, or unit vectors in the planes (at a ridge: the normal and what is
    // square to it in the planes); zero where those leave none.
    std::array<Tensor<1, dim>, dim>  directions;
    ContactEquation                  closing;    // normal . Delta = gap
    std::array<ContactEquation, dim> components; // Delta_k = 0 (not for frictionless nodes)

    // Equations that may come to hold the node: of all its components, or of its normal one.
    std::vector<const ContactEquation *>
    holding() const;
    Tensor<1, dim>
    jump(const LA::Vector &u) const;
    ContactEquation
    held(const unsigned int k) const; // directions[k] . Delta = 0
    // Of a vector, what lies in the surface and in the planes.
    Tensor<1, dim>
    tangential(const Tensor<1, dim> &vector) const;
    // Of vectors, the part of that across a direction in it.
    Tensor<2, dim>
    across(const Tensor<1, dim> &direction) const;
    // k < dim - 1: unit vectors along the surface, square to each other, in the planes; zero where those
    // leave none.
    Tensor<1, dim>
    tangent(const unsigned int k = 0) const;
  };

  // Supports leave the node one axis to move along, oblique to the surface, and what is opposite none: its
  // way along the surface is given. Where that is none, what friction does cannot be told from their
  // reaction, and counts as nothing.
  template <int dim>
  bool
  is_wedged(const SlaveNode<dim> &node, const Constraints &supports);

  // What may come to hold the nodes, or only the tied ones.
  template <int dim>
  std::vector<const LinearEquation *>
  holding_equations(const std::vector<SlaveNode<dim>> &nodes, const bool only_tied = false);

  // Of one coupling row. with_components: for frictionless nodes, too.
  template <int dim>
  SlaveNode<dim>
  make_contact_node(const Discretization<dim>                &discretization,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const unsigned int                        interface,
                    const unsigned int                        row,
                    const double                              scaling,
                    const bool                                with_components = false);

  template <int dim>
  std::vector<SlaveNode<dim>>
  collect_contact_nodes(const Discretization<dim>                &discretization,
                        const std::vector<ContactInterface<dim>> &interfaces,
                        const double                              scaling);

  // "(x, y), (x, y), (x, y) and n more"
  template <int dim>
  std::string
  places_of(const std::vector<Point<dim>> &points);

  // sum coefficient u
  double
  evaluate(const LinearEquation &equation, const LA::Vector &u);

  //! [equations]
  // What each state asks of displacements (doc/introduction.md, (12) and (16)). Open:
  // nothing. Slip: the gap is closed, while test functions obey (normal + slope d) . Delta = 0 (frictionless:
  // slope = 0). Stick: Delta is that of the closed gap across and `origin` along the surface; tied: zero.
  template <int dim>
  std::vector<ContactEquation>
  equations_of(const SlaveNode<dim> &node,
               const ContactStatus   state,
               const SlipLaw<dim>   &law,
               const Tensor<1, dim> &origin);
  //! [equations]

  // An equation of all DoFs of the node's jump, for the sparsity pattern: slip mixes the components.
  template <int dim>
  ContactEquation
  all_components(const SlaveNode<dim> &node);

  // area stiffness (1 - n n^T - d d^T) on the jump, in planes of symmetry without what is across them (3D):
  // the forces of the shear across the slip.
  template <int dim>
  LocalMatrix
  slip_stiffness(const SlaveNode<dim> &node, const SlipLaw<dim> &law);

  // A DoF of a node's jump, with its component and weight.
  struct JumpTerm
  {
    types::global_dof_index dof;
    unsigned int            component;
    double                  weight;
  };
  // Of all components; `normal`: of the normal part alone, as component 0.
  template <int dim>
  std::vector<JumpTerm>
  jump_terms(const SlaveNode<dim> &node, const bool normal);

  // area sum weight dt_component: the derivative of the node's forces by its traction's.
  LocalMatrix
  stiffness_of_traction(const std::vector<JumpTerm>     &jump,
                        const double                     area,
                        const std::vector<Coefficients> &dt);

  // What resists rigid motions in this state: the equations above and, in 3D, the stiffness across the slip.
  template <int dim>
  std::vector<LinearEquation>
  resistance_of(const SlaveNode<dim> &node, const ContactStatus state, const SlipLaw<dim> &law);

  // First guess without a history: what the prescribed displacements press together, and, for bodies that
  // only contact holds, the nodes that will touch first, of what is about as near as the nearest (linear
  // kinematics close their gap exactly, whatever its size).
  template <int dim>
  std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<SlaveNode<dim>>        &nodes,
                              const std::vector<ContactInterface<dim>> &interfaces,
                              const FloatingBodies<dim>                &floating,
                              const std::vector<double>                &gaps);
} // namespace Amontons
