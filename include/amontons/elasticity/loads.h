// External forces of the scene at time t.
#pragma once

#include <amontons/base/local_matrix.h>
#include <amontons/discretization/discretization.h>

#include <map>

namespace Amontons
{
  // A quadrature point of a boundary face of an owned cell where another body lies on it: pressure does not
  // act there.
  template <int dim>
  struct CoveredPoint
  {
    typename DoFHandler<dim>::active_cell_iterator cell;
    unsigned int                                   face;
    Point<dim>                                     unit_point; // of the cell
    double                                         weight; // area, of the full turn in axisymmetric scenes
  };

  // Body forces, tractions, pressures (on the exposed part of a face: its integral minus that over the
  // covered points), total forces (as uniform tractions) and the forces and moments on rigid motions, on
  // unconstrained degrees of freedom.
  //
  // With u (finite strain; readable at relevant DoFs), pressures act on the current surface, along its normal
  // and per current area, which is also that of the covered points' weights (plane stress: per reference
  // thickness). All other loads keep their direction and are per reference area and volume. Expressions are
  // of the reference position.
  template <int dim>
  LA::Vector
  assemble_loads(const Discretization<dim>            &discretization,
                 const double                          t,
                 const std::vector<CoveredPoint<dim>> &covered,
                 const LA::Vector                     *u = nullptr);

  // What `pressure` (where nothing touches) and `traction` put on faces, which may be in contact as well.
  // Total forces are left out.
  template <int dim>
  class FaceLoads
  {
  public:
    FaceLoads(const Discretization<dim>            &discretization,
              const double                          t,
              const std::vector<CoveredPoint<dim>> &covered);

    // Of an owned face, on a part of it with this area (measure() included), which all that touches lies in.
    std::vector<const ConditionData *>
    on(const typename DoFHandler<dim>::active_cell_iterator &cell,
       const unsigned int                                    face,
       const double                                          area) const;

    // Per area, at the reference point X with the normal n (finite strain: `traction` as if areas were those
    // of reference).
    Tensor<1, dim>
    traction(const std::vector<const ConditionData *> &conditions,
             const Point<dim>                         &X,
             const Tensor<1, dim>                     &n) const;

  private:
    const Discretization<dim>                              &discretization;
    const double                                            t;
    std::map<std::pair<unsigned int, unsigned int>, double> covered_areas; // by active cell and face
  };

  // d f/du of the loads f, by owned face under pressure: unsymmetric, and as if no point was covered.
  template <int dim>
  std::vector<LocalMatrix>
  pressure_stiffness(const Discretization<dim> &discretization, const double t, const LA::Vector &u);
} // namespace Amontons
