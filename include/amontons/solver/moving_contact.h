// Contact nodes of surfaces that move far: their gaps and slips in the current configuration, with
// derivatives.
#pragma once

#include <amontons/algebra/tangent_system.h>
#include <amontons/contact/coupling_derivatives.h>
#include <amontons/solver/node_states.h>

namespace Amontons
{
  // Surfaces move with the bodies, and the coupling of each pair is integrated where they are; the nodes are
  // those of the slave surfaces, whether anything is opposite of them at present or not, so that their
  // numbers stay. Tied pairs keep the coupling of the start: material points stay together.
  //
  // Slip of a node since the last converged state: with the weights w of that state (its partners then, as
  // material points), z = sum w x over slave minus master nodes, n the present normal and R the smallest
  // rotation from the normal of that state,
  //   v = (1 - n n^T) z - R (1 - n n^T)_old z_old.
  // A motion of the whole scene makes none, and the derivative needs no derivative of weights (Puso and
  // Laursen 2004; Gitterle et al. 2010).
  template <int dim>
  class MovingContact
  {
  public:
    // Couples the surfaces as they are at start.committed (empty: undeformed) first. Nodes that are closed in
    // `start` may stick from the beginning of the increment.
    MovingContact(const Discretization<dim>          &discretization,
                  const Constraints                  &supports,
                  std::vector<ContactInterface<dim>> &interfaces,
                  const SolutionState                &start,
                  const double                        scaling);

    void
    move(const LA::Vector &u);

    // Derivatives for the nodes that are not open, at the last move(). Collective.
    void
    differentiate(const NodeStates<dim> &states);
    bool
    is_differentiated(const NodeStates<dim> &states) const;

    // Open nodes with something opposite on faces that have closed ones.
    std::vector<unsigned int>
    neighbours(const NodeStates<dim> &states) const;

    const std::vector<CandidateNode<dim>> &
    nodes() const
    {
      return all;
    }
    // Whether anything is opposite of the node.
    bool
    is_opposite(const unsigned int k) const
    {
      return all[k].row != numbers::invalid_unsigned_int;
    }
    // Where the gap grows faster than the shape functions, beyond the edge of the contact, its projection on
    // to them is negative at some nodes: what does not penetrate on average is open.
    double
    open_gap(const unsigned int k) const
    {
      return is_opposite(k)
                 ? std::max(all[k].gap, interfaces[all[k].interface].coupling.rows[all[k].row].mean_gap)
                 : all[k].gap;
    }
    // v; u as in move().
    Tensor<1, dim>
    slip(const unsigned int k, const LA::Vector &u) const;
    // Distance of a closed node from its equations.
    double
    violation(const unsigned int k, const ContactState state, const LA::Vector &u) const;

    // The equations of a closed node, linearised about u, to be written into the rows `pivots`. Slip: the gap
    // g closes, -dg = g. Stick: E = v - g/|normal| n = 0 by component.
    std::vector<WrittenRow>
    written_rows(const unsigned int                                         k,
                 const ContactState                                         state,
                 const std::vector<std::optional<types::global_dof_index>> &pivots,
                 const LA::Vector                                          &u) const;

    // Their values alone, by component (slip: the first).
    Tensor<1, dim>
    row_values(const unsigned int k, const ContactState state, const LA::Vector &u) const;

    // Derivatives of the contact forces at fixed multipliers. This rank's part.
    std::vector<RectangularMatrix>
    stiffness(const NodeStates<dim>              &states,
              const std::vector<NodeAnswer<dim>> &answers,
              const LA::Vector                   &u) const;

    // Blocks that stiffness() and rows may have now or after a little sliding; without values. This rank's
    // part.
    std::vector<RectangularMatrix>
    links() const;

  private:
    struct OldRow
    {
      std::array<LinearEquation, dim> weights; // by component of the jump
      Tensor<1, dim>                  normal, tangential_jump;
    };
    using Rows = std::array<Gradient, dim>;

    std::vector<bool>
    closed_nodes(const SolutionState &state) const;
    void
    remember_old_rows(const LA::Vector &committed, const std::vector<bool> &closed);
    Tensor<1, dim>
    position_jump(const std::array<LinearEquation, dim> &weights, const LA::Vector &u) const;
    Tensor<1, dim>
    jump_since(const unsigned int k, const LA::Vector &u) const;
    const std::vector<Tensor<1, dim>> &
    symmetry_planes(const unsigned int k) const;
    Rows
    slip_gradient(const unsigned int k, const LA::Vector &u) const;
    Rows
    unit_normal_gradient(const unsigned int k) const;
    const RowGradient<dim> &
    gradient(const unsigned int k) const
    {
      return derivatives[all[k].interface]->rows()[differentiated[k]];
    }
    RectangularMatrix
    turning_traction(const unsigned int     k,
                     const SlipLaw<dim>    &law,
                     const NodeAnswer<dim> &answer,
                     const LA::Vector      &u) const;

    const Discretization<dim>                             &discretization;
    const Constraints                                     &supports;
    std::vector<ContactInterface<dim>>                    &interfaces;
    const double                                           scaling;
    std::vector<CandidateNode<dim>>                        all;
    std::vector<std::vector<unsigned int>>                 node_of; // by interface and slave node
    std::vector<double>                                    old_gap;
    std::vector<std::optional<OldRow>>                     old;
    LA::Vector                                             committed;
    double                                                 t; // of declared gaps
    std::map<types::global_dof_index, double>              reference_coordinate;
    std::vector<std::unique_ptr<CouplingDerivatives<dim>>> derivatives; // by interface
    std::vector<unsigned int> differentiated;                           // by node: its row there, or invalid
  };
} // namespace Amontons
