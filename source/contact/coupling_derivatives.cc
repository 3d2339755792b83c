#include <amontons/contact/coupling_derivatives.h>

namespace Amontons
{
  template <int dim>
  class FaceDerivatives
  {
  };

  template <int dim>
  CouplingDerivatives<dim>::CouplingDerivatives(const Discretization<dim> &,
                                                const ContactInterface<dim> &interface,
                                                const std::vector<bool>     &wanted)
      : interface(interface), wanted(wanted), gradients(wanted.size())
  {
  }

  template <int dim>
  CouplingDerivatives<dim>::~CouplingDerivatives() = default;

  template <int dim>
  std::vector<SurfaceMatrix>
  CouplingDerivatives<dim>::stiffness(const std::vector<Tensor<1, dim>> &) const
  {
    return {};
  }

  template class CouplingDerivatives<2>;
  template class CouplingDerivatives<3>;
} // namespace Amontons
