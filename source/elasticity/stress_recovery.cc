#include <amontons/elasticity/stress_recovery.h>

#include <deal.II/base/polynomial_space.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/householder.h>

#include <limits>
#include <set>

namespace Amontons
{
  namespace
  {
    template <int dim>
    struct Sample
    {
      Point<dim> X;
      Voigt<dim> stress;
    };

    // Least-squares polynomial of total degree p through samples, in coordinates scaled to their bounding
    // box.
    template <int dim>
    class PatchPolynomial
    {
    public:
      PatchPolynomial(const PolynomialSpace<dim> &space, const std::vector<Sample<dim>> &samples)
          : space(space)
      {
        Point<dim> lower = samples.front().X, upper = lower;
        for (const auto &sample : samples)
          for (unsigned int d = 0; d < dim; ++d)
            {
              lower[d] = std::min(lower[d], sample.X[d]);
              upper[d] = std::max(upper[d], sample.X[d]);
            }
        centre = lower + (upper - lower) / 2;
        for (unsigned int d = 0; d < dim; ++d)
          scale[d] = std::max((upper[d] - lower[d]) / 2, std::numeric_limits<double>::min());
        fit(samples);
      }

      Voigt<dim>
      value(const Point<dim> &X) const
      {
        const Point<dim> xi = scaled(X);
        Voigt<dim>       stress;
        stress.fill(0);
        for (unsigned int i = 0; i < space.n(); ++i)
          {
            const double monomial = space.compute_value(i, xi);
            for (unsigned int k = 0; k < n_voigt<dim>; ++k)
              stress[k] += monomial * coefficients[k][i];
          }
        return stress;
      }

    private:
      Point<dim>
      scaled(const Point<dim> &X) const
      {
        Point<dim> xi;
        for (unsigned int d = 0; d < dim; ++d)
          xi[d] = (X[d] - centre[d]) / scale[d];
        return xi;
      }

      void
      fit(const std::vector<Sample<dim>> &samples)
      {
        FullMatrix<double> monomials(samples.size(), space.n());
        for (unsigned int s = 0; s < samples.size(); ++s)
          for (unsigned int i = 0; i < space.n(); ++i)
            monomials(s, i) = space.compute_value(i, scaled(samples[s].X));
        const Householder<double> qr(monomials);
        Vector<double>            stresses(samples.size());
        for (unsigned int k = 0; k < n_voigt<dim>; ++k)
          {
            for (unsigned int s = 0; s < samples.size(); ++s)
              stresses[s] = samples[s].stress[k];
            coefficients[k].reinit(space.n());
            qr.least_squares(coefficients[k], stresses);
          }
      }

      const PolynomialSpace<dim>              &space;
      Point<dim>                               centre, scale;
      std::array<Vector<double>, n_voigt<dim>> coefficients;
    };

    // The patch polynomials at all inner vertices of this rank's cells. Ghost cells complete the patches.
    template <int dim>
    class Patches
    {
    public:
      Patches(const Discretization<dim>     &discretization,
              const ElasticityOperator<dim> &elasticity,
              const LA::Vector              &displacement)
          : discretization(discretization), degree(discretization.fe.degree),
            space(Polynomials::Monomial<double>::generate_complete_basis(degree)),
            gauss(Polynomials::generate_complete_Lagrange_basis(QGauss<1>(degree).get_points())),
            nodes(discretization.fe.base_element(0).get_unit_support_points()),
            node_positions(
                discretization.mapping, discretization.fe, Quadrature<dim>(nodes), update_quadrature_points),
            samples(discretization.geometry.triangulation.n_active_cells())
      {
        take_samples(elasticity, displacement);
        find_outer_vertices();
        fit_patches();
      }

      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      // Stress at the nodes of the cell, in the numbering of the base element.
      std::vector<Voigt<dim>>
      nodal_stresses(const Cell &cell)
      {
        node_positions.reinit(cell);
        std::vector<Voigt<dim>> result;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          result.push_back(nodal_stress(cell, i));
        return result;
      }

    private:
      bool
      has_stress(const Cell &cell) const
      {
        return !cell->is_artificial() && discretization.is_deformable(cell->material_id());
      }

      // sigma_h at the p^dim Gauss points, as its L2 projection on the unit cell to polynomials of degree p -
      // 1 per direction: these agree at the Gauss points with whatever has degree p.
      void
      take_samples(const ElasticityOperator<dim> &elasticity, const LA::Vector &displacement)
      {
        const QGauss<dim> full(degree + 1), reduced(degree);
        FEValues<dim>     values(discretization.mapping, discretization.fe, full, elasticity.needed_flags());
        FEValues<dim> places(discretization.mapping, discretization.fe, reduced, update_quadrature_points);
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (has_stress(cell))
            {
              values.reinit(cell);
              places.reinit(cell);
              const auto stress = elasticity.stresses(values, cell, displacement);
              auto      &list   = samples[cell->active_cell_index()];
              for (unsigned int a = 0; a < reduced.size(); ++a)
                {
                  list.push_back({places.quadrature_point(a), Voigt<dim>()});
                  for (unsigned int q = 0; q < full.size(); ++q)
                    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
                      list.back().stress[k] += full.weight(q) / reduced.weight(a) *
                                               gauss.compute_value(a, full.point(q)) * stress[q][k];
                }
            }
      }

      // Vertices on the surface of a body, and hanging ones.
      void
      find_outer_vertices()
      {
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (has_stress(cell))
            for (const unsigned int f : cell->face_indices())
              {
                std::set<unsigned int> kept;
                if (!cell->face(f)->at_boundary())
                  {
                    if (!cell->neighbor_is_coarser(f))
                      continue;
                    for (const unsigned int v : cell->neighbor(f)->vertex_indices())
                      kept.insert(cell->neighbor(f)->vertex_index(v));
                  }
                for (const unsigned int v : cell->face(f)->vertex_indices())
                  if (kept.count(cell->face(f)->vertex_index(v)) == 0)
                    outer.insert(cell->face(f)->vertex_index(v));
              }
      }

      void
      fit_patches()
      {
        std::map<unsigned int, std::vector<Sample<dim>>> patches;
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() && has_stress(cell))
            for (const unsigned int v : cell->vertex_indices())
              if (outer.count(cell->vertex_index(v)) == 0)
                patches[cell->vertex_index(v)];
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (has_stress(cell))
            for (const unsigned int v : cell->vertex_indices())
              if (const auto patch = patches.find(cell->vertex_index(v)); patch != patches.end())
                for (const auto &sample : samples[cell->active_cell_index()])
                  patch->second.push_back(sample);
        for (const auto &[vertex, patch] : patches)
          if (patch.size() >= space.n())
            polynomials.emplace(vertex, PatchPolynomial<dim>(space, patch));
      }

      // sum_v N_v sigma_v / sum_v N_v over the inner vertices v with hat function N_v; where all these N_v
      // are zero: the plain mean.
      Voigt<dim>
      nodal_stress(const Cell &cell, const unsigned int i) const
      {
        Voigt<dim> weighted, plain;
        weighted.fill(0);
        plain.fill(0);
        double       weights = 0;
        unsigned int n       = 0;
        for (const unsigned int v : cell->vertex_indices())
          if (const auto p = polynomials.find(cell->vertex_index(v)); p != polynomials.end())
            {
              const double     hat    = GeometryInfo<dim>::d_linear_shape_function(nodes[i], v);
              const Voigt<dim> stress = p->second.value(node_positions.quadrature_point(i));
              for (unsigned int k = 0; k < n_voigt<dim>; ++k)
                {
                  weighted[k] += hat * stress[k];
                  plain[k] += stress[k];
                }
              weights += hat;
              ++n;
            }
        if (n == 0)
          return extrapolated(cell, i);
        const bool near = weights > 1e-12;
        for (unsigned int k = 0; k < n_voigt<dim>; ++k)
          weighted[k] = near ? weighted[k] / weights : plain[k] / n;
        return weighted;
      }

      Voigt<dim>
      extrapolated(const Cell &cell, const unsigned int i) const
      {
        const auto &list = samples[cell->active_cell_index()];
        Voigt<dim>  stress;
        stress.fill(0);
        for (unsigned int a = 0; a < list.size(); ++a)
          for (unsigned int k = 0; k < n_voigt<dim>; ++k)
            stress[k] += gauss.compute_value(a, nodes[i]) * list[a].stress[k];
        return stress;
      }

      const Discretization<dim>                   &discretization;
      const unsigned int                           degree;
      const PolynomialSpace<dim>                   space;
      const TensorProductPolynomials<dim>          gauss; // Lagrange polynomials of the Gauss points
      const std::vector<Point<dim>>                nodes;
      FEValues<dim>                                node_positions;
      std::vector<std::vector<Sample<dim>>>        samples; // by active cell
      std::set<unsigned int>                       outer;
      std::map<unsigned int, PatchPolynomial<dim>> polynomials; // by vertex
    };
  } // namespace

  template <int dim>
  StressRecovery<dim>::StressRecovery(const Discretization<dim>     &discretization,
                                      const ElasticityOperator<dim> &elasticity)
      : discretization(discretization), elasticity(elasticity),
        scalar_dofs(discretization.geometry.triangulation)
  {
    scalar_dofs.distribute_dofs(discretization.fe.base_element(0));
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(scalar_dofs, relevant);
    hanging.reinit(relevant);
    DoFTools::make_hanging_node_constraints(scalar_dofs, hanging);
    hanging.close();
    components.assign(
        n_voigt<dim>,
        LA::Vector(scalar_dofs.locally_owned_dofs(), relevant, discretization.geometry.communicator));
  }

  // Mean over the cells of a node (of this and other ranks); a count stands beside the sums of the
  // components.
  template <int dim>
  void
  StressRecovery<dim>::recover(const LA::Vector &displacement)
  {
    const IndexSet         &owned    = scalar_dofs.locally_owned_dofs();
    const IndexSet         &relevant = hanging.get_local_lines();
    const MPI_Comm          comm     = discretization.geometry.communicator;
    std::vector<LA::Vector> sums(n_voigt<dim> + 1);
    for (auto &sum : sums)
      sum.reinit(owned, relevant, comm, true);

    Patches<dim>                         patches(discretization, elasticity, displacement);
    std::vector<types::global_dof_index> dofs(scalar_dofs.get_fe().n_dofs_per_cell());
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          const auto stresses = patches.nodal_stresses(cell);
          typename DoFHandler<dim>::active_cell_iterator(
              &discretization.geometry.triangulation, cell->level(), cell->index(), &scalar_dofs)
              ->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              for (unsigned int k = 0; k < n_voigt<dim>; ++k)
                sums[k](dofs[i]) += stresses[i][k];
              sums.back()(dofs[i]) += 1;
            }
        }
    for (auto &sum : sums)
      sum.compress(VectorOperation::add);

    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
      {
        LA::Vector means(owned, comm);
        for (const auto i : owned)
          means(i) = double(sums[k](i)) / std::max(1., double(sums.back()(i)));
        means.compress(VectorOperation::insert);
        hanging.distribute(means);
        components[k] = means;
      }
  }

  template <int dim>
  std::vector<Voigt<dim>>
  StressRecovery<dim>::values_at(const FEValuesBase<dim> &values) const
  {
    std::vector<Voigt<dim>> result(values.n_quadrature_points);
    std::vector<double>     component(values.n_quadrature_points);
    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
      {
        values.get_function_values(components[k], component);
        for (unsigned int q = 0; q < result.size(); ++q)
          result[q][k] = component[q];
      }
    return result;
  }

  template class StressRecovery<2>;
  template class StressRecovery<3>;
} // namespace Amontons
