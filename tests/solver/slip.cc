// Slip at finite strain: none where the whole scene turns, about any axis, on curved faces too; that which is
// reported turns with the scene. Derivatives of slip and gap against differences.
#include "contact/moved_scene.h"

#include <amontons/contact/surface_fields.h>
#include <amontons/solver/moving_contact.h>

#include <deal.II/physics/transformations.h>

namespace test_slip
{
std::mt19937 generator(1);

BodyData
ball(const std::string &shape, const Point<3> &centre, const unsigned int refinements)
{
  BodyData body;
  body.name        = "ball";
  body.shape       = shape;
  body.radius      = 1;
  body.centre      = centre;
  body.refinements = refinements;
  return body;
}

// exp(theta x)
Tensor<2, 3>
rotation(const Tensor<1, 3> &theta)
{
  const Tensor<1, 3> axis = theta / theta.norm();
  return Physics::Transformations::Rotations::rotation_matrix_3d(Point<3>(axis), theta.norm());
}

template <int dim>
class Slipping
{
public:
  Slipping(const Scene &scene, const unsigned int degree, const double size)
      : problem(scene, degree), moved(problem), size(size)
  {
    moved.displace_at_random(0.02 * size, generator);
    supports        = problem.discretization->make_supports(0);
    start.committed = start.displacement = moved.readable(moved.u);
    contact                              = std::make_unique<MovingContact<dim>>(
        *problem.discretization, supports, problem.interfaces, start, 1.);
    contact->move(start.committed);
  }

  // How many nodes have slips; the largest of them.
  std::pair<unsigned int, double>
  largest_slip(const LA::Vector &u)
  {
    contact->move(u);
    std::pair<unsigned int, double> result = {0, 0.};
    for (unsigned int k = 0; k < contact->nodes().size(); ++k)
      if (contact->is_opposite(k))
        {
          ++result.first;
          result.second = std::max(result.second, contact->slip(k, u).norm());
        }
    return result;
  }

  // By slave node.
  std::vector<Tensor<1, dim>>
  reported_slips(const LA::Vector &u)
  {
    contact->move(u);
    const auto &interface = problem.interfaces[0];
    return make_surface_fields(*problem.discretization,
                               interface,
                               NodalContacts<dim>(interface.slave->nodes.size()),
                               std::vector<double>(interface.coupling.rows.size(), 0.),
                               u)
        .slip;
  }

  // The last converged state, turned as a whole and shifted.
  LA::Vector
  turned(const Tensor<2, 3> &R) const
  {
    LA::Vector u    = moved.u;
    const auto turn = [&](const NodeDofs<dim> &dofs, const Point<dim> &X) {
      Tensor<1, 3> x, change;
      for (unsigned int c = 0; c < dim; ++c)
        x[c] = X[c] + start.committed(dofs[c]);
      change = R * x - x;
      for (unsigned int c = 0; c < dim; ++c)
        moved.add(u, dofs[c], change[c] + 0.3 - c);
    };
    const auto &interface = problem.interfaces[0];
    for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
      if (surface != nullptr)
        for (const auto &node : surface->nodes)
          turn(node.dofs, node.X);
    if (interface.master_surface == nullptr)
      {
        const auto &carrier = problem.geometry.carriers[interface.master.carrier];
        for (unsigned int k = 0; k <= dim; ++k)
          {
            Point<dim> X;
            for (unsigned int d = 0; d < dim; ++d)
              X[d] = carrier.motion.reference[d] + (k == d + 1 ? carrier.size : 0.);
            turn(problem.discretization->carrier_dofs[interface.master.carrier][k], X);
          }
      }
    u.compress(VectorOperation::add);
    return moved.readable(u);
  }

  // Away from the last converged state, turned meanwhile, along random directions: rows of sticking nodes
  // hold the slip and the gap.
  void
  check_derivatives_after(const Tensor<2, 3> &R, const std::string &what)
  {
    std::uniform_real_distribution<double> number(-1, 1);
    LA::Vector                             u = problem.discretization->make_owned_vector();
    u.reinit(problem.discretization->locally_owned, MPI_COMM_WORLD);
    u = turned(R);
    Coefficients sliding;
    for (const auto dof : moved.dofs)
      sliding[dof] = 0.02 * size * number(generator);
    const auto readable_along = [&](const Coefficients &direction, const double factor) {
      LA::Vector at = u;
      for (const auto &[dof, value] : direction)
        moved.add(at, dof, factor * value);
      at.compress(VectorOperation::add);
      return moved.readable(at);
    };
    const LA::Vector here = readable_along(sliding, 1);
    u                     = here;
    contact->move(here);
    FloatingBodies<dim> floating(*problem.discretization, supports, problem.interfaces, &here);
    NodeStates<dim>     states(contact->nodes(), problem.interfaces, floating, 0.);
    for (unsigned int k = 0; k < contact->nodes().size(); ++k)
      if (contact->is_opposite(k))
        states.close(k);
    contact->differentiate(states);
    // With the row -dg of a slipping node, the rows dv - n/|n|^2 dg of a sticking one hold dv.
    std::vector<std::optional<types::global_dof_index>> pivots;
    for (unsigned int c = 0; c < dim; ++c)
      pivots.emplace_back(c); // any
    std::vector<Gradient>                  gap_gradients(contact->nodes().size());
    std::vector<std::array<Gradient, dim>> slip_gradients(contact->nodes().size());
    for (unsigned int k = 0; k < gap_gradients.size(); ++k)
      if (states[k] != ContactStatus::open)
        {
          const auto normal = contact->nodes()[k].normal;
          const auto of_gap = contact->contact_rows(k, ContactStatus::slip, {pivots[0]}, here);
          for (const auto &[dof, value] : of_gap[0].equation.coefficients)
            gap_gradients[k][dof] = -value;
          const auto rows = contact->contact_rows(k, ContactStatus::stick, pivots, here);
          for (unsigned int c = 0; c < dim; ++c)
            {
              slip_gradients[k][c] = rows[c].equation.coefficients;
              for (const auto &[dof, value] : gap_gradients[k])
                slip_gradients[k][c][dof] += normal[c] / normal.norm_square() * value;
            }
        }

    Deviation slips, gaps;
    for (unsigned int n = 0; n < 3; ++n)
      {
        Coefficients direction;
        for (const auto dof : moved.dofs)
          direction[dof] = number(generator);
        const double                h = 1e-6 * size;
        std::vector<Tensor<1, dim>> slip(gap_gradients.size());
        std::vector<double>         gap(gap_gradients.size(), 0.);
        for (const double sign : {-1., 1.})
          {
            const auto at = readable_along(direction, sign * h);
            contact->move(at);
            for (unsigned int k = 0; k < gap.size(); ++k)
              if (states[k] != ContactStatus::open)
                {
                  slip[k] += sign / (2 * h) * contact->slip(k, at);
                  gap[k] += sign / (2 * h) * contact->nodes()[k].gap;
                }
          }
        for (unsigned int k = 0; k < gap.size(); ++k)
          if (states[k] != ContactStatus::open)
            {
              gaps.compare(along(gap_gradients[k], direction), gap[k]);
              for (unsigned int c = 0; c < dim; ++c)
                slips.compare(along(slip_gradients[k][c], direction), slip[k][c]);
            }
      }
    std::cout << what << ": deviations of gaps " << gaps.relative() << ", slips " << slips.relative()
              << std::endl;
    check::is_true(gaps.scale > 0 && slips.scale > 0, what + ": slips and gaps change");
    check::is_close(gaps.relative(), 0, 1e-6, what + ": derivative of the gap", 1);
    check::is_close(slips.relative(), 0, 1e-6, what + ": derivative of the slip", 1);
  }

  Problem<dim>                        problem;
  Moved<dim>                          moved;
  const double                        size;
  Constraints                         supports;
  SolutionState<dim>                  start;
  std::unique_ptr<MovingContact<dim>> contact;
};

template <int dim>
void
check_scene(Scene scene, const unsigned int degree, const double size, const std::string &text)
{
  const std::string what = text + ", degree " + std::to_string(degree);
  for (auto &pair : scene.pairs)
    pair.friction = Expression(0.3);
  Slipping<dim>             slipping(scene, degree, size);
  std::vector<Tensor<1, 3>> turns = {Tensor<1, 3>({0, 0, 0.7}), Tensor<1, 3>({0, 0, 3.1})};
  if (dim == 3)
    for (const auto &theta :
         {Tensor<1, 3>({0.9, 0, 0}), Tensor<1, 3>({0.4, -1.1, 0.8}), Tensor<1, 3>({-1, 2, 2})})
      turns.push_back(theta);
  for (const auto &theta : turns)
    {
      const auto [n, largest] = slipping.largest_slip(slipping.turned(rotation(theta)));
      check::is_true(n > 0, what + ": there are nodes that could slip");
      check::is_close(largest, 0, 1e-12 * size, what + ": slip of a turn", 1);
    }
  const Tensor<2, 3> R      = rotation(turns.back());
  const auto         before = slipping.reported_slips(slipping.start.committed),
             after          = slipping.reported_slips(slipping.turned(R));
  double largest            = 0;
  for (unsigned int i = 0; i < before.size(); ++i)
    {
      Tensor<1, dim> turned;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          turned[c] += R[c][d] * before[i][d];
      check::is_close((after[i] - turned).norm(), 0, 1e-12, what + ": reported slip", 1);
      largest = std::max(largest, turned.norm());
    }
  check::is_true(largest > 1e-3, what + ": slip is reported");
  slipping.check_derivatives_after(R, what);
}

Scene
two_bodies(const BodyData    &lower,
           const std::string &top,
           const BodyData    &upper,
           const std::string &bottom,
           const bool         upper_is_slave)
{
  Scene              scene;
  const BoundaryName first = {upper.name, bottom, {}}, second = {lower.name, top, {}};
  scene.bodies = {lower, upper};
  scene.pairs  = {upper_is_slave ? pair_of(first, second) : pair_of(second, first)};
  return scene;
}

void
check_plane(const unsigned int degree)
{
  for (const bool upper : {true, false})
    {
      const std::string slave = upper ? ", upper slave" : ", lower slave";
      check_scene<2>(two_bodies(block("lower", {0, 0, 0}, {2, 1, 0}, {{6, 1, 1}}),
                                "top",
                                block("upper", {-0.3, 1.02, 0}, {2.2, 2, 0}, {{4, 1, 1}}),
                                "bottom",
                                upper),
                     degree,
                     0.3,
                     "blocks" + slave);
      check_scene<2>(two_bodies(block("lower", {-0.8, -1, 0}, {0.7, 0, 0}, {{5, 1, 1}}),
                                "top",
                                ball("half disk", {0, 1.02, 0}, 1),
                                "arc",
                                upper),
                     degree,
                     0.3,
                     "disk" + slave);
    }
}

void
check_space(const unsigned int degree)
{
  for (const bool upper : {true, false})
    {
      const std::string slave = upper ? ", upper slave" : ", lower slave";
      check_scene<3>(two_bodies(block("lower", {0, 0, 0}, {1, 1, 0.5}, {{2, 2, 1}}),
                                "top",
                                block("upper", {-0.2, 0.13, 0.51}, {0.7, 1.2, 1}, {{2, 1, 1}}),
                                "bottom",
                                upper),
                     degree,
                     0.4,
                     "blocks in space" + slave);
      check_scene<3>(two_bodies(block("lower", {-0.61, -0.53, -1}, {0.7, 0.65, 0}, {{2, 3, 1}}),
                                "top",
                                ball("half sphere", {0, 0, 1.02}, 0),
                                "surface",
                                upper),
                     degree,
                     0.4,
                     "ball" + slave);
    }
  ObstacleData sphere;
  sphere.type   = ObstacleData::Type::sphere;
  sphere.centre = {0.1, 0.1, 3.6};
  sphere.radius = 3;
  check_scene<3>(scene_with_obstacle(block("it", {0, 0, 0}, {1, 1, 0.5}, {{2, 1, 1}}), "top", sphere),
                 degree,
                 0.4,
                 "obstacle");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_plane(degree);
      check_space(degree);
    }
  return check::result();
}
} // namespace test_slip
