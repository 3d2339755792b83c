// A surface face as a function of what moves it: the displacements of its nodes and the normals there.
#pragma once

#include <amontons/contact/components.h>
#include <amontons/contact/contact_surface.h>
#include <amontons/contact/face_basis.h>

namespace Amontons
{
  // d2X/dxi_k dxi_l of the face as it lies.
  template <int dim>
  std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1>
  second_derivatives(const SurfaceFace<dim> &face, const Point<dim - 1> &xi);

  template <int dim, typename Number>
  struct FrameAD
  {
    Components<dim, Number>                      x;
    std::array<Components<dim, Number>, dim - 1> tangents;
  };

  // With doubles the face as it lies. With ADNumber<n> variables are, from first_displacement on, the nodes'
  // further displacements, and from first_normal on their unit normals (node by node, component by
  // component), about the values that they have.
  template <int dim, typename Number>
  struct FaceAD
  {
    const ContactSurface<dim> &surface;
    unsigned int               face;
    unsigned int               first_displacement = 0, first_normal = 0;

    // X + sum_j (N_j + d(deviation)/du_j) du_j
    Components<dim, Number>
    position(const Point<dim - 1> &xi) const
    {
      Components<dim, Number> x(surface.position(face, xi));
      if constexpr (!std::is_same_v<Number, double>)
        {
          const auto N = lagrange_values<dim - 1>(surface.degree, xi);
          for (unsigned int j = 0; j < N.size(); ++j)
            for (unsigned int d = 0; d < dim; ++d)
              x[d].fastAccessDx(first_displacement + j * dim + d) = N[j];
          for_each_deviation(xi, [&](const auto d, const auto variable, const auto &deviation, const auto e) {
            x[d].fastAccessDx(variable) += deviation.value[d][e];
          });
        }
      return x;
    }

    // To first order in the variables and in xi - value(xi), as is all that follows:
    //   x = X + sum_k dX/dxi_k dxi_k + sum_j (N_j + d(deviation)/du_j) du_j.
    FrameAD<dim, Number>
    frame(const Components<dim - 1, Number> &xi) const
    {
      const Point<dim - 1> at = value_of(xi);
      const auto           f  = surface.frame(face, at);
      FrameAD<dim, Number> result;
      result.x = Components<dim, Number>(f.X);
      for (unsigned int k = 0; k < dim - 1; ++k)
        result.tangents[k] = Components<dim, Number>(f.tangents[k]);
      if constexpr (!std::is_same_v<Number, double>)
        {
          const auto second = second_derivatives(surface.faces[face], at);
          for (unsigned int l = 0; l < dim - 1; ++l)
            {
              const Number dxi = xi[l] - at[l];
              for (unsigned int d = 0; d < dim; ++d)
                {
                  result.x[d] += f.tangents[l][d] * dxi;
                  for (unsigned int k = 0; k < dim - 1; ++k)
                    result.tangents[k][d] += second[k][l][d] * dxi;
                }
            }
          const auto N         = lagrange_values<dim - 1>(surface.degree, at);
          const auto gradients = lagrange_gradients<dim - 1>(surface.degree, at);
          for (unsigned int j = 0; j < N.size(); ++j)
            for (unsigned int d = 0; d < dim; ++d)
              {
                const unsigned int variable = first_displacement + j * dim + d;
                result.x[d].fastAccessDx(variable) += N[j];
                for (unsigned int k = 0; k < dim - 1; ++k)
                  result.tangents[k][d].fastAccessDx(variable) += gradients[j][k];
              }
          for_each_deviation(at, [&](const auto d, const auto variable, const auto &deviation, const auto e) {
            result.x[d].fastAccessDx(variable) += deviation.value[d][e];
            for (unsigned int k = 0; k < dim - 1; ++k)
              result.tangents[k][d].fastAccessDx(variable) += deviation.slopes[k][d][e];
          });
        }
      return result;
    }

    // Calls action(component d, variable of a node's displacement along e, what it does to the deviation, e).
    template <typename Action>
    void
    for_each_deviation(const Point<dim - 1> &xi, const Action &action) const
    {
      if (surface.faces[face].deviation.empty())
        return;
      unsigned int variable = first_displacement;
      for (const auto &deviation : surface.deviation_gradient(face, xi))
        for (unsigned int e = 0; e < dim; ++e, ++variable)
          for (unsigned int d = 0; d < dim; ++d)
            action(d, variable, deviation, e);
    }

    // The interpolated unit normal m/|m|, m = sum_j N_j n_j.
    Components<dim, Number>
    normal(const Components<dim - 1, Number> &xi) const
    {
      const Point<dim - 1> at = value_of(xi);
      if constexpr (std::is_same_v<Number, double>)
        return Components<dim, Number>(surface.nodal_normal(face, at));
      else
        {
          std::array<Tensor<1, dim>, dim - 1> slopes;
          const Tensor<1, dim>                n = surface.nodal_normal(face, at, &slopes);
          Components<dim, Number>             result(n);
          for (unsigned int l = 0; l < dim - 1; ++l)
            for (unsigned int d = 0; d < dim; ++d)
              result[d] += slopes[l][d] * (xi[l] - at[l]);
          const auto     N = lagrange_values<dim - 1>(surface.degree, at);
          Tensor<1, dim> m;
          for (unsigned int j = 0; j < N.size(); ++j)
            m += N[j] * surface.nodes[surface.faces[face].nodes[j]].normal;
          for (unsigned int j = 0; j < N.size(); ++j)
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                result[d].fastAccessDx(first_normal + j * dim + c) +=
                    N[j] / m.norm() * ((c == d ? 1. : 0.) - n[c] * n[d]);
          return result;
        }
    }
  };

  // Normal to the tangents, of the length of their area element.
  template <typename Number>
  Components<2, Number>
  area_vector(const std::array<Components<2, Number>, 1> &t)
  {
    Components<2, Number> c;
    c[0] = t[0][1];
    c[1] = -t[0][0];
    return c;
  }

  template <typename Number>
  Components<3, Number>
  area_vector(const std::array<Components<3, Number>, 2> &t)
  {
    return cross(t[0], t[1]);
  }

  // A quadrature point of a piece of the slave face; what its formula says about the area element included.
  template <int dim, typename Number>
  struct SlavePoint
  {
    SlavePoint(const FaceAD<dim, Number> &face, const Components<dim - 1, Number> &xi, const Number &weight)
        : xi(xi), normal(face.normal(xi))
    {
      const auto frame = face.frame(xi);
      x                = frame.x;
      this->weight     = weight * norm(area_vector(frame.tangents));
    }

    Components<dim - 1, Number> xi;
    Components<dim, Number>     x, normal;
    Number                      weight;
  };

  // Derivatives of xi with x(xi) + g n(xi) = y, of which xi has the value already: one step of Newton's
  // method.
  template <int dim, typename Number>
  Components<dim - 1, Number>
  vary_foot_on_slave(const FaceAD<dim, Number>     &slave,
                     const Point<dim - 1>          &xi,
                     const Components<dim, Number> &y)
  {
    const Components<dim - 1, Number> at(xi);
    if constexpr (std::is_same_v<Number, double>)
      return at;
    std::array<Tensor<1, dim>, dim - 1> slopes;
    const auto                          frame = slave.surface.frame(slave.face, xi);
    const auto                          n     = slave.surface.nodal_normal(slave.face, xi, &slopes);
    const double                        g     = n * (value_of(y) - frame.X);
    std::array<Tensor<1, dim>, dim>     columns;
    for (unsigned int k = 0; k < dim - 1; ++k)
      columns[k] = frame.tangents[k] + g * slopes[k];
    columns[dim - 1] = n;
    const auto step  = solve<dim, Number>(columns, y - slave.position(xi) - scaled(g, slave.normal(at)));
    Components<dim - 1, Number> result;
    for (unsigned int k = 0; k < dim - 1; ++k)
      result[k] = xi[k] + (step[k] - value_of(step[k]));
    return result;
  }

  // The same for (eta, g) with y(eta) - g n = x.
  template <int dim, typename Number>
  Components<dim, Number>
  vary_foot_on_master(const FaceAD<dim, Number>     &master,
                      const Point<dim - 1>          &eta,
                      const double                   g,
                      const Components<dim, Number> &x,
                      const Components<dim, Number> &n)
  {
    std::array<Tensor<1, dim>, dim> columns;
    for (unsigned int k = 0; k < dim - 1; ++k)
      columns[k] = master.surface.frame(master.face, eta).tangents[k];
    columns[dim - 1]             = -value_of(n);
    const auto              step = solve<dim, Number>(columns, x + scaled(g, n) - master.position(eta));
    Components<dim, Number> result;
    for (unsigned int k = 0; k < dim; ++k)
      result[k] = (k < dim - 1 ? eta[k] : g) + (step[k] - value_of(step[k]));
    return result;
  }
} // namespace Amontons
