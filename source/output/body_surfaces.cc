#include <amontons/base/gather.h>
#include <amontons/output/body_surfaces.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iterator>

namespace Amontons
{
  namespace
  {
    // (n+1)^2 points, lexicographic.
    Quadrature<2>
    lattice(const unsigned int n)
    {
      std::vector<Point<2>> points;
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          points.emplace_back(double(i) / n, double(j) / n);
      return Quadrature<2>(points);
    }

    // Calls `visit` for each face of a body in an owned cell.
    template <typename Visit>
    void
    for_each_face(const Discretization<3> &discretization, const Visit &visit)
    {
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && !discretization.geometry.is_carrier(cell->material_id()))
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
              visit(cell, f);
    }

    // Parts of an edge, so that all faces together have about as many triangles as a picture needs.
    unsigned int
    divisions(const unsigned long long n_faces)
    {
      return n_faces <= 400 ? 4 : (n_faces <= 1000 ? 3 : (n_faces <= 10000 ? 2 : 1));
    }

    // Of the reference configuration: the same on any number of ranks.
    bool
    comes_before(const BodyPatch &a, const BodyPatch &b)
    {
      for (unsigned int q = 0; q < std::min(a.points.size(), b.points.size()); ++q)
        if (a.points[q].X != b.points[q].X)
          return a.points[q].X < b.points[q].X;
      return a.body < b.body;
    }

    BodySurfaces
    own_faces(const Discretization<3> &discretization,
              const StressRecovery<3> &recovery,
              const LA::Vector        &displacement,
              const double             rounding,
              const unsigned int       n)
    {
      const Quadrature<2> points = lattice(n);
      FEFaceValues<3>     values(
          discretization.mapping(), discretization.fe, points, update_values | update_quadrature_points);
      FEFaceValues<3> stress_values(
          discretization.mapping(), recovery.dof_handler().get_fe(), points, update_values);
      std::vector<Vector<double>> u(points.size(), Vector<double>(3));
      BodySurfaces                surfaces;
      for_each_face(discretization, [&](const auto &cell, const unsigned int f) {
        values.reinit(cell, f);
        values.get_function_values(displacement, u);
        stress_values.reinit(recovery.cell_of(cell), f);
        const auto stresses = recovery.values_at(stress_values);
        BodyPatch  patch;
        patch.body = std::min<unsigned int>(cell->material_id(), 250);
        patch.n    = n;
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            BodyPoint point;
            for (unsigned int d = 0; d < 3; ++d)
              {
                point.X[d] = values.quadrature_point(q)[d];
                point.u[d] = u[q][d];
              }
            const double stress = von_mises<3>(stresses[q]);
            point.stress        = stress < rounding ? 0 : stress;
            patch.points.push_back(point);
          }
        surfaces.push_back(patch);
      });
      return surfaces;
    }
  } // namespace

  BodySurfaces
  gather_body_surfaces(const Discretization<3> &discretization,
                       const StressRecovery<3> &recovery,
                       const LA::Vector        &displacement,
                       const double             rounding)
  {
    const MPI_Comm     communicator = discretization.geometry.communicator;
    unsigned long long n_faces      = 0;
    for_each_face(discretization, [&](const auto &, const unsigned int) { ++n_faces; });
    const unsigned int        n = divisions(Utilities::MPI::sum(n_faces, communicator));
    std::vector<BodySurfaces> parts =
        gather_on_first(communicator, own_faces(discretization, recovery, displacement, rounding, n));
    BodySurfaces surfaces;
    for (BodySurfaces &part : parts)
      std::move(part.begin(), part.end(), std::back_inserter(surfaces));
    std::sort(surfaces.begin(), surfaces.end(), comes_before);
    return surfaces;
  }
} // namespace Amontons
