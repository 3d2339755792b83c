#include <amontons/elasticity/boundary_faces.h>
#include <amontons/solver/symmetry_planes.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    struct Plane
    {
      Point<dim>     at;
      Tensor<1, dim> outward; // unit
    };

    // Of each boundary of the conditions; of all its faces, that of the first.
    template <int dim>
    std::vector<Plane<dim>>
    symmetry_planes(const Discretization<dim> &discretization)
    {
      FEFaceValues<dim>       values(discretization.mapping(),
                               discretization.fe,
                               QMidpoint<dim - 1>(),
                               update_quadrature_points | update_normal_vectors);
      std::vector<Plane<dim>> planes;
      for (const auto &condition : discretization.scene.conditions)
        if (condition.type == ConditionData::Type::symmetry)
          for (const auto &name : condition.boundaries)
            {
              std::optional<Plane<dim>> mine;
              for_each_face(discretization,
                            discretization.geometry.boundary(name, discretization.scene).id,
                            [&](const auto &cell, const unsigned int f) {
                              if (mine)
                                return;
                              values.reinit(cell, f);
                              mine = Plane<dim>{values.quadrature_point(0), values.normal_vector(0)};
                            });
              const auto         communicator = discretization.geometry.communicator;
              const unsigned int none         = Utilities::MPI::n_mpi_processes(communicator);
              const unsigned int rank         = Utilities::MPI::min(
                  mine ? Utilities::MPI::this_mpi_process(communicator) : none, communicator);
              if (rank == none)
                continue;
              const auto plane = mine.value_or(Plane<dim>());
              planes.push_back({Utilities::MPI::broadcast(communicator, plane.at, rank),
                                Utilities::MPI::broadcast(communicator, plane.outward, rank)});
            }
      return planes;
    }

    // Of one body and one plane: how far beyond at first and now, and where.
    template <int dim>
    struct Excursion
    {
      double     at_first = std::numeric_limits<double>::lowest(), now = at_first;
      Point<dim> where;
    };

    // Whether a boundary of the body that lay in the plane is taken beyond it, as the scene says (the section
    // in which a bolt is tightened).
    template <int dim>
    bool
    is_driven_beyond(const Discretization<dim> &discretization,
                     const unsigned int         body,
                     const Plane<dim>          &plane,
                     const LA::Vector          &u,
                     const double               near,
                     const double               far)
    {
      using Type     = ConditionData::Type;
      bool is_driven = false;
      for (const auto &condition : discretization.scene.conditions)
        if (condition.type == Type::displacement || condition.type == Type::platen)
          for (const auto &name : condition.boundaries)
            if (const auto &boundary = discretization.geometry.boundary(name, discretization.scene);
                boundary.body == body)
              for_each_face(discretization, boundary.id, [&](const auto &cell, const unsigned int f) {
                bool was_in_plane = true, is_beyond = true;
                for (const unsigned int v : cell->face(f)->vertex_indices())
                  {
                    const double before = plane.outward * (cell->face(f)->vertex(v) - plane.at);
                    double       moved  = 0;
                    for (unsigned int c = 0; c < dim; ++c)
                      moved += plane.outward[c] * u(cell->face(f)->vertex_dof_index(v, c));
                    was_in_plane = was_in_plane && std::abs(before) <= near;
                    is_beyond    = is_beyond && before + moved > far;
                  }
                is_driven = is_driven || (was_in_plane && is_beyond);
              });
      return Utilities::MPI::max(is_driven ? 1 : 0, discretization.geometry.communicator) == 1;
    }
  } // namespace

  template <int dim>
  std::vector<Point<dim>>
  beyond_symmetry_planes(const Discretization<dim> &discretization, const LA::Vector &u)
  {
    const auto                                                      planes = symmetry_planes(discretization);
    std::map<std::pair<unsigned int, unsigned int>, Excursion<dim>> excursions; // by body and plane
    for (unsigned int body = 0; body < discretization.scene.bodies.size(); ++body)
      for (unsigned int p = 0; p < planes.size(); ++p)
        excursions[{body, p}];
    if (!planes.empty())
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          for (const unsigned int v : cell->vertex_indices())
            {
              Tensor<1, dim> moved;
              for (unsigned int c = 0; c < dim; ++c)
                moved[c] = u(cell->vertex_dof_index(v, c));
              for (unsigned int p = 0; p < planes.size(); ++p)
                {
                  auto        &excursion = excursions[{cell->material_id(), p}];
                  const double before    = planes[p].outward * (cell->vertex(v) - planes[p].at),
                               now       = before + planes[p].outward * moved;
                  excursion.at_first     = std::max(excursion.at_first, before);
                  if (now > excursion.now)
                    {
                      excursion.now   = now;
                      excursion.where = cell->vertex(v);
                    }
                }
            }

    std::vector<Point<dim>> result;
    const auto              communicator = discretization.geometry.communicator;
    for (const auto &[where, mine] : excursions)
      {
        const double size     = discretization.geometry.body_sizes[where.first];
        const double at_first = Utilities::MPI::max(mine.at_first, communicator);
        const auto   now      = Utilities::MPI::min_max_avg(mine.now, communicator);
        const double near = 1e-6 * size, far = 1e-3 * size;
        if (at_first <= near && now.max > far &&
            !is_driven_beyond(discretization, where.first, planes[where.second], u, near, far))
          result.push_back(Utilities::MPI::broadcast(communicator, mine.where, now.max_index));
      }
    return result;
  }

  template std::vector<Point<2>>
  beyond_symmetry_planes(const Discretization<2> &, const LA::Vector &);
  template std::vector<Point<3>>
  beyond_symmetry_planes(const Discretization<3> &, const LA::Vector &);
} // namespace Amontons
