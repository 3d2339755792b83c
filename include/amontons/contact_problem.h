// One scene from its file to its answer.
#pragma once

#include <amontons/adaptivity/increment_error.h>
#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/adaptivity/model_selection.h>
#include <amontons/elasticity/loads.h>
#include <amontons/load_history.h>
#include <amontons/elasticity/finite_mechanics.h>
#include <amontons/elasticity/linear_mechanics.h>
#include <amontons/run_report.h>
#include <amontons/solver/solve_contact.h>

namespace Amontons
{
  // All sections of the .prm file that are not the scene itself.
  struct Parameters
  {
    DiscretizationParameters discretization;
    LinearSolverParameters   linear_solver;
    NewtonParameters         newton;
    RefinementParameters     refinement;
    OutputParameters         output;

    ParameterGroups
    groups()
    {
      return {&discretization, &newton, &linear_solver, &refinement, &output};
    }
  };

  template <int dim>
  class ContactProblem
  {
  public:
    // make_reference: not needed for scenes without `reference`.
    ContactProblem(const Scene              &scene,
                   const Parameters         &parameters,
                   const std::string        &output_folder,
                   const bool                quiet,
                   const MakeReference<dim> &make_reference = {});

    // Throws InputError; a failed iteration is reported in the summary's status.
    RunSummary
    run();

  private:
    std::optional<IncrementErrors>
    run_to_measure_increments();
    bool
    resolves_friction() const;
    void
    measure_increments();
    void
    keep_record(const LoadProgram &program);
    void
    add_error_of_increments();
    bool
    run_all_meshes();
    bool
    choose_kinematics(const bool success);
    void
    restart(const bool with_finite_strain);
    double
    kinematic_error() const;
    std::string
    describe_small_strain() const;
    double
    allowed_error() const;
    void
    make_mesh();
    void
    rebuild();
    void
    couple_surfaces();
    void
    refine_where_bodies_are_close();
    bool
    run_load_program();
    void
    start_history();
    void
    set_time(const double t);
    void
    commit(const LoadProgram &program);
    void
    roll_back(const double failed_time);
    struct FailedIncrement
    {
      NewtonReport        report;
      LA::Vector          loads, values; // prescribed ones
      std::vector<double> gaps;          // those that grow
    };
    bool
    failed_alike(const FailedIncrement &before) const;
    void
    note_snaps(const double duration);
    LA::Vector
    prescribed_values() const;
    std::vector<double>
    growing_gaps() const;
    void
    go_back();
    void
    return_to_last_converged();
    enum class Increment
    {
      converged,
      failed,
      lost // where it starts from has no equilibrium on the refined mesh: a smaller one has none, either
    };
    Increment
    solve_increment(const LoadProgram &program);
    bool
    solve_on_mesh(const LoadProgram &program);
    NewtonReport
    iterate();
    ContactSolver<dim>
    contact_solver();
    FiniteMechanics<dim>
    finite_mechanics(ElasticityOperator<dim> &bodies) const;
    void
    move_surfaces();
    std::optional<double>
    change_by_finite_strain();
    bool
    rebalance(const LoadProgram &program);
    bool
    wants_refinement() const;
    bool
    replay_refined();
    bool
    refine_now(const LoadProgram &program) const;
    bool
    may_transfer() const;
    void
    remember_path();
    void
    guess_from_path();
    std::vector<std::vector<double>>
    unused_shears() const;
    bool
    widen_reach();
    bool
    refine();
    void
    estimate();
    void
    make_traction_field();
    void
    carry_active_set();
    void
    collect_fields();
    Answer<dim>
    answer() const;
    typename RunReport<dim>::Ending
    ending(const bool success) const;
    std::vector<CoveredPoint<dim>>
    covered_points() const;

    const Scene       scene;
    bool              finite_strain; // in effect
    bool              has_history;   // friction: the answer depends on the path of the load
    bool              incremental;   // it is applied in increments
    const Parameters &parameters;
    const std::string folder;
    RunReport<dim>    report;

    Geometry<dim>                            geometry;
    std::unique_ptr<Discretization<dim>>     discretization;
    std::unique_ptr<ElasticityOperator<dim>> elasticity;
    std::vector<bool>                        first_is_slave;
    std::vector<double>                      reaches; // by pair, see widen_reach; 0: not known yet
    std::vector<ContactInterface<dim>>       interfaces;
    Constraints                              supports;
    LA::Vector                               loads;
    std::optional<double>                    time_of_supports;
    LoadHistory<dim>                         history;
    unsigned int                             cycle = 0; // refinements so far
    std::vector<SurfaceFields<dim>>          fields;
    std::unique_ptr<StressRecovery<dim>>     recovery;
    ErrorEstimate<dim>                       error;
    unsigned int                             mesh_number = 0;
    NeglectedTermsOfHistory<dim>             neglected; // small strain
    std::map<std::string, double>            neglected_checks;
    bool                                     tried_finite_strain = false; // after small strain, and
    std::optional<double>                    change_of_answer;            // by it, if it converged
    // Friction: the repeat of the load program with other increments.
    double coarser             = 1;
    bool   is_repeat           = false;
    bool   measured_increments = false, only_increments = false; // only: what this run is for
  };
} // namespace Amontons
