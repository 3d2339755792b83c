// Large objects from all ranks on all ranks, or on the first.
#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/set.hpp>

#include <numeric>

namespace Amontons
{
  // Utilities::MPI::all_gather, or gather, without their compression, which takes longer than any network. By
  // rank; not on_all: on the first rank, nothing on the others.
  template <typename T>
  std::vector<T>
  gather(const MPI_Comm communicator, T object, const bool on_all)
  {
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator),
                       own     = dealii::Utilities::MPI::this_mpi_process(communicator);
    std::vector<T> objects;
    if (n_ranks == 1)
      {
        objects.push_back(std::move(object));
        return objects;
      }
    const std::vector<char> mine = dealii::Utilities::pack(object, false);
    const int               size = mine.size();
    std::vector<int>        sizes(n_ranks), begins(n_ranks + 1, 0);
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
    std::partial_sum(sizes.begin(), sizes.end(), begins.begin() + 1);
    const bool        is_here = on_all || own == 0;
    std::vector<char> all(is_here ? begins.back() : 0);
    if (on_all)
      MPI_Allgatherv(
          mine.data(), size, MPI_CHAR, all.data(), sizes.data(), begins.data(), MPI_CHAR, communicator);
    else
      MPI_Gatherv(
          mine.data(), size, MPI_CHAR, all.data(), sizes.data(), begins.data(), MPI_CHAR, 0, communicator);
    for (unsigned int rank = 0; is_here && rank < n_ranks; ++rank)
      if (rank == own)
        objects.push_back(std::move(object)); // NOLINT(bugprone-use-after-move): once
      else
        objects.push_back(dealii::Utilities::unpack<T>(
            all.cbegin() + begins[rank], all.cbegin() + begins[rank + 1], false));
    return objects;
  }

  template <typename T>
  std::vector<T>
  gather_on_all(const MPI_Comm communicator, T object)
  {
    return gather(communicator, std::move(object), true);
  }

  template <typename T>
  std::vector<T>
  gather_on_first(const MPI_Comm communicator, T object)
  {
    return gather(communicator, std::move(object), false);
  }

  // A set or a map with what all ranks have. Collective.
  template <typename Container>
  Container
  of_all_ranks(const MPI_Comm communicator, const Container &mine)
  {
    Container all;
    for (const auto &part : gather_on_all(communicator, mine))
      all.insert(part.begin(), part.end());
    return all;
  }

  // compute(0), ..., compute(n - 1) on all ranks: each computes every n_ranks-th, so that neighbours, which
  // cost about the same, are shared out.
  template <typename Compute>
  auto
  compute_in_turn(const MPI_Comm communicator, const unsigned int n, const Compute &compute)
  {
    using Result               = decltype(compute(0u));
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);

    std::vector<Result> mine, all;
    for (unsigned int i = dealii::Utilities::MPI::this_mpi_process(communicator); i < n; i += n_ranks)
      mine.push_back(compute(i));
    auto parts = gather_on_all(communicator, std::move(mine));
    for (unsigned int i = 0; i < n; ++i)
      all.push_back(std::move(parts[i % n_ranks][i / n_ranks]));
    return all;
  }
} // namespace Amontons
