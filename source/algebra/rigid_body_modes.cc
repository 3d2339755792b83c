#include <amontons/algebra/rigid_body_modes.h>
#include <amontons/discretization/dof_places.h>

namespace Amontons
{
  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Discretization<dim> &discretization)
  {
    const bool                       axisymmetric = discretization.scene.kind == ProblemType::axisymmetric;
    const unsigned int               n_modes      = axisymmetric ? 2 : dim * (dim + 1) / 2;
    const auto                      &owned        = discretization.locally_owned;
    std::vector<std::vector<double>> modes(n_modes, std::vector<double>(owned.n_elements(), 0.));

    const auto places = places_of_dofs(discretization);
    for (unsigned int i = 0; i < owned.n_elements(); ++i)
      {
        const auto dof           = owned.nth_index_in_set(i);
        const auto &[body, c, X] = places[discretization.relevant.index_within_set(dof)];
        modes[c][i]              = 1;
        unsigned int mode        = dim;
        for (unsigned int a = 0; a < dim && !axisymmetric; ++a)
          for (unsigned int b = a + 1; b < dim; ++b, ++mode)
            modes[mode][i] = c == a ? -X[b] : c == b ? X[a] : 0.;
      }
    return modes;
  }

  template std::vector<std::vector<double>>
  rigid_body_modes(const Discretization<2> &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Discretization<3> &);
} // namespace Amontons
