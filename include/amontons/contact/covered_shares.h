// How much of the faces at a slave node lies opposite of the other side.
#pragma once

#include <amontons/contact/contact_surface.h>
#include <amontons/contact/coupling.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <numeric>
#include <set>

namespace Amontons
{
  // Area per area of the meshed surface: in axisymmetric scenes the full turn.
  template <int dim>
  double
  area_factor(const bool axisymmetric, const Point<dim> &x)
  {
    return axisymmetric ? 2 * numbers::PI * x[0] : 1.;
  }

  template <int dim>
  using PointsView = ArrayView<const OverlapPoint<dim>>;

  // Points by slave face; whether a face meets the other side at all; and the faces that this rank
  // integrates: consecutive ones, with its share of the points, so that what all ranks have, one after
  // another, is in the order of the faces.
  template <int dim>
  class FacesWithPoints
  {
  public:
    FacesWithPoints(const std::size_t                     n_faces,
                    const std::vector<OverlapPoint<dim>> &points,
                    const MPI_Comm                        communicator)
        : points(points), begins(n_faces + 1, 0), rank(Utilities::MPI::this_mpi_process(communicator)),
          n_ranks(Utilities::MPI::n_mpi_processes(communicator))
    {
      for (const auto &p : points)
        ++begins[p.slave_face + 1];
      std::partial_sum(begins.begin(), begins.end(), begins.begin());
    }

    bool
    meets(const unsigned int face) const
    {
      return begins[face] < begins[face + 1];
    }

    bool
    is_mine(const unsigned int face) const
    {
      const std::size_t place = n_ranks * begins[face] / std::max<std::size_t>(1, points.size());
      return rank == std::min<std::size_t>(place, n_ranks - 1);
    }

    PointsView<dim>
    operator[](const unsigned int face) const
    {
      return PointsView<dim>(points.data() + begins[face], begins[face + 1] - begins[face]);
    }

  private:
    const std::vector<OverlapPoint<dim>> &points;
    std::vector<std::size_t>              begins;
    const std::size_t                     rank, n_ranks;
  };

  // Nodes on the axis of axisymmetric scenes.
  template <int dim>
  bool
  is_on_axis(const ContactSurface<dim> &slave, const unsigned int node)
  {
    return std::abs(slave.nodes[node].x[0]) < 1e-8 * slave.mean_size;
  }

  struct Coverage
  {
    std::vector<double>    shares;      // by slave node: int B_i, in proportion to that over the whole faces
    std::set<unsigned int> whole_faces; // covered whole, up to quadrature on curved ones
    // By face: int N_i of all its Lagrange polynomials is above a fifth of what a plane face has, covered
    // whole. (On the axis the polynomial of the node there does not count: int N_i r = 0.)
    std::vector<bool> positive_faces;
  };

  // Over the covered parts of all faces. Collective.
  template <int dim>
  Coverage
  covered_shares(const ContactSurface<dim>  &slave,
                 const FacesWithPoints<dim> &points,
                 const bool                  axisymmetric,
                 const MPI_Comm              communicator);
} // namespace Amontons
