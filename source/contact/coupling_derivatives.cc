#include <amontons/base/gather.h>
#include <amontons/contact/coupling_derivatives.h>
#include <amontons/contact/face_derivatives.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>

#include <algorithm>
#include <set>

namespace Amontons
{
  namespace
  {
    void
    add_to(Gradient &sum, const Gradient &part)
    {
      for (const auto &[dof, value] : part)
        sum[dof] += value;
    }

    void
    add_to(Gradient &sum, const std::vector<types::global_dof_index> &dofs, const std::vector<double> &values)
    {
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (values[i] != 0)
          sum[dofs[i]] += values[i];
    }

    // Adds one face's part to the row of its unknown i. With P = int psi n and H = int psi g n,
    //   normal = P/area,   gap = P . H/area^2,
    //   d(gap) = (H/area . dP + normal . dH - 2 gap darea)/area.
    template <int dim>
    void
    add_face(const MortarRow<dim>       &row,
             const FaceDerivatives<dim> &face,
             const unsigned int          i,
             RowGradient<dim>           &gradient)
    {
      const Tensor<1, dim> none;
      add_to(gradient.gap,
             face.dofs,
             face.integral_gradient(i,
                                    row.gap_vector / row.area,
                                    row.normal / row.area,
                                    -2 * (row.normal * row.gap_vector) / row.area));
      for (unsigned int c = 0; c < dim; ++c)
        {
          Tensor<1, dim> p;
          p[c] = 1 / row.area;
          add_to(
              gradient.normal[c], face.dofs, face.integral_gradient(i, p, none, -row.normal[c] / row.area));
        }
      add_to(gradient.area, face.dofs, face.integral_gradient(i, none, none, 1));
    }

    // The parts of all ranks, added in their order.
    template <int dim>
    std::vector<RowGradient<dim>>
    sum_over_ranks(const unsigned int                       n_rows,
                   std::map<unsigned int, RowGradient<dim>> mine,
                   const MPI_Comm                           communicator)
    {
      std::vector<RowGradient<dim>> sums(n_rows);
      for (auto &part : gather_on_all(communicator, std::move(mine)))
        for (auto &[row, gradient] : part)
          if (sums[row].area.empty())
            sums[row] = std::move(gradient);
          else
            {
              add_to(sums[row].gap, gradient.gap);
              for (unsigned int c = 0; c < dim; ++c)
                add_to(sums[row].normal[c], gradient.normal[c]);
              add_to(sums[row].area, gradient.area);
            }
      return sums;
    }
  } // namespace

  template <int dim>
  CouplingDerivatives<dim>::CouplingDerivatives(const Discretization<dim>   &discretization,
                                                const ContactInterface<dim> &interface,
                                                const std::vector<bool>     &wanted)
      : wanted(wanted)
  {
    const auto                &slave        = *interface.slave;
    const auto                &coupling     = interface.coupling;
    const MPI_Comm             communicator = discretization.geometry.communicator;
    const FacesWithPoints<dim> points_of(slave.faces.size(), coupling.points, communicator);
    std::vector<unsigned int>  row_of_node(slave.nodes.size(), numbers::invalid_unsigned_int);
    for (unsigned int r = 0; r < coupling.rows.size(); ++r)
      row_of_node[coupling.rows[r].node] = r;

    std::map<unsigned int, RowGradient<dim>>       mine;
    typename FaceDerivatives<dim>::NormalGradients normal_gradients;
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      if (points_of.meets(f) && points_of.is_mine(f))
        {
          std::vector<unsigned int> rows;
          for (const unsigned int node : slave.faces[f].unknowns)
            rows.push_back(row_of_node[node]);
          const auto is_wanted = [&](const unsigned int r) {
            return r != numbers::invalid_unsigned_int && wanted[r];
          };
          if (std::none_of(rows.begin(), rows.end(), is_wanted))
            continue;
          faces.emplace_back(discretization, interface, points_of[f], rows, normal_gradients);
          for (unsigned int i = 0; i < rows.size(); ++i)
            if (is_wanted(rows[i]))
              add_face(coupling.rows[rows[i]], faces.back(), i, mine[rows[i]]);
          faces.back().forget_rows();
        }
    gradients = sum_over_ranks(wanted.size(), std::move(mine), communicator);
  }

  template <int dim>
  CouplingDerivatives<dim>::~CouplingDerivatives() = default;

  template <int dim>
  std::vector<LocalMatrix>
  CouplingDerivatives<dim>::stiffness(const std::vector<Tensor<1, dim>> &tractions) const
  {
    auto tractions_here = tractions;
    for (unsigned int r = 0; r < wanted.size(); ++r)
      if (!wanted[r])
        tractions_here[r] = 0;
    std::vector<LocalMatrix> matrices;
    for (const auto &face : faces)
      matrices.push_back(face.stiffness(tractions_here));
    return matrices;
  }

  template <int dim>
  std::vector<std::vector<types::global_dof_index>>
  CouplingDerivatives<dim>::links() const
  {
    std::map<unsigned int, std::set<types::global_dof_index>> opposite; // by row
    for (const auto &face : faces)
      for (const unsigned int row : face.rows)
        {
          const auto dofs = face.master_dofs();
          opposite[row].insert(dofs.begin(), dofs.end());
        }
    std::vector<std::vector<types::global_dof_index>> groups;
    for (const auto &face : faces)
      {
        std::set<types::global_dof_index> group(face.dofs.begin(), face.dofs.end());
        for (const unsigned int row : face.rows)
          group.insert(opposite[row].begin(), opposite[row].end());
        groups.emplace_back(group.begin(), group.end());
      }
    return groups;
  }

  template class CouplingDerivatives<2>;
  template class CouplingDerivatives<3>;
} // namespace Amontons
