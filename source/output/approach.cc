#include <amontons/base/points.h>
#include <amontons/output/approach.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    // Whether a condition holds its boundaries along e; nothing if it does so by a field.
    std::optional<bool>
    holds(const ConditionData &condition, const Tensor<1, 3> &e)
    {
      if (condition.type == ConditionData::Type::displacement)
        {
          if (condition.field)
            return {};
          for (unsigned int c = 0; c < 3; ++c)
            if (std::abs(e[c]) > 1e-3 && !condition.displacement[c])
              return false;
          return true;
        }
      return condition.type == ConditionData::Type::platen || condition.type == ConditionData::Type::symmetry;
    }

    template <int dim>
    void
    add_moments(const double weight, const Tensor<1, dim> &u, const Point<dim> &X, std::vector<double> &sums)
    {
      sums[0] += weight;
      for (unsigned int c = 0; c < dim; ++c)
        {
          sums[1 + c] += weight * u[c];
          sums[1 + dim + c] += weight * X[c];
        }
      sums[1 + 2 * dim] += weight * u.norm_square();
      sums[2 + 2 * dim] += weight * X.square();
    }

    // Root of the variance of u over that of X: of a plane that turns in itself or of a line 2 sin(angle/2),
    // less about other axes; 0 where it only moves.
    template <int dim>
    double
    turn(const std::vector<double> &sums)
    {
      double of_u = sums[1 + 2 * dim] * sums[0], of_X = sums[2 + 2 * dim] * sums[0];
      for (unsigned int c = 0; c < dim; ++c)
        {
          of_u -= sums[1 + c] * sums[1 + c];
          of_X -= sums[1 + dim + c] * sums[1 + dim + c];
        }
      return of_X > 0 ? std::sqrt(std::max(0., of_u) / of_X) : 0;
    }

    // Mean of u . e over the boundaries of a body that hold it along e; nothing if those turn: then the mean
    // of one does not tell how far it is from the other.
    template <int dim>
    std::optional<double>
    motion_of_supports(const Answer<dim> &answer, const unsigned int body, const Tensor<1, dim> &e)
    {
      const auto  &discretization = answer.discretization;
      const Scene &scene          = discretization.scene;
      Tensor<1, 3> direction;
      for (unsigned int c = 0; c < dim; ++c)
        direction[c] = e[c];
      std::map<types::boundary_id, bool> supports; // true: only where it is normal to e
      for (const auto &condition : scene.conditions)
        for (const auto &name : condition.boundaries)
          {
            const Boundary &boundary = discretization.geometry.boundary(name, scene);
            const auto      holding  = holds(condition, direction);
            if (boundary.body == body && !holding)
              return {};
            if (boundary.body == body && *holding)
              supports[boundary.id] = condition.type == ConditionData::Type::symmetry;
          }

      const auto                      &fe = discretization.fe;
      const FEValuesExtractors::Vector u(0);
      FEFaceValues<dim>                values(discretization.mapping(),
                               fe,
                               QGauss<dim - 1>(fe.degree + 1),
                               update_values | update_quadrature_points | update_normal_vectors |
                                   update_JxW_values);
      std::vector<Tensor<1, dim>>      displacement(values.n_quadrature_points);
      // int 1, u, X, u^2, X^2 over all of them that are no mirrors; then int u . e, 1
      constexpr unsigned int n = 2 * dim + 3;
      std::vector<double>    sums(n + 2, 0.);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          for (const unsigned int f : cell->face_indices())
            if (const auto support = supports.find(cell->face(f)->boundary_id());
                cell->face(f)->at_boundary() && support != supports.end())
              {
                values.reinit(cell, f);
                if (support->second && std::abs(values.normal_vector(0) * e) < 0.999)
                  continue;
                values[u].get_function_values(answer.state.displacement, displacement);
                for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
                  {
                    const double weight =
                        values.JxW(q) * measure<dim>(scene.kind, values.quadrature_point(q));
                    sums[n] += weight * (displacement[q] * e);
                    sums[n + 1] += weight;
                    if (!support->second)
                      add_moments<dim>(weight, displacement[q], values.quadrature_point(q), sums);
                  }
              }
      Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);
      constexpr double noteworthy_turn = 0.03; // moves what is L apart by half of its square
      if (sums[n + 1] == 0 || turn<dim>(sums) > noteworthy_turn)
        return {};
      return sums[n] / sums[n + 1];
    }

    // The surfaces have moved along each other, or touch elsewhere than where they were closest: the first
    // gap lay along another direction than the force, and says nothing of how far they are pressed together.
    template <int dim>
    bool
    touches_elsewhere(const typename ContactInterface<dim>::FirstGap &gap,
                      const Tensor<1, dim>                           &e,
                      const double                                    motion)
    {
      constexpr double along = 0.95, noteworthy = 0.01;
      return gap.size > noteworthy * motion &&
             std::none_of(gap.normals.begin(), gap.normals.end(), [&](const auto &normal) {
               return std::abs(normal * e) > along;
             });
    }

    // Of its reference point.
    template <int dim>
    Tensor<1, dim>
    motion_of_carrier(const Answer<dim> &answer, const unsigned int carrier)
    {
      Tensor<1, dim> motion;
      for (unsigned int c = 0; c < dim; ++c)
        motion[c] = answer.state.displacement(answer.discretization.carrier_dofs[carrier][0][c]);
      return motion;
    }

    // Along e (of the force on the slave). Nothing if the obstacle has turned so that it is elsewhere at the
    // contact than its reference point tells: one that is round about that is not.
    template <int dim>
    std::optional<double>
    motion_of_obstacle(const Answer<dim> &answer, const unsigned int pair, const Tensor<1, dim> &e)
    {
      const auto &master = answer.interfaces[pair].master;
      const auto  turned = carrier_motion(answer.discretization, master.carrier, answer.state.displacement);
      AffineMap<dim> shifted;
      shifted.b           = motion_of_carrier(answer, master.carrier);
      const double motion = shifted.b * e;
      if (turned.A == shifted.A)
        return motion;
      const auto      &centre     = answer.fields[pair].centre;
      const auto       there      = project_to_obstacle(*master.obstacle, turned, centre, -e);
      const auto       unturned   = project_to_obstacle(*master.obstacle, shifted, centre, -e);
      constexpr double noteworthy = 0.01;
      if (!there || !unturned || std::abs((there->x - unturned->x) * e) > noteworthy * std::abs(motion))
        return {};
      return motion;
    }

    // Of a body (by name) along e.
    template <int dim>
    std::optional<double>
    motion_of_body(const Answer<dim> &answer, const std::string &name, const Tensor<1, dim> &e)
    {
      const auto &discretization = answer.discretization;
      const auto &bodies         = discretization.scene.bodies;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (bodies[b].name == name)
          {
            if (!discretization.is_deformable(b))
              return motion_of_carrier(answer, discretization.carrier_of_body[b]) * e;
            return motion_of_supports(answer, b, e);
          }
      return {};
    }
  } // namespace

  template <int dim>
  std::optional<double>
  compute_approach(const Answer<dim> &answer, const unsigned int pair)
  {
    const auto               &interface = answer.interfaces[pair];
    const PairData           &data      = *interface.pair;
    const SurfaceFields<dim> &fields    = answer.fields[pair];
    Tensor<1, dim>            e         = fields.normal_force;
    for (const auto &normal : fields.symmetry_planes)
      e -= (e * normal) * normal;
    if (e.norm() == 0 || !interface.first_gap || std::isinf(interface.first_gap->size))
      return {};
    e /= e.norm();

    const auto first = motion_of_body(answer, data.first.body, e);
    const auto second =
        data.second ? motion_of_body(answer, data.second->body, e) : motion_of_obstacle(answer, pair, e);
    if (!first || !second)
      return {};
    // What holds both bodies does not move; other loads or an interference press them together.
    double gap = interface.first_gap->size;
    if (gap_grows(interface)) // finite strain: since it was measured
      {
        const auto place = as_3d(interface.first_gap->place);
        gap += data.initial_gap->value(place, answer.state.t) -
               data.initial_gap->value(place, interface.first_gap->t);
      }
    constexpr double rounding = 1e-12;
    const double     motion   = std::abs(*second - *first);
    if (motion <= rounding * answer.state.displacement.linfty_norm() && gap >= 0)
      return {};
    if (touches_elsewhere<dim>(*interface.first_gap, e, motion))
      return {};
    return motion - gap;
  }

  template std::optional<double>
  compute_approach(const Answer<2> &, const unsigned int);
  template std::optional<double>
  compute_approach(const Answer<3> &, const unsigned int);
} // namespace Amontons
