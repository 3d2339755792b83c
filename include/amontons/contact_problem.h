/// One scene from its file to its answer.
#pragma once

#include <amontons/load_stepping.h>
#include <amontons/small_strain_check.h>

namespace Amontons
{
  template <int dim>
  class ContactProblem
  {
  public:
    /// make_reference: not needed for scenes without `reference`. control: of the process.
    ContactProblem(const Scene              &scene,
                   const Parameters         &parameters,
                   const std::string        &output_folder,
                   const bool                quiet,
                   RunControl               &control,
                   const MakeReference<dim> &make_reference = {});

    /// Throws InputError; a failed iteration is reported in the summary's status. notes: what there is to say
    /// beforehand.
    RunSummary
    run(const std::vector<std::string> &notes = {});

  private:
    void
    make_mesh();
    void
    start(const bool finite_strain, const SolutionState<dim> *nearby = nullptr);
    void
    start_on_first_mesh(const bool finite_strain, const bool walls_are_none = true);
    bool
    lets_go_at_wall(const bool finite_strain);
    void
    replay(const std::string &reason);
    bool
    run_load_program();
    bool
    run_on_other_mesh(const unsigned int first, const bool finite_strain, const bool walls_are_none);
    bool
    run_without_facets();
    bool
    may_be_too_coarse() const;
    bool
    choose_kinematics(const bool success);
    bool
    run_with_finite_strain(const bool small_strain_converged);
    bool
    go_on_with_finite_strain();
    void
    warn_of_halves();
    bool
    judge_small_strain();
    void
    add_error_of_increments();
    std::optional<IncrementErrors>
    measure_increments_elsewhere();
    std::optional<IncrementErrors>
    run_to_measure_increments(const bool finite_strain);
    using Checks = std::map<std::string, double>;
    bool
    obeys_laws(Checks checks);
    bool
    is_stopped();
    typename RunReport<dim>::Ending
    ending(const bool success, Checks checks) const;

    Scene                              scene;
    Parameters                         parameters;
    const std::string                  folder;
    RunControl                        &control;
    RunReport<dim>                     report;
    double                             n_first_dofs = 0;
    bool                               is_finer     = false; // the first mesh, than the scene says
    std::shared_ptr<BodyMesh<dim>>     mesh;
    std::unique_ptr<LoadStepping<dim>> steps; // with the kinematics in effect
    SmallStrainCheck<dim>              small_strain;
  };
} // namespace Amontons
