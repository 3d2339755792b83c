// One or several named boundaries of a body as a surface that may touch others, known whole on every rank.
#pragma once

#include <amontons/discretization/discretization.h>
#include <amontons/geometry/facets.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <map>
#include <set>

namespace Amontons
{
  template <int dim>
  struct SurfaceNode
  {
    Point<dim>                               X; // reference position
    Point<dim>                               x; // current position: X until the surface is moved
    std::array<types::global_dof_index, dim> dofs;
    Tensor<1, dim> normal; // unit, outward: mean over the faces that meet here; within symmetry planes
    bool           holds_normal = false; // whatever the faces do: of an obstacle, see hold_end_normals()
    // A hanging node: its displacement is sum of weight x that of these nodes, which do not hang. Else empty.
    std::vector<std::pair<unsigned int, double>> parents;
    // Control value of the Bernstein trace at this node: c = sum of weight x nodal value (see face_basis.h),
    // over nodes that do not hang. Hanging nodes have none.
    std::vector<std::pair<unsigned int, double>> control;
    std::vector<Tensor<1, dim>> symmetry_planes; // unit normals of the planes (and the axis) that it lies on
    std::vector<Tensor<1, dim>> crossed_planes;  // of those, the ones that the surface crosses without a kink
    // Unit normals of planes that displacements along an axis keep it in, where the surface leans to them.
    std::vector<Tensor<1, dim>> walls;
    bool                        is_on_plane = false; // of either kind, or of displacements across the surface
  };

  template <int dim>
  struct SurfaceFace
  {
    std::vector<unsigned int> nodes; // (degree+1)^(dim-1), lexicographic
    std::vector<Point<dim>>
               geometry; // true surface, as it lies now: (geometry_degree+1)^(dim-1) points, lexicographic
    double     sign;     // of the outward normal against the cross product of the tangents
    double     size;
    Point<dim> centre;
    bool       straight; // geometry is the (bi)linear interpolation of the corners
    // Of the lattice points from the finite elements' face: (a_k, b) with d = sum_k a_k t_k + b n, where t_k
    // and n are tangents and unit normal of that face at its centre, which they follow. Empty: none.
    std::vector<Point<dim>>     deviation;
    std::vector<Tensor<2, dim>> centre_normal_gradient; // dn/dx by node, where there is a deviation
    // Nodes whose control values determine the face: `nodes`, but for hanging ones, whose place parents take;
    // as many as `nodes`. Local control value i = sum_j subdivision(i, j) x that of unknowns[j] (weights
    // >= 0, of sum 1); empty for the identity.
    std::vector<unsigned int> unknowns;
    FullMatrix<double>        subdivision;
    unsigned int              rank;        // owner of the cell, and
    unsigned int              owned_index; // place in `owned` there
  };

  // What ranks tell each other about their faces: all numbers of all faces, one after another.
  struct FaceNumbers
  {
    std::vector<types::global_dof_index> dofs;
    std::vector<double>                  positions; // nodes, then the lattice
    std::vector<double>                  signs;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &dofs &positions &signs;
    }
  };

  // The part of a surface that this rank's cells have.
  template <int dim>
  struct OwnedFaces
  {
    OwnedFaces(const Discretization<dim> &discretization, const BoundaryName &name);

    std::vector<std::pair<typename DoFHandler<dim>::active_cell_iterator, unsigned int>> cells; // face number
    FaceNumbers                                                                          numbers;
  };

  template <int dim>
  class ContactSurface
  {
  public:
    // Gaps are measured between the true surfaces, not the facets or quadratic arcs of the finite elements;
    // polynomials of degree 4 through points of the true geometry stand for it: the error (h/R)^5 R is far
    // below that of the solution.
    static constexpr unsigned int geometry_degree = 4;

    // Collective.
    ContactSurface(const Discretization<dim> &discretization, const BoundaryName &name);
    // With `own` of several surfaces made before, ranks that have faces of one only work at the same time.
    ContactSurface(const Discretization<dim> &discretization, const BoundaryName &name, OwnedFaces<dim> own);

    // To where u (readable at all DoFs of the surface) takes the reference geometry: lattice points by
    // interpolation, exact up to geometry_degree, with the deviations of the true surface, which turn with
    // their faces. Normals and sizes are made anew, mean_size stays. False if the surface is there already.
    bool
    move(const LA::Vector &u);

    // How the deviation at xi and its slopes along xi_k change with the position of each node of the face; to
    // be asked only where there is one.
    struct DeviationGradient
    {
      Tensor<2, dim>                      value; // [component][direction]
      std::array<Tensor<2, dim>, dim - 1> slopes;
    };
    std::vector<DeviationGradient>
    deviation_gradient(const unsigned int face, const Point<dim - 1> &xi) const;

    // d(nodal normal)/d(displacement), for nodes of faces.
    std::vector<std::pair<types::global_dof_index, Tensor<1, dim>>>
    normal_gradient(const unsigned int node) const;

    Point<dim>
    reference_position(const unsigned int face, const Point<dim - 1> &xi) const;

    // All that follows refers to the surface as it lies now.
    Point<dim>
    position(const unsigned int face, const Point<dim - 1> &xi) const;
    // Position and tangent vectors dX/dxi_k.
    struct Frame
    {
      Point<dim>                          X;
      std::array<Tensor<1, dim>, dim - 1> tangents;
    };
    Frame
    frame(const unsigned int face, const Point<dim - 1> &xi) const;
    // Normal of the true surface, outward, unit; `jacobian` = area of the face element per d(xi).
    Tensor<1, dim>
    face_normal(const unsigned int face, const Point<dim - 1> &xi, double *jacobian = nullptr) const;
    // Unit normal interpolated between the nodal normals: continuous over the surface. `derivatives`: by
    // xi_k.
    Tensor<1, dim>
    nodal_normal(const unsigned int                   face,
                 const Point<dim - 1>                &xi,
                 std::array<Tensor<1, dim>, dim - 1> *derivatives = nullptr) const;
    IndexSet
    dofs() const;

    const unsigned int            body;
    const unsigned int            degree;
    std::vector<SurfaceNode<dim>> nodes;
    std::vector<SurfaceFace<dim>> faces;
    // Cells and face numbers behind the faces that this rank owns.
    std::vector<std::pair<typename DoFHandler<dim>::active_cell_iterator, unsigned int>> owned;
    double                                                                               mean_size = 0;
    bool                                                                                 moved     = false;
    // The largest angle (degrees) between two faces at a node, and where: a sharp edge has no normal.
    double                  sharpest_edge = 0;
    Point<dim>              sharpest_at;
    std::vector<Facet<dim>> facets; // in the reference configuration

  private:
    void
    collect_faces(const std::vector<FaceNumbers> &parts);
    void
    find_parents(const Discretization<dim> &discretization);
    void
    join_nodes(const Discretization<dim>                       &discretization,
               std::set<types::global_dof_index>                missing,
               std::map<types::global_dof_index, unsigned int> &node_of_dof);
    void
    make_controls();
    void
    find_symmetry_planes(const Discretization<dim> &discretization);
    // Of the faces at a node; points: the places of nodes in a face.
    Tensor<1, dim>
    sum_of_normals(const unsigned int node, const std::vector<Point<dim - 1>> &points) const;
    void
    find_crossed_planes(const bool axisymmetric);
    void
    find_sharpest_edge();
    void
    measure(SurfaceFace<dim> &face) const;
    void
    make_normals();
    void
    find_deviation(SurfaceFace<dim> &face) const;

    const IndexSet::size_type            n_dofs;
    std::vector<std::vector<Point<dim>>> reference_geometry; // by face
    // By node: the faces there and its place in them.
    std::vector<std::vector<std::pair<unsigned int, unsigned int>>> faces_at;
  };
} // namespace Amontons
