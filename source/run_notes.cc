// RunReport: what its answer is not.
#include <amontons/adaptivity/unseen_contact.h>
#include <amontons/base/independent_errors.h>
#include <amontons/contact/declared_gap.h>
#include <amontons/run_report.h>
#include <amontons/scene/text.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Amontons
{
  namespace
  {
    // Of pair i, whether its obstacle may leave a plane of symmetry that cuts the contact: the other half of
    // the scene would take it the other way.
    template <int dim>
    bool
    leaves_plane(const Answer<dim> &answer, const unsigned int i)
    {
      const auto &obstacles = answer.discretization.scene.obstacles;
      const auto  obstacle  = std::find_if(obstacles.begin(), obstacles.end(), [&](const auto &candidate) {
        return candidate.name == answer.interfaces[i].pair->obstacle;
      });
      if (obstacle == obstacles.end())
        return false;
      for (const auto &plane : answer.fields[i].symmetry_planes)
        for (unsigned int d = 0; d < dim; ++d)
          if (std::abs(plane[d]) > 1e-6 && !obstacle->motion.displacement[d])
            return true;
      return false;
    }
  } // namespace

  // What touches nothing at the end may have touched before. (Coarse meshes may take what they hardly see for
  // touching: at the end the last one counts.)
  template <int dim>
  void
  RunReport<dim>::note_untouched_pairs()
  {
    for (unsigned int i = 0; i < summary.pairs.size(); ++i)
      {
        PairSummary &pair = summary.pairs[i];
        pair.touched      = std::any_of(summary.meshes.begin(), summary.meshes.end(), [&](const auto &mesh) {
          const bool counts = mesh.t != summary.meshes.back().t || &mesh == &summary.meshes.back();
          return counts && mesh.pairs[i].touched;
        });
        if (!pair.touched && summary.converged)
          note("warning: pair '" + pair.name + "' touched nothing at any time that was solved; " +
               without_contact(pair));
      }
  }

  template <int dim>
  void
  RunReport<dim>::note_facets(const std::vector<ContactInterface<dim>> &interfaces,
                              const ErrorEstimate<dim>                 &error)
  {
    for (unsigned int i = 0; i < error.facets_of.size(); ++i)
      if (const FacetError &facets = error.facets_of[i]; facets.pressure > noteworthy_facets)
        {
          std::ostringstream text;
          text.precision(2);
          text << "warning: pair '" << interfaces[i].pair->name
               << (facets.is_curved ? "' touches on arcs of second order that stand for a curve: "
                                    : "' touches on facets, flat faces that stand for a curve: ");
          if (facets.angle > 0)
            text << "kinks of up to " << facets.angle * 180 / numbers::PI << " degrees";
          if (facets.step > 0)
            text << (facets.angle > 0 ? " and curvatures" : "curvatures") << " that change by "
                 << facets.step;
          text << " between lengths of " << facets.size << " make an error of about " << facets.gap
               << " in the gap, of which the load closes " << facets.closed_gap << ", and of "
               << 100 * facets.pressure
               << " % in the pressure. Refinement does not mend it: declare 'Curved boundaries', "
               << (facets.is_curved
                       ? "or give a finer mesh"
                       : "give a mesh of second order (gmsh: Mesh.ElementOrder = 2), or a finer one");
          note(text.str());
        }
  }

  // Motion that is damped loses what the loads do, and overlaps that are there from the start do work.
  template <int dim>
  void
  RunReport<dim>::note_sums_of_work(const Ending &ending)
  {
    constexpr double much    = 0.05;
    const auto      &work    = ending.history.work;
    const double     gap     = std::abs(work.contact_work - work.dissipation);
    const bool overlaps_fade = std::any_of(scene.pairs.begin(), scene.pairs.end(), [](const auto &pair) {
      return pair.initial_gap && pair.initial_gap->value(Point<3>(), 0) < 0;
    });
    if (!ending.history.snaps.empty() || overlaps_fade || gap <= much * work.largest_work)
      return;
    std::ostringstream text;
    text.precision(3);
    text << (ending.refinement.target_quantity == "dissipation" ? "warning: " : "")
         << "the external work or that of friction is off by about " << gap / work.largest_work
         << " of the largest external work, as far as the work of contact is from that of friction: both are "
            "sums over increments, of the mean of what acts at their ends, and these are too long for it: "
            "more 'Increments' mend that (the stored energy does not suffer from it)";
    note(text.str());
  }

  template <int dim>
  void
  RunReport<dim>::note_rough_pressure(const Ending &ending)
  {
    const double error = ending.evaluation.error.contact;
    if (!ending.converged || !(error > 0.2))
      return;
    std::ostringstream text;
    text.precision(2);
    text << "warning: the pressure is known to " << 100 * error
         << " % only (estimated). If no edge makes it infinite, the mesh is too coarse for this contact, and "
            "forces that displacements cause are off, too: refine ('Cycles', 'Target error')";
    note(text.str());
  }

  template <int dim>
  void
  RunReport<dim>::note_small_tractions(const Answer<dim> &answer, const Ending &ending)
  {
    constexpr double small = 1e-3; // errors of which nobody asks what they are relative to
    const auto      &error = ending.evaluation.error;
    if (!ending.converged || std::max(error.contact, error.shear) < small)
      return;
    if (ending.evaluation.touches() && ending.evaluation.is_judged_by_history())
      note(std::string(
               "at the end the pressure is less than 5 % of the largest of the load program (in the mean "
               "square): the estimated errors are the largest of the program, relative to that pressure") +
           (sizes_are_seen(answer.interfaces, answer.fields)
                ? ""
                : "; the contact is smaller than cells then, and its size is not known"));
    if (error.shear < small || error.shear_norm > noteworthy_shear * error.pressure_norm * (1 + 1e-9))
      return;
    std::ostringstream text;
    text << "the tangential traction is less than " << 100 * noteworthy_shear
         << " % of the pressure (in the mean square): its error is told relative to these "
         << 100 * noteworthy_shear << " %, not to itself";
    note(text.str());
  }

  // Why, and what it would take. Collective.
  template <int dim>
  std::string
  RunReport<dim>::missed_target(const Discretization<dim> &discretization, const Ending &ending) const
  {
    const auto        &error      = ending.evaluation.error;
    const std::string &name       = ending.refinement.target_quantity;
    const bool         touches    = ending.evaluation.touches();
    const auto         indicators = !touches                                      ? error.cell_indicators
                                    : name == "peak pressure" && error.cusp_grows ? error.quantity_indicators
                                                                                  : error.indicators_for(0);
    std::ostringstream place;
    place.precision(2);
    if (indicators.size() == discretization.geometry.triangulation.n_active_cells())
      place << place_of_largest(discretization, indicators);
    const std::string reason =
        !touches ? ". Nothing touches, and the error is that of the stress, which corners and the ends of "
                   "supports make infinite"
        : name.find(" pressure") == std::string::npos
            ? ""
            : ". Where a sharp edge presses, the pressure is infinite, and its mean square does not "
              "converge, nor does the peak at a tip; forces, contact sizes and the pressure away from there "
              "do: round it, or ask for those ('Target quantity')";
    return ending.history.meshes.why_missed(
        ending.refinement.target_error, ending.refinement.max_dofs, place.str(), reason);
  }

  template <int dim>
  void
  RunReport<dim>::note_free_motions(const Discretization<dim> &discretization)
  {
    std::set<std::string> turning, sliding;
    for (const auto &turn : discretization.free_turns)
      turning.insert("'" + scene.bodies[turn.body].name + "'");
    for (const auto &slide : discretization.free_slides)
      for (const unsigned int b : slide.bodies)
        if (discretization.finite_strain)
          sliding.insert("'" + scene.bodies[b].name + "'");
    const auto names = [](const std::set<std::string> &set) { return join({set.begin(), set.end()}, ", "); };
    if (!turning.empty())
      note("model: " + names(turning) +
           (turning.size() == 1 ? " is round and slides" : " are round and slide") +
           " without friction: nothing keeps it from turning, and no turn changes anything else; it is held");
    if (!sliding.empty())
      note("model: nothing holds or drives " + names(sliding) +
           " along planes touched without friction, and no motion along them changes anything else; held");
  }

  // Where the mesh alone keeps the target. What small strain may leave out is what is left of it, or a
  // quarter, as where the program decides.
  template <int dim>
  void
  RunReport<dim>::note_what_adds_to_the_mesh(const ErrorEstimate<dim>   &error,
                                             const RefinementParameters &refinement,
                                             const KinematicsErrors     &kinematics)
  {
    const auto   or_none       = [](const double part) { return std::isnan(part) ? 0. : part; };
    const double by_increments = error_by_increments(refinement.target_quantity);
    const double by_kinematics = error.quantity
                                     ? or_none(kinematics.target)
                                     : std::max(or_none(kinematics.answer), or_none(kinematics.shear));
    const double target = refinement.target_error, left = target - together(error.of_target(), by_increments);
    if (left >= 0 && by_kinematics <= std::max(left, target / 4))
      return;
    const bool by_these    = by_increments >= std::min(target / 4, by_kinematics),
               by_strain   = by_kinematics >= std::min(target / 4, by_increments),
               may_be_less = by_strain && kinematics.has_alternative;
    std::ostringstream text;
    text.precision(2);
    text << "warning: the target error was not reached: the mesh alone reaches it, with what";
    if (by_these)
      text << " the increments add (" << by_increments << ")" << (by_strain ? " and" : "");
    if (by_strain)
      text << " small strain leaves out (" << by_kinematics << ")";
    text << " it is missed";
    if (by_these || may_be_less)
      text << ": " << (by_these ? "more of them ('Increments') make that less" : "")
           << (by_these && may_be_less ? ", and so does " : "")
           << (may_be_less ? "finite strain ('Kinematics')" + std::string(by_these ? "" : " leaves out less")
                           : "");
    note(text.str());
  }

  // Forces, and what follows from them, are off by that. (The edge of a punch has little of it. The error of
  // a total force counts it.)
  template <int dim>
  void
  RunReport<dim>::note_corner_forces(const Ending &ending)
  {
    const auto   check      = ending.checks.find("corner_forces");
    const auto  &error      = ending.evaluation.error;
    const double target     = error.quantity ? ending.refinement.target_error : 0;
    const bool   is_counted = target > 0 && ending.refinement.target_quantity == "total force";
    if (!ending.converged || check == ending.checks.end() ||
        check->second <= (is_counted   ? target
                          : target > 0 ? target / 4
                                       : 0.01))
      return;
    std::ostringstream text;
    text.precision(2);
    text << "warning: where a slave surface ends or has an edge it presses along the normals of its own "
            "faces, not along those of the other side: that adds "
         << check->second << " of the force along a wrong direction"
         << (!is_counted && error.of_target() <= target && error.of_target() + check->second > target
                 ? ", and the target error was not reached"
                 : "")
         << "; make the other side the slave, make a pair of each face at the corner, or round it";
    note(text.str());
  }

  namespace
  {
    template <int dim>
    std::string
    warning_of_step(const Answer<dim> &answer, const unsigned int i)
    {
      const auto &interface = answer.interfaces[i];
      const auto  step =
          answer.discretization.finite_strain
               ? std::nullopt
               : step_by_adjust(
                    *interface.pair, *interface.slave, interface.coupling.points, answer.state.contact[i]);
      if (!step)
        return "";
      std::ostringstream text;
      text << "warning: pair '" << interface.pair->name << "': 'Adjust' (" << interface.pair->adjust
           << ") makes a step in the contact, near (" << *step
           << "): gaps are none up to there and more than that beyond, which presses as an edge does; it is "
              "for gaps that meshes make, and has to be much smaller than those between the bodies";
      return text.str();
    }
  } // namespace

  namespace
  {
    // Where no mesh has twice the unknowns of another, so that there is no estimate. error: none, or
    // infinite.
    std::string
    change_of_quantity(const QuantitySequence      &values,
                       const std::string           &name,
                       const std::optional<double> &error)
    {
      if (!error || std::isfinite(*error) || values.change() == 0)
        return "";
      std::ostringstream text;
      text.precision(2);
      text << " (the meshes before it are too alike to estimate one: " << name << " changed by "
           << 100 * values.change() << " % between them)";
      return text.str();
    }
  } // namespace

  // What the answer is not, or not the whole of.
  template <int dim>
  void
  RunReport<dim>::note_limits(const Answer<dim> &answer, const Ending &ending)
  {
    const auto &error = ending.evaluation.error;
    // A run that was stopped or has failed is not at its end: that is said.
    const double target = control.stop.is_there() || !ending.converged ? 0. : ending.refinement.target_error;
    const auto  &quantity = ending.refinement.target_quantity;
    if (target > 0 && error.quantity && ending.history.quantity.vanishes())
      note("the target error has no meaning: there is no " + ending.refinement.target_quantity +
           ", or it is 0 on all meshes");
    else if (target > 0 && !(error.of_target() <= target))
      note(finer_mesh_failed ? "the target error was not reached, as the finer mesh failed" +
                                   change_of_quantity(ending.history.quantity, quantity, error.quantity)
           : !error.quantity && error.facets > target
               ? "the target error cannot be reached: facets alone make a larger one"
               : missed_target(answer.discretization, ending));
    else if (target > 0 && error.facets > target && !always_converges(quantity) && quantity != "dissipation")
      note("warning: the target error was not reached: the mesh alone reaches it, facets do not");
    else if (target > 0)
      note_what_adds_to_the_mesh(error, ending.refinement, ending.kinematics);
    note_corner_forces(ending);
    if (target > 0 && !scene.has_friction() && !scene.output_times.empty() &&
        scene.output_times.front() < scene.end_time)
      note("without friction meshes are refined at the end: at the 'Output times' before, forces and "
           "pressures are those of the first mesh (a run that ends there keeps the target there)");
    note_free_motions(answer.discretization);
    for (unsigned int i = 0; i < answer.fields.size(); ++i)
      note(warning_of_step(answer, i));
    for (unsigned int i = 0; i < answer.fields.size(); ++i)
      if (leaves_plane(answer, i))
        note(
            "warning: '" + answer.interfaces[i].pair->obstacle +
            "' is free across a plane of symmetry that cuts its contact, and its mirror image would move the "
            "other way: let it not ('Displacement')");
    if (answer.discretization.degree_is_chosen && answer.discretization.fe.degree == 1)
      note(
          "model: linear elements ('Discretization/Degree'): in space they reach this target of the pressure "
          "in less time");
    if (scene.kind == ProblemType::axisymmetric)
      note("axisymmetric: forces are for the full turn");
    if (std::any_of(answer.fields.begin(), answer.fields.end(), [](const auto &fields) {
          return fields.symmetry_factor > 1;
        }))
      note("symmetry planes cut the contact: forces are those of the meshed part");
  }

  template void
  RunReport<2>::note_untouched_pairs();
  template void
  RunReport<3>::note_untouched_pairs();
  template void
  RunReport<2>::note_facets(const std::vector<ContactInterface<2>> &, const ErrorEstimate<2> &);
  template void
  RunReport<3>::note_facets(const std::vector<ContactInterface<3>> &, const ErrorEstimate<3> &);
  template void
  RunReport<2>::note_sums_of_work(const Ending &);
  template void
  RunReport<3>::note_sums_of_work(const Ending &);
  template void
  RunReport<2>::note_rough_pressure(const Ending &);
  template void
  RunReport<2>::note_small_tractions(const Answer<2> &, const Ending &);
  template void
  RunReport<3>::note_rough_pressure(const Ending &);
  template void
  RunReport<3>::note_small_tractions(const Answer<3> &, const Ending &);
  template void
  RunReport<2>::note_limits(const Answer<2> &, const Ending &);
  template void
  RunReport<3>::note_limits(const Answer<3> &, const Ending &);
} // namespace Amontons
