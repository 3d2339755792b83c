// Boundary faces, flat or of second order, that stand for a curved surface.
#pragma once

#include <deal.II/grid/tria.h>

#include <array>
#include <functional>
#include <set>
#include <vector>

namespace Amontons
{
  // A face of the coarse mesh whose neighbours meet it at kinks as a polygon's do that stands for a curve.
  // Refinement leaves it flat. With the angle theta of the kinks and the length h across them, the radius is
  // h / theta and the face lies off the curve by up to h^2 / (8 radius) = h theta / 8: doc/introduction.md,
  // (32). Quadratic arcs meet at kinks, too, of theta^3 / 16 where theta is the angle of the arc. In the
  // plane, where the curvature kappa changes along a curve, they meet at steps of it: through three points of
  // the curve, the error of the curvature is kappa' s at the distance s from the middle of an arc.
  template <int dim>
  struct Facet
  {
    static constexpr unsigned int n_ridges = 2 * (dim - 1);

    dealii::Point<dim> centre;
    double             radius      = 0; // of a ball about the centre that holds the face
    double             size        = 0; // h, where the kinks are largest
    double             angle       = 0; // largest kink; > 0: convex
    double             mean_square = 0; // of the kinks, in 3D summed over both directions
    bool               is_curved   = false;
    // Where it meets its neighbours, ridge k opposite of ridge k ^ 1, and the kinks there (0: none).
    std::array<dealii::Point<dim>, n_ridges> ridges;
    std::array<double, n_ridges>             kinks = {};
    std::array<double, n_ridges>             steps = {}; // of the curvature, from this face to the next
  };

  template <int dim>
  using IsMirror = std::function<bool(const typename dealii::Triangulation<dim>::face_iterator &)>;

  // Those of the surface that consists of the boundaries `ids`. A kink belongs to a facet if it is no corner
  // (below 40 degrees) and one of three or more in a row, from face to opposite face, of the same sign and
  // within a factor of four: one or two kinks between longer flat parts are meant. So with steps along the
  // curve: where a fillet ends there is one. Faces with a manifold that
  // several share are curved. Beyond faces in planes of symmetry the image of the surface goes on. The same
  // on all ranks.
  template <int dim>
  std::vector<Facet<dim>>
  find_facets(const dealii::Triangulation<dim>           &triangulation,
              const std::set<dealii::types::boundary_id> &ids,
              const IsMirror<dim>                        &is_mirror);
} // namespace Amontons
