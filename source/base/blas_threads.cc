#include <amontons/base/blas_threads.h>

#include <dlfcn.h>

namespace Amontons
{
  namespace
  {
    int
    get()
    {
      static const auto function =
          reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
      return function == nullptr ? 1 : function();
    }

    void
    set(const int n)
    {
      static const auto function =
          reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
      if (function != nullptr)
        function(n);
    }

    const int at_start = get();
  } // namespace

  BlasThreads::BlasThreads(const int n) : before(get()) { set(n); }

  BlasThreads::~BlasThreads() { set(before); }

  int
  BlasThreads::available()
  {
    return at_start;
  }
} // namespace Amontons
