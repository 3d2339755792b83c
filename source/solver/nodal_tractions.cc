#include <amontons/solver/nodal_tractions.h>

namespace Amontons
{
  template <int dim>
  void
  set_traction_of_stick(const SlaveNode<dim> &node, const double *multipliers, NodalContact<dim> &answer)
  {
    Tensor<1, dim> traction;
    for (unsigned int d = 0; d < dim; ++d)
      traction += multipliers[d] / node.area * node.directions[d];
    answer.pressure = traction * node.normal / node.normal.norm_square();
    answer.shear    = traction - answer.pressure * node.normal; // all of it, where normals lean out of planes
  }

  template <int dim>
  NodalContact<dim>
  answer_of_closed(const SlaveNode<dim> &node,
                   const ContactStatus   state,
                   const SlipLaw<dim>   &law,
                   const Tensor<1, dim> &slip,
                   const double          gap,
                   const bool            has_multiplier,
                   const double         *multipliers)
  {
    NodalContact<dim> result;
    if (node.frictional)
      result.slip = slip;
    if (state == ContactStatus::stick)
      {
        set_traction_of_stick(node, multipliers, result);
        return result;
      }
    if (has_multiplier)
      result.pressure = multipliers[0] / node.area;
    else
      result.gap = gap;
    if (node.frictional)
      result.shear = law.traction(result.pressure, result.slip);
    return result;
  }

  template <int dim>
  void
  add_known_shear_forces(const SlaveNode<dim> &node,
                         const SlipLaw<dim>   &law,
                         const Tensor<1, dim> &slip,
                         const IndexSet       &locally_owned,
                         LA::Vector           &forces)
  {
    if (law.constant == 0 && !(law.stiffness > 0))
      return;
    const auto q = law.traction(0, slip);
    for (unsigned int c = 0; c < dim; ++c)
      for (const auto &[dof, weight] : node.components[c].equation.coefficients)
        if (locally_owned.is_element(dof))
          forces(dof) -= node.area * q[c] * weight;
  }

  template <int dim>
  double
  rounding_of_pressures(const std::vector<SlaveNode<dim>> &nodes, const double motion)
  {
    double rounding = 0, c = 0;
    for (const auto &node : nodes)
      if (!node.tied)
        {
          rounding = std::max(rounding, node.rounding);
          c        = std::max(c, node.c);
        }
    return rounding + 1e-13 * c * motion;
  }

  template void
  set_traction_of_stick(const SlaveNode<2> &, const double *, NodalContact<2> &);
  template NodalContact<2>
  answer_of_closed(const SlaveNode<2> &,
                   const ContactStatus,
                   const SlipLaw<2> &,
                   const Tensor<1, 2> &,
                   const double,
                   const bool,
                   const double *);
  template void
  add_known_shear_forces(
      const SlaveNode<2> &, const SlipLaw<2> &, const Tensor<1, 2> &, const IndexSet &, LA::Vector &);
  template double
  rounding_of_pressures(const std::vector<SlaveNode<2>> &, const double);
  template void
  set_traction_of_stick(const SlaveNode<3> &, const double *, NodalContact<3> &);
  template NodalContact<3>
  answer_of_closed(const SlaveNode<3> &,
                   const ContactStatus,
                   const SlipLaw<3> &,
                   const Tensor<1, 3> &,
                   const double,
                   const bool,
                   const double *);
  template void
  add_known_shear_forces(
      const SlaveNode<3> &, const SlipLaw<3> &, const Tensor<1, 3> &, const IndexSet &, LA::Vector &);
  template double
  rounding_of_pressures(const std::vector<SlaveNode<3>> &, const double);
} // namespace Amontons
