#include <amontons/contact/face_basis.h>
#include <amontons/contact/face_lattice.h>
#include <amontons/contact/pressure_projection.h>

#include <functional>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

namespace Amontons
{
  namespace
  {
    // Solves for c in place of the right-hand side. Of slivers that are all that is left of a contact the
    // mass may have no factors: then with a diagonal that is rounding beside it, and 0 if there is none.
    void
    solve(SparseMatrix<double> &matrix, Vector<double> &c)
    {
      double largest = 0;
      for (unsigned int i = 0; i < c.size(); ++i)
        largest = std::max(largest, matrix.diag_element(i));
      const Vector<double> rhs = c;
      for (const double shift : {0., 1e-10})
        try
          {
            for (unsigned int i = 0; i < c.size(); ++i)
              matrix.diag_element(i) += shift * largest;
            SparseDirectUMFPACK solver;
            solver.initialize(matrix);
            solver.solve(c);
            return;
          }
        catch (const ExceptionBase &)
          {
            c = rhs;
          }
      c = 0;
    }

    // The minimum of c.Mc/2 - b.c over all c with c_i >= 0 where is_bounded[i], by its active set: entries
    // that are held at 0 with (Mc - b)_i >= 0.
    Vector<double>
    solve_projection(const SparseMatrix<double> &mass,
                     const Vector<double>       &rhs,
                     const std::vector<bool>    &is_bounded)
    {
      const unsigned int   n = rhs.size();
      std::vector<bool>    held(n, false);
      Vector<double>       c(n), residual(n);
      SparseMatrix<double> matrix(mass.get_sparsity_pattern());
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          matrix.copy_from(mass);
          c = rhs;
          for (unsigned int i = 0; i < n; ++i)
            for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
              if (held[i] || held[entry->column()])
                entry->value() = i == entry->column() ? mass.diag_element(i) : 0.;
          for (unsigned int i = 0; i < n; ++i)
            if (held[i])
              c[i] = 0;
          solve(matrix, c);
          mass.vmult(residual, c);
          residual -= rhs;
          bool changed = false;
          for (unsigned int i = 0; i < n; ++i)
            if (is_bounded[i])
              {
                const bool hold = held[i] ? residual[i] > 0 : c[i] < 0;
                changed         = changed || hold != held[i];
                held[i]         = hold;
              }
          if (!changed)
            break;
        }
      for (unsigned int i = 0; i < n; ++i)
        if (is_bounded[i])
          c[i] = std::max(0., c[i]);
      return c;
    }
  } // namespace

  template <int dim>
  std::vector<double>
  project(const ContactInterface<dim> &interface,
          const std::vector<double>   &row_values,
          const bool                   nonnegative,
          const Smoothness            &smoothness)
  {
    using Terms                                       = std::vector<std::pair<unsigned int, double>>;
    const auto                              &coupling = interface.coupling;
    const std::function<Terms(unsigned int)> expand   = [&](const unsigned int node) {
      for (const auto *const known : {&smoothness.means, &coupling.slivers})
        if (const auto mean = known->find(node); mean != known->end())
          {
            Terms terms;
            for (const unsigned int other : mean->second)
              for (const auto &[i, a] : expand(other))
                terms.emplace_back(i, a / mean->second.size());
            return terms;
          }
      return Terms{{node, 1.}};
    };
    std::map<unsigned int, unsigned int> unknown; // by slave node
    for (const auto &entry : coupling.trace_mass)
      for (const auto &term : expand(entry.first.first))
        unknown.emplace(term.first, unknown.size());
    std::vector<double> control(interface.slave->nodes.size(), 0.);
    const unsigned int  n = unknown.size();
    if (n == 0)
      return control;

    std::vector<std::tuple<unsigned int, unsigned int, double>> entries;
    std::vector<double>                                         area(n, 0.);
    for (const auto &[nodes, value] : coupling.trace_mass)
      for (const auto &[i, a] : expand(nodes.first))
        for (const auto &[j, b] : expand(nodes.second))
          {
            entries.emplace_back(unknown[i], unknown[j], a * b * value);
            area[unknown[i]] += a * b * value;
          }
    for (const auto &jump : smoothness.jumps)
      {
        constexpr double weight = 0.25;
        Terms            terms;
        double           jump_area = 0;
        for (const auto &[node, coefficient] : jump.terms)
          for (const auto &[i, a] : expand(node))
            terms.emplace_back(unknown.at(i), coefficient * a);
        for (const unsigned int node : jump.edge)
          for (const auto &[i, a] : expand(node))
            jump_area += area[unknown.at(i)] / jump.edge.size();
        for (const auto &[i, a] : terms)
          for (const auto &[j, b] : terms)
            entries.emplace_back(i, j, weight * jump_area * a * b);
      }
    DynamicSparsityPattern dsp(n, n);
    for (const auto &entry : entries)
      dsp.add(std::get<0>(entry), std::get<1>(entry));
    SparsityPattern pattern;
    pattern.copy_from(dsp);
    SparseMatrix<double> mass(pattern);
    for (const auto &[i, j, value] : entries)
      mass.add(i, j, value);
    Vector<double>    rhs(n);
    std::vector<bool> is_bounded(n, nonnegative);
    for (unsigned int r = 0; r < coupling.rows.size(); ++r)
      for (const auto &[node, trace] : coupling.rows[r].traces)
        for (const auto &[i, a] : expand(node))
          {
            rhs[unknown[i]] += a * trace * row_values[r];
            if (interface.pair->tied && row_values[r] < 0)
              is_bounded[unknown[i]] = false;
          }
    const Vector<double> c = solve_projection(mass, rhs, is_bounded);
    for (const auto &entry : coupling.trace_mass)
      for (const auto &[i, a] : expand(entry.first.first))
        if (entry.first.first == entry.first.second)
          control[entry.first.first] += a * c[unknown[i]];
    return control;
  }

  template <int dim>
  std::vector<double>
  control_to_nodal(const ContactSurface<dim> &surface, const std::vector<double> &control)
  {
    std::vector<double> nodal(surface.nodes.size(), 0.);
    const auto          place = lattice<dim - 1>(surface.degree);
    for (const auto &face : surface.faces)
      for (unsigned int k = 0; k < face.nodes.size(); ++k)
        {
          const auto B =
              traces_of_unknowns(bernstein_values<dim - 1>(surface.degree, place[k]), face.subdivision);
          double v = 0;
          for (unsigned int j = 0; j < B.size(); ++j)
            v += B[j] * control[face.unknowns[j]];
          nodal[face.nodes[k]] = v;
        }
    return nodal;
  }

  template std::vector<double>
  project(const ContactInterface<2> &, const std::vector<double> &, const bool, const Smoothness &);
  template std::vector<double>
  project(const ContactInterface<3> &, const std::vector<double> &, const bool, const Smoothness &);
  template std::vector<double>
  control_to_nodal(const ContactSurface<2> &, const std::vector<double> &);
  template std::vector<double>
  control_to_nodal(const ContactSurface<3> &, const std::vector<double> &);
} // namespace Amontons
