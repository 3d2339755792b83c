/// One loop for geometry and contact: solve with the present closed nodes, see which nodes pull or penetrate,
/// change them.
#pragma once

#include <amontons/solver/rigid_mode_stabilisation.h>
#include <amontons/solver/status_update.h>

namespace Amontons
{
  /// The semismooth Newton iteration. Each turn linearises about the iterate for its set of closed nodes,
  /// solves, takes the multipliers from the residual of the rows that test functions of closed nodes leave,
  /// and updates the states. At small strain everything but the states is linear; at finite strain surfaces
  /// and bodies are integrated where they are, and steps that invert a cell are halved; if that does not
  /// help, the report says where.
  template <int dim>
  class Newton
  {
  public:
    using Observer = std::function<void(const NewtonReport::Iteration &)>;

    Newton(const ContactEquilibrium<dim> &problem,
           NewtonStep<dim>               &step,
           const double                   smallest_cell,
           const Observer                &observer);

    /// Motions without supports and the first guess of the closed nodes. False: a cell is inverted.
    bool
    prepare();
    /// `Maximum iterations` at most, from where it is.
    void
    iterate();
    /// Leaves the contact in the state; the report is that of all.
    NewtonReport
    finish();

    // What the methods that call this one need: PseudoTransient, AugmentedLagrangian, ...

    const FloatingBodies<dim> &
    floating_bodies() const
    {
      return floating;
    }
    const Iterate<dim> &
    now() const
    {
      return at;
    }
    NewtonReport &
    report()
    {
      return at.report;
    }
    /// From now on (null: no longer).
    void
    set_drag(const Drag *now)
    {
      drag = now;
    }
    /// One turn; false: it failed, or one of the questions (empty: not asked) was answered by no. n_tries: of
    /// the step, its half, ...; try_it: asked before it is taken; stay: afterwards.
    bool
    turn(const unsigned int                                                   n_tries = 5,
         const std::function<bool(const typename NewtonStep<dim>::Solved &)> &try_it  = {},
         const std::function<bool()>                                         &stay    = {});
    void
    stop_or_go_on();
    void
    linearise();
    std::optional<typename NewtonStep<dim>::Solved>
    solve();
    /// u + factor step with the largest factor of 1, 1/2, ... that leaves cells as they are.
    bool
    advance(const LA::Vector &step, const unsigned int n_tries = 5);
    /// Bodies and surfaces where they were before.
    bool
    put(const LA::Vector &where);
    /// The first guess of the states again, with these answers.
    void
    guess_again(const NodalContacts<dim> &answers);
    NodeStates<dim> &
    states()
    {
      return at.states;
    }
    /// What may change the states after each solve.
    StatusUpdate<dim> &
    status_update()
    {
      return statuses;
    }
    /// Of internal forces, loads and drag, relative.
    double
    error_with_drag() const;
    /// Condensed residual before the first step.
    const LA::Vector &
    first_push() const
    {
      return push;
    }
    const std::optional<Failure> &
    last_inversion() const
    {
      return inversion;
    }

  private:
    void
    guess_states();
    void
    open_lonely_nodes();
    bool
    evaluate(const std::vector<double> &dilatations = {}, const bool with_stiffness = true);
    void
    update_constraints();
    void
    recover_contact();
    void
    shorten_flight(LA::Vector &change);
    void
    update_states(NewtonReport::Iteration &line);
    LA::Vector
    balance_with_drag() const;
    std::vector<types::global_dof_index>
    pins() const;
    double
    residual();
    bool
    settle();
    bool
    reach_contact();
    bool
    moves_apart() const;
    std::optional<double>
    flown() const;

    const ContactEquilibrium<dim> &problem;
    NewtonStep<dim>               &step;
    const double                   smallest_cell;
    const Observer                &observer;
    StatusUpdate<dim>              statuses;
    Timer                          clock;
    FloatingBodies<dim>            floating;
    Iterate<dim>                   at;
    RigidModeStabilisation         stabilisation;
    LA::Vector                     springs; // of it, in effect
    const Drag                    *drag = nullptr;
    LA::Vector                     push;        // see first_push()
    LA::Vector                     last_change; // of u
    std::optional<Flight>          flight;      // that the last solution was cut to
    LA::Vector                     balance;     // internal - contact forces - loads
    std::optional<Failure>         inversion;   // the last one
    bool                           may_settle     = true;
    double                         start_distance = 0; // largest displacement then
  };
} // namespace Amontons
