#include <amontons/base/gather.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/output/mesh_picture.h>

#include <iterator>
#include <set>

namespace Amontons
{
  namespace
  {
    // Points once round the unit square, n on each edge, then its centre.
    Quadrature<2>
    outline_points(const unsigned int n)
    {
      std::vector<Point<2>> points;
      for (unsigned int i = 0; i < n; ++i)
        points.emplace_back(double(i) / n, 0);
      for (unsigned int i = 0; i < n; ++i)
        points.emplace_back(1, double(i) / n);
      for (unsigned int i = 0; i < n; ++i)
        points.emplace_back(1 - double(i) / n, 1);
      for (unsigned int i = 0; i < n; ++i)
        points.emplace_back(0, 1 - double(i) / n);
      points.emplace_back(0.5, 0.5);
      return Quadrature<2>(points);
    }

    MeshPicture
    own_cells(const Discretization<2> &discretization,
              const StressRecovery<2> &recovery,
              const LA::Vector        &displacement,
              const double             rounding)
    {
      const Quadrature<2> points = outline_points(discretization.fe.degree);
      FEValues<2>         values(
          discretization.mapping(), discretization.fe, points, update_values | update_quadrature_points);
      FEValues<2> stress_values(
          discretization.mapping(), recovery.dof_handler().get_fe(), points, update_values);
      std::vector<Vector<double>> u(points.size(), Vector<double>(2));

      MeshPicture picture;
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && !discretization.geometry.is_carrier(cell->material_id()))
          {
            values.reinit(cell);
            values.get_function_values(displacement, u);
            stress_values.reinit(recovery.cell_of(cell));
            CellPicture result;
            for (unsigned int q = 0; q + 1 < points.size(); ++q)
              for (unsigned int d = 0; d < 2; ++d)
                result.outline.push_back(values.quadrature_point(q)[d] + u[q][d]);
            const double stress = von_mises<2>(recovery.values_at(stress_values).back());
            result.value        = stress < rounding ? 0 : stress;
            picture.push_back(result);
          }
      return picture;
    }
  } // namespace

  template <>
  MeshPicture
  gather_mesh_picture(const Discretization<2> &discretization,
                      const StressRecovery<2> &recovery,
                      const LA::Vector        &displacement,
                      const double             rounding)
  {
    std::vector<MeshPicture> parts = gather_on_first(
        discretization.geometry.communicator, own_cells(discretization, recovery, displacement, rounding));
    MeshPicture picture;
    for (MeshPicture &part : parts)
      std::move(part.begin(), part.end(), std::back_inserter(picture));
    return picture;
  }

  template <>
  MeshPicture
  gather_mesh_picture(const Discretization<3> &, const StressRecovery<3> &, const LA::Vector &, const double)
  {
    return {};
  }

  template <>
  MeshPicture
  make_pressure_picture(const ContactInterface<2> &,
                        const SurfaceFields<2> &,
                        const std::array<unsigned int, 2> &)
  {
    return {};
  }

  template <>
  MeshPicture
  make_pressure_picture(const ContactInterface<3>         &interface,
                        const SurfaceFields<3>            &fields,
                        const std::array<unsigned int, 2> &axes)
  {
    const auto            &slave = *interface.slave;
    std::set<unsigned int> opposite;
    for (const auto &point : interface.coupling.points)
      opposite.insert(point.slave_face);
    const auto  outline = outline_points(slave.degree);
    MeshPicture picture;
    for (const unsigned int f : opposite)
      {
        CellPicture cell;
        for (unsigned int q = 0; q + 1 < outline.size(); ++q)
          {
            const Point<3> X = slave.position(f, outline.point(q));
            for (const unsigned int axis : axes)
              cell.outline.push_back(X[axis]);
          }
        cell.value = std::max(0., value_on_face(slave, fields.pressure, f, Point<2>(0.5, 0.5)));
        picture.push_back(cell);
      }
    return picture;
  }
} // namespace Amontons
