#include <amontons/algebra/eliminated_system.h>
#include <amontons/base/points.h>
#include <amontons/contact/face_lattice.h>
#include <amontons/contact/shared_nodes.h>
#include <amontons/contact/common_normal.h>
#include <amontons/contact/surface_rim.h>
#include <amontons/contact/surface_search.h>
#include <amontons/friction/shear_law.h>
#include <amontons/output/nodal_forces.h>
#include <amontons/output/physics_checks.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    // What is no pressure: that of a strain of 1e-10 (scenes without load compare rounding with itself else),
    // and a millionth of the largest anywhere (forces balance to a part of all, also where little touches)
    // and so far (what loads have left behind that are gone is rounding).
    template <int dim>
    double
    pressure_of_rounding(const Answer<dim> &answer, const unsigned int i, const double largest_so_far)
    {
      double largest = largest_so_far;
      for (const auto &contacts : answer.state.contact)
        for (const auto &node : contacts)
          largest = std::max(largest, node.pressure);
      const auto &slave = answer.discretization.scene.bodies[answer.interfaces[i].slave->body];
      return std::max(1e-10 * contact_modulus(slave.material), 1e-6 * largest);
    }

    // How far shears exceed the bound of friction, relative to the largest bound.
    template <int dim>
    double
    cone_excess(const Answer<dim> &answer, const unsigned int i, const double largest_so_far)
    {
      const auto &interface = answer.interfaces[i];
      double      excess = 0, largest = pressure_of_rounding(answer, i, largest_so_far);
      for (unsigned int n = 0; interface.pair->has_friction() && n < interface.slave->nodes.size(); ++n)
        if (const auto &node = answer.state.contact[i][n]; node.state != ContactStatus::open)
          {
            const auto   X     = as_3d(interface.slave->nodes[n].X);
            const double bound = shear_bound(*interface.pair, X, answer.state.t, node.pressure).value;
            excess             = std::max(excess, node.shear.norm() - bound);
            largest            = std::max(largest, bound);
          }
      return excess / largest;
    }

    // |q/|q| - v/|v|| of the nodes that slip; slips that are nothing beside the others have no direction.
    template <int dim>
    double
    slip_misalignment(const Answer<dim> &answer, const unsigned int i)
    {
      const auto &interface = answer.interfaces[i];
      double      largest = 0, misalignment = 0;
      if (!interface.pair->has_friction())
        return 0;
      for (const auto &node : answer.state.contact[i])
        if (node.state == ContactStatus::slip)
          largest = std::max(largest, node.slip.norm());
      const double least = std::max(1e-3 * largest, 1e-9 * interface.slave->mean_size);
      for (const auto &node : answer.state.contact[i])
        if (node.state == ContactStatus::slip && node.slip.norm() > least && node.shear.norm() > 0)
          misalignment =
              std::max(misalignment, (node.shear / node.shear.norm() - node.slip / node.slip.norm()).norm());
      return misalignment;
    }

    // Nodes whose forces do not act along a normal of the body: where the surface ends, they have that of the
    // last face, beside an edge what is a mean of both sides there has a part in theirs.
    template <int dim>
    std::vector<bool>
    corner_nodes(const ContactSurface<dim> &surface, std::vector<bool> result, const double degrees)
    {
      const double cosine = std::cos(degrees / 2 * numbers::PI / 180);
      const auto   place  = lattice<dim - 1>(surface.degree);
      for (unsigned int f = 0; surface.sharpest_edge > degrees && f < surface.faces.size(); ++f)
        for (unsigned int k = 0; k < place.size(); ++k)
          {
            const unsigned int node = surface.faces[f].nodes[k];
            if (surface.face_normal(f, place[k]) * surface.nodes[node].normal < cosine)
              for (const unsigned int beside : surface.faces[f].nodes)
                result[beside] = true;
          }
      return result;
    }

    using Checks = std::map<std::string, double>;

    template <int dim>
    struct CornerForces
    {
      double mismatch = 0;  // sine of the angle between the normals of both sides, where they bear most
      double all      = 0;  // forces, also elsewhere
      Tensor<1, dim> aside; // what corners add along a wrong direction
    };

    // Both sides fit where they touch, and where a corner of the master presses on the slave, the normal is
    // the slave's; but a corner of the slave has the normals of its own faces. (The edge of a punch has a
    // part of its force, where the other side is steep: those of both ends balance. Blunt edges, as those of
    // facets, may bear most of a force on coarse meshes, and none of it on fine ones.)
    template <int dim>
    CornerForces<dim>
    corner_forces_of(const Answer<dim> &answer, const unsigned int i)
    {
      const auto       &interface  = answer.interfaces[i];
      const auto       &slave      = *interface.slave;
      const auto        nearest    = nearest_points(interface);
      const auto        rim        = rim_nodes(slave);
      const auto        is_corner  = corner_nodes(slave, rim, 60);
      const auto        is_edge    = corner_nodes(slave, rim, 10);
      double            at_corners = 0, off = 0;
      CornerForces<dim> result;
      for (const auto &row : interface.coupling.rows)
        if (const double f = row.area * answer.state.contact[i][row.node].pressure;
            f > 0 && nearest[row.node] != nullptr)
          {
            result.all += f;
            if (!is_edge[row.node])
              continue;
            const auto   own    = row.normal / row.normal.norm();
            const auto   other  = normal_of_other_side(interface.master, *nearest[row.node]);
            const double cosine = own * other;
            result.aside += f * (own - std::copysign(1., cosine) * other);
            if (!is_corner[row.node])
              continue;
            at_corners += f;
            off += f * std::sqrt(std::max(0., 1 - cosine * cosine));
          }
      for (const auto &node : slave.nodes)
        for (const auto &plane : node.symmetry_planes)
          result.aside -= (result.aside * plane) * plane;
      if (answer.discretization.scene.kind == ProblemType::axisymmetric)
        result.aside[0] = 0;
      if (at_corners > 0.6 * result.all)
        result.mismatch = off / result.all;
      return result;
    }

    // The mismatch of normals, and what forces of all pairs of the same two (those of both faces at a corner
    // make one force) have aside.
    template <int dim>
    std::pair<double, double>
    check_corners(const Answer<dim> &answer)
    {
      std::map<std::pair<unsigned int, unsigned int>, CornerForces<dim>> forces;
      double                                                             mismatch = 0, aside = 0;
      for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
        if (const auto &interface = answer.interfaces[i]; !interface.pair->tied)
          {
            const auto *const  other = interface.master.surface;
            const unsigned int master =
                other != nullptr ? other->body
                                 : answer.discretization.scene.bodies.size() + interface.master.carrier;
            const auto of_pair = corner_forces_of(answer, i);
            auto      &sum     = forces[{interface.slave->body, master}];
            sum.all += of_pair.all;
            sum.aside += of_pair.aside;
            mismatch = std::max(mismatch, of_pair.mismatch);
          }
      for (const auto &[bodies, sum] : forces)
        if (sum.all > 0)
          aside = std::max(aside, sum.aside.norm() / sum.all);
      return {mismatch, aside};
    }

    template <int dim>
    void
    check_contact(const Answer<dim> &answer, const double largest_so_far, Checks &checks)
    {
      double penetration = 0, tension = 0, complementarity = 0, cone = 0, misalignment = 0;
      bool   any_friction = false;
      for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
        {
          const auto &interface = answer.interfaces[i];
          if (interface.pair->tied)
            continue;
          any_friction      = any_friction || interface.pair->has_friction();
          cone              = std::max(cone, cone_excess(answer, i, largest_so_far));
          misalignment      = std::max(misalignment, slip_misalignment(answer, i));
          const double h    = interface.slave->mean_size;
          double       peak = pressure_of_rounding(answer, i, largest_so_far);
          for (const auto &node : answer.state.contact[i])
            peak = std::max(peak, node.pressure);
          for (const auto &node : answer.state.contact[i])
            {
              penetration     = std::max(penetration, -node.gap / h);
              tension         = std::max(tension, -node.pressure / peak);
              complementarity = std::max(complementarity, std::abs(node.pressure * node.gap) / (peak * h));
            }
        }
      checks["penetration"] = penetration;
      checks["overlap_behind"] =
          overlap_behind(answer.discretization, answer.state.displacement, answer.interfaces);
      checks["tension"]         = tension;
      checks["complementarity"] = complementarity;
      if (any_friction)
        {
          checks["coulomb_cone"]   = cone;
          checks["slip_direction"] = misalignment;
        }
    }

    // What is no force: what a strain of 1e-9 takes, E L^(dim - 1) of each body.
    template <int dim>
    std::vector<double>
    forces_of_rounding(const Discretization<dim> &discretization)
    {
      std::vector<double> result;
      for (unsigned int b = 0; b < discretization.scene.bodies.size(); ++b)
        {
          const auto  &body      = discretization.scene.bodies[b];
          const double size      = discretization.geometry.body_sizes[b];
          const bool   full_turn = discretization.scene.kind == ProblemType::axisymmetric;
          result.push_back(body.rigid ? 0.
                                      : 1e-9 * body.material.young * std::pow(size, full_turn ? 2 : dim - 1));
        }
      return result;
    }

    // By body: the supports' forces are what is missing for equilibrium on constrained DoFs; elsewhere
    // nothing may be missing.
    template <int dim>
    void
    check_balance(const Answer<dim> &answer, Checks &checks)
    {
      const auto         &discretization = answer.discretization;
      const MPI_Comm      communicator   = discretization.geometry.communicator;
      const IndexSet     &owned          = discretization.locally_owned;
      const auto          places         = locate_dofs(answer);
      const auto          forces         = support_forces(answer, places);
      const auto          no_force       = forces_of_rounding(discretization);
      const unsigned int  n_moments = dim == 2 ? 1 : 3, n_bodies = no_force.size();
      LA::Vector          missing = discretization.make_owned_vector();
      std::vector<double> moments(n_bodies * n_moments, 0.), levers(n_bodies, 0.), sums(2, 0.);
      const auto          add = [&](const unsigned int body, const double force) {
        sums[1] += force * force;
        if (body != no_body)
          levers[body] += std::abs(force) * discretization.geometry.body_sizes[body];
      };
      unsigned int i = 0;
      for (const auto dof : owned)
        missing(dof) = forces[i++];
      missing.compress(VectorOperation::insert);
      const LA::Vector condensed = condense(missing, answer.supports, discretization.make_owned_vector());
      i                          = 0;
      for (const auto dof : owned)
        {
          const DofPlace<dim> &place = places[i];
          const double         force = forces[i++], value = condensed(dof);
          if (place.body == no_body)
            continue;
          add(place.body, answer.loads(dof));
          if (answer.supports.is_constrained(dof))
            {
              add(place.body, force);
              continue;
            }
          sums[0] += value * value;
          sums[1] += value * value;
          // (About the body: far from the origin rounding of forces would count.)
          const Point<dim> arm(place.X - discretization.geometry.body_centres[place.body]);
          const auto       moment = moment_of(arm, place.component, value);
          for (unsigned int k = 0; k < n_moments; ++k)
            moments[place.body * n_moments + k] += moment[k];
        }
      for (const auto &[dof, force] : contact_forces(answer))
        if (owned.is_element(dof))
          add(places[owned.index_within_set(dof)].body, force);
      Utilities::MPI::sum(moments, communicator, moments);
      Utilities::MPI::sum(levers, communicator, levers);
      Utilities::MPI::sum(sums, communicator, sums);
      double &moment_balance = checks["moment_balance"] = 0;
      for (unsigned int b = 0; b < n_bodies; ++b)
        {
          const double lever = std::max(levers[b], no_force[b] * discretization.geometry.body_sizes[b]);
          for (unsigned int k = 0; k < n_moments && lever > 0; ++k)
            moment_balance = std::max(moment_balance, std::abs(moments[b * n_moments + k]) / lever);
        }
      const double scale = std::max(std::sqrt(sums[1]), *std::max_element(no_force.begin(), no_force.end()));
      checks["force_balance"] = scale > 0 ? std::sqrt(sums[0]) / scale : 0;
    }
  } // namespace

  template <int dim>
  std::map<std::string, double>
  check_physics(const Answer<dim> &answer, const double largest_so_far)
  {
    Checks checks;
    check_contact(answer, largest_so_far, checks);
    std::tie(checks["normal_mismatch"], checks["corner_forces"]) = check_corners(answer);
    check_balance(answer, checks);
    return checks;
  }

  template <int dim>
  double
  corner_forces(const Answer<dim> &answer)
  {
    return check_corners(answer).second;
  }

  constexpr double largest_normal_mismatch = 0.25;

  std::string
  broken_laws(const std::map<std::string, double> &checks, const double tolerance)
  {
    std::ostringstream text;
    text.precision(2);
    for (const auto &[name, law] :
         {std::make_pair("force_balance", "equilibrium of forces"),
          std::make_pair("moment_balance", "equilibrium of moments"),
          std::make_pair("tension", "no tension in the contact"),
          std::make_pair("penetration", "no overlap in the contact"),
          std::make_pair("overlap_behind",
                         "no overlap with a master behind the one that a node obeys (it "
                         "obeys one: where both press, make their sides the slaves)"),
          std::make_pair("complementarity", "no pressure across a gap"),
          std::make_pair("coulomb_cone", "the bound of friction")})
      if (const auto check = checks.find(name); check != checks.end() && !(check->second <= tolerance))
        text << (text.str().empty() ? "" : "; ") << law << " by " << check->second;
    if (const auto check = checks.find("normal_mismatch");
        check != checks.end() && check->second > largest_normal_mismatch)
      text << (text.str().empty() ? "" : "; ") << "contact along the normals of both sides by "
           << check->second << " (sine of their angle, at most " << largest_normal_mismatch
           << ": a corner of the slave presses on a face, along the normal of its own faces; round the "
              "corner, or "
              "make the other side the slave)";
    return text.str();
  }

  template double
  corner_forces(const Answer<2> &);
  template double
  corner_forces(const Answer<3> &);
  template std::map<std::string, double>
  check_physics(const Answer<2> &, const double);
  template std::map<std::string, double>
  check_physics(const Answer<3> &, const double);
} // namespace Amontons
