#include <amontons/output/files.h>
#include <amontons/output/history.h>
#include <amontons/output/json.h>

namespace Amontons
{
  namespace
  {
    using Row = std::vector<std::pair<std::string, double>>; // name and value of each column

    void
    add_vector(Row                            &row,
               const std::string              &name,
               const std::vector<std::string> &axes,
               const std::vector<double>      &values)
    {
      for (std::size_t i = 0; i < axes.size(); ++i)
        row.emplace_back(name + axes[i], i < values.size() ? values[i] : unknown);
    }

    void
    add_pair(Row &row, const PairSummary &pair, const std::vector<std::string> &axes)
    {
      add_vector(row, pair.name + ".normal_force_", axes, pair.normal_force);
      add_vector(row, pair.name + ".tangential_force_", axes, pair.tangential_force);
      row.emplace_back(pair.name + ".peak_pressure", pair.peak_pressure);
      row.emplace_back(pair.name + ".contact_size", pair.contact_size);
      if (pair.stick_size)
        row.emplace_back(pair.name + ".stick_size", *pair.stick_size);
      row.emplace_back(pair.name + ".n_open", pair.n_open);
      row.emplace_back(pair.name + ".n_stick", pair.n_stick);
      row.emplace_back(pair.name + ".n_slip", pair.n_slip);
    }

    void
    add_probe(Row &row, const ProbeSummary &probe, const ProblemType kind)
    {
      for (std::size_t i = 0; i < probe.points.size(); ++i)
        {
          const ProbePoint &point = probe.points[i];
          const std::string name =
              probe.name + (probe.points.size() > 1 ? "[" + std::to_string(i) + "]" : std::string());
          add_vector(row, name + ".u_", axis_names(kind), point.displacement);
          add_vector(row, name + ".stress_", stress_names(kind), point.stress);
          row.emplace_back(name + ".von_mises", point.von_mises);
        }
    }

    Row
    make_row(const MeshSummary &mesh, const ProblemType kind)
    {
      Row row = {{"increment", mesh.increment},
                 {"t", mesh.t},
                 {"mesh", mesh.mesh},
                 {"cells", static_cast<double>(mesh.cells)},
                 {"dofs", static_cast<double>(mesh.dofs)},
                 {"iterations", mesh.iterations},
                 {"krylov", mesh.krylov_iterations},
                 {"residual", mesh.residual}};
      for (const PairSummary &pair : mesh.pairs)
        add_pair(row, pair, axis_names(kind));
      row.emplace_back("error_bulk", mesh.error_estimate.bulk);
      row.emplace_back("error_contact", mesh.error_estimate.contact);
      row.emplace_back("energy", mesh.energy);
      if (mesh.external_work)
        {
          row.emplace_back("external_work", *mesh.external_work);
          row.emplace_back("contact_work", *mesh.contact_work);
          row.emplace_back("dissipation", *mesh.dissipation);
          row.emplace_back("contact_work_minus_dissipation", *mesh.contact_work - *mesh.dissipation);
        }
      for (const ProbeSummary &probe : mesh.probes)
        add_probe(row, probe, kind);
      return row;
    }
  } // namespace

  void
  write_history(const std::string &file, const std::vector<MeshSummary> &meshes, const ProblemType kind)
  {
    // The header is that of the row with most columns; what a row does not have is nan there.
    std::vector<std::map<std::string, double>> rows;
    std::vector<std::string>                   header;
    for (const MeshSummary &mesh : meshes)
      {
        const Row row = make_row(mesh, kind);
        rows.emplace_back(row.begin(), row.end());
        if (row.size() > header.size())
          {
            header.clear();
            for (const auto &column : row)
              header.push_back(column.first);
          }
      }
    std::string text;
    for (const std::string &name : header)
      text += (text.empty() ? "" : ",") + csv_field(name);
    for (const auto &row : rows)
      {
        text += "\n";
        for (std::size_t c = 0; c < header.size(); ++c)
          {
            const auto found = row.find(header[c]);
            text += (c == 0 ? "" : ",") + number_text(found == row.end() ? unknown : found->second);
          }
      }
    write_file(file, text + "\n");
  }
} // namespace Amontons
