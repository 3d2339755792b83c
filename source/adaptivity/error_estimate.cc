#include <amontons/adaptivity/error_estimator.h>
#include <amontons/adaptivity/face_points.h>
#include <amontons/elasticity/linear_elastic.h>

namespace Amontons
{
  template <int dim>
  Vector<float>
  ErrorEstimate<dim>::indicators_for(const double target) const
  {
    Vector<float> result(cell_indicators.size());
    const auto    add = [&](const Vector<float> &part, const double norm, const double weight) {
      for (unsigned int c = 0; norm > 0 && c < result.size(); ++c)
        result[c] += weight * std::pow(part[c] / norm, 2);
    };
    add(contact_indicators, pressure_norm, 1);
    add(pollution_indicators, pressure_norm, 1);
    add(shear_indicators, shear_norm, 1);
    add(cell_indicators, energy_norm, std::min(1., 2 * target));
    for (auto &square : result)
      square = std::sqrt(square);
    return result;
  }

  template <int dim>
  std::vector<double>
  pair_weights(const std::vector<ContactInterface<dim>> &interfaces,
               const std::vector<SurfaceFields<dim>>    &fields)
  {
    std::vector<double> squares(interfaces.size(), 0.);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (const auto &row : interfaces[i].coupling.rows)
        squares[i] += interfaces[i].pair->tied ? fields[i].force[row.node].norm_square() / row.area
                                               : row.area * std::pow(fields[i].multiplier[row.node], 2);
    double of_tied = 0, of_others = 0; // the largest
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        double &of = interfaces[i].pair->tied ? of_tied : of_others;
        of         = std::max(of, squares[i]);
      }
    const double        largest = of_others > 0 ? of_others : of_tied;
    std::vector<double> weights;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      weights.push_back(interfaces[i].pair->tied && of_others > 0 ? 0.
                        : largest > 0 ? largest / std::max(squares[i], largest / largest_pair_weight)
                                      : 1.);
    return weights;
  }

  template <int dim>
  double
  combined_modulus(const Scene &scene, const ContactInterface<dim> &interface)
  {
    double compliance = 1 / contact_modulus(scene.bodies[interface.slave->body].material);
    if (master_deforms(interface, scene))
      compliance += 1 / contact_modulus(scene.bodies[interface.master_surface->body].material);
    return 1 / compliance;
  }

  template <int dim>
  void
  indicate_at_faces(const Discretization<dim>   &discretization,
                    const ContactInterface<dim> &interface,
                    const std::vector<double>   &of_faces,
                    Vector<float>               &indicators)
  {
    const unsigned int me = Utilities::MPI::this_mpi_process(discretization.geometry.communicator);
    const auto add = [&](const ContactSurface<dim> &side, const unsigned int face, const double value) {
      if (side.faces[face].rank != me)
        return;
      auto &cell = indicators[side.owned[side.faces[face].owned_index].first->active_cell_index()];
      cell       = std::max(cell, float(value));
    };
    for (unsigned int f = 0; f < of_faces.size(); ++f)
      if (of_faces[f] > 0)
        add(*interface.slave, f, of_faces[f]);
    for (const auto &point : interface.coupling.points)
      if (interface.master_surface && of_faces[point.slave_face] > 0)
        add(*interface.master_surface, point.master_face, of_faces[point.slave_face]);
  }

  template <int dim>
  Point<dim>
  place_of_largest(const Discretization<dim> &discretization, const Vector<float> &indicators)
  {
    const MPI_Comm communicator = discretization.geometry.communicator;
    double         largest      = -1;
    Point<dim>     place;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && indicators[cell->active_cell_index()] > largest)
        {
          largest = indicators[cell->active_cell_index()];
          place   = cell->center();
        }
    const auto of_ranks = Utilities::MPI::all_gather(communicator, std::make_pair(largest, place));
    return std::max_element(of_ranks.begin(),
                            of_ranks.end(),
                            [](const auto &a, const auto &b) { return a.first < b.first; })
        ->second;
  }

  template struct ErrorEstimate<2>;
  template struct ErrorEstimate<3>;

  template std::vector<double>
  pair_weights(const std::vector<ContactInterface<2>> &, const std::vector<SurfaceFields<2>> &);
  template std::vector<double>
  pair_weights(const std::vector<ContactInterface<3>> &, const std::vector<SurfaceFields<3>> &);
  template double
  combined_modulus(const Scene &, const ContactInterface<2> &);
  template double
  combined_modulus(const Scene &, const ContactInterface<3> &);
  template void
  indicate_at_faces(const Discretization<2> &,
                    const ContactInterface<2> &,
                    const std::vector<double> &,
                    Vector<float> &);
  template void
  indicate_at_faces(const Discretization<3> &,
                    const ContactInterface<3> &,
                    const std::vector<double> &,
                    Vector<float> &);
  template Point<2>
  place_of_largest(const Discretization<2> &, const Vector<float> &);
  template Point<3>
  place_of_largest(const Discretization<3> &, const Vector<float> &);
} // namespace Amontons
