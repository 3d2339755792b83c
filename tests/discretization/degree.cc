// The degree that the program chooses: by shape and material, not by how a body lies in space.
#include "check.h"

#include <amontons/discretization/discretization.h>

#include <deal.II/base/mpi.h>

namespace test_degree
{
using namespace Amontons;

unsigned int
degree_of(BodyData body, const bool for_pressure = true)
{
  Scene scene;
  scene.kind          = ProblemType::three_dimensional;
  body.name           = "body";
  body.material.young = 1;
  scene.bodies        = {body};
  Geometry<3> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  DiscretizationParameters parameters;
  parameters.for_pressure = for_pressure;
  return parameters.degree_for(scene, geometry);
}

void
check_however_turned(BodyData body, const unsigned int degree, const std::string &what)
{
  check::is_true(degree_of(body) == degree, what);
  body.rotation_axis = Tensor<1, 3>({1, 2, -1.5});
  body.rotation_axis /= body.rotation_axis.norm();
  body.rotation_centre = {3, -1, 2};
  for (const double angle : {10., 45., 67.})
    {
      body.rotation_angle = angle;
      check::is_true(degree_of(body) == degree, what + ", turned by " + std::to_string(angle));
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  BodyData                                 block;
  block.lower = {0, 0, 0};
  block.upper = {2, 2, 1};
  block.cells = {{2, 2, 1}};
  check_however_turned(block, 1, "a stout block");
  check::is_true(degree_of(block, false) == 2, "not for the pressure");
  block.material.poisson = 0.49;
  check_however_turned(block, 2, "nearly incompressible");
  block.material.poisson = 0.3;
  block.upper            = {6, 1, 1};
  block.cells            = {{1, 1, 1}};
  check_however_turned(block, 2, "a beam of one cell");
  return check::result();
}
} // namespace test_degree
