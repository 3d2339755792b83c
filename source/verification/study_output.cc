#include <amontons/verification/gnuplot.h>
#include <amontons/verification/study_output.h>

#include <deal.II/base/convergence_table.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>

namespace Amontons
{
  namespace
  {
    unsigned int
    dofs_column(const Study &study)
    {
      unsigned int i = 0;
      while (study.columns[i].label != "dofs")
        ++i;
      return i;
    }

    // Orders need more DoFs in every row, and an error in every row.
    bool
    has_orders(const StudySeries &series, const unsigned int dofs, const unsigned int quantity)
    {
      for (unsigned int r = 0; r < series.rows.size(); ++r)
        if (!(std::abs(series.rows[r].errors[quantity]) > 0) ||
            (r > 0 && !(series.rows[r].columns[dofs] > series.rows[r - 1].columns[dofs])))
          return false;
      return series.rows.size() > 1;
    }

    void
    print_table(const Study &study, const StudySeries &series, std::ostream &out)
    {
      dealii::ConvergenceTable table;
      for (const StudyRow &row : series.rows)
        {
          table.add_value(varied_name(study), row.varied);
          for (unsigned int c = 0; c < row.columns.size(); ++c)
            if (study.columns[c].label == "cells" || study.columns[c].label == "dofs")
              table.add_value(study.columns[c].label, static_cast<unsigned int>(std::lround(row.columns[c])));
            else
              table.add_value(study.columns[c].label, row.columns[c]);
          for (unsigned int q = 0; q < row.errors.size(); ++q)
            table.add_value(study.quantities[q].label, row.errors[q]);
        }
      for (unsigned int c = 0; c < study.columns.size(); ++c)
        if (study.columns[c].label != "cells" && study.columns[c].label != "dofs")
          table.set_precision(study.columns[c].label, 2);
      for (unsigned int q = 0; q < study.quantities.size(); ++q)
        {
          const std::string &name = study.quantities[q].label;
          table.set_precision(name, 3);
          table.set_scientific(name, true);
          if (has_orders(series, dofs_column(study), q))
            table.evaluate_convergence_rates(
                name, "dofs", dealii::ConvergenceTable::reduction_rate_log2, series.dim);
        }
      table.write_text(out);
    }

    std::string
    in_csv(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
      return result + "\"";
    }

    void
    write_csv(const Study &study, const std::vector<StudySeries> &all_series, std::ostream &out)
    {
      out << "series," << in_csv(varied_name(study));
      for (const SummaryPath &column : study.columns)
        out << ',' << in_csv(column.label);
      for (const SummaryPath &quantity : study.quantities)
        out << ',' << in_csv(quantity.label) << ',' << in_csv(quantity.label + " order");
      out << '\n' << std::setprecision(10);
      const unsigned int dofs = dofs_column(study);
      for (const StudySeries &series : all_series)
        for (unsigned int r = 0; r < series.rows.size(); ++r)
          {
            const StudyRow &row = series.rows[r];
            out << in_csv(series.label) << ',' << in_csv(row.varied);
            for (const double value : row.columns)
              out << ',' << value;
            for (unsigned int q = 0; q < row.errors.size(); ++q)
              {
                const StudyRow &before = series.rows[r > 0 ? r - 1 : 0];
                const double    order  = observed_order(
                    before.errors[q], row.errors[q], before.columns[dofs], row.columns[dofs], series.dim);
                out << ',' << row.errors[q] << ',';
                if (std::isfinite(order))
                  out << order;
              }
            out << '\n';
          }
    }
  } // namespace

  std::string
  varied_name(const Study &study)
  {
    return study.per_mesh ? "mesh" : study.sweep.back().label;
  }

  double
  observed_order(const double e1, const double e2, const double n1, const double n2, const unsigned int dim)
  {
    if (!(std::abs(e1) > 0 && std::abs(e2) > 0 && n1 > 0 && n2 > 0 && n1 != n2))
      return std::numeric_limits<double>::quiet_NaN();
    return dim * std::log(std::abs(e1 / e2)) / std::log(n2 / n1);
  }

  void
  print_tables(const Study &study, const std::vector<StudySeries> &all_series, std::ostream &out)
  {
    out << '\n' << study.title << '\n' << std::string(study.title.size(), '=') << '\n';
    out << "Errors "
        << (study.against_finest ? "are relative differences to the last run of each table"
                                 : "refer to the closed form")
        << "; orders are those in h, from the DoFs.\n";
    for (const StudySeries &series : all_series)
      {
        out << '\n' << series.label << (series.label.empty() ? "" : "\n");
        if (series.rows.empty())
          out << "  no rows\n";
        else
          print_table(study, series, out);
      }
    out << std::endl;
  }

  bool
  write_study_files(const Study &study, const std::vector<StudySeries> &all_series, std::ostream &out)
  {
    namespace fs           = std::filesystem;
    const fs::path    dir  = study.output_directory;
    const std::string stem = fs::path(study.file).stem().string();
    std::error_code   error;
    fs::create_directories(dir, error);
    std::ofstream csv(dir / (stem + ".csv")), script(dir / (stem + ".gp"));
    write_csv(study, all_series, csv);
    write_gnuplot_script(study, all_series, stem, script);
    csv.close();
    script.close();
    if (!csv || !script)
      {
        out << "Could not write to the directory " << dir << std::endl;
        return false;
      }
    return draw(dir.string(), stem, out);
  }
} // namespace Amontons
