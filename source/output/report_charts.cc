#include <amontons/output/report.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    std::vector<ContactNode>
    nodes_of(const std::vector<ContactNode> &table, const std::string &pair)
    {
      std::vector<ContactNode> nodes;
      std::copy_if(table.begin(), table.end(), std::back_inserter(nodes), [&](const ContactNode &node) {
        return node.pair == pair;
      });
      return nodes;
    }

    void
    fill_computed(PressureCurve &curve, const std::vector<ContactNode> &nodes, const Point<3> &centre)
    {
      const auto middle =
          std::min_element(nodes.begin(), nodes.end(), [&](const ContactNode &a, const ContactNode &b) {
            return a.X.distance_square(centre) < b.X.distance_square(centre);
          });
      curve.centre = middle->x;
      for (const ContactNode &node : nodes)
        {
          curve.s.push_back(curve.radial ? node.X.distance(centre) : node.arc - middle->arc);
          curve.pressure.push_back(node.pressure);
        }
    }

    // The two axes beside the largest component of the mean normal, of what carries pressure if anything
    // does.
    std::array<unsigned int, 2>
    axes_of_surface(const std::vector<ContactNode> &nodes)
    {
      Tensor<1, 3> normal, of_all;
      for (const ContactNode &node : nodes)
        {
          normal += node.area * std::max(0., node.pressure) * node.normal;
          of_all += node.area * node.normal;
        }
      if (normal.norm() == 0)
        normal = of_all;
      unsigned int across = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(normal[d]) > std::abs(normal[across]))
          across = d;
      return {{across == 0 ? 1u : 0u, across == 2 ? 1u : 2u}};
    }

    // Along the walk through the nodes.
    Tensor<1, 3>
    tangent(const std::vector<ContactNode> &nodes, const std::size_t i)
    {
      Tensor<1, 3> direction = nodes[std::min(i + 1, nodes.size() - 1)].X - nodes[i > 0 ? i - 1 : 0].X;
      direction -= (direction * nodes[i].normal) * nodes[i].normal;
      return direction.norm() > 0 ? direction / direction.norm() : direction;
    }

    // Of a vector in space, to the side where its largest component is positive. What is small beside that
    // component comes from surfaces cut by symmetry planes.
    Tensor<1, 3>
    direction_of(const std::vector<double> &force)
    {
      Tensor<1, 3> direction;
      double       largest = 0;
      for (const double f : force)
        largest = std::abs(f) > std::abs(largest) ? f : largest;
      for (std::size_t d = 0; d < force.size(); ++d)
        direction[d] = std::abs(force[d]) > 0.15 * std::abs(largest) ? force[d] : 0.;
      return direction.norm() > 0 ? direction / std::copysign(direction.norm(), largest) : direction;
    }

    void
    fill_shear(PressureCurve                  &curve,
               const std::vector<ContactNode> &nodes,
               const std::vector<double>      &tangential_force)
    {
      const Tensor<1, 3> force = direction_of(tangential_force);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          const ContactNode &node = nodes[i];
          curve.shear.push_back(node.traction * (curve.radial ? force : tangent(nodes, i)));
          curve.bound.push_back(node.bound);
          curve.states.push_back(node.state);
          curve.has_multiplier.push_back(!std::isnan(node.gap));
          curve.places.push_back({{node.X[curve.axes[0]], node.X[curve.axes[1]]}});
          curve.tractions.push_back({{node.traction[curve.axes[0]], node.traction[curve.axes[1]]}});
        }
    }

    // On the side or sides of the centre where there are nodes.
    void
    fill_exact(PressureCurve &curve, const ReferenceTractions &exact)
    {
      double range = curve.shown > 0 ? curve.shown : 0;
      if (range == 0)
        for (const double s : curve.s)
          range = std::max(range, std::abs(s));
      const auto [lowest, highest] = std::minmax_element(curve.s.begin(), curve.s.end());
      constexpr int n              = 400;
      for (int i = -n; i <= n; ++i)
        {
          const double s = range * i / n;
          if (s < *lowest - 1e-9 * range || s > *highest + 1e-9 * range)
            continue;
          curve.exact_s.push_back(s);
          curve.exact_pressure.push_back(exact.pressure(std::abs(s)));
          if (exact.shear && !curve.shear.empty())
            curve.exact_shear.push_back(exact.shear(std::abs(s)));
        }
    }

    PressureCurve
    make_curve(const PairSummary &pair, const std::vector<ContactNode> &nodes, const int dim)
    {
      PressureCurve curve;
      curve.pair   = pair.name;
      curve.radial = dim == 3;
      Point<3> centre;
      for (std::size_t d = 0; d < pair.centre.size(); ++d)
        centre[d] = pair.centre[d];
      curve.axes = axes_of_surface(nodes);
      if (!nodes.empty())
        fill_computed(curve, nodes, centre);
      if (!nodes.empty() && !std::isnan(nodes.front().bound))
        fill_shear(curve, nodes, pair.tangential_force);
      // Less than three faces: the contact is closed or curved, so that its size says nothing.
      if (std::count_if(curve.s.begin(), curve.s.end(), [&](const double s) {
            return std::abs(s) <= pair.contact_size;
          }) > 3)
        curve.shown = 1.6 * pair.contact_size;
      return curve;
    }

    void
    add_error_curve(Chart                     &chart,
                    const std::string         &name,
                    const std::vector<double> &x,
                    const std::vector<double> &y)
    {
      if (x.size() > 1 && std::any_of(y.begin(), y.end(), [](const double v) { return v > 1e-10; }))
        chart.curves.push_back({name, x, y, true, true});
    }
  } // namespace

  std::vector<PressureCurve>
  pressure_curves(const std::vector<ContactNode> &table,
                  const std::vector<PairSummary> &pairs,
                  const int                       dim,
                  const ReferenceTractions       &reference)
  {
    std::vector<PressureCurve> curves;
    for (const PairSummary &pair : pairs)
      {
        PressureCurve curve = make_curve(pair, nodes_of(table, pair.name), dim);
        if (curve.s.empty())
          continue;
        const bool described = reference.pair.empty() ? curves.empty() : reference.pair == pair.name;
        if (reference.pressure && described)
          {
            curve.exact_name = "closed form";
            fill_exact(curve, reference);
          }
        curves.push_back(curve);
      }
    return curves;
  }

  Chart
  pressure_chart(const PressureCurve &curve, const Units &units)
  {
    Chart chart;
    chart.title   = "Contact pressure, " + curve.pair;
    chart.x_label = with_unit(curve.radial ? "distance from the centre of the contact"
                                           : "arc length from the centre of the contact",
                              units.length);
    chart.y_label = with_unit("pressure", units.pressure());
    Curve computed{"computed", {}, {}, !curve.radial, true};
    for (std::size_t i = 0; i < curve.s.size(); ++i)
      if (curve.shown == 0 || std::abs(curve.s[i]) <= curve.shown)
        {
          computed.x.push_back(curve.s[i]);
          computed.y.push_back(curve.pressure[i]);
        }
    chart.curves.push_back(computed);
    if (!curve.exact_name.empty())
      chart.curves.push_back({curve.exact_name, curve.exact_s, curve.exact_pressure, true, false});
    return chart;
  }

  Chart
  iteration_chart(const RunSummary &summary)
  {
    Chart chart;
    chart.title         = "Convergence of the iteration";
    chart.x_label       = "iteration";
    chart.y_label       = "nodes that change their state";
    chart.whole_numbers = true;
    for (const NewtonSummary &newton : summary.newton)
      if (newton.increment == summary.newton.back().increment)
        {
          Curve curve{"mesh " + std::to_string(newton.mesh), {}, {}, true, true};
          for (const unsigned int changes : newton.active_set_changes)
            {
              curve.x.push_back(curve.x.size() + 1);
              curve.y.push_back(changes);
            }
          if (curve.x.size() > 1)
            chart.curves.push_back(curve);
        }
    if (chart.curves.size() > 8)
      chart.curves.erase(chart.curves.begin(), chart.curves.end() - 8);
    return chart;
  }

  Chart
  error_chart(const RunSummary &summary)
  {
    Chart chart;
    chart.title   = "Relative errors";
    chart.x_label = "degrees of freedom";
    chart.y_label = "error";
    chart.log_x = chart.log_y = true;

    // Of a mesh that other increments were taken on again, the last answer.
    std::vector<const MeshSummary *> meshes;
    for (const MeshSummary &mesh : summary.meshes)
      if (mesh.t == summary.meshes.back().t)
        {
          if (!meshes.empty() && meshes.back()->dofs == mesh.dofs)
            meshes.pop_back();
          meshes.push_back(&mesh);
        }
    std::vector<double>                        dofs, contact, shear, bulk;
    std::map<std::string, std::vector<double>> errors;
    for (const MeshSummary *const mesh : meshes)
      {
        dofs.push_back(mesh->dofs);
        contact.push_back(mesh->error_estimate.contact);
        shear.push_back(mesh->error_estimate.shear);
        bulk.push_back(mesh->error_estimate.bulk);
        if (mesh->reference)
          for (const auto &[name, error] : mesh->reference->errors)
            {
              errors[name].resize(dofs.size() - 1, unknown);
              errors[name].push_back(std::abs(error));
            }
      }
    add_error_curve(chart, "pressure, estimated", dofs, contact);
    add_error_curve(chart, "shear, estimated", dofs, shear);
    add_error_curve(chart, "stress, estimated", dofs, bulk);
    for (auto &[name, values] : errors)
      {
        values.resize(dofs.size(), unknown);
        add_error_curve(chart, name, dofs, values);
      }
    return chart;
  }
} // namespace Amontons
