/// How far the nodes of surfaces that move have slipped since the last converged state, with derivatives.
#pragma once

#include <amontons/solver/contact_nodes.h>
#include <amontons/solver/solution_state.h>

#include <optional>
#include <set>

namespace Amontons
{
  /// Of a node: its partners in the last converged state, as material points, with the weights w of that
  /// state. What the jump sum w x had along the surface then (on curved faces) is taken off by a shift along
  /// the slave surface, sum_j beta_j x_j with sum_j beta_j = 0: the material points that lay opposite of each
  /// other have the jump
  ///   z = sum (w - beta) x,   z_old normal to the surface,   and   v = (1 - n n^T) z   (doc/introduction.md,
  ///   (25)).
  /// A rigid motion of the whole scene by any Q takes z to Q z_old and n to Q n_old, and makes none; the
  /// derivative needs none of weights (Puso and Laursen 2004; Gitterle et al. 2010).
  template <int dim>
  class IncrementSlip
  {
  public:
    using Rows = std::array<Coefficients, dim>; // by component

    /// committed: the displacement of the last converged state; readable.
    IncrementSlip(const Discretization<dim>                &discretization,
                  const std::vector<ContactInterface<dim>> &interfaces,
                  const LA::Vector                         &committed);

    /// The nodes, by which others are numbered from now on, and their interfaces as coupled in that state.
    /// Slip of those that were open counts from where they touch, as far as the increment before tells.
    void
    remember_partners(const std::vector<SlaveNode<dim>> &nodes, const SolutionState<dim> &start);

    /// The displacement of that state.
    const LA::Vector &
    start() const
    {
      return committed;
    }

    /// v of node k, which is coupled as `node` says now; u: readable at relevant DoFs.
    Tensor<1, dim>
    value(const unsigned int k, const SlaveNode<dim> &node, const LA::Vector &u) const
    {
      return node.tangential(jump(k, node, u));
    }
    /// dv, exact for fixed weights; dn: of the unit normal.
    Rows
    gradient(const unsigned int k, const SlaveNode<dim> &node, const Rows &dn, const LA::Vector &u) const;

  private:
    // beta_j = gamma_j . jump, by node of the faces of a slave node.
    struct Place
    {
      Tensor<1, dim>                                        normal;
      std::vector<std::pair<NodeDofs<dim>, Tensor<1, dim>>> gamma;
    };
    struct Partners
    {
      Place place;
      std::optional<Rows>
          weights; // w - beta (of what was open: from its first touch), where something was opposite
    };

    void
    add_coordinates(const NodeDofs<dim> &dofs, const Point<dim> &X);
    static Place
    make_place(const ContactSurface<dim>    &slave,
               const std::set<unsigned int> &beside,
               const Tensor<1, dim>         &normal);
    Rows
    aligned(const Place &place, const SlaveNode<dim> &node) const;
    // Its columns: vectors that the slave surface moves with, dim - 1 along it and its unit normal.
    Tensor<2, dim>
    frame(const Place &place, const LA::Vector &u) const;
    void
    move_to_first_touch(const SolutionState<dim> &start,
                        const SlaveNode<dim>     &node,
                        Partners                 &partners) const;
    Rows
    weights(const unsigned int k, const SlaveNode<dim> &node) const;
    Tensor<1, dim>
    position_jump(const Rows &weights, const LA::Vector &u) const;
    Tensor<1, dim>
    jump(const unsigned int k, const SlaveNode<dim> &node, const LA::Vector &u) const;

    const std::vector<ContactInterface<dim>> &interfaces;
    const LA::Vector                          committed;
    std::map<types::global_dof_index, double> reference_coordinate;
    std::vector<Partners>                     old; // by node
  };
} // namespace Amontons
