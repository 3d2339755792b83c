#include <amontons/base/points.h>
#include <amontons/adaptivity/bulk_error.h>
#include <amontons/adaptivity/edge_error.h>
#include <amontons/adaptivity/error_estimator.h>
#include <amontons/adaptivity/facet_error.h>
#include <amontons/adaptivity/gap_error.h>
#include <amontons/adaptivity/master_traction.h>
#include <amontons/adaptivity/nominal_area.h>
#include <amontons/adaptivity/pair_parts.h>
#include <amontons/adaptivity/pollution_error.h>
#include <amontons/adaptivity/unseen_contact.h>
#include <amontons/contact/common_normal.h>
#include <amontons/contact/face_basis.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor_product_polynomials.h>

#include <deque>

namespace Amontons
{
  namespace
  {
    Vector<float>
    roots(const std::vector<double> &squares)
    {
      Vector<float> result(squares.size());
      for (unsigned int c = 0; c < squares.size(); ++c)
        result[c] = std::sqrt(squares[c]);
      return result;
    }

    template <int dim>
    class Estimation
    {
    public:
      using Cell       = typename DoFHandler<dim>::active_cell_iterator;
      using Conditions = std::vector<const ConditionData *>;

      // displacement: where areas are nominal (see NominalArea).
      Estimation(const Discretization<dim> &discretization,
                 const StressRecovery<dim> &recovery,
                 const FaceLoads<dim>      *face_loads,
                 const double               largest_displacement,
                 const LA::Vector          *displacement)
          : discretization(discretization), recovery(recovery), face_loads(face_loads),
            kind(discretization.scene.kind), gauss(discretization.fe.degree + 1),
            gauss_polynomials(Polynomials::generate_complete_Lagrange_basis(
                QGauss<1>(discretization.fe.degree + 1).get_points())),
            on_face(discretization.fe.degree + 2), rounding(2e-14 * largest_displacement),
            bulk(bulk_error(discretization, recovery, rounding)), squares(bulk.squares),
            contact_squares(squares.size()), pollution_squares(squares.size()), shear_squares(squares.size()),
            unseen(squares.size())
      {
        prepare_faces(displacement);
      }

      void
      add_interface(const ContactInterface<dim> &interface,
                    const SurfaceFields<dim>    &fields,
                    const SurfaceApproach<dim>  &approach,
                    const double                 weight_of_pair,
                    const double                 doubt,
                    const bool                   is_unresolved, // and too light to count in full
                    const bool                   has_geometric_gap)
      {
        const ContactSurface<dim> &slave = *interface.slave;
        std::vector<bool>          has_row(slave.nodes.size(), false);
        for (const auto &row : interface.coupling.rows)
          has_row[row.node] = true;

        // By slave face: eta_F^2, then the squared errors of pressure and shear, and what is unseen.
        const unsigned int n       = slave.faces.size();
        const double       modulus = combined_modulus(discretization.scene, interface);
        const auto         near    = faces_near_contact(interface, fields);
        peaks.emplace_back();
        const FacePoints<dim> points(
            interface, QGauss<1>(discretization.fe.degree + 2), discretization.scene);
        const PairParts<dim> parts{
            points,
            near,
            edge_errors(interface, fields, discretization.scene, on_face),
            gap_errors(interface, fields, modulus, kind, near),
            friction_errors(interface, fields, kind),
            tractions_of_master(discretization, recovery, interface, points, face_loads),
            weight_of_pair,
            doubt * doubt - 1};
        facets_of.push_back(has_geometric_gap ? facet_error(interface, fields, modulus) : FacetError());
        facets_of.back().pressure *= weight_of_pair;
        const auto is_unseen =
            is_unresolved
                ? faces_that_press(interface, fields)
                : faces_of_unseen_contact(interface, fields, approach, parts.gap, near, modulus, kind);
        gap_square += weight_of_pair * sum_of_smooth_gap(interface, parts.gap, my_rank());
        std::vector<double> face_squares(4 * n, 0.);
        for (unsigned int f = 0; f < slave.faces.size(); ++f)
          if (slave.faces[f].rank == my_rank() &&
              std::any_of(slave.faces[f].nodes.begin(),
                          slave.faces[f].nodes.end(),
                          [&](const unsigned int i) { return has_row[i]; }))
            std::tie(face_squares[f], face_squares[n + f], face_squares[2 * n + f]) =
                add_slave_face(interface, fields, parts, f);
        add_unseen(slave, is_unseen, face_squares);
        Utilities::MPI::sum(make_array_view(std::as_const(face_squares)),
                            discretization.geometry.communicator,
                            make_array_view(face_squares));
        if (interface.master_surface)
          add_masters(interface, face_squares);
      }

      // What the errors of the stress, which are known by now, do to the pressure of a pair.
      void
      add_pollution(const ContactInterface<dim> &interface,
                    const SurfaceFields<dim>    &fields,
                    const double                 weight_of_pair,
                    const LA::Vector            *displacement)
      {
        const auto error = pollution_error(discretization,
                                           interface,
                                           fields,
                                           combined_modulus(discretization.scene, interface),
                                           squares,
                                           displacement);
        pollution_square += weight_of_pair * error.square;
        for (unsigned int c = 0; c < error.by_cell.size(); ++c)
          pollution_squares[c] += weight_of_pair * error.by_cell[c];
      }

      ErrorEstimate<dim>
      result() const
      {
        const auto total = [&](const double part) {
          return Utilities::MPI::sum(part, discretization.geometry.communicator);
        };
        const auto relative = [](const double error, const double reference) {
          return reference > 0 ? std::sqrt(error / reference) : 0.;
        };
        ErrorEstimate<dim> estimate;
        estimate.cell_indicators      = roots(squares);
        estimate.contact_indicators   = roots(contact_squares);
        estimate.pollution_indicators = roots(pollution_squares);
        estimate.shear_indicators     = roots(shear_squares);
        const double all_unseen       = total(n_unseen);
        const auto   or_none          = [](const double square, const double none) {
          return square > none ? square : 0;
        };
        double pressure = or_none(total(pressure_square), total(no_pressure_square));
        if (all_unseen > 0 && pressure == 0)
          pressure = all_unseen;
        const double energy    = or_none(total(bulk.energy), total(bulk.no_energy)),
                     shear     = std::max(total(shear_square), std::pow(noteworthy_shear, 2) * pressure);
        estimate.energy_norm   = std::sqrt(energy);
        estimate.pressure_norm = std::sqrt(pressure);
        estimate.shear_norm    = std::sqrt(shear);
        estimate.bulk          = relative(total(bulk.error), energy);
        estimate.contact       = relative(total(pressure_error), pressure);
        estimate.shear         = relative(total(shear_error), shear);
        estimate.recovered     = {estimate.contact, estimate.shear};
        estimate.doubted = {relative(total(hidden_pressure), pressure), relative(total(hidden_shear), shear)};
        estimate.facets_of = facets_of;
        double facets      = 0;
        for (auto &of_pair : estimate.facets_of)
          {
            facets += of_pair.pressure;
            of_pair.pressure = relative(of_pair.pressure, pressure);
          }
        if (const double all_shear = total(shear_sum); all_shear > 0)
          estimate.friction_data = total(friction_resultants) / all_shear;
        double difference = 0, highest = 0;
        for (auto peak : peaks)
          {
            for (double &value : peak)
              value = Utilities::MPI::max(value, discretization.geometry.communicator);
            difference = std::max(difference, std::abs(peak[1] - peak[0]));
            highest    = std::max(highest, peak[0]);
          }
        estimate.peak      = highest > 0 ? difference / highest : 0;
        estimate.facets    = relative(facets, pressure);
        estimate.pollution = relative(pollution_square, pressure);
        estimate.contact   = std::hypot(
            std::hypot(estimate.contact, estimate.facets), estimate.doubted.pressure, estimate.pollution);
        estimate.shear = std::hypot(estimate.shear, estimate.doubted.shear);
        add_facets_of_bodies(energy, pressure, estimate);
        if (total(gap_square) > pressure) // meshes that miss the same ridges agree in all numbers
          estimate.data = 1;
        if (all_unseen > 0) // as large as all that is seen
          {
            estimate.data    = 1;
            estimate.contact = std::hypot(estimate.contact, estimate.data);
            for (unsigned int c = 0; c < squares.size(); ++c)
              estimate.contact_indicators[c] =
                  std::hypot(estimate.contact_indicators[c], std::sqrt(unseen[c] * pressure / all_unseen));
          }
        return estimate;
      }

    private:
      // By that part of the energy, a linear functional of what is missing, all tractions may be off. Their
      // cells are refined where that is most of the error: on coarse meshes the energy of a contact is spread
      // to facets that have little of it.
      void
      add_facets_of_bodies(const double energy, const double pressure, ErrorEstimate<dim> &estimate) const
      {
        double missing = std::accumulate(bulk.missing.begin(), bulk.missing.end(), 0.);
        missing        = Utilities::MPI::sum(missing, discretization.geometry.communicator);
        if (missing == 0 || energy == 0)
          return;
        estimate.sections   = missing / energy;
        const double others = pressure > 0 ? std::max(estimate.contact, estimate.shear)
                                           : std::max(0., std::pow(estimate.bulk, 2) - estimate.sections);
        const double square = std::pow(estimate.sections, 2) * pressure;
        for (unsigned int c = 0; estimate.sections > others && c < bulk.missing.size(); ++c)
          {
            estimate.pollution_indicators[c] =
                std::sqrt(pollution_squares[c] + square * bulk.missing[c] / missing);
            estimate.cell_indicators[c] = std::sqrt(squares[c] + bulk.missing[c]);
          }
        estimate.pollution = std::hypot(estimate.pollution, pressure > 0 ? estimate.sections : 0.);
        if (estimate.contact > 0)
          estimate.contact = std::hypot(estimate.contact, estimate.sections);
        if (estimate.shear > 0)
          estimate.shear = std::hypot(estimate.shear, estimate.sections);
      }

      unsigned int
      my_rank() const
      {
        return Utilities::MPI::this_mpi_process(discretization.geometry.communicator);
      }

      Cell
      recovery_cell(const Cell &cell) const
      {
        return Cell(
            &discretization.geometry.triangulation, cell->level(), cell->index(), &recovery.dof_handler());
      }

      // By face number: sigma* at the points of the face, and the matrix that continues sigma_h there from
      // the Gauss points.
      void
      prepare_faces(const LA::Vector *displacement)
      {
        for (const unsigned int f : GeometryInfo<dim>::face_indices())
          {
            std::vector<Point<dim>> points;
            FullMatrix<double>      matrix(on_face.size(), gauss.size());
            for (unsigned int q = 0; q < on_face.size(); ++q)
              {
                points.push_back(on_unit_cell<dim>(f, on_face.point(q)));
                for (unsigned int s = 0; s < gauss.size(); ++s)
                  matrix(q, s) = gauss_polynomials.compute_value(s, points.back());
              }
            continuation.push_back(matrix);
            recovered_on_face.push_back(std::make_unique<FEValues<dim>>(discretization.mapping(),
                                                                        recovery.dof_handler().get_fe(),
                                                                        Quadrature<dim>(points),
                                                                        update_values));
            if (displacement != nullptr)
              areas.emplace_back(discretization, points, *displacement);
          }
      }

      std::vector<Voigt<dim>>
      stress_on_face(const Cell &cell, const unsigned int f) const
      {
        const auto             &inside = recovery.unsmoothed(cell->active_cell_index());
        std::vector<Voigt<dim>> result(on_face.size(), Voigt<dim>());
        for (unsigned int q = 0; q < result.size(); ++q)
          for (unsigned int s = 0; s < inside.size(); ++s)
            for (unsigned int k = 0; k < n_voigt<dim>; ++k)
              result[q][k] += continuation[f](q, s) * inside[s][k];
        return result;
      }

      Tensor<1, dim>
      load_at(const Conditions     &loads,
              const Cell           &cell,
              const unsigned int    f,
              const Point<dim - 1> &xi,
              const Tensor<1, dim> &n) const
      {
        if (loads.empty())
          return {};
        return face_loads->traction(
            loads, discretization.mapping().transform_unit_to_real_cell(cell, on_unit_cell<dim>(f, xi)), n);
      }

      // eta_F^2 of an owned slave face, and, near the contact, its parts of the squared L2 errors of the
      // pressure and, with friction, of the shear.
      std::tuple<double, double, double>
      add_slave_face(const ContactInterface<dim> &interface,
                     const SurfaceFields<dim>    &fields,
                     const PairParts<dim>        &parts,
                     const unsigned int           face)
      {
        const ContactSurface<dim> &slave = *interface.slave;
        const auto &[cell, f]            = slave.owned[slave.faces[face].owned_index];
        if (!discretization.is_deformable(cell->material_id()))
          return {0., 0., 0.};
        recovered_on_face[f]->reinit(recovery_cell(cell));
        const auto sigma      = stress_on_face(cell, f);
        const auto smooth     = recovery.values_at(*recovered_on_face[f]);
        const bool is_nominal = !areas.empty() && (interface.pair->tied || kind == ProblemType::plane_stress);
        if (is_nominal)
          areas[f].reinit(cell);
        const auto   points = parts.points.on(face);
        const double area   = std::accumulate(
            points.begin(), points.end(), 0., [](auto sum, const auto &p) { return sum + p.weight; });
        const auto   loads     = face_loads == nullptr ? Conditions() : face_loads->on(cell, f, area);
        const double no_stress = stress_of_rounding<dim>(discretization, cell, rounding);
        double       square = 0, pressure_part = 0, shear_part = 0;
        for (const auto &[xi, weight, interpolation, overlap] : points)
          {
            const Tensor<1, dim> n      = slave.face_normal(face, xi);
            const auto           N      = lagrange_values<dim - 1>(slave.degree, xi);
            const auto           common = turned_normal(slave, face, N, n, fields.normal);
            double               p      = 0;
            Tensor<1, dim>       shear;
            for (unsigned int i = 0; parts.points.covers(face) && i < N.size(); ++i)
              {
                p += N[i] * fields.pressure[slave.faces[face].nodes[i]];
                shear += N[i] * fields.traction[slave.faces[face].nodes[i]];
              }
            const Tensor<1, dim> load = load_at(loads, cell, f, xi, n);
            Tensor<1, dim>       t = -load, t_star = -load;
            for (unsigned int q = 0; q < interpolation.size(); ++q)
              {
                if (interpolation[q] == 0) // all but one, on whole faces
                  continue;
                const Tensor<1, dim> area = is_nominal ? areas[f].vector(q, n, interface.pair->tied) : n;
                t += interpolation[q] * times_vector<dim>(sigma[q], area);
                t_star += interpolation[q] * times_vector<dim>(smooth[q], area);
              }
            if (const auto of_master = parts.of_master.find(overlap);
                of_master != parts.of_master.end() && !is_nominal)
              t_star = of_master->second;
            const double mismatch = p + common * t;
            square += weight * mismatch * mismatch;
            if (!interface.pair->tied)
              square += weight * (t - (common * t) * common - shear).norm_square();
            if (!parts.near[face] || (parts.points.knows_master() && !parts.points.covers(face)))
              continue;
            no_pressure_square += parts.weight * weight * no_stress * no_stress;
            const double p_star = -(common * t_star);
            if (interface.pair->has_friction())
              {
                shear_part += parts.weight * weight * (t_star + p_star * common - shear).norm_square();
                shear_square += parts.weight * weight * shear.norm_square();
                shear_sum += weight * shear.norm();
              }
            if (interface.pair->tied) // where it may be turned, the pressure says nothing
              {
                pressure_part += weight * (t_star + p * n - shear).norm_square();
                pressure_square += parts.weight * weight * (p * n - shear).norm_square();
                continue;
              }
            peaks.back()[0] = std::max(peaks.back()[0], p);
            peaks.back()[1] = std::max(peaks.back()[1], p_star);
            pressure_part += weight * (p_star - p) * (p_star - p);
            pressure_square += parts.weight * weight * p * p;
          }
        square *= slave.faces[face].size / discretization.scene.bodies[cell->material_id()].material.young;
        pressure_part = parts.weight * (pressure_part + parts.edge[face] + parts.gap[face]);
        shear_part += parts.weight * parts.friction[face].square;
        friction_resultants += parts.friction[face].resultant;
        shear_error += shear_part;
        pressure_error += pressure_part;
        hidden_shear += parts.hidden * shear_part;
        hidden_pressure += parts.hidden * pressure_part;
        const double all_shear = (1 + parts.hidden) * shear_part, all = (1 + parts.hidden) * pressure_part;
        squares[cell->active_cell_index()] += square;
        contact_squares[cell->active_cell_index()] += all;
        shear_squares[cell->active_cell_index()] += all_shear;
        return {square, all, all_shear};
      }

      void
      add_unseen(const ContactSurface<dim> &slave,
                 const std::vector<bool>   &is_unseen,
                 std::vector<double>       &face_squares)
      {
        for (unsigned int f = 0; f < is_unseen.size(); ++f)
          if (is_unseen[f] && slave.faces[f].rank == my_rank())
            {
              face_squares[3 * is_unseen.size() + f] = 1;
              unseen[slave.owned[slave.faces[f].owned_index].first->active_cell_index()] += 1;
              ++n_unseen;
            }
      }

      // Each slave face's eta_F^2 is shared out by area between the master faces opposite.
      void
      add_masters(const ContactInterface<dim> &interface, const std::vector<double> &face_squares)
      {
        const ContactSurface<dim> &master = *interface.master_surface;
        const unsigned int         n      = interface.slave->faces.size();
        std::vector<double>        areas(n, 0.);
        for (const auto &point : interface.coupling.points)
          areas[point.slave_face] += point.weight;
        for (const auto &point : interface.coupling.points)
          if (point.master_face != numbers::invalid_unsigned_int && areas[point.slave_face] > 0 &&
              master.faces[point.master_face].rank == my_rank())
            {
              const auto &cell = master.owned[master.faces[point.master_face].owned_index].first;
              if (!discretization.is_deformable(cell->material_id()))
                continue;
              const double share = point.weight / areas[point.slave_face] * part_of_master(interface, point);
              squares[cell->active_cell_index()] += share * face_squares[point.slave_face];
              contact_squares[cell->active_cell_index()] += share * face_squares[n + point.slave_face];
              shear_squares[cell->active_cell_index()] += share * face_squares[2 * n + point.slave_face];
              unseen[cell->active_cell_index()] += share * face_squares[3 * n + point.slave_face];
            }
      }

      const Discretization<dim>          &discretization;
      const StressRecovery<dim>          &recovery;
      const FaceLoads<dim>               *face_loads;
      const ProblemType                   kind;
      const QGauss<dim>                   gauss;
      const TensorProductPolynomials<dim> gauss_polynomials; // Lagrange polynomials of the Gauss points
      const QGauss<dim - 1>               on_face;
      std::vector<FullMatrix<double>>     continuation;
      std::vector<std::unique_ptr<FEValues<dim>>> recovered_on_face;
      std::deque<NominalArea<dim>>                areas;    // by face number; finite strain
      std::vector<std::array<double, 2>>          peaks;    // by interface: of the pressure, of -n . sigma* n
      const double                                rounding; // of differences of displacements
      const BulkError                             bulk;
      // by active cell
      std::vector<double> squares, contact_squares, pollution_squares, shear_squares, unseen;
      double              pollution_square = 0; // of all ranks
      // of this rank
      double no_pressure_square = 0, pressure_error = 0, pressure_square = 0, shear_error = 0,
             hidden_pressure = 0, hidden_shear = 0, shear_square = 0, n_unseen = 0, friction_resultants = 0,
             shear_sum = 0, gap_square = 0;
      std::vector<FacetError> facets_of;
    };
  } // namespace

  template <int dim>
  ErrorEstimate<dim>
  estimate_error(const Discretization<dim>                &discretization,
                 const StressRecovery<dim>                &recovery,
                 const std::vector<ContactInterface<dim>> &interfaces,
                 const std::vector<SurfaceFields<dim>>    &fields,
                 const LA::Vector                         &displacement,
                 const bool                                finite_strain,
                 const FaceLoads<dim>                     *face_loads,
                 const std::vector<double>                &doubts)
  {
    double largest = 0;
    for (const auto dof : discretization.locally_owned)
      largest = std::max(largest, std::abs(displacement(dof)));
    largest = Utilities::MPI::max(largest, discretization.geometry.communicator);
    const bool any_nominal =
        discretization.scene.kind == ProblemType::plane_stress ||
        std::any_of(interfaces.begin(), interfaces.end(), [](const auto &i) { return i.pair->tied; });
    Estimation<dim> estimation(discretization,
                               recovery,
                               face_loads,
                               largest,
                               any_nominal && finite_strain ? &displacement : nullptr);
    const auto      weights = pair_weights(interfaces, fields);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      estimation.add_pollution(interfaces[i], fields[i], weights[i], finite_strain ? &displacement : nullptr);
    const auto is_unresolved = unresolved_pairs(interfaces, fields);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      estimation.add_interface(interfaces[i],
                               fields[i],
                               SurfaceApproach<dim>(discretization, interfaces[i], displacement),
                               weights[i],
                               doubts.empty() ? 1. : doubts[i],
                               is_unresolved[i] && weights[i] >= largest_pair_weight * (1 - 1e-12),
                               finite_strain || !interfaces[i].pair->initial_gap);
    return estimation.result();
  }

  template ErrorEstimate<2>
  estimate_error(const Discretization<2> &,
                 const StressRecovery<2> &,
                 const std::vector<ContactInterface<2>> &,
                 const std::vector<SurfaceFields<2>> &,
                 const LA::Vector &,
                 const bool,
                 const FaceLoads<2> *,
                 const std::vector<double> &);
  template ErrorEstimate<3>
  estimate_error(const Discretization<3> &,
                 const StressRecovery<3> &,
                 const std::vector<ContactInterface<3>> &,
                 const std::vector<SurfaceFields<3>> &,
                 const LA::Vector &,
                 const bool,
                 const FaceLoads<3> *,
                 const std::vector<double> &);
} // namespace Amontons
