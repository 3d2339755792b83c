#include <amontons/adaptivity/model_selection.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  namespace
  {
    // int of the energy densities of two small strains, 2 mu e:e + lambda tr(e)^2, over the owned cells.
    template <int dim>
    std::array<double, 2>
    strain_energies(const Discretization<dim> &discretization, const LA::Vector &u)
    {
      const Scene                     &scene = discretization.scene;
      FEValues<dim>                    values(discretization.mapping,
                           discretization.fe,
                           QGauss<dim>(discretization.fe.degree + 1),
                           update_values | update_gradients | update_quadrature_points | update_JxW_values);
      std::vector<Tensor<2, dim>>      gradients(values.n_quadrature_points);
      std::vector<Tensor<1, dim>>      displacements(values.n_quadrature_points);
      const FEValuesExtractors::Vector all(0);
      std::array<double, 2>            energies = {{0, 0}};
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          {
            values.reinit(cell);
            values[all].get_function_gradients(u, gradients);
            values[all].get_function_values(u, displacements);
            const MaterialData      &material = scene.bodies[cell->material_id()].material;
            const LinearElastic<dim> law(material, scene.kind);
            for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
              {
                const Point<dim>    &X      = values.quadrature_point(q);
                Tensor<2, dim>       linear = symmetrize(gradients[q]);
                const Tensor<2, dim> square = 0.5 * transpose(gradients[q]) * gradients[q];
                const double         hoop = scene.kind == Kind::axisymmetric ? displacements[q][0] / X[0] : 0;
                const std::array<std::pair<Tensor<2, dim>, double>, 2> strains = {
                    {{linear, hoop}, {square, 0.5 * hoop * hoop}}};
                for (unsigned int k = 0; k < 2; ++k)
                  {
                    const auto &[e, out] = strains[k];
                    const double tr      = trace(e) + out;
                    energies[k] += (2 * law.mu * (e.norm_square() + out * out) + law.lambda * tr * tr) *
                                   values.JxW(q) * measure<dim>(scene.kind, X);
                  }
              }
          }
      for (double &energy : energies)
        energy = Utilities::MPI::sum(energy, discretization.geometry.communicator);
      return energies;
    }
  } // namespace

  template <int dim>
  NeglectedTerms
  neglected_terms(const Discretization<dim>          &discretization,
                  const Constraints                  &supports,
                  const SolutionState                &state,
                  std::vector<ContactInterface<dim>> &interfaces)
  {
    NeglectedTerms result;
    const auto     energies = strain_energies(discretization, state.displacement);
    if (energies[0] > 0)
      result.strain = std::sqrt(energies[1] / energies[0]);

    std::vector<std::set<unsigned int>> closed(interfaces.size()); // slave nodes
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (unsigned int r = 0; r < interfaces[i].coupling.rows.size(); ++r)
        if (state.states[i][r] != ContactState::open && !interfaces[i].pair->tied)
          closed[i].insert(interfaces[i].coupling.rows[r].node);
    couple_moved(discretization, supports, state.displacement, interfaces);
    double gaps = 0, motions = 0;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        double motion = 0;
        for (const auto &node : interfaces[i].slave->nodes)
          motion = std::max(motion, node.x.distance(node.X));
        for (const auto &row : interfaces[i].coupling.rows)
          if (closed[i].count(row.node) > 0)
            {
              gaps += row.area * row.gap * row.gap;
              motions += row.area * motion * motion;
            }
      }
    if (motions > 0)
      result.contact = std::sqrt(gaps / motions);
    return result;
  }

  template NeglectedTerms
  neglected_terms(const Discretization<2> &,
                  const Constraints &,
                  const SolutionState &,
                  std::vector<ContactInterface<2>> &);
  template NeglectedTerms
  neglected_terms(const Discretization<3> &,
                  const Constraints &,
                  const SolutionState &,
                  std::vector<ContactInterface<3>> &);
} // namespace Amontons
