// The contact nodes alone: what changes of their states would do to all of them, without a system of the
// bodies.
#pragma once

#include <amontons/solver/node_states.h>

#include <functional>
#include <optional>

namespace Amontons
{
  // A solution with these states and laws of the nodes. movable: nodes of which supports own nothing.
  template <int dim>
  struct BaseSolution
  {
    const std::vector<SlaveNode<dim>> &nodes;
    std::vector<ContactStatus>         states;
    std::vector<SlipLaw<dim>>          laws;
    NodalContacts<dim>                 answers;
    std::vector<bool>                  movable;
    const LA::Vector                  &displacement; // owned
  };

  // What the base state of a node keeps at zero: a jump of a closed node, the pressure or the shear of an
  // open one, the shear beyond the law of one that slips; across the surface, or along its tangent (in space
  // the first one, or beside it the second). Forces are in units of node.c, so that all inputs are lengths.
  enum class NodeInput
  {
    across,
    along,
    beside
  };

  template <int dim>
  Tensor<1, dim>
  tangent_of(const SlaveNode<dim> &node, const NodeInput input)
  {
    return node.tangent(input == NodeInput::beside ? 1 : 0);
  }

  // Of a node.
  using ContactInput = std::pair<unsigned int, NodeInput>;

  // What all nodes answer to a unit of an input.
  template <int dim>
  using Responses = std::map<ContactInput, NodalContacts<dim>>;

  // The bodies are linear. So what the nodes answer in other states than those of the base is
  //
  //   answer = base + sum_j x_j response_j   (doc/introduction.md, (18)),
  //
  // where the response is that to a unit of an input. Nodes that keep their state have x = 0. One that
  // changes has as many equations as inputs (tau: its tangents; s: stiffness across the slip, in space),
  //
  //   open: p = 0, q . tau = 0    slip: g = 0, (q - phi' p d - s (v - (v . d) d)) . tau = constant d . tau
  //   stick: g = 0, v . tau = 0,
  //
  // of which nodes that stay closed need those of tau only, and nodes that supports hold in part, other than
  // in planes of symmetry, the first. In space all that slip change, as their laws do.
  // This is a dense system as small as the set of nodes that change (Sherman, Morrison and Woodbury's
  // formula).
  template <int dim>
  class ActiveSetLookahead
  {
  public:
    using Respond = std::function<std::vector<NodalContacts<dim>>(const std::vector<ContactInput> &)>;

    // responses: those that are known already, to which others are added, n_most in all.
    ActiveSetLookahead(const BaseSolution<dim> &base,
                       const Respond           &respond,
                       const unsigned int       n_most,
                       Responses<dim>          &responses);

    // Updates the states by what the nodes answer in them, until they stay or take too many responses (or
    // updates, or leave a rigid motion). False if that ends where it began, in the states `before`. Plane
    // problems only.
    bool
    lead(NodeStates<dim>                  &states,
         const std::vector<ContactStatus> &before,
         const std::vector<SlipLaw<dim>>  &laws_before,
         const double                      rounding,
         const unsigned int                n_most_updates);

    // The inputs x_j that lead to these states; nothing if that takes too many responses.
    std::optional<std::map<ContactInput, double>>
    inputs(const NodeStates<dim> &states);

    // Of these states, responses that are not known yet.
    unsigned int
    n_unknown(const NodeStates<dim> &states) const;
    unsigned int
    n_asked() const // so far
    {
      return n_new;
    }

  private:
    std::optional<NodalContacts<dim>>
    answers(const NodeStates<dim> &states);

    const BaseSolution<dim> &base;
    const Respond            respond;
    const unsigned int       n_most;
    Responses<dim>          &responses;
    unsigned int             n_new = 0;
  };
} // namespace Amontons
