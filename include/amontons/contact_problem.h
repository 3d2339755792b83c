// One scene from its file to its answer.
#pragma once

#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/elasticity/loads.h>
#include <amontons/output/contact_csv.h>
#include <amontons/output/quantities.h>
#include <amontons/output/terminal.h>
#include <amontons/output/vtu_output.h>
#include <amontons/solver/semismooth_newton.h>

namespace Amontons
{
  struct OutputParameters : ParameterGroup
  {
    bool vtu    = true;
    bool report = true;

    void
    declare(ParameterHandler &prm) override;
  };

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
    ContactProblem(const Scene       &scene,
                   const Parameters  &parameters,
                   const std::string &output_folder,
                   const bool         quiet);

    // Throws InputError; a failed iteration is reported in the summary's status.
    RunSummary
    run();

  private:
    void
    make_mesh();
    void
    rebuild();
    void
    refine_where_bodies_are_close();
    void
    set_load_factor(const double t);
    bool
    solve_increment(const unsigned int increment);
    bool
    solve_on_mesh(const unsigned int increment);
    bool
    widen_reach();
    double
    estimated_error() const;
    bool
    refine();
    void
    estimate();
    void
    carry_active_set();
    void
    collect_fields();
    void
    summarise_mesh(const unsigned int increment, const NewtonReport &report, const double seconds);
    void
    add_notes(const NewtonReport &report);
    void
    write_increment();
    void
    finish();
    Answer<dim>
    answer() const;
    std::vector<CoveredPoint<dim>>
    covered_points() const;

    const Scene         scene;
    const unsigned int  n_increments;
    const Parameters   &parameters;
    const std::string   folder;
    const MPI_Comm      communicator;
    Terminal            terminal;
    Timer               wall;
    mutable TimerOutput timer;

    Geometry<dim>                            geometry;
    std::unique_ptr<Discretization<dim>>     discretization;
    std::unique_ptr<ElasticityOperator<dim>> elasticity;
    std::vector<bool>                        first_is_slave;
    std::vector<double>                      reaches; // by pair, see widen_reach; 0: not known yet
    std::vector<ContactInterface<dim>>       interfaces;
    Constraints                              supports;
    LA::Vector                               loads;
    SolutionState                            state;
    std::vector<SurfaceFields<dim>>          fields;
    std::unique_ptr<StressRecovery<dim>>     recovery;
    ErrorEstimate<dim>                       error;
    std::optional<ReferenceSolution>         reference;
    VtuOutput                                vtu;
    unsigned int                             mesh_number = 0;
    RunSummary                               summary;
  };
} // namespace Amontons
