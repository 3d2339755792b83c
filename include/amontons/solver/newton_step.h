/// What Newton's method works on, where it is, and how one of its steps is linearised and solved.
#pragma once

#include <amontons/algebra/contact_constraints.h>
#include <amontons/algebra/linear_solver.h>
#include <amontons/elasticity/mechanics.h>
#include <amontons/solver/contact_kinematics.h>
#include <amontons/solver/newton_report.h>
#include <amontons/solver/node_states.h>
#include <amontons/solver/penalty.h>

#include <deal.II/base/timer.h>

namespace Amontons
{
  struct NewtonParameters : ParameterGroup
  {
    unsigned int max_iterations     = 60;
    double       tolerance          = 1e-9;     // residual relative to the internal forces
    bool         tolerance_is_given = false;    // else by suit_target()
    double       scaling            = 1;        // multiplies the complementarity parameter c = E / h
    std::string  method             = "mortar"; // or one to compare with, see declare()
    double       penalty            = 10;       // contact stiffness over E/(1 - nu^2)/h

    void
    declare(ParameterHandler &prm) override;

    /// In space, where systems are solved by iterations: a tolerance that is not given becomes what this
    /// relative error needs.
    void
    suit_target(const double target_error);

    /// Nodes touch faces, where they lie at the start; else surfaces are coupled by integrals.
    bool
    collocates() const
    {
      return method == "node-to-segment" || method == "seed";
    }
    /// Nodes have stiffnesses instead of equations.
    bool
    has_penalty() const
    {
      return method == "penalty" || method == "augmented Lagrangian";
    }
  };

  /// internal forces(u) - contact forces(u, p, q) = loads(u),  gaps(u) >= 0, ...  at one time on one mesh.
  template <int dim>
  struct ContactEquilibrium
  {
    const NewtonParameters                   &parameters;
    const LinearSolverParameters             &solver_parameters;
    const Discretization<dim>                &discretization;
    Mechanics<dim>                           &mechanics;
    ContactKinematics<dim>                   &contact;
    const std::vector<ContactInterface<dim>> &interfaces;
    const Constraints                        &supports; // with what they prescribe
    SolutionState<dim>                       &state;    // displacement: the start and the result
    TimerOutput                              &timer;
    const Penalty<dim>                       *penalty  = nullptr; // instead of equations
    GivesUp                                   gives_up = {};      // of the linear solvers

    /// Whether a closed node obeys equations.
    bool
    by_equations(const unsigned int k) const
    {
      return penalty == nullptr || contact.nodes()[k].tied;
    }
  };

  /// Where the iteration is; its displacement, readable, is that of the state.
  template <int dim>
  struct Iterate
  {
    LA::Vector                          u; // owned
    NodeStates<dim>                     states;
    NodalContacts<dim>                  answers        = {}; // by contact node
    std::vector<SlipLaw<dim>>           laws           = {}; // of slip, of the last system
    std::shared_ptr<ContactConstraints> constraints    = {}; // of the closed nodes
    std::vector<unsigned int>           first_equation = {}; // of each closed node in `constraints`
    std::vector<std::vector<double>>    free_modes     = {}; // rigid motions that the closed nodes leave
    double                              force_scale    = 0;  // what residuals are measured by
    NewtonReport                        report         = {};

    bool
    is_first() const
    {
      return report.iterations.empty();
    }
    bool
    set_changed() const
    {
      return is_first() || report.iterations.back().n_changes > 0 || states.frozen();
    }
  };

  /// Diagonal terms d_i (u_i - reference_i) that resist motion: see PseudoTransient.
  struct Drag
  {
    LA::Vector values, reference;

    LA::Vector
    force(const LA::Vector &u) const
    {
      LA::Vector result(u);
      result -= reference;
      result.scale(values);
      return result;
    }
  };

  template <int dim>
  class NewtonStep
  {
  public:
    struct Solved
    {
      LA::Vector        change; // of u; owned
      LA::Vector        push;   // the condensed residual that it answers
      LinearSolveReport linear;
      bool              is_downhill = true; // with drag: (K + drag) change . change > 0
    };

    virtual ~NewtonStep() = default;

    /// What constraints of closed nodes are added to.
    virtual const Constraints &
    supports() const = 0;
    /// Before the first step; springs: the diagonal terms that there may be (null: none).
    virtual void
    prepare(const LA::Vector *springs) = 0;
    /// The system at `now`, for its set of closed nodes; the state's displacement is that of now.u. springs:
    /// to be added to the diagonal (may be null).
    virtual void
    linearise(Iterate<dim> &now, const LA::Vector *springs, const Drag *drag) = 0;
    /// At the place of the last linearise() or after it.
    virtual Solved
    solve(const Iterate<dim> &now, const Drag *drag) = 0;

    /// Lets states change further, as long as the contact nodes alone can tell, from a solution with the
    /// states `before`. Returns the number of systems solved.
    virtual unsigned int
    look_ahead(Iterate<dim> &, const std::vector<ContactStatus> &before, const double rounding)
    {
      (void)before, (void)rounding;
      return 0;
    }
    /// Imposes states that obey all laws, found on the contact nodes alone by pivoting; false: there are
    /// none, or this cannot look for them. springs: what to add to the diagonal if no node is closed (may be
    /// null).
    virtual bool
    settle(Iterate<dim> &, const LA::Vector *springs)
    {
      (void)springs;
      return false;
    }
    /// y = (the system of the last linearise())^-1 force, by its factors; null if it has none.
    virtual std::function<bool(LA::Vector &y, const LA::Vector &force)>
    inverse()
    {
      return {};
    }
  };

  /// What constrains the closed nodes in these states; first: by node, its first equation there.
  template <int dim>
  ContactConstraints
  constraints_of(const ContactEquilibrium<dim> &problem,
                 const Constraints             &supports,
                 const NodeStates<dim>         &states,
                 std::vector<unsigned int>     *first = nullptr);

  /// Contact forces without multipliers: of slipping nodes, what the pressure does not make; of penalties,
  /// all.
  template <int dim>
  LA::Vector
  known_contact_forces(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now);

  /// What the contact nodes answer: multipliers from what is left of the forces, unbalanced, at the pivots of
  /// the constraints; gaps of the open nodes at the displacement of the state.
  template <int dim>
  NodalContacts<dim>
  nodal_answers(const ContactEquilibrium<dim> &problem,
                const Iterate<dim>            &now,
                const Constraints             &supports,
                const LA::Vector              &unbalanced);

  /// Displacements, readable. Those of pivots are differences of the other terms of their equations, whose
  /// rounding stiff slaves turn into forces: the sum of their sizes.
  /// (Finite strain: u, as equations are those of its changes.)
  template <int dim>
  LA::Vector
  what_rounding_sees(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now);

  /// Bodies that only springs hold come nearer by some part of their gap in each turn, like the last `change`
  /// of u: how many such turns until the first open node touches; nothing if none comes nearer.
  template <int dim>
  std::optional<double>
  turns_to_contact(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now, const LA::Vector &change);

  /// As far as bodies fly until they touch: the part of a change, and the nodes that touch then.
  struct Flight
  {
    double                    part = 1;
    std::vector<unsigned int> nodes;
  };

  /// If all of this change of u would push an open node through the other side by more than a face.
  template <int dim>
  std::optional<Flight>
  flight_to_contact(const ContactEquilibrium<dim> &problem,
                    const Iterate<dim>            &now,
                    const LA::Vector              &change);

  /// Of the nodes with something opposite.
  template <int dim>
  void
  count_states(const ContactEquilibrium<dim> &problem,
               const NodeStates<dim>         &states,
               NewtonReport::Iteration       &line);
} // namespace Amontons
