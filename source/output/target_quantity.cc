#include <amontons/adaptivity/increment_error.h>
#include <amontons/output/approach.h>
#include <amontons/output/target_quantity.h>

namespace Amontons
{
  namespace
  {
    // Of what a pair carries, the part along the symmetry planes (and the axis) that cut it: across, the
    // images cancel it, and as it shrinks where the other part grows, both together may hardly change
    // between meshes. All of it, if that is all that there is (fits of quarter rings). Forces of nodes that
    // cancel each other but for rounding make none.
    template <int dim>
    double
    total_force(const Answer<dim> &answer, const SurfaceFields<dim> &fields)
    {
      constexpr double     noteworthy = 0.1;
      const Tensor<1, dim> whole      = fields.normal_force + fields.tangential_force;
      double               of_nodes   = 0;
      for (const auto &force : fields.force)
        of_nodes += force.norm();
      if (whole.norm() <= 1e-9 * of_nodes)
        return 0;
      Tensor<1, dim>              along  = whole;
      std::vector<Tensor<1, dim>> across = fields.symmetry_planes;
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
    const auto is_tied = [&](const unsigned int pair) { return answer.interfaces[pair].pair->tied; };
    bool       touches = false; // without what is tied, whose traction may be infinite at its ends
    for (unsigned int pair = 0; pair < answer.fields.size(); ++pair)
      touches = touches || (!is_tied(pair) && answer.fields[pair].peak_pressure > 0);
    std::vector<double> values;
    for (unsigned int pair = 0; pair < answer.fields.size(); ++pair)
      {
        const auto &fields = answer.fields[pair];
        values.push_back(name == "peak pressure"  ? (touches && is_tied(pair) ? 0 : fields.peak_pressure)
                         : name == "contact size" ? fields.contact_size
                         : name == "stick size"   ? fields.stick_size
                         : name == "approach"     ? compute_approach(answer, pair).value_or(0)
                                                  : total_force(answer, fields));
      }
    return values;
  }

  bool
  is_size(const std::string &name)
  {
    return name == "contact size" || name == "stick size";
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
    constexpr double part_of_displacement = 1e-3, part_of_contact = 0.05;
    double           contact_size = 0;
    for (const auto &of_pair : answer.fields)
      contact_size = std::max(contact_size, of_pair.contact_size);
    return name == "dissipation"  ? noteworthy_dissipation * work.largest_work
           : name == "approach"   ? part_of_displacement * answer.state.displacement.linfty_norm()
           : name == "stick size" ? part_of_contact * contact_size
                                  : 0;
  }

  double
  rest_of_value(const std::string &name, const double largest_work, const double largest_force)
  {
    constexpr double of_work = 1e-11, of_force = 1e-9; // a work goes like the square of its force
    return name == "energy" ? of_work * largest_work : name == "total force" ? of_force * largest_force : 0;
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
