#include <amontons/solver/diagnosis.h>

#include <map>

#include <sstream>

namespace Amontons
{
  namespace Diagnosis
  {
    namespace
    {
      const std::string what_to_change =
          "; raise the friction coefficient, lower the load along this motion or hold it by a support";

      std::string
      no_states(const Failure &failure)
      {
        std::ostringstream text;
        if (failure.n_changes == 0)
          {
            text << "no equilibrium after " << failure.n
                 << " iterations: no node changes any more, but the residual stays at " << failure.residual
                 << " of the forces (rounding of very different or nearly incompressible stiffnesses, or "
                    "contact that jumps between faces)"
                    "; try a finer mesh, smaller increments, or stiffnesses that differ less";
            return text.str();
          }
        text << "no converged contact states after " << failure.n << " iterations (residual "
             << failure.residual << ", " << failure.n_changes << " nodes still change";
        if (!failure.where.empty())
          text << ", at " << failure.where;
        text << "); tried: all nodes at once" << (failure.single_nodes ? ", single nodes" : "")
             << (failure.given_bounds ? ", given bounds of friction (Tresca)" : "")
             << "; try a finer mesh, smaller loads, more iterations"
             << (failure.friction
                     ? ", smaller increments or less friction; what friction alone holds may have no "
                       "equilibrium at all"
                     : "");
        return text.str();
      }

      std::string
      beyond_edge(const Failure &failure)
      {
        return "no forces within the contact hold the rigid " + failure.motion +
               ", which the loads drive: they act beyond the edge of what the bodies lie on (and only on "
               "this mesh do nodes beyond the edge seem to carry them); move the load, or hold this motion "
               "by a "
               "support";
      }

      // Of a method to compare with: what bears forces that it has not found.
      std::string
      unsettled(const std::string &what, const Failure &failure, const std::string &why)
      {
        std::ostringstream text;
        text << what << " still changes by " << failure.residual << " of the forces after " << failure.n
             << why;
        return text.str();
      }

      std::string
      seed_unsettled(const Failure &failure)
      {
        if (!failure.motion.empty())
          return "seed: by its rules all nodes slip that could hold the rigid " + failure.motion +
                 ", whether friction can hold it or not; take smaller increments, or say 'Method = mortar'";
        return unsettled("seed: what friction bears",
                         failure,
                         " iterations, and " + std::to_string(failure.n_changes) +
                             " nodes still change: the rules of the seed have no cure for states that come "
                             "back; take smaller increments, or say 'Method = mortar'");
      }

      std::string
      flown(const Failure &failure)
      {
        std::ostringstream text;
        text.precision(2);
        text << "the iteration moves bodies by " << failure.residual
             << " times their size: nothing near holds them; take smaller increments, or hold this motion by "
                "a support";
        return text.str();
      }

      std::string
      still_moving(const Failure &failure)
      {
        std::ostringstream text;
        text << "the bodies probably snap (no equilibrium is near), and the damped motion away did not come "
                "to rest within "
             << failure.n << " steps (residual " << failure.residual
             << "); hold the bodies where they fly away, prescribe displacements instead of loads, or refine "
                "what buckles";
        return text.str();
      }
    } // namespace

    std::string
    sentence(const Failure &failure)
    {
      switch (failure.kind)
        {
          case Failure::Kind::not_a_number:
            return "the solution is not a number: the increment may be too large, a load no number, or the "
                   "stiffness singular";
          case Failure::Kind::linear_solver:
            return failure.n == 0
                       ? "the stiffness is singular: its matrix has no factors"
                       : "the linear solver failed after " + std::to_string(failure.n) + " iterations";
          case Failure::Kind::no_memory:
            return "the factors of the matrix need more memory than there is; say 'Linear solver/Type = cg', "
                   "fewer cells, or a smaller 'Maximum DoFs'";
          case Failure::Kind::given_up:
            return "given up, as the run is to end";
          case Failure::Kind::inverted_cell:
            return failure.cell;
          case Failure::Kind::passed_through:
            return "the increment is so large that a surface passes through another one, at " +
                   failure.where + "; take smaller increments";
          case Failure::Kind::entered:
            return "a corner or an end of one surface moves into the other body, at " + failure.where +
                   ", where no normal of either surface meets the other one: contact does not see it; say a "
                   "pair for each side of the corner, or round it";
          case Failure::Kind::beyond_symmetry:
            return "a body moves through its own plane of symmetry, at " + failure.where +
                   ": there it would meet its image, which contact does not see; put an obstacle with "
                   "'Surface "
                   "= plane' there, or model the whole";
          case Failure::Kind::driven_through:
            return "supports drive a surface through a rigid obstacle, at " + failure.where +
                   ": nothing that the bodies can do is an answer to that; prescribe less there, or leave "
                   "the motion towards the obstacle free";
          case Failure::Kind::wall_touched:
            return "what may slide freely comes to touch a wall";
          case Failure::Kind::moves_apart:
            return "the loads drive the rigid " + failure.motion +
                   ", and no node that is closed holds it: the bodies move apart or slide off each other; "
                   "reverse the load, move the bodies together, or hold this motion by a support";
          case Failure::Kind::flown:
            return flown(failure);
          case Failure::Kind::beyond_edge:
            return beyond_edge(failure);
          case Failure::Kind::friction_beyond_limit:
            return "friction cannot hold the rigid " + failure.motion +
                   ": no contact forces within its bounds balance the loads" + what_to_change;
          case Failure::Kind::friction_exceeded:
            return "friction cannot hold the rigid " + failure.motion +
                   ": where the nodes that slipped least were held to see whether others would stick, at " +
                   failure.where + ", the shear exceeds its bound" + what_to_change;
          case Failure::Kind::friction_at_limit:
            return "friction probably cannot hold the rigid " + failure.motion +
                   ": no states in equilibrium were found, and the loads are at most 2 % below what friction "
                   "could bear if the bodies were rigid" +
                   what_to_change;
          case Failure::Kind::friction_slides:
            return "friction probably cannot hold the rigid " + failure.motion +
                   ": all nodes that could hold it slipped time and again, and no states in equilibrium were "
                   "found" +
                   what_to_change;
          case Failure::Kind::no_states:
            return no_states(failure);
          case Failure::Kind::still_moving:
            return still_moving(failure);
          case Failure::Kind::motion_lost:
            return "the damped motion cannot be followed: its steps become too short" +
                   (failure.cell.empty() ? "" : ", as " + failure.cell);
          case Failure::Kind::multipliers_unsettled:
            return unsettled("augmented Lagrangian: what the multipliers bear",
                             failure,
                             " updates; raise 'Penalty factor' or 'Maximum iterations'");
          case Failure::Kind::bounds_unsettled:
            return unsettled("fixed-point friction: what the bounds of friction bear",
                             failure,
                             " updates, as this iteration does where friction is large; lower the friction "
                             "coefficient, or say 'Method = mortar'");
          case Failure::Kind::seed_unsettled:
            return seed_unsettled(failure);
        }
      Assert(false, ExcInternalError());
      return "";
    }

    std::string
    kind(const Failure &failure)
    {
      using Kind                                      = Failure::Kind;
      static const std::map<Kind, const char *> names = {
          {Kind::not_a_number, "not a number"},
          {Kind::linear_solver, "linear solver"},
          {Kind::no_memory, "no memory"},
          {Kind::given_up, "stopped"},
          {Kind::inverted_cell, "inverted cell"},
          {Kind::passed_through, "passed through"},
          {Kind::entered, "entered"},
          {Kind::beyond_symmetry, "beyond symmetry"},
          {Kind::driven_through, "driven through"},
          {Kind::wall_touched, "wall touched"},
          {Kind::moves_apart, "moves apart"},
          {Kind::flown, "flown"},
          {Kind::beyond_edge, "beyond edge"},
          {Kind::friction_beyond_limit, "friction beyond limit"},
          {Kind::friction_exceeded, "friction exceeded"},
          {Kind::friction_at_limit, "friction at its limit"},
          {Kind::friction_slides, "friction slides"},
          {Kind::no_states, "no states"},
          {Kind::still_moving, "still moving"},
          {Kind::motion_lost, "motion lost"},
          {Kind::multipliers_unsettled, "multipliers unsettled"},
          {Kind::bounds_unsettled, "bounds unsettled"},
          {Kind::seed_unsettled, "seed unsettled"}};
      return names.at(failure.kind);
    }

    std::string
    snapped(const std::vector<Snap> &all, const bool far)
    {
      const unsigned int most = 6;
      unsigned int       n    = 0;
      bool               none = false, unstable = false;
      std::ostringstream text;
      text.precision(4);
      for (const auto &snap : all)
        if (snap.far == far)
          {
            none     = none || !snap.unstable;
            unstable = unstable || snap.unstable;
            if (n++ < most)
              text << (n == 1 ? "" : ", ") << snap.t << " (by " << snap.distance << ")";
          }
      if (n == 0)
        return "";
      if (n > most)
        text << " and " << n - most << " more times";
      const std::string at = "at t = " + text.str();
      const std::string work =
          "; what is lost on the way is missing from the work of these increments, whose balance is open";
      return far ? at + " the bodies snap (" + (none ? "no equilibrium nearby" : "") +
                       (none && unstable ? ", or " : "") +
                       (unstable ? "the equilibrium nearby is unstable" : "") +
                       "): followed by damped motion to a stable equilibrium" + work
                 : at + " the iteration did not find the equilibrium, damped motion did" + work;
    }

    namespace
    {
      template <int dim>
      std::optional<Failure>
      failure_of(const Failure::Kind kind, const NodeStates<dim> &states, const std::vector<double> &motion)
      {
        if (motion.empty())
          return {};
        Failure failure{kind};
        failure.motion = states.describe({motion});
        return failure;
      }
    } // namespace

    template <int dim>
    std::optional<Failure>
    friction_beyond_limit(const NodeStates<dim> &states)
    {
      return failure_of(Failure::Kind::friction_beyond_limit, states, states.beyond_friction());
    }

    template <int dim>
    std::optional<Failure>
    friction_at_limit(const NodeStates<dim> &states)
    {
      return failure_of(Failure::Kind::friction_at_limit, states, states.beyond_friction(0.98));
    }

    template <int dim>
    Failure
    friction_exceeded(const NodeStates<dim> &states)
    {
      Failure failure{Failure::Kind::friction_exceeded};
      failure.motion = states.describe(states.held_motions());
      failure.where  = states.where_unsettled();
      return failure;
    }

    template <int dim>
    Failure
    moves_apart(const NodeStates<dim> &states, const std::vector<std::vector<double>> &motions)
    {
      Failure failure{Failure::Kind::moves_apart};
      failure.motion = states.describe(motions);
      return failure;
    }

    template <int dim>
    Failure
    surfaces_cross(const Failure::Kind kind, const std::vector<Point<dim>> &nodes)
    {
      Failure failure{kind};
      failure.where = places_of(nodes);
      return failure;
    }

    template <int dim>
    Failure
    no_states_found(const NewtonReport &report, const NodeStates<dim> &states, const bool any_friction)
    {
      if (const auto beyond = friction_beyond_limit(states))
        return *beyond;
      Failure failure{Failure::Kind::no_states, static_cast<unsigned int>(report.iterations.size())};
      if (const auto motions = states.often_sliding(); !motions.empty())
        {
          failure.kind   = Failure::Kind::friction_slides;
          failure.motion = states.describe(motions);
          return failure;
        }
      if (const auto motions = states.free_rigid_modes();
          report.iterations.back().n_changes == 0 && !motions.empty())
        return moves_apart(states, motions);
      failure.residual     = report.iterations.back().residual;
      failure.n_changes    = report.iterations.back().n_changes;
      failure.where        = states.where_unsettled();
      failure.single_nodes = report.safeguarded;
      failure.given_bounds = report.frozen;
      failure.friction     = any_friction;
      return failure;
    }

    template <int dim>
    Failure
    inverted(const Discretization<dim> &discretization, const InvertedCell<dim> &cell)
    {
      const auto        &body = discretization.scene.bodies[cell.body];
      std::ostringstream text;
      text << "a cell of body '" << body.name << "' near (" << cell.centre
           << ") is turned inside out (its volume becomes " << cell.smallest_jacobian << " of what it was)";
      // P = M (l^3 - l)/2 of the stretch l is largest at l = 1/sqrt(3).
      if (body.material.law == Law::st_venant_kirchhoff)
        text << "; St. Venant-Kirchhoff's law takes no more load beyond a compression by 42 %: say 'Law = "
                "neo-Hookean' where strains are large";
      Failure failure{Failure::Kind::inverted_cell};
      failure.cell = text.str();
      return failure;
    }

    template Failure
    moves_apart(const NodeStates<2> &, const std::vector<std::vector<double>> &);
    template Failure
    moves_apart(const NodeStates<3> &, const std::vector<std::vector<double>> &);
    template std::optional<Failure>
    friction_beyond_limit(const NodeStates<2> &);
    template std::optional<Failure>
    friction_at_limit(const NodeStates<2> &);
    template Failure
    friction_exceeded(const NodeStates<2> &);
    template Failure
    no_states_found(const NewtonReport &, const NodeStates<2> &, const bool);
    template Failure
    inverted(const Discretization<2> &, const InvertedCell<2> &);
    template Failure
    surfaces_cross(const Failure::Kind, const std::vector<Point<2>> &);
    template Failure
    surfaces_cross(const Failure::Kind, const std::vector<Point<3>> &);
    template std::optional<Failure>
    friction_beyond_limit(const NodeStates<3> &);
    template std::optional<Failure>
    friction_at_limit(const NodeStates<3> &);
    template Failure
    friction_exceeded(const NodeStates<3> &);
    template Failure
    no_states_found(const NewtonReport &, const NodeStates<3> &, const bool);
    template Failure
    inverted(const Discretization<3> &, const InvertedCell<3> &);
  } // namespace Diagnosis
} // namespace Amontons
