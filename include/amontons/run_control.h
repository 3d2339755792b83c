/// What may end a run early, and what a later one goes on from.
#pragma once

#include <amontons/base/input_error.h>
#include <amontons/base/stop_request.h>
#include <amontons/output/checkpoint.h>

#include <deal.II/base/timer.h>

namespace Amontons
{
  struct RunControl
  {
    StopRequest stop;
    Checkpoint  checkpoint;
    Timer       wall = {}; // since the run began

    /// What is being solved is to be given up; see StopRequest. Nothing that a run that goes on has to come
    /// through again. Collective.
    bool
    gives_up(const MPI_Comm communicator)
    {
      return !checkpoint.is_replaying() && stop.gives_up(communicator);
    }

    /// Writes something; where that cannot be done, this is a reason to stop, not an exception.
    template <typename Write>
    void
    try_to(const Write &write)
    {
      try
        {
          write();
        }
      catch (const InputError &error)
        {
          stop.because(error.what());
        }
    }
  };
} // namespace Amontons
