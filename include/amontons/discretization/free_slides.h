/// Bodies that slide on planes without friction, and that nothing keeps from it.
#pragma once

#include <amontons/discretization/rigid_motions.h>
#include <amontons/geometry/geometry.h>

#include <set>

namespace Amontons
{
  /// u_second = sign u_first: of two places at both ends of a body, whose deformation leaves their middle.
  struct HeldPair
  {
    types::global_dof_index first, second;
    double                  sign;
  };

  /// Bodies that touch each other, and the rigid motions of all of them together (columns: coefficients of
  /// rigid_motion() of any place and length) that change nothing.
  struct FreeSlide
  {
    std::vector<unsigned int> bodies;
    FullMatrix<double>        motions;
    std::vector<HeldPair>     held = {}; // displacements that hold them, of one body
  };

  /// By body: rigid motions about its centre and in its size that carry it along all of its own surface (a
  /// disk turns), v . N = 0: null vectors of int (v_i . N)(v_j . N) dA, as columns. bodies: others have none.
  /// Collective.
  template <int dim>
  std::vector<FullMatrix<double>>
  motions_along_surfaces(const Geometry<dim> &geometry, const std::vector<bool> &bodies);

  /// A rigid motion w + Omega x of bodies that touch each other and, without friction, planes that do not
  /// turn, leaves all gaps, loads and prescribed displacements as they are if d . w = 0 and Omega d = 0 for
  /// all normals d of these planes and of planes of symmetry, all prescribed components and all forces.
  /// Without the forces: what they may drive, and nothing ever stops. walls: names of pairs whose obstacles
  /// nothing touches.
  template <int dim>
  std::vector<FreeSlide>
  find_free_slides(const Scene                 &scene,
                   const Geometry<dim>         &geometry,
                   const bool                   with_forces = true,
                   const std::set<std::string> &walls       = {});
} // namespace Amontons
