#include <amontons/solver/diagnosis.h>

#include <sstream>

namespace Amontons
{
  namespace Diagnosis
  {
    namespace
    {
      const std::string what_to_change =
          "; raise the friction coefficient, lower the load along this motion or hold it by a support";
    } // namespace

    std::string
    not_a_number()
    {
      return "the solution is not a number: a load or prescribed displacement may not be one, or the "
             "stiffness "
             "is singular";
    }

    std::string
    moves_apart(const std::string &motion)
    {
      return "the loads drive the rigid " + motion +
             ", and no node that is closed holds it: the bodies move apart or slide off each other; reverse "
             "the "
             "load, move the bodies together, or hold this motion by a support";
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

    std::string
    still_moving(const unsigned int n, const double residual)
    {
      std::ostringstream text;
      text << "the bodies probably snap (no equilibrium is near), and the damped motion away did not come to "
              "rest within "
           << n << " steps (residual " << residual
           << "); hold the bodies where they fly away, prescribe displacements instead of loads, or refine "
              "what buckles";
      return text.str();
    }

    template <int dim>
    std::string
    friction_too_weak(const NodeStates<dim> &states)
    {
      const std::string motion = states.beyond_friction();
      return motion.empty() ? ""
                            : "friction cannot hold the rigid " + motion +
                                  ": no contact forces within its bounds balance the loads" + what_to_change;
    }

    template <int dim>
    std::string
    friction_exceeded(const NodeStates<dim> &states)
    {
      return "friction cannot hold the rigid " + states.held_motion() +
             ": where the nodes that slipped least were held to see whether others would stick, at " +
             states.where_unsettled() + ", the shear exceeds its bound" + what_to_change;
    }

    template <int dim>
    std::string
    no_states_found(const NewtonReport &report, const NodeStates<dim> &states, const bool any_friction)
    {
      if (const std::string text = friction_too_weak(states); !text.empty())
        return text;
      if (const std::string motion = states.often_sliding(); !motion.empty())
        return "friction probably cannot hold the rigid " + motion +
               ": all nodes that could hold it slipped time and again, and no states in equilibrium were "
               "found" +
               what_to_change;

      const auto        &last = report.iterations.back();
      std::ostringstream text;
      text << "no converged contact states after " << report.iterations.size() << " iterations (residual "
           << last.residual << ", " << last.n_changes << " nodes still change";
      if (last.n_changes > 0)
        text << ", at " << states.where_unsettled();
      text << "); tried: all nodes at once" << (report.safeguarded ? ", single nodes" : "")
           << (report.frozen ? ", given bounds of friction (Tresca)" : "")
           << "; try a finer mesh, smaller loads, more iterations"
           << (any_friction ? ", smaller increments or less friction" : "");
      return text.str();
    }

    template std::string
    friction_too_weak(const NodeStates<2> &);
    template std::string
    friction_too_weak(const NodeStates<3> &);
    template std::string
    friction_exceeded(const NodeStates<2> &);
    template std::string
    friction_exceeded(const NodeStates<3> &);
    template std::string
    no_states_found(const NewtonReport &, const NodeStates<2> &, const bool);
    template std::string
    no_states_found(const NewtonReport &, const NodeStates<3> &, const bool);
  } // namespace Diagnosis
} // namespace Amontons
