#include <amontons/adaptivity/data_error.h>
#include <amontons/base/points.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/surface_samples.h>
#include <amontons/elasticity/kinematics.h>
#include <amontons/friction/shear_law.h>

#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  namespace
  {
    bool
    depends_on_place(const std::optional<Expression> &expression)
    {
      return expression && expression->depends_on_place();
    }

    template <int dim>
    FrictionError
    friction_error_of(const ContactInterface<dim> &interface,
                      const SurfaceFields<dim>    &fields,
                      const ProblemType            kind,
                      const Quadrature<dim - 1>   &points,
                      const unsigned int           face)
    {
      const auto &slave = *interface.slave;
      const auto &nodes = slave.faces[face].nodes;
      const auto  phi   = [&](const Point<dim> &X, const double p) {
        return shear_bound(*interface.pair, as_3d(X), interface.t, std::max(0., p)).value;
      };
      bool                slips = false;
      std::vector<double> bounds;
      for (const unsigned int i : nodes)
        {
          slips = slips || fields.state[i] == ContactStatus::slip;
          bounds.push_back(phi(slave.nodes[i].X, fields.pressure[i]));
        }
      FrictionError sums;
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          const auto    &xi = points.point(q);
          double         jacobian, p = 0, bound = 0;
          Tensor<1, dim> shear;
          const auto     N = lagrange_values<dim - 1>(slave.degree, xi);
          for (unsigned int i = 0; i < N.size(); ++i)
            {
              p += N[i] * fields.pressure[nodes[i]];
              bound += N[i] * bounds[i];
              shear += N[i] * fields.traction[nodes[i]];
            }
          slave.face_normal(face, xi, &jacobian);
          const double there = phi(slave.reference_position(face, xi), p),
                       d     = slips ? there - bound : std::max(0., shear.norm() - there),
                       area  = points.weight(q) * jacobian * measure<dim>(kind, slave.position(face, xi));
          sums.square += area * d * d;
          sums.resultant += area * d;
        }
      sums.resultant = std::abs(sums.resultant);
      return sums;
    }

    template <int dim>
    struct PrescribedFace
    {
      typename DoFHandler<dim>::active_cell_iterator cell;
      unsigned int                                   face;
      const ConditionData                           *condition;
    };

    // Those of this rank; none if the scene has no such condition.
    template <int dim>
    std::optional<std::vector<PrescribedFace<dim>>>
    faces_with_formulas(const Discretization<dim> &discretization)
    {
      const Scene                                        &scene = discretization.scene;
      std::map<types::boundary_id, const ConditionData *> conditions;
      for (const auto &condition : scene.conditions)
        if (std::any_of(condition.displacement.begin(), condition.displacement.end(), depends_on_place))
          for (const auto &name : condition.boundaries)
            conditions[discretization.geometry.boundary(name, scene).id] = &condition;
      if (conditions.empty())
        return {};
      std::vector<PrescribedFace<dim>> faces;
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          for (const unsigned int f : cell->face_indices())
            if (const auto found = conditions.find(cell->face(f)->boundary_id());
                cell->face(f)->at_boundary() && found != conditions.end())
              faces.push_back({cell, f, found->second});
      return faces;
    }

    // Of d at the points of a tensor product of lines: int d^2 and int |grad d|^2.
    template <int dim>
    double
    energy_of_trace(const std::vector<double>     &d,
                    const std::vector<Point<dim>> &X,
                    const std::vector<double>     &areas,
                    const unsigned int             n_line)
    {
      double square = 0, slope = 0;
      for (unsigned int q = 0; q < d.size(); ++q)
        {
          square += areas[q] * d[q] * d[q];
          for (unsigned int e = 0, stride = 1; e < dim - 1; ++e, stride *= n_line)
            if (q / stride % n_line + 1 < n_line)
              slope += areas[q] * std::pow((d[q + stride] - d[q]) / X[q + stride].distance(X[q]), 2);
        }
      return std::sqrt(square * slope);
    }
  } // namespace

  template <int dim>
  std::vector<FrictionError>
  friction_errors(const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const ProblemType            kind)
  {
    const auto                &slave = *interface.slave;
    const auto                &pair  = *interface.pair;
    std::vector<FrictionError> result(slave.faces.size());
    if (!pair.bound_depends_on_place())
      return result;
    const Quadrature<dim - 1> points(samples_along<dim>(slave.faces.size()));
    for (unsigned int f = 0; f < result.size(); ++f)
      {
        const auto &nodes   = slave.faces[f].nodes;
        const bool  presses = std::any_of(
            nodes.begin(), nodes.end(), [&](const unsigned int i) { return fields.pressure[i] > 0; });
        if (presses)
          result[f] = friction_error_of(interface, fields, kind, points, f);
      }
    return result;
  }

  template <int dim>
  void
  add_error_of_displacements(const Discretization<dim> &discretization,
                             const SolutionState<dim>  &state,
                             ErrorEstimate<dim>        &error)
  {
    const Scene &scene = discretization.scene;
    const auto   faces = faces_with_formulas(discretization);
    if (!faces || !(error.energy_norm > 0))
      return;
    const QGauss<1> line = samples_along<dim>(
        Utilities::MPI::sum<unsigned int>(faces->size(), discretization.geometry.communicator));
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): a product in 3D
    const Quadrature<dim - 1>   points(line);
    FEFaceValues<dim>           values(discretization.mapping(),
                             discretization.fe,
                             points,
                             update_values | update_quadrature_points | update_JxW_values);
    std::vector<Tensor<1, dim>> u(points.size());
    std::vector<double>         d(points.size()), areas(points.size());
    double                      sum = 0;
    for (const auto &[cell, f, condition] : *faces)
      {
        values.reinit(cell, f);
        values[FEValuesExtractors::Vector(0)].get_function_values(state.displacement, u);
        for (unsigned int q = 0; q < points.size(); ++q)
          areas[q] = values.JxW(q) * measure<dim>(scene.kind, values.quadrature_point(q));
        double energy = 0;
        for (unsigned int c = 0; c < dim; ++c)
          if (const auto &g = condition->displacement[c]; depends_on_place(g))
            {
              for (unsigned int q = 0; q < points.size(); ++q)
                d[q] = g->value(as_3d(values.quadrature_point(q)), state.t) - u[q][c];
              energy += scene.bodies[cell->material_id()].material.young *
                        energy_of_trace<dim>(d, values.get_quadrature_points(), areas, line.size());
            }
        sum += energy;
        const auto   k           = cell->active_cell_index();
        const double relative    = energy / std::pow(error.energy_norm, 2);
        error.cell_indicators[k] = std::hypot(error.cell_indicators[k], std::sqrt(energy));
        error.contact_indicators[k] =
            std::hypot(error.contact_indicators[k], std::sqrt(relative) * error.pressure_norm);
      }
    const double relative =
        std::sqrt(Utilities::MPI::sum(sum, discretization.geometry.communicator)) / error.energy_norm;
    error.bulk = std::hypot(error.bulk, relative);
    if (error.contact > 0 || error.pressure_norm > 0)
      {
        error.data    = std::hypot(error.data, relative);
        error.contact = std::hypot(error.contact, relative);
      }
  }

  template std::vector<FrictionError>
  friction_errors(const ContactInterface<2> &, const SurfaceFields<2> &, const ProblemType);
  template std::vector<FrictionError>
  friction_errors(const ContactInterface<3> &, const SurfaceFields<3> &, const ProblemType);
  template void
  add_error_of_displacements(const Discretization<2> &, const SolutionState<2> &, ErrorEstimate<2> &);
  template void
  add_error_of_displacements(const Discretization<3> &, const SolutionState<3> &, ErrorEstimate<3> &);
} // namespace Amontons
