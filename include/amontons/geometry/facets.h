// Flat boundary faces that stand for a curved surface.
#pragma once

#include <deal.II/grid/tria.h>

#include <set>
#include <vector>

namespace Amontons
{
  // A face of the coarse mesh whose neighbours meet it at kinks as a polygon's do that stands for a curve.
  // Refinement leaves it flat. With the angle theta of the kinks and the length h across them, the radius is
  // h / theta and the face lies off the curve by up to h^2 / (8 radius) = h theta / 8: doc/introduction.md,
  // (32).
  template <int dim>
  struct Facet
  {
    dealii::Point<dim> centre;
    double             radius;      // of a ball about the centre that holds the face
    double             size;        // h, where the kinks are largest
    double             angle;       // largest kink; > 0: convex
    double             mean_square; // of the kinks, in 3D summed over both directions
  };

  // Those of the surface that consists of the boundaries `ids`. A kink belongs to a facet if it is no corner
  // (below 40 degrees) and one of three or more in a row, from face to opposite face, of the same sign and
  // within a factor of four: one or two kinks between longer flat parts are meant. Faces with a manifold are
  // curved. The same on all ranks.
  template <int dim>
  std::vector<Facet<dim>>
  find_facets(const dealii::Triangulation<dim>           &triangulation,
              const std::set<dealii::types::boundary_id> &ids);
} // namespace Amontons
