#include <amontons/adaptivity/master_traction.h>
#include <amontons/base/points.h>
#include <amontons/elasticity/linear_elastic.h>

namespace Amontons
{
  namespace
  {
    // sigma* at a point of the unit cell.
    template <int dim>
    Voigt<dim>
    stress_at(const StressRecovery<dim>                            &recovery,
              const typename DoFHandler<dim>::active_cell_iterator &cell,
              const Point<dim>                                     &unit_point)
    {
      const auto                          &fe = recovery.dof_handler().get_fe();
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      recovery.cell_of(cell)->get_dof_indices(dofs);
      Voigt<dim> sigma{};
      for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const double N = fe.shape_value(i, unit_point);
          for (unsigned int k = 0; k < n_voigt<dim>; ++k)
            sigma[k] += N * recovery.stress()[k](dofs[i]);
        }
      return sigma;
    }
  } // namespace

  template <int dim>
  std::map<unsigned int, Tensor<1, dim>>
  tractions_of_master(const Discretization<dim>   &discretization,
                      const StressRecovery<dim>   &recovery,
                      const ContactInterface<dim> &interface,
                      const FacePoints<dim>       &face_points,
                      const FaceLoads<dim>        *face_loads)
  {
    if (!face_points.knows_master())
      return {};
    const ContactSurface<dim> &master = *interface.master_surface;
    const auto                &points = interface.coupling.points;
    std::vector<double>        areas(master.faces.size(), 0.);
    std::vector<unsigned int>  asked;
    for (unsigned int i = 0; i < points.size(); ++i)
      if (points[i].master_face != numbers::invalid_unsigned_int)
        {
          areas[points[i].master_face] += points[i].weight;
          if (face_points.is_at_edge(points[i].slave_face))
            asked.push_back(i);
        }

    const unsigned int  rank = Utilities::MPI::this_mpi_process(discretization.geometry.communicator);
    std::vector<double> values(dim * asked.size(), 0.);
    for (unsigned int k = 0; k < asked.size(); ++k)
      {
        const auto &point = points[asked[k]];
        const auto &face  = master.faces[point.master_face];
        if (face.rank != rank)
          continue;
        const auto &[cell, f]       = master.owned[face.owned_index];
        const Point<dim> unit_point = on_unit_cell<dim>(f, point.xi_master);
        const auto       m          = master.face_normal(point.master_face, point.xi_master);
        auto             traction   = -times_vector<dim>(stress_at(recovery, cell, unit_point), m);
        if (face_loads != nullptr)
          if (const auto loads = face_loads->on(cell, f, areas[point.master_face]); !loads.empty())
            traction += face_loads->traction(
                loads, discretization.mapping().transform_unit_to_real_cell(cell, unit_point), m);
        for (unsigned int d = 0; d < dim; ++d)
          values[dim * k + d] = traction[d];
      }
    Utilities::MPI::sum(make_array_view(std::as_const(values)),
                        discretization.geometry.communicator,
                        make_array_view(values));
    std::map<unsigned int, Tensor<1, dim>> result;
    for (unsigned int k = 0; k < asked.size(); ++k)
      for (unsigned int d = 0; d < dim; ++d)
        result[asked[k]][d] = values[dim * k + d];
    return result;
  }

  template <int dim>
  double
  part_of_master(const ContactInterface<dim> &interface, const OverlapPoint<dim> &point)
  {
    constexpr double much  = 0.25; // less apart, both are refined by turns
    const double     finer = interface.master_surface->faces[point.master_face].size /
                         interface.slave->faces[point.slave_face].size;
    return std::pow(std::min(1., finer / much), 4);
  }

  template double
  part_of_master(const ContactInterface<2> &, const OverlapPoint<2> &);
  template double
  part_of_master(const ContactInterface<3> &, const OverlapPoint<3> &);
  template std::map<unsigned int, Tensor<1, 2>>
  tractions_of_master(const Discretization<2> &,
                      const StressRecovery<2> &,
                      const ContactInterface<2> &,
                      const FacePoints<2> &,
                      const FaceLoads<2> *);
  template std::map<unsigned int, Tensor<1, 3>>
  tractions_of_master(const Discretization<3> &,
                      const StressRecovery<3> &,
                      const ContactInterface<3> &,
                      const FacePoints<3> &,
                      const FaceLoads<3> *);
} // namespace Amontons
