#include <amontons/output/comparison.h>
#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/output/approach.h>
#include <amontons/scene/reference_solution.h>

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

    // Whether all of a face is farther from the centre than the closed form is compared: curved faces lie in
    // the ball about the mean of their nodes, with some margin. On closed surfaces it also keeps the opposite
    // pole out.
    template <int dim>
    bool
    is_out_of_range(const ContactSurface<dim> &surface,
                    const unsigned int         face,
                    const ReferenceSolution   &reference)
    {
      const auto    &nodes = surface.faces[face].nodes;
      Tensor<1, dim> mean, centre;
      for (const unsigned int i : nodes)
        mean += surface.nodes[i].X;
      mean /= nodes.size();
      for (unsigned int k = 0; k < dim; ++k)
        centre[k] = reference.centre[k];
      double radius = 0;
      for (const unsigned int i : nodes)
        radius = std::max(radius, (surface.nodes[i].X - mean).norm());
      return (mean - centre).norm() > reference.pressure_range + 1.2 * radius;
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
        if (!is_out_of_range(slave, f, reference))
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const auto  &xi = quadrature.point(q);
              const auto   X  = slave.position(f, xi);
              double       jacobian;
              const auto   n     = as_3d(Point<dim>(slave.face_normal(f, xi, &jacobian)));
              const auto   d     = as_3d(X) - reference.centre;
              Tensor<1, 3> along = d - (d * n) * n;
              if (dim == 2) // out of the plane nothing is compared
                along[2] = 0;
              if (along.norm() > reference.pressure_range)
                continue;
              const double weight = quadrature.weight(q) * jacobian * measure<dim>(kind, X);
              const double exact =
                  reference.ellipse ? reference.ellipse->pressure(along) : reference.pressure(along.norm());
              const double error = value_on_face(slave, fields.pressure, f, xi) - exact;
              difference += weight * error * error;
              norm += weight * exact * exact;
            }
      return norm > 0 ? std::sqrt(difference / norm) : unknown;
    }

    // sqrt(int (q - q_exact)^2 / int q_exact^2) with the shear traction along x: over lines, or, where the
    // closed form is one of the radius, over discs.
    template <int dim>
    double
    shear_error(const ContactInterface<dim> &interface,
                const SurfaceFields<dim>    &fields,
                const ReferenceSolution     &reference)
    {
      const auto              &slave = *interface.slave;
      const QIterated<dim - 1> quadrature(QGauss<1>(3), dim == 2 ? 12 : 4);
      std::vector<double>      along_x;
      for (const auto &traction : fields.traction)
        along_x.push_back(traction[0]);
      double difference = 0, norm = 0;
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        if (!is_out_of_range(slave, f, reference))
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const auto  &xi = quadrature.point(q);
              double       jacobian;
              const auto   n     = as_3d(Point<dim>(slave.face_normal(f, xi, &jacobian)));
              const auto   d     = as_3d(slave.position(f, xi)) - reference.centre;
              Tensor<1, 3> along = d - (d * n) * n;
              if (dim == 2)
                along[2] = 0;
              if (along.norm() > reference.pressure_range)
                continue;
              const double weight = quadrature.weight(q) * jacobian;
              const double exact  = reference.shear_traction(dim == 2 ? along[0] : along.norm());
              const double error  = value_on_face(slave, along_x, f, xi) - exact;
              difference += weight * error * error;
              norm += weight * exact * exact;
            }
      return norm > 0 ? std::sqrt(difference / norm) : unknown;
    }

    // Semi-axis along a unit vector of the half-ellipsoidal pressure with the same spread: sqrt(5 int p x^2 /
    // int p).
    template <int dim>
    double
    semi_axis(const SurfaceFields<dim> &fields, const Tensor<1, 3> &axis)
    {
      double variance = 0;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          variance += axis[i] * fields.covariance[i][j] * axis[j];
      return std::sqrt(std::max(0., 5 * variance));
    }

    // Stress components in the order of Voigt<dim> (kinematics.h) as a tensor.
    template <int dim>
    SymmetricTensor<2, 3>
    as_tensor(const Voigt<dim> &s)
    {
      SymmetricTensor<2, 3> t;
      for (unsigned int i = 0; i < 3; ++i)
        t[i][i] = s[i];
      t[0][1] = s[3];
      if (dim == 3)
        {
          t[0][2] = s[n_voigt<dim> - 2];
          t[1][2] = s[n_voigt<dim> - 1];
        }
      return t;
    }

    // Twice the density of the complementary energy: (1+nu)/E s:s - nu/E tr(s)^2
    double
    energy(const SymmetricTensor<2, 3> &s, const MaterialData &material)
    {
      return ((1 + material.poisson) * (s * s) - material.poisson * trace(s) * trace(s)) / material.young;
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
                    const auto exact_stress = reference.stress(body.name, X);
                    sums[4] += weight * energy(as_tensor<dim>(stress[q]) - exact_stress, body.material);
                    sums[5] += weight * energy(exact_stress, body.material);
                  }
              }
          }
      Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);
      summary.errors["displacement_l2"] = std::sqrt(sums[0] / sums[1]);
      summary.errors["displacement_h1"] = std::sqrt(sums[2] / sums[3]);
      if (reference.stress)
        summary.errors["energy"] = std::sqrt(sums[4] / sums[5]);
    }

    template <int dim>
    unsigned int
    compared_pair(const Answer<dim> &answer, const ReferenceData &data)
    {
      unsigned int i = 0;
      for (unsigned int k = 0; k < answer.interfaces.size(); ++k)
        if (answer.interfaces[k].pair->name == data.pair)
          i = k;
      return i;
    }

    template <int dim>
    class ClosedFormReference : public Reference<dim>
    {
    public:
      explicit ClosedFormReference(const Scene &scene)
          : data(*scene.reference), solution(make_reference_solution(data.solution, scene))
      {
      }

      ReferenceSummary
      compare(const Answer<dim> &answer) const override;
      void
      compare_dissipation(const Answer<dim> &answer,
                          const double       dissipation,
                          ReferenceSummary  &summary) const override;

      ReferenceTractions
      tractions() const override
      {
        return {data.pair, solution.pressure, solution.shear_traction};
      }

    private:
      const ReferenceData     data;
      const ReferenceSolution solution;
    };

    template <int dim>
    void
    ClosedFormReference<dim>::compare_dissipation(const Answer<dim> &answer,
                                                  const double       dissipation,
                                                  ReferenceSummary  &summary) const
    {
      if (!solution.dissipation)
        return;
      const double factor = answer.fields.at(compared_pair(answer, data)).symmetry_factor;
      add_value(summary, "dissipation", factor * dissipation, *solution.dissipation);
    }

    template <int dim>
    ReferenceSummary
    ClosedFormReference<dim>::compare(const Answer<dim> &answer) const
    {
      ReferenceSummary summary;
      summary.closed_form       = data.solution.name;
      const unsigned int i      = compared_pair(answer, data);
      const auto        &fields = answer.fields.at(i);
      // What symmetry planes cut is compared as a whole: the components along their normals cancel in the
      // mirror.
      Tensor<1, dim> force = fields.normal_force;
      for (const auto &normal : fields.symmetry_planes)
        force -= (force * normal) * normal;
      const double P            = fields.symmetry_factor * force.norm();
      const bool   line         = dim == 2 && answer.discretization.scene.kind != Kind::axisymmetric;
      const double hertz_factor = line ? 4 : 2.5;
      double a = fields.contact_size * std::sqrt(solution.size_factor.value_or(hertz_factor) / hertz_factor),
             b = a;
      if (solution.ellipse)
        {
          a = semi_axis(fields, solution.ellipse->axes[0]);
          b = semi_axis(fields, solution.ellipse->axes[1]);
          add_value(summary, "contact_size_2", b, solution.ellipse->second_size);
        }
      if (solution.normal_force)
        add_value(summary, "normal_force", P, *solution.normal_force);
      if (solution.contact_size)
        add_value(summary, "contact_size", a, *solution.contact_size);
      if (solution.peak_pressure)
        {
          add_value(summary, "nodal_peak_pressure", fields.peak_pressure, *solution.peak_pressure);
          // Peak from the force and size: 2P/(pi a) in the plane, 3P/(2 pi a b) for points; the nodal peak of
          // Q1 is only O(h).
          if (solution.contact_size && a * b > 0)
            add_value(summary,
                      "peak_pressure",
                      line ? 2 * P / (numbers::PI * a) : 3 * P / (2 * numbers::PI * a * b),
                      *solution.peak_pressure);
        }
      if (solution.tangential_force)
        add_value(summary,
                  "tangential_force",
                  fields.symmetry_factor * fields.tangential_force[0],
                  *solution.tangential_force);
      if (solution.stick_size && solution.unused_shear_is_hertzian &&
          answer.interfaces[i].pair->has_friction())
        add_value(summary, "stick_size", fields.stick_size, *solution.stick_size);
      if (solution.shear_traction)
        summary.errors["shear_l2"] = shear_error(answer.interfaces[i], fields, solution);
      if (solution.approach)
        if (const auto approach = compute_approach(answer, i))
          add_value(summary, "approach", *approach, *solution.approach);
      if (solution.pressure)
        summary.errors["pressure_l2"] =
            pressure_error(answer.interfaces[i], fields, solution, answer.discretization.scene.kind);
      if (solution.displacement)
        compare_fields(answer, solution, summary);
      return summary;
    }
  } // namespace

  template <int dim>
  std::unique_ptr<const Reference<dim>>
  make_reference(const Scene &scene)
  {
    return std::make_unique<ClosedFormReference<dim>>(scene);
  }

  template std::unique_ptr<const Reference<2>>
  make_reference(const Scene &);
  template std::unique_ptr<const Reference<3>>
  make_reference(const Scene &);
} // namespace Amontons
