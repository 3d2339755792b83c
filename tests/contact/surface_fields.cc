// From multipliers to fields: uniform ones stay uniform and linear ones linear, also at hanging nodes;
// nothing radial is on the axis; forces, sizes and centres are those of geometry by hand.
#include "contact/contact_scene.h"

#include <amontons/contact/face_basis.h>
#include <amontons/contact/pressure_projection.h>
#include <amontons/contact/surface_fields.h>

#include <deal.II/base/quadrature_lib.h>

namespace test_surface_fields
{
// A slave block above a larger master.
Scene
blocks(const int dim, const ProblemType kind = ProblemType::plane_strain)
{
  Scene scene;
  scene.kind                          = kind;
  const std::array<unsigned int, 3> n = {{2, dim == 2 ? 1u : 2u, 1}};
  const double                      a = kind == ProblemType::axisymmetric ? 0 : -0.5;
  if (dim == 2)
    scene.bodies = {block("lower", {a, 0, 0}, {1.5, 1, 0}, {{3, 1, 1}}),
                    block("upper", {0, 1, 0}, {1, 2, 0}, n)};
  else
    scene.bodies = {block("lower", {a, a, 0}, {1.5, 1.5, 1}, {{3, 3, 1}}),
                    block("upper", {0, 0, 1}, {1, 1, 2}, n)};
  scene.pairs             = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  scene.pairs[0].friction = Expression(0.3);
  return scene;
}

// Pressure 3, shear (0.5, 0.25), slip (0.1 x, 0.2 y), gap 1 + x + 2 y, all nodes slip.
template <int dim>
SurfaceFields<dim>
fields_of(const Problem<dim> &problem)
{
  const auto        &rows = problem.coupling().rows;
  NodalContacts<dim> contact(problem.slave().nodes.size());
  for (const auto &row : rows)
    {
      const auto X        = problem.slave().nodes[row.node].X;
      auto      &node     = contact[row.node];
      node.state          = ContactStatus::slip;
      node.pressure       = 3;
      node.gap            = 1 + X[0] + (dim == 3 ? 2 * X[1] : 0);
      node.shear[0]       = 0.5;
      node.shear[dim - 2] = dim == 3 ? 0.25 : 0.5;
    }
  auto u = problem.discretization->make_owned_vector();
  for (const auto &node : problem.slave().nodes)
    for (unsigned int c = 0; c + 1 < dim; ++c)
      if (u.in_local_range(node.dofs[c]))
        u(node.dofs[c]) = 0.1 * (c + 1) * node.X[c];
  u.compress(VectorOperation::insert);
  auto readable = problem.discretization->make_relevant_vector();
  readable      = u;
  return make_surface_fields(*problem.discretization,
                             problem.interfaces[0],
                             contact,
                             std::vector<double>(rows.size(), 2.),
                             readable);
}

template <int dim>
void
check_nodes(const Problem<dim> &problem, const SurfaceFields<dim> &fields, const std::string &what)
{
  unsigned int n_hanging = 0;
  for (unsigned int i = 0; i < problem.slave().nodes.size(); ++i)
    {
      const auto    &node = problem.slave().nodes[i];
      Tensor<1, dim> slip, traction;
      slip[0]     = 0.1 * node.X[0];
      traction[0] = -0.5;
      if (dim == 3)
        {
          slip[1]     = 0.2 * node.X[1];
          traction[1] = -0.25;
        }
      n_hanging += !node.parents.empty();
      check::is_close(fields.pressure[i], 3, 1e-10, what + ": pressure");
      check::is_close(fields.gap[i], 1 + node.X[0] + (dim == 3 ? 2 * node.X[1] : 0), 1e-10, what + ": gap");
      check::is_close((fields.slip[i] - slip).norm(), 0, 1e-10, what + ": slip", 1);
      if (problem.discretization->scene.kind != ProblemType::axisymmetric) // nothing uniform is radial there
        check::is_close((fields.traction[i] - traction).norm(), 0, 1e-10, what + ": traction", 1);
      check::is_true(fields.state[i] == ContactStatus::slip, what + ": state");
      check::is_close(fields.multiplier[i], node.parents.empty() ? 3 : 0, 0, what + ": multiplier");
      check::is_true((fields.area[i] > 0) == node.parents.empty(), what + ": area");
    }
  if (dim == 3)
    check::is_true(n_hanging > 0, what + ": some nodes hang");
  check::is_close(fields.peak_pressure, 3, 1e-10, what + ": peak");
}

void
check_plane(const unsigned int degree)
{
  const Problem<2>  problem(blocks(2), degree);
  const auto        fields = fields_of(problem);
  const std::string what   = "plane, degree " + std::to_string(degree);
  check_nodes(problem, fields, what);
  check::is_close(fields.normal_force[1], 3, 1e-10, what + ": normal force on the slave");
  check::is_close(fields.normal_force[0], 0, 1e-10, what + ": normal force across", 1);
  check::is_close(fields.tangential_force[0], -0.5, 1e-10, what + ": tangential force on the slave");
  check::is_close(fields.centre[0], 0.5, 1e-10, what + ": centre");
  check::is_close(fields.contact_size, std::sqrt(4. / 12), 1e-10, what + ": size");
  check::is_close(fields.stick_size, std::sqrt(4. / 12), 1e-10, what + ": size of stick");
  check::is_close(fields.covariance[0][0], 1. / 12, 1e-10, what + ": covariance");
  check::is_close(fields.symmetry_factor, 1, 0, what + ": no symmetry");
}

// The master ends at x = 0.55, a tenth of a face beyond a node of the slave: the next one leaves its share.
void
check_edge(const unsigned int degree)
{
  Scene scene     = blocks(2);
  scene.bodies[0] = block("lower", {-0.5, 0, 0}, {0.55, 1, 0}, {{3, 1, 1}});
  const Problem<2>  problem(scene, degree);
  const auto        fields = fields_of(problem);
  const std::string what   = "beyond an edge, degree " + std::to_string(degree);
  double            force = 0, moment = 0;
  for (unsigned int i = 0; i < fields.force.size(); ++i)
    {
      force += fields.force[i][1];
      moment += fields.force[i][1] * problem.slave().nodes[i].X[0];
    }
  check::is_close(problem.coupling().slivers.size(), 1, 0, what + ": a node leaves its share");
  check::is_close(force, 3 * 0.55, 1e-10, what + ": force of the nodes");
  check::is_close(moment, 3 * 0.55 * 0.55 / 2, 1e-10, what + ": moment of the nodes");
}

// Cut at x = 0: the centre is there, and the other half is not meshed.
void
check_half(const unsigned int degree)
{
  Scene         scene = blocks(2);
  ConditionData plane;
  plane.type       = ConditionData::Type::symmetry;
  plane.boundaries = {{"upper", "left", {}}};
  scene.conditions = {plane};
  const Problem<2>  problem(scene, degree);
  const auto        fields = fields_of(problem);
  const std::string what   = "half, degree " + std::to_string(degree);
  check::is_close(fields.centre[0], 0, 1e-10, what + ": centre", 1);
  check::is_close(fields.contact_size, std::sqrt(4. / 3), 1e-10, what + ": size");
  check::is_close(fields.symmetry_factor, 2, 0, what + ": symmetry");
  check::is_close(fields.normal_force[1], 3, 1e-10, what + ": force of the meshed part");
}

// int r^2 2 pi r dr / int 2 pi r dr = 1/2
void
check_axisymmetric(const unsigned int degree)
{
  const Problem<2>  problem(blocks(2, ProblemType::axisymmetric), degree);
  const auto        fields = fields_of(problem);
  const std::string what   = "axisymmetric, degree " + std::to_string(degree);
  check_nodes(problem, fields, what);
  check::is_close(fields.normal_force[1], 3 * numbers::PI, 1e-10, what + ": normal force of the full turn");
  check::is_close(fields.tangential_force[0], 0, 0, what + ": radial forces cancel", 1);
  check::is_close(fields.centre[0], 0, 0, what + ": centre", 1);
  for (unsigned int i = 0; i < problem.slave().nodes.size(); ++i)
    if (problem.slave().nodes[i].X[0] == 0)
      check::is_close(fields.traction[i][0], 0, 0, what + ": radial traction on the axis", 1);
  check::is_close(fields.contact_size, std::sqrt(2.5 / 2), 1e-10, what + ": size");
}

void
check_space(const unsigned int degree)
{
  const Problem<3>  problem(blocks(3), degree, 2, 2);
  const auto        fields = fields_of(problem);
  const std::string what   = "space, degree " + std::to_string(degree);
  check_nodes(problem, fields, what);
  check::is_close(fields.normal_force[2], 3, 1e-10, what + ": normal force");
  check::is_close(fields.tangential_force[0], -0.5, 1e-10, what + ": tangential force along x");
  check::is_close(fields.tangential_force[1], -0.25, 1e-10, what + ": tangential force along y");
  check::is_close(fields.contact_size, std::sqrt(2.5 / 6), 1e-10, what + ": size");
  check::is_close(fields.stick_size, std::sqrt(2.5 / 6), 1e-10, what + ": size of stick");
  check::is_close(fields.covariance[0][0], 1. / 12, 1e-10, what + ": covariance xx");
  check::is_close(fields.covariance[0][1], 0, 1e-10, what + ": covariance xy", 1);
}

// A shear that goes up and down from node to node of 16 faces, at nodes that stick and touched alone: force
// and moment stay, and what is left of the saw-tooth inside is a small part. The last two faces are closed
// from the start.
void
check_saw_tooth(const unsigned int degree)
{
  Scene scene     = blocks(2);
  scene.bodies[1] = block("upper", {0, 1, 0}, {1, 2, 0}, {{16, 1, 1}});
  const Problem<2>  problem(scene, degree);
  const auto       &slave = problem.slave();
  const auto       &rows  = problem.coupling().rows;
  const std::string what  = "saw-tooth, degree " + std::to_string(degree);
  NodalContacts<2>  contact(slave.nodes.size());
  std::vector<bool> was_open(slave.nodes.size());
  for (unsigned int i = 0; i < slave.nodes.size(); ++i)
    was_open[i] = slave.nodes[i].X[0] < 0.86;
  for (const auto &row : rows)
    {
      const unsigned int place   = std::lround(16 * degree * slave.nodes[row.node].X[0]);
      contact[row.node].state    = ContactStatus::stick;
      contact[row.node].pressure = 3;
      contact[row.node].shear[0] = place % 2 == 0 ? 1.5 : 0.5;
    }
  auto       readable  = problem.discretization->make_relevant_vector();
  const auto fields_of = [&](const std::vector<bool> &opened) {
    return make_surface_fields(*problem.discretization,
                               problem.interfaces[0],
                               contact,
                               std::vector<double>(rows.size(), 1.),
                               readable,
                               opened);
  };
  const auto      raw = fields_of({}), smooth = fields_of(was_open);
  double          force = 0, moment = 0, left = 0, before = 0;
  const QGauss<1> gauss(4);
  for (unsigned int f = 0; f < slave.faces.size(); ++f)
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const auto N = lagrange_values<1>(degree, gauss.point(q));
        double     x = 0, change = 0;
        for (unsigned int k = 0; k < N.size(); ++k)
          {
            const unsigned int i = slave.faces[f].nodes[k];
            x += N[k] * slave.nodes[i].X[0];
            change += N[k] * (smooth.traction[i][0] - raw.traction[i][0]);
          }
        force += gauss.weight(q) / 16 * change;
        moment += gauss.weight(q) / 16 * change * x;
      }
  check::is_close(force, 0, 1e-12, what + ": force", 1);
  check::is_close(moment, 0, 1e-12, what + ": moment", 1);
  for (unsigned int i = 0; i < slave.nodes.size(); ++i)
    if (std::abs(slave.nodes[i].X[0] - 0.4) < 0.3)
      {
        left   = std::max(left, std::abs(smooth.traction[i][0] + 1));
        before = std::max(before, std::abs(raw.traction[i][0] + 1));
      }
  check::is_true(before > 0.4 && left < 0.15 * before,
                 what + ": left of " + std::to_string(before) + " is " + std::to_string(left));
}

// Of a contact that has slid off an edge there may be a sliver left whose mass is one value, or none.
void
check_sliver()
{
  Problem<2> problem(blocks(2), 2);
  auto      &coupling = problem.interfaces[0].coupling;
  for (const double mass : {1e-30, 0.})
    {
      for (auto &entry : coupling.trace_mass)
        entry.second = mass;
      for (const double v : project(problem.interfaces[0], std::vector<double>(coupling.rows.size(), mass)))
        check::is_true(std::isfinite(v), "projection on a sliver of mass " + std::to_string(mass));
    }
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_plane(degree);
      check_edge(degree);
      check_saw_tooth(degree);
      check_half(degree);
      check_axisymmetric(degree);
      check_space(degree);
    }
  check_sliver();
  return check::result();
}
} // namespace test_surface_fields
