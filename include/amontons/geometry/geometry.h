// From the scene to one distributed mesh of all bodies, in the reference configuration.
#pragma once

#include <amontons/scene/scene.h>

#include <deal.II/distributed/tria.h>

#include <map>
#include <string>
#include <vector>

namespace Amontons
{
  // Rigid motions (platens, obstacles, rigid bodies) have no unknowns of their own kind: each owns one coarse
  // cell of the mesh, the unit "carrier", never refined, assembled or written out, whose corner A stands at
  // the motion's reference point and whose edges of length `size` point along the axes. A rigid motion is
  // affine, so u(X) = sum_k N_k(X) u_k over the corners A, B (+x), C (+y), D (+z), with N_B = (X-A)_x/size,
  // ..., N_A = 1 - sum of the others. A, B, C, D are the cell's vertices 0, 1, 2, 4. In axisymmetric scenes
  // the reference has x = 0.
  struct CarrierCell
  {
    dealii::types::material_id material_id;
    MotionData                 motion;
    double                     size;
  };

  // Ids: cells of body b have material_id b; the carrier of motion m has material_id n_bodies + m.
  // Each (body, boundary) has a boundary id of its own over the whole mesh; faces of a body that belong to no
  // named boundary, and the carriers' faces, have ids without a name.
  struct Boundary
  {
    unsigned int               body;
    std::string                name;
    dealii::types::boundary_id id;
    TrueGeometry               geometry; // after placement
  };

  template <int dim>
  class Geometry
  {
  public:
    explicit Geometry(MPI_Comm communicator);

    MPI_Comm                                          communicator;
    dealii::parallel::distributed::Triangulation<dim> triangulation;
    std::vector<Boundary>                             boundaries;
    std::vector<CarrierCell>                          carriers;
    std::vector<double>                               body_sizes;   // diameter of the bounding box, per body
    std::vector<dealii::Point<dim>>                   body_centres; // of the bounding box, per body
    std::vector<bool> of_second_order; // by body: its surface is of arcs through three nodes

    // Throws InputError with a list of the body's boundaries and a suggestion.
    const Boundary &
    boundary(const BoundaryName &name, const Scene &scene) const;
    // Index into `carriers` by the name of the motion.
    unsigned int
    carrier(const std::string &motion) const;
    bool
    is_carrier(const dealii::types::material_id id) const;

  private:
    unsigned int n_bodies = 0;
    template <int d>
    friend void
    make_geometry(const Scene &, Geometry<d> &, const bool);
  };

  // Reads or makes the mesh of every body, places it, joins all (without fusing touching bodies) with the
  // carriers into the coarse mesh, attaches the manifolds, and refines each body uniformly as the scene says
  // (unless `refine` is false: whether a scene can be read is known from the coarse mesh). Throws InputError.
  // Collective.
  template <int dim>
  void
  make_geometry(const Scene &scene, Geometry<dim> &geometry, const bool refine = true);
} // namespace Amontons
