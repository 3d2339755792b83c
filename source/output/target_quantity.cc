#include <amontons/adaptivity/increment_error.h>
#include <amontons/output/approach.h>
#include <amontons/output/target_quantity.h>

namespace Amontons
{
  namespace
  {
    // Of what a pair carries, the part along the symmetry planes (and the axis) that cut it: across, the
    // images cancel it, and as it shrinks where the other part grows, both together may hardly change
    // between meshes. All of it, if that is all that there is (fits of quarter rings).
    template <int dim>
    double
    total_force(const Answer<dim> &answer, const SurfaceFields<dim> &fields)
    {
      constexpr double            noteworthy = 0.1;
      const Tensor<1, dim>        whole      = fields.normal_force + fields.tangential_force;
      Tensor<1, dim>              along      = whole;
      std::vector<Tensor<1, dim>> across     = fields.symmetry_planes;
      if (answer.discretization.scene.kind == ProblemType::axisymmetric)
        across.push_back(Point<dim>::unit_vector(0));
      for (const auto &normal : across)
        along -= (along * normal) * normal;
      return along.norm() > noteworthy * whole.norm() ? along.norm() : whole.norm();
    }
  } // namespace

  template <int dim>
  std::vector<double>
  target_quantity(const std::string &name, const Answer<dim> &answer, const WorkDone<dim> &work)
  {
    if (name == "energy")
      return {stored_energy(answer)};
    if (name == "dissipation")
      return {work.dissipation};
    std::vector<double> values;
    for (unsigned int pair = 0; pair < answer.fields.size(); ++pair)
      {
        const auto &fields = answer.fields[pair];
        values.push_back(name == "peak pressure"  ? fields.peak_pressure
                         : name == "contact size" ? fields.contact_size
                         : name == "stick size"   ? fields.stick_size
                         : name == "approach"     ? compute_approach(answer, pair).value_or(0)
                                                  : total_force(answer, fields));
      }
    return values;
  }

  bool
  always_converges(const std::string &name)
  {
    return name == "total force" || name == "approach" || name == "energy";
  }

  std::optional<double>
  sensitivity_to_shear(const std::string &name)
  {
    if (name == "contact pressure")
      return 1;
    if (name == "stick size")
      return 2;
    if (name == "dissipation")
      return 5;
    return {};
  }

  template <int dim>
  double
  noteworthy_value(const std::string &name, const Answer<dim> &answer, const WorkDone<dim> &work)
  {
    constexpr double part_of_displacement = 1e-3;
    return name == "dissipation" ? noteworthy_dissipation * work.largest_work
           : name == "approach"  ? part_of_displacement * answer.state.displacement.linfty_norm()
                                 : 0;
  }

  template double
  noteworthy_value(const std::string &, const Answer<2> &, const WorkDone<2> &);
  template double
  noteworthy_value(const std::string &, const Answer<3> &, const WorkDone<3> &);
  template std::vector<double>
  target_quantity(const std::string &, const Answer<2> &, const WorkDone<2> &);
  template std::vector<double>
  target_quantity(const std::string &, const Answer<3> &, const WorkDone<3> &);
} // namespace Amontons
