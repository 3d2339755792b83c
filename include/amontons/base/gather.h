// Large objects from all ranks on all ranks.
#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <numeric>

namespace Amontons
{
  // Utilities::MPI::all_gather without its compression, which takes longer than any network.
  template <typename T>
  std::vector<T>
  gather_on_all(const MPI_Comm communicator, const T &object)
  {
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return {object};
    const std::vector<char> mine = dealii::Utilities::pack(object, false);
    const int               size = mine.size();
    std::vector<int>        sizes(n_ranks), begins(n_ranks + 1, 0);
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
    std::partial_sum(sizes.begin(), sizes.end(), begins.begin() + 1);
    std::vector<char> all(begins.back());
    MPI_Allgatherv(
        mine.data(), size, MPI_CHAR, all.data(), sizes.data(), begins.data(), MPI_CHAR, communicator);
    std::vector<T> objects;
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      objects.push_back(
          dealii::Utilities::unpack<T>(all.cbegin() + begins[rank], all.cbegin() + begins[rank + 1], false));
    return objects;
  }
} // namespace Amontons
