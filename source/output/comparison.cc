// Errors against closed forms.
#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/output/quantities.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    void
    add_value(ReferenceSummary &summary, const std::string &name, const double computed, const double exact)
    {
      summary.values[name] = {{computed, exact}};
      summary.errors[name] = std::abs(computed - exact) / std::abs(exact);
    }

    // sqrt(int (p - p_exact)^2 / int p_exact^2) over the slave surface within the range of the closed form.
    template <int dim>
    double
    pressure_error(const ContactInterface<dim> &interface,
                   const SurfaceFields<dim>    &fields,
                   const ReferenceSolution     &reference,
                   const Kind                   kind)
    {
      const auto              &slave = *interface.slave;
      const QIterated<dim - 1> quadrature(QGauss<1>(3), dim == 2 ? 12 : 4);
      double                   difference = 0, norm = 0;
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const auto    &xi = quadrature.point(q);
            const auto     X  = slave.position(f, xi);
            double         jacobian;
            const auto     n = slave.face_normal(f, xi, &jacobian);
            Tensor<1, dim> d;
            for (unsigned int k = 0; k < dim; ++k)
              d[k] = X[k] - reference.centre[k];
            const double r = (d - (d * n) * n).norm();
            if (r > reference.pressure_range)
              continue;
            const double weight = quadrature.weight(q) * jacobian * measure<dim>(kind, X);
            const double exact  = reference.pressure(r);
            const double error  = value_on_face(slave, fields.pressure, f, xi) - exact;
            difference += weight * error * error;
            norm += weight * exact * exact;
          }
      return norm > 0 ? std::sqrt(difference / norm) : unknown;
    }

    // Norms of the displacement error (rigid motions included) and, if the stress is known, of the stress
    // error in the energy norm.
    template <int dim>
    void
    compare_fields(const Answer<dim> &answer, const ReferenceSolution &reference, ReferenceSummary &summary)
    {
      const auto                      &discretization = answer.discretization;
      const Scene                     &scene          = discretization.scene;
      FEValues<dim>                    values(discretization.mapping,
                           discretization.fe,
                           QGauss<dim>(discretization.fe.degree + 2),
                           ElasticityOperator<dim>::needed_flags());
      const FEValuesExtractors::Vector u(0);
      std::vector<Tensor<1, dim>>      displacement(values.n_quadrature_points);
      std::vector<Tensor<2, dim>>      gradient(values.n_quadrature_points);
      std::vector<double>              sums(6, 0.);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          {
            const auto &body = scene.bodies[cell->material_id()];
            values.reinit(cell);
            values[u].get_function_values(answer.state.displacement, displacement);
            values[u].get_function_gradients(answer.state.displacement, gradient);
            std::vector<Voigt<dim>> stress;
            if (reference.stress)
              stress = answer.elasticity.stresses(values, cell, answer.state.displacement);
            const double E = body.material.young, nu = body.material.poisson;
            for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
              {
                const Point<3> X      = as_3d(values.quadrature_point(q));
                const double   weight = values.JxW(q) * measure<dim>(scene.kind, values.quadrature_point(q));
                const auto     exact  = reference.displacement(body.name, X);
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    sums[0] += weight * std::pow(displacement[q][c] - exact[c], 2);
                    sums[1] += weight * exact[c] * exact[c];
                  }
                const double step = 1e-4 * cell->diameter();
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    Point<3> forward = X, backward = X;
                    forward[d] += step;
                    backward[d] -= step;
                    const auto derivative = (reference.displacement(body.name, forward) -
                                             reference.displacement(body.name, backward)) /
                                            (2 * step);
                    for (unsigned int c = 0; c < dim; ++c)
                      {
                        sums[2] += weight * std::pow(gradient[q][c][d] - derivative[c], 2);
                        sums[3] += weight * derivative[c] * derivative[c];
                      }
                  }
                if (reference.stress)
                  {
                    const auto s = reference.stress(body.name, X);
                    // 2 x energy density: (1+nu)/E s:s - nu/E tr(s)^2, with the out-of-plane stress of plane
                    // strain
                    const auto density =
                        [&](const double xx, const double yy, const double zz, const double xy) {
                          const double trace = xx + yy + zz;
                          return (1 + nu) / E * (xx * xx + yy * yy + zz * zz + 2 * xy * xy) -
                                 nu / E * trace * trace;
                        };
                    if (dim == 2)
                      {
                        sums[4] += weight * density(stress[q][0] - s[0][0],
                                                    stress[q][1] - s[1][1],
                                                    stress[q][2] - s[2][2],
                                                    stress[q][3] - s[0][1]);
                        sums[5] += weight * density(s[0][0], s[1][1], s[2][2], s[0][1]);
                      }
                  }
              }
          }
      Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);
      summary.errors["displacement_l2"] = std::sqrt(sums[0] / sums[1]);
      summary.errors["displacement_h1"] = std::sqrt(sums[2] / sums[3]);
      if (reference.stress && dim == 2)
        summary.errors["energy"] = std::sqrt(sums[4] / sums[5]);
    }
  } // namespace

  template <int dim>
  ReferenceSummary
  compare(const Answer<dim> &answer, const ReferenceData &data, const ReferenceSolution &reference)
  {
    ReferenceSummary summary;
    summary.closed_form = data.solution.name;
    unsigned int i      = 0;
    for (unsigned int k = 0; k < answer.interfaces.size(); ++k)
      if (answer.interfaces[k].pair->name == data.pair)
        i = k;
    const auto &fields = answer.fields.at(i);
    // What symmetry planes cut is compared as a whole: the components along their normals cancel in the
    // mirror.
    Tensor<1, dim> force = fields.normal_force;
    for (const auto &normal : fields.symmetry_planes)
      force -= (force * normal) * normal;
    const double P            = fields.symmetry_factor * force.norm();
    const bool   line         = dim == 2 && answer.discretization.scene.kind != Kind::axisymmetric;
    const double hertz_factor = line ? 4 : 2.5;
    const double a =
        fields.contact_size * std::sqrt(reference.size_factor.value_or(hertz_factor) / hertz_factor);
    if (reference.normal_force)
      add_value(summary, "normal_force", P, *reference.normal_force);
    if (reference.contact_size)
      add_value(summary, "contact_size", a, *reference.contact_size);
    if (reference.peak_pressure)
      {
        add_value(summary, "nodal_peak_pressure", fields.peak_pressure, *reference.peak_pressure);
        // Peak from the force and size: 2P/(pi a) in the plane, 3P/(2 pi a^2) for points; the nodal peak of
        // Q1 is only O(h).
        if (reference.contact_size && a > 0)
          {
            add_value(summary,
                      "peak_pressure",
                      line ? 2 * P / (numbers::PI * a) : 3 * P / (2 * numbers::PI * a * a),
                      *reference.peak_pressure);
          }
      }
    if (reference.pressure)
      summary.errors["pressure_l2"] =
          pressure_error(answer.interfaces[i], fields, reference, answer.discretization.scene.kind);
    if (reference.displacement)
      compare_fields(answer, reference, summary);
    return summary;
  }

  template ReferenceSummary
  compare(const Answer<2> &, const ReferenceData &, const ReferenceSolution &);
} // namespace Amontons
