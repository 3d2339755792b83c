#include <amontons/contact/face_derivatives.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    // to += factor row
    void
    add_row(const double              factor,
            const FullMatrix<double> &matrix,
            const unsigned int        row,
            std::vector<double>      &to)
    {
      if (factor == 0)
        return;
      const double *from = &matrix(row, 0);
      for (unsigned int v = 0; v < to.size(); ++v)
        to[v] += factor * from[v];
    }
  } // namespace

  template <int dim>
  FaceDerivatives<dim>::FaceDerivatives(const Discretization<dim>       &discretization,
                                        const ContactInterface<dim>     &interface,
                                        const PointsView<dim>           &points,
                                        const std::vector<unsigned int> &rows,
                                        NormalGradients                 &normal_gradients)
      : rows(rows), moments(make_face_moments(discretization, interface, points))
  {
    const unsigned int face = points[0].slave_face;
    make_coefficients(interface.slave->faces[face].subdivision);
    make_dofs(*interface.slave, face, normal_gradients);
  }

  template <int dim>
  void
  FaceDerivatives<dim>::make_coefficients(const FullMatrix<double> &subdivision)
  {
    const unsigned int n    = moments.n;
    const auto   carries    = [&](const unsigned int i) { return rows[i] != numbers::invalid_unsigned_int; };
    unsigned int n_carrying = 0;
    for (unsigned int i = 0; i < n; ++i)
      n_carrying += carries(i);
    S.reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; carries(i) && j < n; ++j)
        S(i, j) = i == j ? 1. : carries(j) ? 0. : 1. / n_carrying;
    Q = moments.R;
    if (!subdivision.empty())
      subdivision.Tmmult(Q, moments.R);
    C.reinit(n, n);
    single = n_carrying == 1;
    if (single)
      {
        for (unsigned int i = 0; i < n; ++i)
          C(i, 0) = carries(i);
        return;
      }
    G_inverse.reinit(n, n);
    G_inverse.invert(moments.G);
    FullMatrix<double> Q_inverse(n, n);
    Q_inverse.invert(Q);
    W.reinit(n, n);
    Q_inverse.Tmmult(W, G_inverse);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int r = 0; r < n; ++r)
        {
          double D = 0;
          for (unsigned int k = 0; k < n; ++k)
            D += Q(r, k) * moments.G(k, 0);
          for (unsigned int k = 0; k < n; ++k)
            C(i, k) += S(i, r) * D * W(r, k);
        }
  }

  template <int dim>
  void
  FaceDerivatives<dim>::make_dofs(const ContactSurface<dim> &slave,
                                  const unsigned int         face,
                                  NormalGradients           &normal_gradients)
  {
    const auto &nodes = slave.faces[face].nodes;
    for (const unsigned int i : nodes)
      if (normal_gradients.count(i) == 0)
        normal_gradients[i] = slave.normal_gradient(i);

    const auto add_node = [&](const NodeDofs<dim> &node) {
      dofs.insert(dofs.end(), node.begin(), node.end());
    };
    for (const unsigned int i : nodes)
      {
        add_node(slave.nodes[i].dofs);
        for (const auto &entry : normal_gradients[i])
          dofs.push_back(entry.first);
      }
    for (const unsigned int i : slave.faces[face].unknowns)
      for (const auto &entry : slave.nodes[i].control)
        add_node(slave.nodes[entry.first].dofs);
    for (const auto &node : moments.master)
      add_node(node);
    std::sort(dofs.begin(), dofs.end());
    dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());

    const auto place = [&](const types::global_dof_index dof) -> unsigned int {
      return std::lower_bound(dofs.begin(), dofs.end(), dof) - dofs.begin();
    };
    for (const unsigned int i : nodes)
      for (unsigned int c = 0; c < dim; ++c)
        columns.push_back({{place(slave.nodes[i].dofs[c]), 1.}});
    for (const unsigned int i : nodes)
      for (unsigned int c = 0; c < dim; ++c)
        {
          columns.emplace_back();
          for (const auto &[dof, dn] : normal_gradients[i])
            columns.back().emplace_back(place(dof), dn[c]);
        }
    for (const auto &node : moments.master)
      for (unsigned int c = 0; c < dim; ++c)
        {
          columns.push_back({{place(node[c]), 1.}});
        }

    const auto force_on = [&](const types::global_dof_index dof) -> unsigned int {
      const auto found = std::find(forced_dofs.begin(), forced_dofs.end(), dof);
      if (found == forced_dofs.end())
        {
          forced_dofs.push_back(dof);
          return forced_dofs.size() - 1;
        }
      return found - forced_dofs.begin();
    };
    for (const auto &node : moments.master)
      for (unsigned int c = 0; c < dim; ++c)
        master_forces.push_back({{force_on(node[c]), 1.}});
    for (const unsigned int i : slave.faces[face].unknowns)
      for (unsigned int c = 0; c < dim; ++c)
        {
          slave_forces.emplace_back();
          for (const auto &[j, weight] : slave.nodes[i].control)
            slave_forces.back().emplace_back(force_on(slave.nodes[j].dofs[c]), weight);
        }
  }

  template <int dim>
  std::vector<types::global_dof_index>
  FaceDerivatives<dim>::master_dofs() const
  {
    std::vector<types::global_dof_index> result;
    for (const auto &node : moments.master)
      result.insert(result.end(), node.begin(), node.end());
    return result;
  }

  template <int dim>
  void
  FaceDerivatives<dim>::chain(const double *by_variable, double *by_dof) const
  {
    for (unsigned int v = 0; v < columns.size(); ++v)
      if (by_variable[v] != 0)
        for (const auto &[place, factor] : columns[v])
          by_dof[place] += factor * by_variable[v];
  }

  // With m_k = int L_k (p . n + h . g n + a):  d(C m) = C dm + S diag(dD) W m - C dG G^-1 m.
  template <int dim>
  std::vector<double>
  FaceDerivatives<dim>::integral_gradient(const unsigned int    i,
                                          const Tensor<1, dim> &p,
                                          const Tensor<1, dim> &h,
                                          const double          a) const
  {
    const unsigned int  n = moments.n;
    std::vector<double> result(moments.n_variables, 0.), by_dof(dofs.size(), 0.);
    FullMatrix<double>  of_G(n, n); // factors of dG
    for (unsigned int k = 0; k < n; ++k)
      {
        of_G(k, 0) += a * C(i, k);
        for (unsigned int c = 0; c < dim; ++c)
          {
            add_row(p[c] * C(i, k), moments.dP, k * dim + c, result);
            add_row(h[c] * C(i, k), moments.dH, k * dim + c, result);
          }
      }
    if (!single)
      {
        Vector<double> m(n), y(n), Wm(n);
        for (unsigned int k = 0; k < n; ++k)
          m[k] = p * moments.P[k] + h * moments.H[k] + a * moments.G(k, 0);
        G_inverse.vmult(y, m);
        W.vmult(Wm, m);
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int l = 0; l < n; ++l)
            {
              of_G(k, 0) += S(i, l) * Wm[l] * Q(l, k);
              of_G(k, l) -= C(i, k) * y[l];
            }
      }
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int l = 0; l < n; ++l)
        add_row(of_G(k, l), moments.dG, k * n + l, result);
    chain(result.data(), by_dof.data());
    return by_dof;
  }

  // On the trace of unknown j: tau_j D_j, tau_j = sum_i t_i S_ij. On the master: -sum_k lambda_k N_kq,
  // lambda_k = sum_i t_i C_ik, so that with Y = G^-1 N
  //   d(force_q) = -sum_k lambda_k dN_kq - sum_r tau_r dD_r (W N)_rq + sum_kl lambda_k dG_kl Y_lq.
  template <int dim>
  LocalMatrix
  FaceDerivatives<dim>::stiffness(const std::vector<Tensor<1, dim>> &tractions) const
  {
    const unsigned int          n = moments.n, n_master = moments.master.size(), n_v = moments.n_variables;
    std::vector<Tensor<1, dim>> tau(n), lambda(n);
    for (unsigned int i = 0; i < n; ++i)
      if (rows[i] != numbers::invalid_unsigned_int)
        for (unsigned int j = 0; j < n; ++j)
          {
            tau[j] += S(i, j) * tractions[rows[i]];
            lambda[j] += C(i, j) * tractions[rows[i]];
          }
    FullMatrix<double> dD(n, n_v), WN(n, n_master), Y(n, n_master);
    for (unsigned int r = 0; r < n; ++r)
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int v = 0; v < n_v; ++v)
          dD(r, v) += Q(r, k) * moments.dG(k * n, v);
    if (!single)
      {
        W.mmult(WN, moments.N);
        G_inverse.mmult(Y, moments.N);
      }

    LocalMatrix         result{forced_dofs, dofs, FullMatrix<double>(forced_dofs.size(), dofs.size())};
    std::vector<double> by_dof(dofs.size());
    const auto          add = [&](const std::vector<double> &gradient, const Line &where) {
      std::fill(by_dof.begin(), by_dof.end(), 0.);
      chain(gradient.data(), by_dof.data());
      for (const auto &[row, weight] : where)
        for (unsigned int column = 0; column < dofs.size(); ++column)
          result.matrix(row, column) += weight * by_dof[column];
    };
    for (unsigned int c = 0; c < dim; ++c)
      {
        FullMatrix<double> E(n, n_v); // sum_k lambda_k dG_kl
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int l = 0; l < n; ++l)
            for (unsigned int v = 0; v < n_v; ++v)
              E(l, v) += lambda[k][c] * moments.dG(k * n + l, v);
        for (unsigned int j = 0; j < n; ++j)
          {
            std::vector<double> gradient(n_v, 0.);
            add_row(tau[j][c], dD, j, gradient);
            add(gradient, slave_forces[j * dim + c]);
          }
        for (unsigned int q = 0; q < n_master; ++q)
          {
            std::vector<double> gradient(n_v, 0.);
            for (unsigned int k = 0; k < n; ++k)
              {
                add_row(-lambda[k][c], moments.dN, k * n_master + q, gradient);
                add_row(-tau[k][c] * WN(k, q), dD, k, gradient);
                add_row(Y(k, q), E, k, gradient);
              }
            add(gradient, master_forces[q * dim + c]);
          }
      }
    return result;
  }

  template <int dim>
  void
  FaceDerivatives<dim>::forget_rows()
  {
    moments.dP.reinit(0, 0);
    moments.dH.reinit(0, 0);
  }

  template class FaceDerivatives<2>;
  template class FaceDerivatives<3>;
} // namespace Amontons
