// The quadrature points of an overlap as functions of what moves the two faces.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/contact/covered_shares.h>
#include <amontons/contact/polygon_clipping.h>
#include <amontons/contact/segment_clipping.h>

#include <amontons/base/points.h>

namespace Amontons
{
  // Variables, node by node and component by component: displacements of the slave face's nodes, the normals
  // there, displacements of the master face's nodes or of the carrier's corners.
  constexpr unsigned int
  n_face_nodes(const int dim, const int degree)
  {
    return dim == 2 ? degree + 1 : (degree + 1) * (degree + 1);
  }

  // A multiple of four, which compilers like.
  constexpr unsigned int
  n_variables(const int dim, const int degree)
  {
    const unsigned int n = n_face_nodes(dim, degree), n_master = n > dim + 1u ? n : dim + 1u;
    return (dim * (2 * n + n_master) + 3) / 4 * 4;
  }

  // What an OverlapPoint says to the integrals.
  template <int dim, int n>
  struct PointAD
  {
    Components<dim - 1, ADNumber<n>> xi;
    ADNumber<n>                      weight, gap;
    Components<dim, ADNumber<n>>     normal;
    std::vector<ADNumber<n>>         master; // shape values
  };

  template <int dim>
  double
  declared_gap(const ContactInterface<dim> &interface, const OverlapPoint<dim> &p, const Point<dim - 1> &xi)
  {
    return interface.pair->initial_gap
               ? interface.pair->initial_gap->value(
                     as_3d(interface.slave->reference_position(p.slave_face, xi)), interface.t)
               : 0.;
  }

  // The projected point on the other face; of a declared gap the slope is taken by differences.
  template <int dim, int n>
  PointAD<dim, n>
  vary_point(const ContactInterface<dim>        &interface,
             const FaceAD<dim, ADNumber<n>>     &master,
             const SlavePoint<dim, ADNumber<n>> &slave,
             const OverlapPoint<dim>            &p)
  {
    PointAD<dim, n> result{slave.xi, slave.weight, {}, slave.normal, {}};
    const auto      projection =
        vary_foot_on_master(master, p.xi_master, p.normal * (p.x_master - p.x_slave), slave.x, slave.normal);
    result.gap = projection[dim - 1];
    if (interface.pair->initial_gap)
      {
        result.gap += declared_gap(interface, p, p.xi_slave);
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            const Point<dim - 1> step = 1e-5 * Point<dim - 1>::unit_vector(k);
            result.gap += (declared_gap(interface, p, p.xi_slave + step) -
                           declared_gap(interface, p, Point<dim - 1>(p.xi_slave - step))) /
                          2e-5 * (slave.xi[k] - p.xi_slave[k]);
          }
      }
    const auto N         = lagrange_values<dim - 1>(master.surface.degree, p.xi_master);
    const auto gradients = lagrange_gradients<dim - 1>(master.surface.degree, p.xi_master);
    for (unsigned int q = 0; q < N.size(); ++q)
      {
        result.master.emplace_back(N[q]);
        for (unsigned int k = 0; k < dim - 1; ++k)
          result.master[q] += gradients[q][k] * (projection[k] - p.xi_master[k]);
      }
    return result;
  }

  // The obstacle's normal m at the foot y = x + g n, which its carrier moves by sum_k N_k du_k:
  //   dg = -m . (dx + g dn - sum_k N_k du_k) / (m . n),
  // and the foot is another point of the obstacle then: dX = A^-1 (dx + d(g n) - sum_k N_k du_k).
  template <int dim, int n>
  PointAD<dim, n>
  vary_point(const Discretization<dim>          &discretization,
             const ContactInterface<dim>        &interface,
             const unsigned int                  first_variable,
             const SlavePoint<dim, ADNumber<n>> &slave,
             const OverlapPoint<dim>            &p)
  {
    const auto          &master = interface.master;
    PointAD<dim, n>      result{slave.xi, slave.weight, {}, slave.normal, {}};
    const Tensor<1, dim> m =
        project_to_obstacle(*master.obstacle, master.motion, p.x_slave, p.normal)->normal;
    const double g       = p.normal * (p.x_master - p.x_slave);
    const auto   weights = [&](const Point<dim> &X) {
      return discretization.carrier_weights(master.carrier, X);
    };
    const auto                   N     = weights(master.motion.origin_of(p.x_master));
    Components<dim, ADNumber<n>> moved = slave.x + scaled(g, slave.normal), dX;
    for (unsigned int d = 0; d < dim; ++d)
      {
        moved[d] -= value_of(moved[d]);
        for (unsigned int k = 0; k <= dim; ++k)
          moved[d].fastAccessDx(first_variable + k * dim + d) -= N[k];
      }
    ADNumber<n> dg(0.);
    for (unsigned int d = 0; d < dim; ++d)
      dg -= m[d] / (m * p.normal) * moved[d];
    result.gap                = p.gap + dg;
    const Tensor<2, dim> back = invert(master.motion.A);
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        dX[d] += back[d][e] * (moved[e] + p.normal[e] * dg);
    const auto at_0 = weights(Point<dim>());
    for (unsigned int k = 0; k <= dim; ++k)
      {
        result.master.emplace_back(N[k]);
        for (unsigned int d = 0; d < dim; ++d)
          result.master[k] += (weights(Point<dim>::unit_vector(d))[k] - at_0[k]) * dX[d];
      }
    return result;
  }

  // Calls consume(PointAD) for all points of a slave face above one master face, or above the obstacle.
  template <int dim, int n, typename Consume>
  void
  vary_points(const Discretization<dim>       &discretization,
              const ContactInterface<dim>     &interface,
              const Clipper<dim, ADNumber<n>> &clipper,
              const PointsView<dim>           &points,
              const Consume                   &consume)
  {
    const bool         axisymmetric   = discretization.scene.kind == ProblemType::axisymmetric;
    const unsigned int first_variable = 2 * dim * n_face_nodes(dim, interface.slave->degree);
    const auto         on_turn        = [&](SlavePoint<dim, ADNumber<n>> slave) {
      if (axisymmetric)
        slave.weight *= 2 * numbers::PI * slave.x[0];
      return slave;
    };
    if (interface.master.surface == nullptr)
      {
        for (const auto &p : points)
          {
            // Pieces stay where they are on the face: so do their ends at an obstacle's edge.
            SlavePoint<dim, ADNumber<n>> slave =
                on_turn({clipper.slave, Components<dim - 1, ADNumber<n>>(p.xi_slave), ADNumber<n>(1.)});
            slave.weight *= p.weight / slave.weight.val();
            consume(vary_point(discretization, interface, first_variable, slave, p));
          }
        return;
      }
    const FaceAD<dim, ADNumber<n>> master{*interface.master.surface, points[0].master_face, first_variable};
    unsigned int                   next = 0;
    // Pieces that have not been counted are passed over.
    clipper.for_each_piece(master, [&](const unsigned int n_points, const auto &slave_point) {
      for (unsigned int q = 0; q < n_points; ++q, ++next)
        {
          const auto slave = on_turn(slave_point(q));
          if (next == points.size() || value_of(slave.xi).distance(points[next].xi_slave) > 1e-9)
            {
              AssertThrow(q == 0, ExcInternalError());
              return;
            }
          consume(vary_point(interface, master, slave, points[next]));
        }
    });
    AssertThrow(next == points.size(), ExcInternalError());
  }
} // namespace Amontons
