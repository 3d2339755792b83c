/// All sections of the .prm file that are not the scene itself.
#pragma once

#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/run_report.h>
#include <amontons/solver/newton.h>

namespace Amontons
{
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
} // namespace Amontons
