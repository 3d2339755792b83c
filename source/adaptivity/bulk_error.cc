#include <amontons/adaptivity/bulk_error.h>
#include <amontons/elasticity/linear_elastic.h>
#include <amontons/geometry/missing_volume.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    // Of the full turn in axisymmetric scenes.
    template <int dim>
    double
    missing_volume_of(const typename DoFHandler<dim>::active_cell_iterator &cell,
                      const Mapping<dim>                                   &mapping,
                      const ProblemType                                     kind)
    {
      double     volume  = 0;
      const auto corners = mapping.get_vertices(cell);
      for (const unsigned int f : cell->face_indices())
        if (const auto face = cell->face(f); face->at_boundary())
          {
            Point<dim> middle;
            for (unsigned int v = 0; v < face->n_vertices(); ++v)
              middle += corners[GeometryInfo<dim>::face_to_cell_vertices(f, v)] / double(face->n_vertices());
            volume += missing_volume<dim>(face, middle) * measure<dim>(kind, face->center());
          }
      return volume;
    }

    struct CellSums
    {
      double square = 0, energy = 0, volume = 0; // int eta^2, int sigma* : C^-1 : sigma* / 2, int
    };

    template <int dim>
    CellSums
    sum_over(const FEValues<dim>           &values,
             const std::vector<Voigt<dim>> &sigma,
             const std::vector<Voigt<dim>> &smooth,
             const MaterialData            &material,
             const ProblemType              kind)
    {
      CellSums sums;
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        {
          Voigt<dim> difference = smooth[q];
          for (unsigned int k = 0; k < n_voigt<dim>; ++k)
            difference[k] -= sigma[q][k];
          const double weight = values.JxW(q) * measure<dim>(kind, values.quadrature_point(q));
          sums.square += weight * complementary_energy<dim>(difference, material);
          sums.energy += weight * complementary_energy<dim>(smooth[q], material);
          sums.volume += weight;
        }
      return sums;
    }
  } // namespace

  template <int dim>
  BulkError
  bulk_error(const Discretization<dim> &discretization,
             const StressRecovery<dim> &recovery,
             const double               rounding)
  {
    const ProblemType kind   = discretization.scene.kind;
    const auto        degree = discretization.fe.degree;
    const QGauss<dim> gauss(degree + 1);
    FEValues<dim>     values(
        discretization.mapping(), discretization.fe, gauss, update_quadrature_points | update_JxW_values);
    FEValues<dim> recovered(discretization.mapping(), recovery.dof_handler().get_fe(), gauss, update_values);
    BulkError     result;
    result.squares.resize(discretization.geometry.triangulation.n_active_cells());
    result.missing = result.squares;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          values.reinit(cell);
          recovered.reinit(typename DoFHandler<dim>::active_cell_iterator(
              &discretization.geometry.triangulation, cell->level(), cell->index(), &recovery.dof_handler()));
          const unsigned int c        = cell->active_cell_index();
          const auto        &material = discretization.scene.bodies[cell->material_id()].material;
          const CellSums     sums =
              sum_over<dim>(values, recovery.unsmoothed(c), recovery.values_at(recovered), material, kind);
          if (degree == 1 && cell->at_boundary())
            result.missing[c] =
                sums.energy / sums.volume * missing_volume_of<dim>(cell, discretization.mapping(), kind);
          result.squares[c] = sums.square;
          result.error += sums.square + result.missing[c];
          result.energy += sums.energy;
          result.no_energy += sums.volume *
                              std::pow(stress_of_rounding<dim>(discretization, cell, rounding), 2) /
                              material.young;
        }
    return result;
  }

  template BulkError
  bulk_error(const Discretization<2> &, const StressRecovery<2> &, const double);
  template BulkError
  bulk_error(const Discretization<3> &, const StressRecovery<3> &, const double);
} // namespace Amontons
