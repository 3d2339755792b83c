// Runs a scene in the plane and prints the force of each pair: what main.cc does, without studies and
// checkpoints.
#include <amontons/contact_problem.h>
#include <amontons/output/output_folder.h>
#include <amontons/run_control.h>
#include <amontons/run_parameters.h>
#include <amontons/scene/scene_reader.h>
#include <amontons/verification/comparison.h>
#include <amontons/verification/reference_solution.h>

#include <iostream>

using namespace Amontons;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      Parameters  parameters;
      const Scene scene = read_scene(argc > 1 ? argv[1] : "",
                                     {"Output/VTU = false"}, // as --set
                                     parameters.groups(),
                                     {make_displacement_field, displacement_field_corners});
      parameters.refinement.choose_target(scene.has_friction() ||
                                          scene.kinematics == Kinematics::finite_strain);

      RunControl control{StopRequest(0, false), Checkpoint(MPI_COMM_WORLD)}; // of signals: none is noted
      const bool quiet = true;
      const RunSummary summary =
          ContactProblem<2>(scene, parameters, "output", quiet, control, make_reference<2>).run();
      keep_output_folder();
      for (const PairSummary &pair : summary.pairs)
        std::cout << pair.name << ": " << pair.normal_force[0] << ", " << pair.normal_force[1] << std::endl;
      return summary.converged ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
