#include <amontons/verification/comparison.h>
#include <amontons/output/approach.h>
#include <amontons/verification/reference_errors.h>

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
        refuse_points_in_plane(data.solution, scene.kind);
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
      const bool   line         = dim == 2 && answer.discretization.scene.kind != ProblemType::axisymmetric;
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
