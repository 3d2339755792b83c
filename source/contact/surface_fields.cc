#include <amontons/contact/common_normal.h>
#include <amontons/contact/covered_shares.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/face_lattice.h>
#include <amontons/contact/force_centre.h>
#include <amontons/contact/shear_smoothness.h>
#include <amontons/contact/surface_fields.h>

namespace Amontons
{
  namespace
  {
    // The centre of a symmetric contact is where the slave surface meets the symmetry planes (or the axis,
    // but for a ring: its mean radius is 2.6 times the spread about it under Hertz's pressure, 3.5 times
    // under a flat punch).
    template <int dim>
    void
    find_centre(const Discretization<dim>   &discretization,
                const ContactInterface<dim> &interface,
                SurfaceFields<dim>          &fields)
    {
      const auto found  = force_centre(interface, fields.pressure);
      Point<dim> centre = found.centre;
      // A plane cuts the contact if it is as near as an end of half a contact is (1.6 spreads for half of a
      // Hertz pressure), and something presses there (not so where a pin that fits its hole presses to one
      // side).
      const bool axisymmetric = discretization.scene.kind == ProblemType::axisymmetric;
      auto      &planes       = fields.symmetry_planes;
      for (unsigned int i = 0; i < interface.slave->nodes.size(); ++i)
        if (fields.area[i] > 0 && (interface.pair->tied || fields.multiplier[i] > 0) &&
            interface.slave->nodes[i].x.distance(found.centre) < 2.5 * found.spread)
          for (const auto &normal : interface.slave->nodes[i].symmetry_planes)
            if (!axisymmetric && std::none_of(planes.begin(), planes.end(), [&](const auto &m) {
                  return std::abs(m * normal) > 1 - 1e-6;
                }))
              {
                planes.push_back(normal);
                centre -= (normal * (centre - interface.slave->nodes[i].x)) * normal;
                fields.symmetry_factor *= 2;
              }
      if (axisymmetric && centre[0] < 6 * found.spread)
        centre[0] = 0;
      fields.centre = centre;
    }

    template <int dim>
    bool
    is_around_axis(const Discretization<dim> &discretization, const SurfaceFields<dim> &fields)
    {
      return discretization.scene.kind == ProblemType::axisymmetric && fields.centre[0] == 0;
    }

    template <int dim>
    bool
    is_of_a_point(const Discretization<dim> &discretization, const SurfaceFields<dim> &fields)
    {
      return dim == 3 || is_around_axis(discretization, fields);
    }

    // Where the stick zone is: the centroid of what the shear leaves of its bound, on the symmetry planes
    // (and the axis) of the contact.
    template <int dim>
    Point<dim>
    stick_centre(const Discretization<dim>   &discretization,
                 const ContactInterface<dim> &interface,
                 const SurfaceFields<dim>    &fields,
                 const std::vector<double>   &unused)
    {
      double     total = 0;
      Point<dim> centre;
      for (const auto &p : interface.coupling.points)
        {
          const double f = value_on_face(*interface.slave, unused, p.slave_face, p.xi_slave) * p.weight;
          total += f;
          centre += f * p.x_slave;
        }
      if (!(total > 0))
        return fields.centre;
      centre /= total;
      for (const auto &normal : fields.symmetry_planes)
        centre -= (normal * (centre - fields.centre)) * normal;
      if (is_around_axis(discretization, fields))
        centre[0] = 0;
      return centre;
    }

    // Half-width or radius about `centre` of the Hertzian traction with the moments of the field f:
    // sqrt(4 int f x^2 / int f), for points 2.5 instead of 4; 0 where the field is all around its centre, as
    // in a shrink fit, and x is what the mesh makes of nothing.
    template <int dim>
    double
    size_of(const ContactInterface<dim> &interface,
            const bool                   of_a_point,
            const Point<dim>            &centre,
            const std::vector<double>   &field)
    {
      constexpr double all_around = 1e-4;
      double           force = 0, second_moment = 0, polar_moment = 0;
      for (const auto &p : interface.coupling.points)
        {
          const double f = value_on_face(*interface.slave, field, p.slave_face, p.xi_slave) * p.weight;
          const auto   r = p.x_slave - centre;
          force += f;
          second_moment += f * (r * r - (r * p.normal) * (r * p.normal));
          polar_moment += f * (r * r);
        }
      if (second_moment < all_around * polar_moment)
        return 0;
      const double factor = of_a_point ? 2.5 : 4;
      return force > 0 ? std::sqrt(std::max(0., factor * second_moment / force)) : 0;
    }

    template <int dim>
    void
    add_resultants(const Discretization<dim>   &discretization,
                   const ContactInterface<dim> &interface,
                   SurfaceFields<dim>          &fields)
    {
      find_centre(discretization, interface, fields);
      double force = 0, area = 0;
      for (const auto &p : interface.coupling.points)
        {
          area += p.weight;
          const double f =
              value_on_face(*interface.slave, fields.pressure, p.slave_face, p.xi_slave) * p.weight;
          const auto r = p.x_slave - fields.centre;
          force += f;
          fields.covariance += f * outer_product(r, r);
        }
      if (force > 0)
        fields.covariance /= force;
      // A force of rounding, where surfaces just touch, is at no place.
      if (force > 1e-17 * area * discretization.scene.bodies[interface.slave->body].material.young)
        fields.contact_size =
            size_of(interface, is_of_a_point(discretization, fields), fields.centre, fields.pressure);
    }

    // Over the overlap: at its points and at the nodes of faces that are covered whole. Nodal values beyond
    // an edge of the other body are continuations.
    // On faces of which nodes are covered but not the whole, no more than at these: slivers bear anything.
    template <int dim>
    double
    peak(const ContactInterface<dim> &interface,
         const std::vector<double>   &pressure,
         const std::vector<bool>     &is_covered)
    {
      const auto &slave   = *interface.slave;
      double      largest = 0;
      for (const auto &p : interface.coupling.points)
        {
          double value = value_on_face(slave, pressure, p.slave_face, p.xi_slave);
          if (interface.coupling.whole_faces.count(p.slave_face) == 0)
            {
              double most = -1; // where nodes are covered
              for (const unsigned int node : slave.faces[p.slave_face].nodes)
                most = std::max(most, is_covered[node] ? pressure[node] : -1);
              value = most < 0 ? value : std::min(value, most);
            }
          largest = std::max(largest, value);
        }
      for (const unsigned int f : interface.coupling.whole_faces)
        for (const unsigned int node : slave.faces[f].nodes)
          largest = std::max(largest, pressure[node]);
      return largest;
    }

    // int (1 - |t - x|)^6 dt over 0 < t < 1
    double
    whole_bump(const double x)
    {
      return (2 - std::pow(1 - x, 7) - std::pow(x, 7)) / 7;
    }

    // Nodes that the other side is opposite of: those of faces that are covered whole, and those with half of
    // a bump over a face, prod_d (1 - |xi_d - xi_node,d|)^6, on the covered part. An edge may be a tenth of a
    // face off.
    template <int dim>
    std::vector<bool>
    covered_nodes(const ContactInterface<dim> &interface, const bool axisymmetric)
    {
      const auto                      &slave = *interface.slave;
      std::vector<bool>                covered(slave.nodes.size(), false);
      std::vector<std::vector<double>> bump(slave.faces.size());
      const auto                       place = lattice<dim - 1>(slave.degree);
      for (const unsigned int f : interface.coupling.whole_faces)
        for (const unsigned int node : slave.faces[f].nodes)
          covered[node] = true;
      for (const auto &p : interface.coupling.points)
        {
          if (interface.coupling.whole_faces.count(p.slave_face) > 0)
            continue;
          auto  &of_face = bump[p.slave_face];
          double jacobian;
          slave.face_normal(p.slave_face, p.xi_slave, &jacobian);
          of_face.resize(slave.faces[p.slave_face].nodes.size(), 0.);
          for (unsigned int k = 0; k < of_face.size(); ++k)
            {
              double value = p.weight / (jacobian * area_factor(axisymmetric, p.x_slave));
              for (unsigned int d = 0; d < dim - 1; ++d)
                value *= std::pow(1 - std::abs(p.xi_slave[d] - place[k][d]), 6);
              of_face[k] += value;
            }
        }
      for (unsigned int f = 0; f < bump.size(); ++f)
        for (unsigned int k = 0; k < bump[f].size(); ++k)
          {
            double whole = 1;
            for (unsigned int d = 0; d < dim - 1; ++d)
              whole *= whole_bump(place[k][d]);
            if (bump[f][k] >= 0.5 * whole)
              covered[slave.faces[f].nodes[k]] = true;
          }
      return covered;
    }

    // sum slave weight X - sum master weight X
    template <int dim>
    std::vector<Tensor<1, dim>>
    jumps_of_reference_positions(const Discretization<dim>   &discretization,
                                 const ContactInterface<dim> &interface)
    {
      std::map<NodeDofs<dim>, Tensor<1, dim>> X;
      for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
        if (surface != nullptr)
          for (const auto &node : surface->nodes)
            X[node.dofs] = node.X;
      if (interface.master_surface == nullptr)
        {
          const auto &carrier = discretization.geometry.carriers[interface.master.carrier];
          for (unsigned int k = 0; k <= dim; ++k)
            for (unsigned int d = 0; d < dim; ++d)
              X[discretization.carrier_dofs[interface.master.carrier][k]][d] =
                  carrier.motion.reference[d] + (k == d + 1 ? carrier.size : 0.);
        }
      std::vector<Tensor<1, dim>> jumps;
      for (const auto &row : interface.coupling.rows)
        {
          jumps.emplace_back();
          for (const auto &[dofs, weight] : row.slave)
            jumps.back() += weight * X.at(dofs);
          for (const auto &[dofs, weight] : row.master)
            jumps.back() -= weight * X.at(dofs);
        }
      return jumps;
    }

    // Of a, which has singular values >= 0, of which at most one is 0; never a reflection: a + cof a has the
    // singular vectors of a.
    template <int dim>
    Tensor<2, dim>
    rotation_of(Tensor<2, dim> a)
    {
      a /= a.norm();
      Tensor<2, dim> cofactors;
      if constexpr (dim == 2)
        cofactors = Tensor<2, 2>({{a[1][1], -a[1][0]}, {-a[0][1], a[0][0]}});
      else
        for (unsigned int d = 0; d < 3; ++d)
          cofactors[d] = cross_product_3d(a[(d + 1) % 3], a[(d + 2) % 3]);
      return project_onto_orthogonal_tensors(a + cofactors);
    }

    // How the surface at its nodes has turned since the start: the rotation in sum_j (x_j - x)(X_j - X)^T
    // over the nodes of the faces that depend on the node.
    template <int dim>
    std::vector<Tensor<2, dim>>
    rotations(const ContactSurface<dim> &surface)
    {
      std::vector<Tensor<2, dim>> result(surface.nodes.size());
      for (const auto &face : surface.faces)
        for (const unsigned int i : face.unknowns)
          for (const unsigned int j : face.nodes)
            result[i] += outer_product(surface.nodes[j].x - surface.nodes[i].x,
                                       surface.nodes[j].X - surface.nodes[i].X);
      for (auto &a : result)
        a = a.norm() > 0 ? rotation_of(a) : Tensor<2, dim>(unit_symmetric_tensor<dim>());
      return result;
    }

    // Tangential displacement of the slave relative to the master since the start. Where the surfaces have
    // moved, what lay between the present partners then turns with the slave, so that a rigid motion of both
    // is none.
    template <int dim>
    void
    add_slips(const Discretization<dim>   &discretization,
              const ContactInterface<dim> &interface,
              const LA::Vector            &displacement,
              SurfaceFields<dim>          &fields)
    {
      const auto                 &rows = interface.coupling.rows;
      std::vector<Tensor<1, dim>> slips;
      slips.reserve(rows.size());
      for (const auto &row : rows)
        slips.push_back(jump(row, displacement));
      if (interface.slave->moved)
        {
          const auto turned = rotations(*interface.slave);
          const auto before = jumps_of_reference_positions(discretization, interface);
          for (unsigned int r = 0; r < rows.size(); ++r)
            slips[r] += before[r] - turned[rows[r].node] * before[r];
        }
      for (unsigned int r = 0; r < rows.size(); ++r)
        fields.slip[rows[r].node] =
            slips[r] - (slips[r] * rows[r].normal) / rows[r].normal.norm_square() * rows[r].normal;
    }

    // A row's force acts at its node, but for the shares of nodes without a row that have left them: those
    // stay there, so that moments are right, and such nodes are closed where the row of most of their force
    // is.
    template <int dim>
    void
    add_nodal_forces(const Discretization<dim>   &discretization,
                     const ContactInterface<dim> &interface,
                     const NodalContacts<dim>    &contact,
                     SurfaceFields<dim>          &fields)
    {
      const bool          axisymmetric = discretization.scene.kind == ProblemType::axisymmetric;
      std::vector<double> largest(fields.force.size(), 0.);
      for (const auto &row : interface.coupling.rows)
        {
          const auto &node    = contact[row.node];
          const auto  density = -(node.shear + node.pressure * row.normal);
          fields.force[row.node] += row.area * density;
          for (const auto &[j, trace] : row.traces)
            if (fields.area[j] == 0 && !(axisymmetric && is_on_axis(*interface.slave, j)))
              {
                const Tensor<1, dim> share = trace * density;
                fields.force[j] += share;
                fields.force[row.node] -= share;
                if (share.norm() > largest[j])
                  {
                    largest[j]      = share.norm();
                    fields.state[j] = node.state;
                  }
              }
        }
    }

    // Hanging nodes have no row: what is shown there is interpolated; they are closed where a parent is.
    template <int dim>
    void
    fill_hanging_nodes(const ContactSurface<dim> &slave, SurfaceFields<dim> &fields)
    {
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        if (!slave.nodes[i].parents.empty())
          {
            double gap = 0, largest = 0;
            for (const auto &[parent, weight] : slave.nodes[i].parents)
              {
                gap += weight * fields.gap[parent];
                fields.slip[i] += weight * fields.slip[parent];
                if (fields.state[parent] != ContactStatus::open && std::abs(weight) > largest)
                  {
                    largest         = std::abs(weight);
                    fields.state[i] = fields.state[parent];
                  }
              }
            fields.gap[i] = gap;
          }
    }

    // From the rows' tangential densities, a vector of them per direction. Nothing radial is on the axis.
    template <int dim>
    void
    add_tractions(const Discretization<dim>              &discretization,
                  const ContactInterface<dim>            &interface,
                  const std::vector<std::vector<double>> &tangential,
                  const std::vector<bool>                &was_open,
                  SurfaceFields<dim>                     &fields)
    {
      const auto &slave  = *interface.slave;
      const auto  smooth = shear_smoothness(interface, fields, was_open);
      auto        radial = smooth;
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        if (discretization.scene.kind == ProblemType::axisymmetric && is_on_axis(slave, i))
          radial.means[i] = {};
      for (unsigned int c = 0; c < dim; ++c)
        {
          const auto values =
              control_to_nodal(slave, project(interface, tangential[c], false, c == 0 ? radial : smooth));
          for (unsigned int i = 0; i < values.size(); ++i)
            fields.traction[i][c] = values[i];
        }
    }
  } // namespace

  template <int dim>
  double
  value_on_face(const ContactSurface<dim> &surface,
                const std::vector<double> &nodal_values,
                const unsigned int         face,
                const Point<dim - 1>      &xi)
  {
    const auto N = lagrange_values<dim - 1>(surface.degree, xi);
    double     v = 0;
    for (unsigned int k = 0; k < N.size(); ++k)
      v += N[k] * nodal_values[surface.faces[face].nodes[k]];
    return v;
  }

  template <int dim>
  SurfaceFields<dim>
  make_surface_fields(const Discretization<dim>   &discretization,
                      const ContactInterface<dim> &interface,
                      const NodalContacts<dim>    &contact,
                      const std::vector<double>   &unused_shears,
                      const LA::Vector            &displacement,
                      const std::vector<bool>     &was_open)
  {
    const auto        &slave = *interface.slave;
    const unsigned int n     = slave.nodes.size();
    SurfaceFields<dim> fields;
    fields.multiplier.assign(n, 0.);
    fields.gap.assign(n, std::numeric_limits<double>::quiet_NaN());
    fields.area.assign(n, 0.);
    fields.traction.resize(n);
    fields.slip.resize(n);
    fields.force.resize(n);
    fields.state.assign(n, ContactStatus::open);
    for (const auto &node : slave.nodes)
      {
        fields.normal.push_back(node.normal);
        Tensor<1, dim> u;
        for (unsigned int c = 0; c < dim; ++c)
          u[c] = displacement(node.dofs[c]);
        fields.displacement.push_back(u);
      }

    const unsigned int               n_rows = interface.coupling.rows.size();
    std::vector<double>              pressures, bounds;
    std::vector<std::vector<double>> tangential(dim, std::vector<double>(n_rows));
    for (unsigned int r = 0; r < n_rows; ++r)
      {
        const auto &row             = interface.coupling.rows[r];
        const auto &node            = contact[row.node];
        fields.multiplier[row.node] = node.pressure;
        fields.gap[row.node]        = node.gap;
        fields.area[row.node]       = row.area;
        fields.state[row.node]      = node.state;
        if (has_common_normals(discretization, interface))
          fields.normal[row.node] = row.normal / row.normal.norm();
        fields.normal_force -= row.area * node.pressure * row.normal;
        fields.tangential_force -= row.area * node.shear;
        pressures.push_back(node.pressure);
        bounds.push_back(unused_shears[r] + node.shear.norm());
        for (unsigned int c = 0; c < dim; ++c)
          tangential[c][r] = -node.shear[c];
      }
    add_nodal_forces(discretization, interface, contact, fields);
    add_slips(discretization, interface, displacement, fields);
    fill_hanging_nodes(slave, fields);
    const bool axisymmetric = discretization.scene.kind == ProblemType::axisymmetric;
    if (axisymmetric) // nodal traces: no row on the axis
      for (const auto &[node, others] : interface.coupling.slivers)
        if (is_on_axis(slave, node))
          fields.state[node] = fields.state[others[0]];
    // Resultants need the projection that keeps all moments; what is shown and compared is >= 0 where the
    // multipliers are: the same for tied surfaces and for those that stick.
    fields.pressure = control_to_nodal(slave, project(interface, pressures));
    if (axisymmetric) // radial forces cancel over the full turn
      fields.normal_force[0] = fields.tangential_force[0] = 0;
    add_resultants(discretization, interface, fields);
    fields.pressure      = control_to_nodal(slave, project(interface, pressures, true));
    fields.is_covered    = covered_nodes(interface, axisymmetric);
    fields.peak_pressure = peak(interface, fields.pressure, fields.is_covered);
    if (interface.pair->has_friction())
      {
        const auto unused   = control_to_nodal(slave, project(interface, unused_shears));
        fields.stick_centre = stick_centre(discretization, interface, fields, unused);
        fields.stick_size =
            size_of(interface, is_of_a_point(discretization, fields), fields.stick_centre, unused);
        if (fields.stick_size < 1e-6 * fields.contact_size) // what rounding leaves of bounds
          fields.stick_size = 0;
        fields.bound = control_to_nodal(slave, project(interface, bounds, true));
      }
    if (interface.pair->tied || interface.pair->has_friction())
      add_tractions(discretization, interface, tangential, was_open, fields);
    return fields;
  }

  template double
  value_on_face(const ContactSurface<2> &, const std::vector<double> &, const unsigned int, const Point<1> &);
  template SurfaceFields<2>
  make_surface_fields(const Discretization<2> &,
                      const ContactInterface<2> &,
                      const NodalContacts<2> &,
                      const std::vector<double> &,
                      const LA::Vector &,
                      const std::vector<bool> &);
  template double
  value_on_face(const ContactSurface<3> &, const std::vector<double> &, const unsigned int, const Point<2> &);
  template SurfaceFields<3>
  make_surface_fields(const Discretization<3> &,
                      const ContactInterface<3> &,
                      const NodalContacts<3> &,
                      const std::vector<double> &,
                      const LA::Vector &,
                      const std::vector<bool> &);
} // namespace Amontons
