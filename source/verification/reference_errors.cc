// Norms by quadrature on the slave surface and in the bodies.
#include <amontons/verification/reference_errors.h>
#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/elasticity/kirchhoff.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
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

    // Twice the density of the complementary energy: (1+nu)/E s:s - nu/E tr(s)^2
    double
    energy(const SymmetricTensor<2, 3> &s, const MaterialData &material)
    {
      return ((1 + material.poisson) * (s * s) - material.poisson * trace(s) * trace(s)) / material.young;
    }
  } // namespace

  template <int dim>
  double
  pressure_error(const ContactInterface<dim> &interface,
                 const SurfaceFields<dim>    &fields,
                 const ReferenceSolution     &reference,
                 const ProblemType            kind)
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

  template <int dim>
  void
  compare_fields(const Answer<dim> &answer, const ReferenceSolution &reference, ReferenceSummary &summary)
  {
    const auto                      &discretization = answer.discretization;
    const Scene                     &scene          = discretization.scene;
    FEValues<dim>                    values(discretization.mapping(),
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
                  sums[4] += weight * energy(symmetrize(as_tensor(stress[q])) - exact_stress, body.material);
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

  template double
  pressure_error(const ContactInterface<2> &,
                 const SurfaceFields<2> &,
                 const ReferenceSolution &,
                 const ProblemType);
  template double
  shear_error(const ContactInterface<2> &, const SurfaceFields<2> &, const ReferenceSolution &);
  template void
  compare_fields(const Answer<2> &, const ReferenceSolution &, ReferenceSummary &);

  template double
  pressure_error(const ContactInterface<3> &,
                 const SurfaceFields<3> &,
                 const ReferenceSolution &,
                 const ProblemType);
  template double
  shear_error(const ContactInterface<3> &, const SurfaceFields<3> &, const ReferenceSolution &);
  template void
  compare_fields(const Answer<3> &, const ReferenceSolution &, ReferenceSummary &);
} // namespace Amontons
