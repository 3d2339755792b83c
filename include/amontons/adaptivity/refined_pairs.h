// Which contacts meshes have been refined in.
#pragma once

#include <amontons/contact/contact_interface.h>

#include <optional>

namespace Amontons
{
  // Recovery alone may see a fifth of the error of a contact on faces that are too coarse for it, and
  // differences between meshes tell nothing of where these are alike. So a pair is believed once the faces
  // of its contact are smaller than where it was first resolved; on the first mesh of all, none is.
  template <int dim>
  class RefinedPairs
  {
  public:
    /// Of what the estimate says on a first mesh, the error may be so many times as much.
    static constexpr double doubt = 5;

    /// At a state on the mesh of this number; pairs that touch nowhere, and tied ones, are none of this.
    void
    look(const std::vector<ContactInterface<dim>> &interfaces,
         const std::vector<SurfaceFields<dim>>    &fields,
         const unsigned int                        mesh);

    /// By pair: what the last look says that estimates are to be multiplied by.
    const std::vector<double> &
    doubts() const
    {
      return factors;
    }

  private:
    struct First
    {
      unsigned int mesh;
      double       face; // smallest
    };
    std::vector<std::optional<First>> first; // by pair
    std::vector<double>               factors;
  };
} // namespace Amontons
