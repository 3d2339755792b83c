// Threads of the BLAS library: they pay in large sparse factorisations and cost elsewhere.
#pragma once

namespace Amontons
{
  // OpenBLAS starts threads for any vector of 10000 entries and lets them spin, which takes time from other
  // processes and gives none. Sets the number of its threads while it lives; no effect with other libraries.
  class BlasThreads
  {
  public:
    explicit BlasThreads(const int n);
    ~BlasThreads();

    BlasThreads(const BlasThreads &) = delete;
    BlasThreads &
    operator=(const BlasThreads &) = delete;

    // What the environment asks for (OPENBLAS_NUM_THREADS, or all cores).
    static int
    available();

  private:
    const int before;
  };
} // namespace Amontons
