// Pictures of the load history.
#include <amontons/output/report.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    using Pass = std::vector<const MeshSummary *>;

    // For labels.
    struct UnitNames
    {
      std::string length, force, pressure, work;
    };

    UnitNames
    names_of(const RunSummary &summary)
    {
      const Units &units = summary.units;
      const bool   per_thickness =
          summary.kind == ProblemType::plane_strain || summary.kind == ProblemType::plane_stress;
      return {units.length, units.force_of(per_thickness), units.pressure(), units.work_of(per_thickness)};
    }

    double
    norm(const std::vector<double> &v)
    {
      double sum = 0;
      for (const double x : v)
        sum += x * x;
      return std::sqrt(sum);
    }

    // Unit vector along the largest tangential force of a pair, to the side where its largest component is
    // positive; zero without one.
    std::vector<double>
    tangential_direction(const Pass &pass, const std::size_t pair)
    {
      std::vector<double> direction;
      double              largest_normal = 0;
      for (const MeshSummary *mesh : pass)
        {
          largest_normal = std::max(largest_normal, norm(mesh->pairs[pair].normal_force));
          if (norm(mesh->pairs[pair].tangential_force) > norm(direction))
            direction = mesh->pairs[pair].tangential_force;
        }
      const double length = norm(direction);
      if (length <= 1e-9 * largest_normal)
        return {};
      const double largest =
          *std::max_element(direction.begin(), direction.end(), [](const double a, const double b) {
            return std::abs(a) < std::abs(b);
          });
      for (double &x : direction)
        x /= std::copysign(length, largest);
      return direction;
    }

    double
    along(const std::vector<double> &v, const std::vector<double> &direction)
    {
      double sum = 0;
      for (std::size_t d = 0; d < std::min(v.size(), direction.size()); ++d)
        sum += v[d] * direction[d];
      return v.size() < direction.size() ? unknown : sum;
    }

    Chart
    over_time(const std::string &title, const std::string &y_label)
    {
      Chart chart;
      chart.title   = title;
      chart.x_label = "t";
      chart.y_label = y_label;
      return chart;
    }

    template <typename Value>
    void
    add_curve(Chart &chart, const std::string &name, const Pass &pass, const Value &value)
    {
      Curve curve{name, {}, {}, true, pass.size() <= 60};
      for (const MeshSummary *mesh : pass)
        {
          curve.x.push_back(mesh->t);
          curve.y.push_back(value(*mesh));
        }
      chart.curves.push_back(curve);
    }

    Chart
    normal_force_chart(const Pass &pass, const UnitNames &units)
    {
      Chart chart = over_time("Normal force", with_unit("force on the slave body", units.force));
      for (std::size_t i = 0; i < pass.back()->pairs.size(); ++i)
        add_curve(chart, pass.back()->pairs[i].name, pass, [i](const MeshSummary &mesh) {
          return norm(mesh.pairs[i].normal_force);
        });
      return chart;
    }

    Chart
    tangential_force_chart(const Pass &pass, const UnitNames &units)
    {
      Chart chart = over_time("Tangential force", with_unit("force on the slave body", units.force));
      for (std::size_t i = 0; i < pass.back()->pairs.size(); ++i)
        if (const auto direction = tangential_direction(pass, i); !direction.empty())
          add_curve(chart, pass.back()->pairs[i].name, pass, [&](const MeshSummary &mesh) {
            return along(mesh.pairs[i].tangential_force, direction);
          });
      return chart;
    }

    Chart
    peak_chart(const Pass &pass, const UnitNames &units)
    {
      Chart chart = over_time("Peak pressure", with_unit("pressure", units.pressure));
      for (std::size_t i = 0; i < pass.back()->pairs.size(); ++i)
        add_curve(chart, pass.back()->pairs[i].name, pass, [i](const MeshSummary &mesh) {
          return mesh.pairs[i].peak_pressure;
        });
      return chart;
    }

    // Where part of a surface slips: how large the sticking part is.
    Chart
    size_chart(const Pass &pass, const UnitNames &units)
    {
      Chart chart = over_time("Size of contact and stick", with_unit("half-width or radius", units.length));
      for (std::size_t i = 0; i < pass.back()->pairs.size(); ++i)
        if (std::any_of(pass.begin(), pass.end(), [i](const MeshSummary *mesh) {
              const PairSummary &pair = mesh->pairs[i];
              return pair.stick_size && pair.n_open > 0 && pair.n_slip > 0 && pair.n_stick > 0;
            }))
          {
            add_curve(chart, pass.back()->pairs[i].name + ": contact", pass, [i](const MeshSummary &mesh) {
              return mesh.pairs[i].contact_size;
            });
            add_curve(chart, pass.back()->pairs[i].name + ": stick", pass, [i](const MeshSummary &mesh) {
              return mesh.pairs[i].stick_size.value_or(unknown);
            });
          }
      return chart;
    }

    // All of it is zero at t = 0, the state of rest.
    void
    begin_at_rest(Chart &chart)
    {
      for (Curve &curve : chart.curves)
        {
          curve.x.insert(curve.x.begin(), 0.);
          curve.y.insert(curve.y.begin(), 0.);
        }
    }

    Chart
    work_chart(const Pass &pass, const UnitNames &units)
    {
      Chart chart = over_time("Where the work goes", with_unit("since t = 0", units.work));
      if (!pass.back()->external_work)
        return chart;
      add_curve(chart, "external work", pass, [](const MeshSummary &mesh) {
        return mesh.external_work.value_or(unknown);
      });
      add_curve(chart, "stored energy", pass, [](const MeshSummary &mesh) { return mesh.energy; });
      add_curve(chart, "contact work", pass, [](const MeshSummary &mesh) {
        return mesh.contact_work.value_or(unknown);
      });
      begin_at_rest(chart);
      return chart;
    }

    Chart
    dissipation_chart(const Pass &pass, const UnitNames &units)
    {
      Chart chart = over_time("Work of friction", with_unit("dissipation since t = 0", units.work));
      if (!pass.back()->dissipation)
        return chart;
      add_curve(chart, "", pass, [](const MeshSummary &mesh) { return mesh.dissipation.value_or(unknown); });
      begin_at_rest(chart);
      return chart;
    }

    // The first point of a probe, along the tangential force of the first pair that has one.
    Chart
    hysteresis_chart(const Pass &pass, const std::size_t probe, const UnitNames &units)
    {
      Chart chart;
      for (std::size_t i = 0; i < pass.back()->pairs.size() && chart.curves.empty(); ++i)
        {
          const auto direction = tangential_direction(pass, i);
          if (direction.empty())
            continue;
          chart.title = "Hysteresis, " + pass.back()->pairs[i].name;
          chart.x_label =
              with_unit("displacement along it, probe " + pass.back()->probes[probe].name, units.length);
          chart.y_label = with_unit("tangential force on the slave body", units.force);
          Curve curve{"", {}, {}, true, true};
          for (const MeshSummary *mesh : pass)
            {
              const auto  &points = mesh->probes[probe].points;
              const double u      = points.empty() ? unknown : along(points[0].displacement, direction);
              if (!std::isfinite(u))
                continue;
              curve.x.push_back(u);
              curve.y.push_back(along(mesh->pairs[i].tangential_force, direction));
            }
          if (!curve.x.empty() &&
              std::any_of(curve.x.begin(), curve.x.end(), [](const double u) { return u != 0; }))
            chart.curves.push_back(curve);
        }
      return chart;
    }

    Chart
    iterations_chart(const Pass &pass)
    {
      Chart chart;
      chart.title         = "Iterations per increment, last mesh";
      chart.x_label       = "increment";
      chart.y_label       = "iterations";
      chart.whole_numbers = true;
      Curve curve{"", {}, {}, false, true};
      for (const MeshSummary *mesh : pass)
        {
          curve.x.push_back(mesh->increment);
          curve.y.push_back(mesh->iterations);
        }
      chart.curves.push_back(curve);
      return chart;
    }
  } // namespace

  std::vector<const MeshSummary *>
  last_pass(const RunSummary &summary)
  {
    Pass pass;
    for (auto mesh = summary.meshes.rbegin(); mesh != summary.meshes.rend(); ++mesh)
      {
        if (!pass.empty() && mesh->t > pass.back()->t)
          break;
        if (pass.empty() || mesh->t < pass.back()->t)
          pass.push_back(&*mesh);
      }
    std::reverse(pass.begin(), pass.end());
    return pass;
  }

  std::vector<Chart>
  history_charts(const RunSummary &summary)
  {
    const Pass pass = last_pass(summary);
    if (pass.size() < 2)
      return {};
    const UnitNames    units  = names_of(summary);
    std::vector<Chart> charts = {normal_force_chart(pass, units),
                                 tangential_force_chart(pass, units),
                                 peak_chart(pass, units),
                                 size_chart(pass, units),
                                 work_chart(pass, units),
                                 dissipation_chart(pass, units)};
    for (std::size_t p = 0; p < std::min<std::size_t>(2, pass.back()->probes.size()); ++p)
      charts.push_back(hysteresis_chart(pass, p, units));
    charts.push_back(iterations_chart(pass));
    charts.erase(
        std::remove_if(charts.begin(), charts.end(), [](const Chart &chart) { return chart.curves.empty(); }),
        charts.end());
    return charts;
  }
} // namespace Amontons
