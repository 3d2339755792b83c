#include <amontons/adaptivity/face_points.h>
#include <amontons/adaptivity/mesh_difference.h>
#include <amontons/contact/common_normal.h>
#include <amontons/contact/face_basis.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    struct Squares
    {
      double pressure = 0, shear = 0, pressure_difference = 0, shear_difference = 0;
      double unrefined = 0; // of pressure
    };

    // Of one slave face; now, before, normals: nodal values of its surface.
    template <int dim>
    void
    add_face(const ContactSurface<dim>         &slave,
             const unsigned int                 face,
             const FacePoints<dim>             &points,
             const std::vector<Tensor<1, dim>> &now,
             const std::vector<Tensor<1, dim>> &before,
             const std::vector<Tensor<1, dim>> &normals,
             const PairData                    &pair,
             const double                       weight_of_pair,
             Squares                           &squares)
    {
      if (points.knows_master() && !points.covers(face)) // what is there is a continuation
        return;
      for (const auto &point : points.knows_master() ? points.on(face) : points.on_whole(face))
        {
          const auto    &xi     = point.xi;
          const double   weight = weight_of_pair * point.weight;
          Tensor<1, dim> n      = slave.face_normal(face, xi), value, difference;
          const auto     N      = lagrange_values<dim - 1>(slave.degree, xi);
          n                     = turned_normal(slave, face, N, n, normals);
          for (unsigned int i = 0; i < N.size(); ++i)
            {
              const unsigned int node = slave.faces[face].nodes[i];
              value += N[i] * now[node];
              difference += N[i] * (now[node] - before[node]);
            }
          // where surfaces are tied the whole traction counts, as in estimate_error
          const auto normal_part = [&](const Tensor<1, dim> &v) { return pair.tied ? v : (v * n) * n; };
          squares.pressure += weight * normal_part(value).norm_square();
          squares.pressure_difference += weight * normal_part(difference).norm_square();
          if (!pair.has_friction())
            continue;
          squares.shear += weight * (value - normal_part(value)).norm_square();
          squares.shear_difference += weight * (difference - normal_part(difference)).norm_square();
        }
    }

    // Nodal values of a field on one surface.
    template <int dim>
    std::vector<Tensor<1, dim>>
    values_on(const ContactSurface<dim> &surface, const LA::Vector &field)
    {
      std::vector<Tensor<1, dim>> values(surface.nodes.size());
      for (unsigned int n = 0; n < values.size(); ++n)
        for (unsigned int c = 0; c < dim; ++c)
          values[n][c] = field(surface.nodes[n].dofs[c]);
      return values;
    }

    double
    ratio(const double difference, const double whole)
    {
      return whole > 0 ? std::sqrt(difference / whole) : 0;
    }

    // Of the pressure of all pairs, in the mean square.
    constexpr double noteworthy_part = 0.1;

    // By what part the error falls, as recovery sees it.
    double
    reduction(const double eta_before, const double eta)
    {
      return std::min(0.8, eta / eta_before);
    }
  } // namespace

  double
  factor_by_difference(const double difference, const double eta_before, const double eta)
  {
    const double q = reduction(eta_before, eta);
    return eta_before > 0 ? difference / (eta_before * std::sqrt(1 - q * q)) : 1;
  }

  double
  error_by_difference(const double difference, const double eta_before, const double eta)
  {
    if (!(eta_before > 0))
      return eta;
    const double e    = factor_by_difference(difference, eta_before, eta) * eta_before;
    const double left = std::sqrt(std::max(0., eta_before * eta_before - difference * difference));
    return std::max({eta, e * reduction(eta_before, eta), std::sqrt(eta * left)});
  }

  double
  error_by_comparisons(const double     difference,
                       const double     eta_before,
                       const double     eta,
                       RecoveryFactors &factors,
                       const bool       may_grow)
  {
    constexpr double least = 0.25, safety = 1.4;
    const double     of_coarser = factor_by_difference(difference, eta_before, eta);
    const double     next       = of_coarser * std::max(1., may_grow ? of_coarser / factors.of_coarser : 1.);
    const double     proven     = safety * std::max({next, factors.of_coarser, least});
    const double     error = proven < 1 ? proven * eta : error_by_difference(difference, eta_before, eta);
    factors                = {eta > 0 ? error / eta : 1, of_coarser};
    return error;
  }

  namespace
  {
    // Where not all that bears pressure is refined, differences may only say that errors are larger.
    double
    error_now(const double     difference,
              const double     eta_before,
              const double     eta,
              const bool       is_refined,
              const bool       may_grow,
              RecoveryFactors &factors)
    {
      if (is_refined)
        return error_by_comparisons(difference, eta_before, eta, factors, may_grow);
      return std::max(factors.of_this, factor_by_difference(difference, eta_before, eta)) * eta;
    }
  } // namespace

  template <int dim>
  std::vector<std::size_t>
  numbers_of_nodes(const std::vector<ContactInterface<dim>> &interfaces)
  {
    std::vector<std::size_t> numbers;
    numbers.reserve(interfaces.size());
    for (const auto &interface : interfaces)
      numbers.push_back(interface.slave->nodes.size());
    return numbers;
  }

  template <int dim>
  LA::Vector
  surface_tractions(const Discretization<dim>                &discretization,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const std::vector<SurfaceFields<dim>>    &fields)
  {
    LA::Vector sum     = discretization.make_owned_vector();
    const auto weights = pair_weights(interfaces, fields);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (unsigned int n = 0; weights[i] > 0 && n < interfaces[i].slave->nodes.size(); ++n)
        {
          const auto          &node = interfaces[i].slave->nodes[n];
          const Tensor<1, dim> t    = fields[i].pressure[n] * fields[i].normal[n] - fields[i].traction[n];
          for (unsigned int c = 0; c < dim; ++c)
            if (discretization.locally_owned.is_element(node.dofs[c]))
              sum(node.dofs[c]) += t[c];
        }
    sum.compress(VectorOperation::add);
    LA::Vector result = discretization.make_relevant_vector();
    result            = sum;
    return result;
  }

  namespace
  {
    template <int dim>
    Squares
    changes(const Discretization<dim>                &discretization,
            const std::vector<ContactInterface<dim>> &interfaces,
            const std::vector<SurfaceFields<dim>>    &fields,
            const CoarserTractions<dim>              &before)
    {
      const LA::Vector now     = surface_tractions(discretization, interfaces, fields);
      const auto       weights = pair_weights(interfaces, fields);
      const auto       numbers = numbers_of_nodes(interfaces);
      Squares          squares;
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        {
          const auto &interface = interfaces[i];
          const auto  values    = values_on(*interface.slave, now),
                     old        = values_on(*interface.slave, before.traction);
          const FacePoints<dim> points(
              interface, QGauss<1>(discretization.fe.degree + 1), discretization.scene);
          const double of_others = squares.pressure;
          for (unsigned int f = 0; f < interface.slave->faces.size(); ++f)
            add_face(*interface.slave,
                     f,
                     points,
                     values,
                     old,
                     fields[i].normal,
                     *interface.pair,
                     weights[i],
                     squares);
          if (numbers[i] == before.n_nodes[i])
            squares.unrefined += squares.pressure - of_others;
        }
      return squares;
    }
  } // namespace

  template <int dim>
  void
  combine_with_difference(const Discretization<dim>                &discretization,
                          const std::vector<ContactInterface<dim>> &interfaces,
                          const std::vector<SurfaceFields<dim>>    &fields,
                          const PlaceInHistory                     &place,
                          CoarserTractions<dim>                    &before,
                          ErrorEstimate<dim>                       &error)
  {
    double pressure = error.recovered.pressure * before.pressure.of_this,
           shear    = error.recovered.shear * before.shear.of_this;
    if (error.pressure_norm > 0 && before.traction.size() == discretization.dof_handler.n_dofs() &&
        before.place.t == place.t && before.place.increment_length == place.increment_length)
      {
        const Squares squares    = changes(discretization, interfaces, fields, before);
        const bool    is_refined = squares.unrefined <= std::pow(noteworthy_part, 2) * squares.pressure;
        pressure                 = error_now(ratio(squares.pressure_difference, squares.pressure),
                             before.recovered.pressure,
                             error.recovered.pressure,
                             is_refined,
                             true,
                             before.pressure);
        shear                    = error_now(ratio(squares.shear_difference,
                                std::max(squares.shear, std::pow(noteworthy_shear, 2) * squares.pressure)),
                          before.recovered.shear,
                          error.recovered.shear,
                          is_refined,
                          dim == 2,
                          before.shear);
      }
    error.contact = std::hypot(
        std::hypot(pressure, error.doubted.pressure), error.facets, std::hypot(error.data, error.pollution));
    error.shear = std::hypot(shear, error.doubted.shear, shear > 0 ? error.sections : 0.);
  }

  template std::vector<std::size_t>
  numbers_of_nodes(const std::vector<ContactInterface<2>> &);
  template std::vector<std::size_t>
  numbers_of_nodes(const std::vector<ContactInterface<3>> &);
  template LA::Vector
  surface_tractions(const Discretization<2> &,
                    const std::vector<ContactInterface<2>> &,
                    const std::vector<SurfaceFields<2>> &);
  template LA::Vector
  surface_tractions(const Discretization<3> &,
                    const std::vector<ContactInterface<3>> &,
                    const std::vector<SurfaceFields<3>> &);
  template void
  combine_with_difference(const Discretization<2> &,
                          const std::vector<ContactInterface<2>> &,
                          const std::vector<SurfaceFields<2>> &,
                          const PlaceInHistory &,
                          CoarserTractions<2> &,
                          ErrorEstimate<2> &);
  template void
  combine_with_difference(const Discretization<3> &,
                          const std::vector<ContactInterface<3>> &,
                          const std::vector<SurfaceFields<3>> &,
                          const PlaceInHistory &,
                          CoarserTractions<3> &,
                          ErrorEstimate<3> &);
} // namespace Amontons
