// The states of all contact nodes, and how they follow from what the last solve says.
#pragma once

#include <amontons/friction/active_set.h>
#include <amontons/solver/nodal_tractions.h>
#include <amontons/solver/solution_state.h>

#include <set>

namespace Amontons
{
  // What counts as none where bodies are in equilibrium: the tension of a closed node (a force) and what
  // shear has beyond its bound where a node sticks; the overlap of an open one. Rounding and the tolerance
  // decide about less, and nodes would change for ever.
  struct Neutral
  {
    double force = 0, gap = 0;
  };

  // Open or closed as ActiveSetUpdate says, stick and slip by doc/introduction.md, (15). A closed node with
  // friction slips along trial/|trial|, trial = shear + c slip, where |trial| exceeds the bound phi(p), and
  // sticks elsewhere; nodes whose slip turns round stick first (but for directions that were guessed). Two
  // things keep this from running in circles or away:
  // - where the nodes that slip would leave a rigid motion of a body without hold, that node is held which
  //   rests if the body is moved back so far along it that the others' friction balances the loads; if the
  //   bound is exceeded there when nothing else changes, friction cannot hold the body (held_too_much);
  // - when a set of states comes back, bounds are frozen: with given bounds (Tresca) the problem is that of
  //   minimising a convex energy; each time it is solved, the bounds follow the pressures, until they agree
  //   (by half of the way once they swing). If states come back even then, nodes change one by one, and what
  //   opens has no bound when it closes again: its friction may be what opens it.
  template <int dim>
  class NodeStates
  {
  public:
    NodeStates(const std::vector<SlaveNode<dim>>        &nodes,
               const std::vector<ContactInterface<dim>> &interfaces,
               const FloatingBodies<dim>                &floating,
               const double                              t);

    // From `state` if it fits the rows, else from which nodes are `closed`.
    void
    start(const SolutionState<dim> &state, const std::vector<bool> &closed);

    // A node that nothing is opposite of any more.
    void
    open(const unsigned int k)
    {
      states[k] = ContactStatus::open;
    }

    // As it would close, by whatever law.
    void
    close(const unsigned int k)
    {
      states[k] = nodes[k].frictional ? ContactStatus::stick : ContactStatus::slip;
    }

    // After its normal has turned, the direction of slip lies in the surface again.
    void
    turn(const unsigned int k)
    {
      auto      &d = laws[k].direction;
      const auto t = nodes[k].tangential(d);
      d            = t.norm() > 0 ? t / t.norm() : t;
    }

    // The states of these, with the laws that their pressures and shears make.
    void
    impose(const NodalContacts<dim> &answers);
    void
    impose(const unsigned int k, const ContactStatus state, const SlipLaw<dim> &law = {})
    {
      states[k] = state;
      laws[k]   = law;
    }

    // From now on shears obey these bounds, by node, instead of those that pressures make.
    void
    give_bounds(const std::vector<double> &bounds)
    {
      given_bounds = bounds;
    }

    // The next set of states has nothing to do with those before: safeguards start anew.
    void
    forget()
    {
      active_set = ActiveSetUpdate();
      is_frozen = single = is_exhausted = false;
      met.clear();
    }

    // Changes states and laws; returns the number of nodes whose state changed. rounding: see
    // ActiveSetUpdate::update.
    unsigned int
    update(const NodalContacts<dim> &answers, const double rounding, const Neutral &neutral = {});

    // Rigid motions that supports, pins and the present states leave. by_sticking: those that no sticking
    // node holds, although nodes that slip resist them across their slip (3D).
    std::vector<std::vector<double>>
    free_rigid_modes(const bool by_sticking = false) const;
    std::string
    describe(const std::vector<std::vector<double>> &motions) const;

    // A rigid motion that friction cannot hold in whatever states, empty if there is none or Coulomb's
    // coefficients are no constants: see motion_beyond_friction in friction/limit_load.h. `share`: of the
    // coefficients.
    std::vector<double>
    beyond_friction(const double share = 1) const;

    // What the iteration leaves, by interface and slave node.
    std::vector<NodalContacts<dim>>
    by_slave_node(const NodalContacts<dim> &answers) const;

    // How far shears are from the law of friction: sqrt sum (area |shear - shear of the law|)^2 (a force).
    double
    law_error(const NodalContacts<dim> &answers) const;

    // Equations of the closed nodes in their present states, to see which motions they hold.
    std::vector<ContactEquation>
    equations(const unsigned int k, const Tensor<1, dim> &origin) const
    {
      return equations_of(nodes[k], states[k], laws[k], origin);
    }

    const ContactStatus &
    operator[](const unsigned int k) const
    {
      return states[k];
    }
    const std::vector<ContactStatus> &
    all() const
    {
      return states;
    }
    const SlipLaw<dim> &
    law(const unsigned int k) const
    {
      return laws[k];
    }
    ShearBound
    bound(const unsigned int k, const double pressure) const;
    // States came back although single nodes were changed at given bounds.
    bool
    exhausted() const
    {
      return is_exhausted;
    }
    bool
    safeguarded() const
    {
      return active_set.safeguarded();
    }
    bool
    frozen() const
    {
      return is_frozen;
    }
    // Nodes held against their bound after the last update, and the motions that they hold.
    unsigned int
    n_held_beyond_friction() const
    {
      return held.size();
    }
    // "(x, y), (x, y) and n more": where nodes are held against their bound, or else changed in the last
    // update.
    std::string
    where_unsettled() const;
    const std::vector<std::vector<double>> &
    held_motions() const
    {
      return motions_held;
    }
    // The last motions that no sticking node held, none if that was in less than a tenth of all updates: in
    // 3D bodies without equilibrium turn about ever other centres, and some nodes stick now and then.
    std::vector<std::vector<double>>
    often_sliding() const
    {
      return 10 * sliding.n >= sliding.n_updates ? sliding.motions : std::vector<std::vector<double>>();
    }

  private:
    std::vector<double>
    neutral_forces(const NodalContacts<dim> &answers, const double neutral) const;
    // By pair, of friction.
    std::vector<double>
    largest_bounds(const NodalContacts<dim> &answers, const std::vector<bool> &closed) const;
    // A wedged node: it goes nowhere; and along its way, or without friction where it does so.
    bool
    rests(const unsigned int k, const NodalContact<dim> &answer, const double limit) const;
    void
    slide(const unsigned int k, const NodalContact<dim> &answer);
    void
    choose_friction_states(const NodalContacts<dim>  &answers,
                           const std::vector<bool>   &closed,
                           const double               rounding,
                           const std::vector<double> &no_force); // by interface
    void
    hold_motions(const NodalContacts<dim> &answers);
    void
    keep_last_change(const std::vector<ContactStatus> &old);
    unsigned int
    node_at_rest(const std::vector<double> &motion, const NodalContacts<dim> &answers) const;
    void
    watch_for_cycles(const NodalContacts<dim> &answers, const unsigned int n_changes);
    Tensor<1, dim>
    trial(const unsigned int k, const NodalContact<dim> &answer) const
    {
      return answer.shear + nodes[k].c * answer.slip;
    }

    const std::vector<SlaveNode<dim>>        &nodes;
    const std::vector<ContactInterface<dim>> &interfaces;
    const FloatingBodies<dim>                &floating;
    const double                              t;
    const bool                                any_friction;
    ActiveSetUpdate                           active_set;
    std::vector<ContactStatus>                states;
    std::vector<SlipLaw<dim>>                 laws;
    std::vector<double>                       frozen_bounds, given_bounds;
    bool                                      first        = true; // no update yet: directions are guesses
    bool                                      is_frozen    = false;
    bool                                      single       = false; // frozen, and states came back even so
    bool                                      is_exhausted = false; // see exhausted()
    double                                    last_change  = 0;     // of the bounds
    bool                                      swings       = false; // that did not halve once
    std::set<std::string>                     met;
    std::vector<unsigned int>                 held, changed; // in the last update
    std::vector<std::vector<double>>          motions_held;
    // Updates in which no sticking node held some motions.
    struct Sliding
    {
      unsigned int                     n_updates = 0, n = 0;
      std::vector<std::vector<double>> motions; // the last ones
    };
    Sliding sliding;
  };
} // namespace Amontons
