#include <amontons/elasticity/stress_recovery.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/householder.h>

#include <limits>
#include <optional>
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

    // All monomials of total degree <= p at a point; appended to `values`.
    template <int dim>
    void
    append_monomials(const unsigned int degree, const Point<dim> &x, std::vector<double> &values)
    {
      double zs = 1;
      for (unsigned int c = 0; c <= (dim == 3 ? degree : 0); ++c, zs *= x[dim - 1])
        {
          double ys = zs;
          for (unsigned int b = 0; b + c <= degree; ++b, ys *= x[1])
            {
              double value = ys;
              for (unsigned int a = 0; a + b + c <= degree; ++a, value *= x[0])
                values.push_back(value);
            }
        }
    }

    // Least-squares polynomial of total degree p through samples, in coordinates scaled to their bounding
    // box.
    template <int dim>
    class PatchPolynomial
    {
    public:
      PatchPolynomial(const unsigned int degree, const std::vector<Sample<dim>> &samples) : degree(degree)
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

      // monomials: room to work in.
      Voigt<dim>
      value(const Point<dim> &X, std::vector<double> &monomials) const
      {
        monomials.clear();
        append_monomials(degree, scaled(X), monomials);
        Voigt<dim> stress;
        stress.fill(0);
        for (unsigned int i = 0; i < monomials.size(); ++i)
          for (unsigned int k = 0; k < n_voigt<dim>; ++k)
            stress[k] += monomials[i] * coefficients[i][k];
        return stress;
      }

      static unsigned int
      n_coefficients(const unsigned int degree)
      {
        return dim == 2 ? (degree + 1) * (degree + 2) / 2 : (degree + 1) * (degree + 2) * (degree + 3) / 6;
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
        const unsigned int  n = n_coefficients(degree);
        std::vector<double> monomials;
        for (const auto &sample : samples)
          append_monomials(degree, scaled(sample.X), monomials);
        const Householder<double> qr(FullMatrix<double>(samples.size(), n, monomials.data()));
        Vector<double>            stresses(samples.size()), solution(n);
        coefficients.resize(n);
        for (unsigned int k = 0; k < n_voigt<dim>; ++k)
          {
            for (unsigned int s = 0; s < samples.size(); ++s)
              stresses[s] = samples[s].stress[k];
            qr.least_squares(solution, stresses);
            for (unsigned int i = 0; i < n; ++i)
              coefficients[i][k] = solution[i];
          }
      }

      unsigned int            degree;
      Point<dim>              centre, scale;
      std::vector<Voigt<dim>> coefficients; // by monomial
    };

    // The patch polynomials at all inner vertices of this rank's cells. Ghost cells complete the patches.
    template <int dim>
    class Patches
    {
    public:
      using GaussStresses = std::vector<std::vector<Voigt<dim>>>; // by active cell

      Patches(const Discretization<dim>     &discretization,
              const ElasticityOperator<dim> &elasticity,
              const LA::Vector              &displacement,
              GaussStresses                 &at_gauss_points,
              double                        &neglected_energy)
          : discretization(discretization), degree(discretization.fe.degree),
            gauss(Polynomials::generate_complete_Lagrange_basis(QGauss<1>(degree).get_points())),
            nodes(discretization.fe.base_element(0).get_unit_support_points()),
            node_positions(discretization.mapping(),
                           discretization.fe,
                           Quadrature<dim>(nodes),
                           update_quadrature_points),
            samples(discretization.geometry.triangulation.n_active_cells()),
            outer(discretization.geometry.triangulation.n_vertices(), false), polynomials(outer.size())
      {
        take_samples(elasticity, displacement, at_gauss_points, neglected_energy);
        find_outer_vertices();
        fit_patches();
      }

      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      // Stress at the nodes of the cell, in the numbering of the base element.
      std::vector<Voigt<dim>>
      nodal_stresses(const Cell &cell)
      {
        node_positions.reinit(cell);
        around.clear();
        for (const unsigned int v : cell->vertex_indices())
          if (const auto &polynomial = polynomials[cell->vertex_index(v)])
            around.emplace_back(v, &*polynomial);
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
      take_samples(const ElasticityOperator<dim> &elasticity,
                   const LA::Vector              &displacement,
                   GaussStresses                 &at_gauss_points,
                   double                        &neglected_energy)
      {
        const QGauss<dim> full(degree + 1), reduced(degree);
        FEValues<dim> values(discretization.mapping(), discretization.fe, full, elasticity.needed_flags());
        FEValues<dim> places(discretization.mapping(), discretization.fe, reduced, update_quadrature_points);
        FullMatrix<double> projection(reduced.size(), full.size());
        for (unsigned int a = 0; a < reduced.size(); ++a)
          for (unsigned int q = 0; q < full.size(); ++q)
            projection(a, q) = full.weight(q) / reduced.weight(a) * gauss.compute_value(a, full.point(q));
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
                      list.back().stress[k] += projection(a, q) * stress[q][k];
                }
              if (!cell->is_locally_owned())
                continue;
              at_gauss_points[cell->active_cell_index()] = stress;
              if (!elasticity.finite_strain())
                neglected_energy += elasticity.energy_of_neglected_stress(values, cell, displacement, stress);
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
                    outer[cell->face(f)->vertex_index(v)] = true;
              }
      }

      void
      fit_patches()
      {
        std::vector<bool> wanted(outer.size(), false);
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() && has_stress(cell))
            for (const unsigned int v : cell->vertex_indices())
              wanted[cell->vertex_index(v)] = !outer[cell->vertex_index(v)];
        std::vector<std::vector<Sample<dim>>> patches(wanted.size());
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (has_stress(cell))
            for (const unsigned int v : cell->vertex_indices())
              if (wanted[cell->vertex_index(v)])
                {
                  auto       &patch = patches[cell->vertex_index(v)];
                  const auto &more  = samples[cell->active_cell_index()];
                  patch.insert(patch.end(), more.begin(), more.end());
                }
        for (unsigned int v = 0; v < patches.size(); ++v)
          if (patches[v].size() >= PatchPolynomial<dim>::n_coefficients(degree))
            polynomials[v].emplace(degree, patches[v]);
      }

      // sum_v N_v sigma_v / sum_v N_v over the inner vertices v with hat function N_v; where all these N_v
      // are zero: the plain mean.
      Voigt<dim>
      nodal_stress(const Cell &cell, const unsigned int i)
      {
        Voigt<dim> weighted, plain;
        weighted.fill(0);
        plain.fill(0);
        double weights = 0;
        for (const auto &[v, polynomial] : around)
          {
            const double     hat    = GeometryInfo<dim>::d_linear_shape_function(nodes[i], v);
            const Voigt<dim> stress = polynomial->value(node_positions.quadrature_point(i), monomials);
            for (unsigned int k = 0; k < n_voigt<dim>; ++k)
              {
                weighted[k] += hat * stress[k];
                plain[k] += stress[k];
              }
            weights += hat;
          }
        if (around.empty())
          return extrapolated(cell, i);
        const bool near = weights > 1e-12;
        for (unsigned int k = 0; k < n_voigt<dim>; ++k)
          weighted[k] = near ? weighted[k] / weights : plain[k] / around.size();
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

      const Discretization<dim>                       &discretization;
      const unsigned int                               degree;
      const TensorProductPolynomials<dim>              gauss; // Lagrange polynomials of the Gauss points
      const std::vector<Point<dim>>                    nodes;
      FEValues<dim>                                    node_positions;
      std::vector<std::vector<Sample<dim>>>            samples;                  // by active cell
      std::vector<bool>                                outer;                    // by vertex
      std::vector<std::optional<PatchPolynomial<dim>>> polynomials;              // by vertex
      std::vector<std::pair<unsigned int, const PatchPolynomial<dim> *>> around; // vertices of a cell
      std::vector<double>                                                monomials;
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

    gauss_stresses.assign(discretization.geometry.triangulation.n_active_cells(), {});
    neglected_energy = 0;
    Patches<dim> patches(discretization, elasticity, displacement, gauss_stresses, neglected_energy);
    std::vector<types::global_dof_index> dofs(scalar_dofs.get_fe().n_dofs_per_cell());
    std::vector<double>                  component(dofs.size());
    const std::vector<double>            ones(dofs.size(), 1.);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          const auto stresses = patches.nodal_stresses(cell);
          typename DoFHandler<dim>::active_cell_iterator(
              &discretization.geometry.triangulation, cell->level(), cell->index(), &scalar_dofs)
              ->get_dof_indices(dofs);
          for (unsigned int k = 0; k < n_voigt<dim>; ++k)
            {
              for (unsigned int i = 0; i < dofs.size(); ++i)
                component[i] = stresses[i][k];
              sums[k].add(dofs, component);
            }
          sums.back().add(dofs, ones);
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
  double
  StressRecovery<dim>::energy_of_neglected_stress() const
  {
    return Utilities::MPI::sum(neglected_energy, discretization.geometry.communicator);
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
