/// Whether small strain was enough: what it leaves out, and what finite strain would change.
#pragma once

#include <amontons/adaptivity/model_selection.h>
#include <amontons/adaptivity/shear_kinematics.h>
#include <amontons/model.h>
#include <amontons/run_control.h>
#include <amontons/run_parameters.h>

namespace Amontons
{
  template <int dim>
  class SmallStrainCheck
  {
  public:
    SmallStrainCheck(const Scene &scene, const Parameters &parameters);

    /// What the load program collects.
    NeglectedTermsOfHistory<dim> neglected;

    /// Before a finer mesh takes the place of this one, at a converged state of the load program.
    /// energy: stored. Collective.
    void
    leave_mesh(Model<dim>                &model,
               const StressRecovery<dim> &recovery,
               const SolutionState<dim>  &state,
               const double               energy,
               TimerOutput               &timer,
               RunControl                &control);

    /// After the load program, at its last state. Finite strain is tried where small strain leaves out more
    /// than is allowed, or, if the scene insists on small strain, more than any answer may. Not after a
    /// failure, nor where the bodies have been much farther before: what finite strain changes in the end
    /// says nothing of the way then, and what is left out decides. of_mesh: error of the target quantity.
    /// control: of the run. Collective.
    void
    look(Model<dim>               &model,
         const SolutionState<dim> &state,
         const bool                converged,
         const double              of_mesh,
         TimerOutput              &timer,
         RunControl               &control);

    /// Of the relative error: the target, or 1 %; and what an answer may have at most.
    double
                            allowed_error() const;
    static constexpr double too_much = 0.1;

    /// After look(). What finite strain changes, where that was tried; else what small strain leaves out.
    double
    error() const;
    /// What that makes of the shear traction (NaN: there is none), and of the target quantity.
    double
    error_of_shear() const;
    double
    error_of_target() const;
    bool
    is_harmless() const;
    /// It is not, and the scene lets finite strain take over.
    bool
    calls_for_finite_strain() const;
    /// On the way: what is left out is so much that finite strain takes over on whatever mesh. energy:
    /// stored. Collective.
    bool
    gives_way(const StressRecovery<dim> &recovery, const double energy);
    /// The numbers are not those of the scene: more than `too_much` is left out, or bodies buckle, or, where
    /// finite strain was tried, forces or displacements change by more, or pressures by half and the gaps are
    /// others. (At an edge, where they are infinite, pressures change by much if it slides on by little.)
    bool
    is_too_much() const;
    /// Finite strain was tried and converged.
    bool
    knows_change() const
    {
      return change.has_value();
    }
    /// Meshes that were made for small strain serve finite strain as well: the contact lies where it lay.
    bool
    keeps_meshes() const
    {
      return error_by_uneven_gaps() == 0;
    }
    /// What the iteration from the answer of small strain came to, where that is near (no more than too_much)
    /// and the path there does not matter; else null. Of the mesh that was looked at.
    const SolutionState<dim> *
    answer_nearby() const
    {
      return found ? &*found : nullptr;
    }
    /// No rotation is free: finite strain needs them given or held. Nor does the method touch at nodes.
    bool
    has_alternative() const
    {
      return rotations_are_held && !parameters.newton.collocates();
    }
    /// Where slender bodies bear more than a cantilever of their size, which is the least that buckles: what
    /// is the same on both sides of a plane of symmetry may not be all that there is. (A bound.)
    bool
    may_lose_symmetry() const
    {
      return neglected.largest().buckling > 1;
    }
    /// For sentences.
    std::string
    description() const;
    std::string
    allowance() const;
    /// Of the answer by finite strain. What is soft may move by much beside what moves farther, or is pressed
    /// harder: a tenth of the error where stress makes anything much softer or stiffer.
    double
    allowed_change() const;
    /// neglected_strain, neglected_contact, neglected_pressure, neglected_stiffening(, change_of_answer):
    /// when it was looked.
    const std::map<std::string, double> &
    checks() const
    {
      return what_was_seen;
    }

  private:
    // What error() may be for the target quantity to be as exact as allowed, where shear follows from it,
    // too. Mesh and model share what is allowed: all that the mesh leaves, and a quarter anyway.
    double
    allowed_part() const;
    bool
    pressures_are_known() const;
    // What is left out as far as the target quantity looks at it.
    double
    error_by_uneven_gaps() const;
    double
    neglected_part() const;
    // How much stress changes the stiffness.
    double
    stiffening_at(Model<dim>               &model,
                  const SolutionState<dim> &state,
                  TimerOutput              &timer,
                  RunControl               &control) const;
    struct Change
    {
      double largest, without_pressures;
    };
    std::optional<Change>
    change_nearby(Model<dim>                        &model,
                  const SolutionState<dim>          &state,
                  TimerOutput                       &timer,
                  RunControl                        &control,
                  std::optional<SolutionState<dim>> *nearby) const;
    std::optional<Change>
    change_by_finite_strain(Model<dim>               &model,
                            const SolutionState<dim> &state,
                            TimerOutput              &timer,
                            RunControl               &control);
    Change
    change_to(const Model<dim>         &finite,
              const SolutionState<dim> &finite_state,
              const Model<dim>         &model,
              const SolutionState<dim> &state) const;
    // Of what is neglected: where it is more, what it does is looked for.
    double
    bound() const;
    double
    allowed_stiffening() const;
    // On a mesh before; what was looked for.
    struct Findings
    {
      NeglectedTerms        terms;
      std::optional<double> stiffening;
      std::optional<Change> change;
    };
    // No more is neglected here than there.
    bool
    is_as_before() const;

    const Scene                      &scene;
    const Parameters                 &parameters;
    bool                              rotations_are_held = true;
    bool                              is_no_answer       = false; // by the mesh before
    bool                              has_given_way      = false;
    double                            error_of_mesh      = 0;
    bool                              tried              = false; // finite strain, and
    std::optional<Change>             change;                     // by it, if it converged
    std::optional<SolutionState<dim>> found;
    double                            stiffening = 0;
    std::optional<ShearKinematics>    shear;
    std::optional<Findings>           before;
    std::map<std::string, double>     what_was_seen;
  };
} // namespace Amontons
