#include <amontons/algebra/rigid_body_modes.h>
#include <amontons/solver/kept_system.h>

#include <boost/functional/hash.hpp>

namespace Amontons
{
  namespace
  {
    // Of one value after another, whatever their type.
    class Fingerprint
    {
    public:
      template <typename T>
      void
      add(const T &value)
      {
        boost::hash_combine(seed, value);
      }
      template <int dim>
      void
      add(const Tensor<1, dim> &v)
      {
        for (unsigned int d = 0; d < dim; ++d)
          add(v[d]);
      }
      void
      add(const ContactEquation &equation)
      {
        for (const auto &entry : equation.equation.coefficients)
          add(entry);
        for (const auto dof : equation.candidates)
          add(dof);
      }

      std::size_t seed = 0;
    };

    // The bodies' stiffness stays what it is on a mesh.
    template <int dim>
    std::size_t
    fingerprint_of(const ContactEquilibrium<dim> &problem, const LA::Vector *springs)
    {
      Fingerprint result;
      for (const auto &line : problem.supports.get_lines())
        {
          result.add(line.index);
          for (const auto &entry : line.entries)
            result.add(entry);
        }
      for (const auto &node : problem.contact.nodes())
        {
          result.add(node.tied);
          result.add(node.frictional);
          result.add(node.area);
          result.add(node.c);
          result.add(node.normal);
          result.add(node.closing);
          for (unsigned int d = 0; d < dim; ++d)
            {
              result.add(node.directions[d]);
              result.add(node.components[d]);
            }
        }
      if (springs != nullptr)
        for (const auto dof : problem.discretization.locally_owned)
          if ((*springs)(dof) != 0)
            result.add(dof);
      return result.seed;
    }

    bool
    is_nearly_incompressible(const Scene &scene)
    {
      return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto &body) {
        return !body.rigid && body.material.poisson >= 0.49;
      });
    }
  } // namespace

  template <int dim>
  void
  KeptSystem<dim>::prepare(const ContactEquilibrium<dim> &problem, const LA::Vector *springs)
  {
    const auto    &discretization = problem.discretization;
    const MPI_Comm communicator   = discretization.geometry.communicator;
    const auto     now            = fingerprint_of(problem, springs);
    if (Utilities::MPI::min(int(fingerprint == now), communicator) == 1)
      {
        solver->set_gives_up(problem.gives_up);
        return;
      }
    fingerprint = now;
    solver.reset();
    forget_states();
    system = std::make_unique<EliminatedSystem>(
        discretization.locally_owned, discretization.relevant, communicator);
    solver = std::make_unique<LinearSolver>(
        problem.solver_parameters,
        dim,
        discretization.fe.degree,
        !problem.contact.any_friction(),
        problem.gives_up,
        SolverPurpose{is_nearly_incompressible(discretization.scene),
                      problem.contact.any_friction() && problem.penalty == nullptr});
    if (!solver->is_direct(discretization.dof_handler.n_dofs()))
      solver->set_near_null_space(rigid_body_modes(discretization));

    TimerOutput::Scope           scope(problem.timer, "sparsity and bulk matrix");
    std::vector<ContactEquation> candidates;
    for (const auto &node : problem.contact.nodes())
      for (const auto *equation : node.holding())
        {
          candidates.push_back(*equation);
          if (!others_hold(*equation, problem.supports))
            candidates.back().others.clear();
          substitute(candidates.back().equation, problem.supports);
        }
    for (const auto &node : problem.contact.nodes())
      if (node.frictional || (node.tied && !node.planes.empty())) // slip and planes mix components
        {
          candidates.push_back(all_components(node));
          substitute(candidates.back().equation, problem.supports);
        }
    system->setup(problem.mechanics.bodies().tangent(), problem.supports, candidates, springs);
  }

  template <int dim>
  void
  KeptSystem<dim>::assemble(const ContactEquilibrium<dim>  &problem,
                            const Iterate<dim>             &now,
                            const LA::Vector               *new_springs,
                            const std::vector<LocalMatrix> &further)
  {
    system->assemble(problem.mechanics.bodies().tangent(), *now.constraints, new_springs, further);
    forget_states();
    states = now.states.all();
    laws   = now.laws;
    if (new_springs != nullptr)
      springs = *new_springs;
  }

  template <int dim>
  void
  KeptSystem<dim>::forget_states()
  {
    states.clear();
    laws.clear();
    responses.clear();
    springs = LA::Vector();
  }

  template <int dim>
  unsigned int
  KeptSystem<dim>::n_other_states(const NodeStates<dim> &now) const
  {
    unsigned int n = 0;
    for (unsigned int k = 0; k < states.size(); ++k)
      n += now[k] != states[k];
    return n;
  }

  template <int dim>
  bool
  KeptSystem<dim>::has_springs(const LA::Vector *others) const
  {
    if (others == nullptr || springs.size() == 0)
      return (others == nullptr) == (springs.size() == 0);
    LA::Vector difference(*others);
    difference -= springs;
    return difference.linfty_norm() == 0;
  }

  template class KeptSystem<2>;
  template class KeptSystem<3>;
} // namespace Amontons
