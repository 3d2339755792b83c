/// What pictures of 3D scenes are drawn from: the faces of the bodies, or a cut through them, with
/// displacements and von Mises stress, gathered on rank 0.
#pragma once

#include <amontons/elasticity/stress_recovery.h>

#include <array>

namespace Amontons
{
  /// As floats: pictures need no more.
  struct BodyPoint
  {
    std::array<float, 3> X = {{0, 0, 0}}, u = {{0, 0, 0}}; // reference position, displacement
    float                stress = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &X &u &stress;
    }
  };

  /// (n+1)^2 points of a face of a cell, lexicographic.
  struct BodyPatch
  {
    unsigned char          body = 0; // number in the scene
    unsigned int           n    = 1;
    std::vector<BodyPoint> points;

    const BodyPoint &
    at(const unsigned int i, const unsigned int j) const
    {
      return points[j * (n + 1) + i];
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &body &n &points;
    }
  };

  using BodySurfaces = std::vector<BodyPatch>;

  /// All faces of deformable and rigid bodies, on rank 0 in an order that does not depend on the number of
  /// ranks; empty on the others. Faces are divided more, the fewer there are: curved and quadratic
  /// ones look so. Stresses below `rounding` are zero. Collective.
  BodySurfaces
  gather_body_surfaces(const Discretization<3> &discretization,
                       const StressRecovery<3> &recovery,
                       const LA::Vector        &displacement,
                       const double             rounding);

  /// Points x with (x - point) . normal = 0, where x = X + moved u: of the reference configuration (0) or the
  /// current one (1).
  struct CutPlane
  {
    std::array<double, 3> point = {{0, 0, 0}}, normal = {{0, 0, 1}};
    double                moved = 0;

    double
    distance(const BodyPoint &p) const
    {
      double sum = 0;
      for (unsigned int d = 0; d < 3; ++d)
        sum += (p.X[d] + moved * p.u[d] - point[d]) * normal[d];
      return sum;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &point &normal &moved;
    }
  };

  /// The bodies in the plane: triangles, and lines where faces of cells cross it.
  struct BodyCut
  {
    struct Triangle
    {
      unsigned char            body = 0;
      std::array<BodyPoint, 3> corners;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &body &corners;
      }
    };
    std::vector<Triangle>                 triangles;
    std::vector<std::array<BodyPoint, 2>> lines;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &triangles &lines;
    }
  };

  /// On rank 0; empty on the others. Collective.
  BodyCut
  gather_body_cut(const Discretization<3> &discretization,
                  const StressRecovery<3> &recovery,
                  const LA::Vector        &displacement,
                  const double             rounding,
                  const CutPlane          &plane);

  /// What of a tetrahedron lies in the plane is added: nothing, a triangle, or two.
  void
  cut_tetrahedron(const std::array<BodyPoint, 4> &corners,
                  const unsigned char             body,
                  const CutPlane                 &plane,
                  BodyCut                        &cut);

  /// What of a triangle lies in the plane is added to the lines.
  void
  cut_triangle(const std::array<BodyPoint, 3> &corners, const CutPlane &plane, BodyCut &cut);
} // namespace Amontons
