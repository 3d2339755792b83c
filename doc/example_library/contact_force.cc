// Runs a scene and prints the force of each pair.
#include <amontons/verification/run_scene.h>

#include <iostream>

int
main(int argc, char **argv)
{
  using namespace Amontons;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      RunControl control{StopRequest(0, false), Checkpoint(MPI_COMM_WORLD)}; // of signals: none is noted
      const std::vector<std::string> entries = {"Output/VTU = false"};       // as --set
      const bool                     quiet   = true;
      const RunSummary summary = run_scene({argc > 1 ? argv[1] : "", entries, "output", quiet}, control);
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
