// The result of the surface integrals: what a pair of surfaces says about displacements. Plain values.
#pragma once

#include <amontons/base/linear_algebra.h>

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <set>
#include <vector>

namespace Amontons
{
  // A quadrature point of the region where slave and master lie above each other.
  template <int dim>
  struct OverlapPoint
  {
    unsigned int   slave_face, master_face; // master_face: invalid for an analytic obstacle
    Point<dim - 1> xi_slave, xi_master;
    Point<dim>     x_slave, x_master; // positions on the true surfaces as they lie
    Tensor<1, dim> normal;            // unit, outward from the slave
    Tensor<1, dim> ray;               // likewise: the slave's normal, along which its partner was found
    double         gap;               // along the ray (or as the scene declares it)
    double         weight;            // slave area, in axisymmetric scenes of the full turn

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &slave_face &master_face &xi_slave &xi_master &x_slave &x_master &normal &ray &gap &weight;
    }
  };

  template <int dim>
  using NodeDofs = std::array<types::global_dof_index, dim>;

  // One multiplier. Jump: Delta = sum slave weight u - sum master weight u (each sum of weights is 1), and
  // contact says
  //   g = gap - normal . Delta >= 0,   p >= 0,   p g = 0,
  // with virtual work -area p normal . delta(Delta): doc/introduction.md, (5) and (6).
  //! [coupling row]
  template <int dim>
  struct MortarRow
  {
    unsigned int   node; // of the slave surface: the node that is eliminated
    double         area;
    double         gap;
    double         mean_gap;   // int B g / int B: of one sign with g, while psi changes its own
    Tensor<1, dim> normal;     // int psi n / area; not of unit length on curved surfaces
    Tensor<1, dim> gap_vector; // int psi g r / area, r the ray
    std::vector<std::pair<NodeDofs<dim>, double>> slave, master;
    std::vector<std::pair<unsigned int, double>>
        traces; // int psi B_j dA, by slave node: B_j are the traces of the control values
  };
  //! [coupling row]

  // Delta; u readable at relevant DoFs.
  template <int dim>
  Tensor<1, dim>
  jump(const MortarRow<dim> &row, const LA::Vector &u)
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      {
        for (const auto &[dofs, weight] : row.slave)
          result[c] += weight * u(dofs[c]);
        for (const auto &[dofs, weight] : row.master)
          result[c] -= weight * u(dofs[c]);
      }
    return result;
  }

  template <int dim>
  struct Coupling
  {
    std::vector<MortarRow<dim>>    rows;
    std::vector<OverlapPoint<dim>> points;
    // Nodes without a row whose pressure is the mean of others': nodes of which next to nothing is covered,
    // with those that take their share; under nodal traces (nodal_traces.h) nodes on the axis, with the
    // middle node beside them.
    std::map<unsigned int, std::vector<unsigned int>> slivers;
    std::set<unsigned int> whole_faces; // slave faces that lie opposite of the other side as a whole
    // int B_i B_j dA over the overlap, by slave node
    std::map<std::pair<unsigned int, unsigned int>, double> trace_mass;
  };
} // namespace Amontons
