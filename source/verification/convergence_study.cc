#include <amontons/verification/convergence_study.h>
#include <amontons/verification/gnuplot.h>
#include <amontons/verification/study_report.h>
#include <amontons/verification/summary_path.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    StudyRow
    row(const Study &study, const Tree &summary, const std::string &varied)
    {
      StudyRow result;
      result.varied = varied;
      for (const SummaryPath &path : study.columns)
        result.columns.push_back(number_at(summary, path, study.columns_where));
      for (const SummaryPath &path : study.quantities)
        result.errors.push_back(number_at(summary, path, study.quantities_where));
      return result;
    }

    // One row, or one for each mesh of the last increment.
    void
    add_rows(const Study &study, const Tree &summary, const std::string &varied, StudySeries &series)
    {
      series.dim = summary.get<unsigned int>("dimension", 2);
      if (!study.per_mesh)
        {
          series.rows.push_back(row(study, summary, varied));
          return;
        }
      const auto meshes = summary.get_child_optional("meshes");
      if (!meshes)
        throw InputError({study.file, 0, "Per mesh"}, "found true, but the summary has no 'meshes'", "false");
      const auto increment = [](const Tree &mesh) { return mesh.get<int>("increment", 0); };
      for (const auto &mesh : *meshes)
        if (increment(mesh.second) == increment(meshes->back().second))
          series.rows.push_back(row(study, mesh.second, std::to_string(series.rows.size())));
    }

    // Quantities become |q - q_last| / |q_last|; the last row, whose difference is zero, is left out.
    void
    refer_to_last(StudySeries &series)
    {
      if (series.rows.empty())
        return;
      const std::vector<double> last = series.rows.back().errors;
      series.rows.pop_back();
      for (StudyRow &r : series.rows)
        for (unsigned int q = 0; q < last.size(); ++q)
          r.errors[q] = std::abs(r.errors[q] - last[q]) / (last[q] != 0 ? std::abs(last[q]) : 1.);
    }

    // All combinations of the first n swept parameters, as indices of their values; the last of them runs
    // fastest.
    std::vector<std::vector<unsigned int>>
    combinations(const Study &study, const unsigned int n)
    {
      std::vector<std::vector<unsigned int>> result(1);
      for (unsigned int i = 0; i < n; ++i)
        {
          std::vector<std::vector<unsigned int>> longer;
          for (const auto &combination : result)
            for (unsigned int v = 0; v < study.sweep[i].values.size(); ++v)
              {
                longer.push_back(combination);
                longer.back().push_back(v);
              }
          result = longer;
        }
      return result;
    }

    void
    add_overrides(const SweptParameter     &parameter,
                  const unsigned int        value,
                  std::vector<std::string> &overrides)
    {
      const auto more = parameter.overrides(value);
      overrides.insert(overrides.end(), more.begin(), more.end());
    }

    std::string
    label_of(const Study &study, const std::vector<unsigned int> &combination)
    {
      std::string label;
      for (unsigned int i = 0; i < combination.size(); ++i)
        if (study.sweep[i].values.size() > 1)
          label += (label.empty() ? "" : ", ") + study.sweep[i].label + " = " +
                   study.sweep[i].values[combination[i]];
      return label;
    }

    // Runs once; false if the run failed.
    bool
    run(const Study                    &study,
        const Runner                   &runner,
        const std::vector<std::string> &overrides,
        const std::string              &varied,
        StudySeries                    &series,
        dealii::ConditionalOStream     &out)
    {
      Tree summary;
      try
        {
          summary = runner(study.scene, overrides);
        }
      catch (const InputError &)
        {
          throw;
        }
      catch (const std::runtime_error &error)
        {
          out << "A run of the study failed (" << series.label << (series.label.empty() ? "" : ", ") << varied
              << "): " << error.what() << std::endl;
          series.failures.push_back({varied, error.what(), overrides});
          return false;
        }
      add_rows(study, summary, varied, series);
      return true;
    }
  } // namespace

  int
  run_convergence_study(const std::string &study_file,
                        const Runner      &runner,
                        std::ostream      &out,
                        MPI_Comm           communicator)
  {
    const Study                study = read_study(study_file);
    const bool                 root  = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    dealii::ConditionalOStream log(out, root);

    bool                     good     = true;
    const unsigned int       n_series = study.sweep.size() - (study.per_mesh ? 0 : 1);
    std::vector<StudySeries> all_series;
    for (const auto &combination : combinations(study, n_series))
      {
        StudySeries series;
        series.label                       = label_of(study, combination);
        std::vector<std::string> overrides = study.overrides;
        for (unsigned int i = 0; i < n_series; ++i)
          add_overrides(study.sweep[i], combination[i], overrides);
        if (study.per_mesh)
          good = run(study, runner, overrides, "all meshes", series, log) && good;
        else
          for (unsigned int v = 0; v < study.sweep.back().values.size(); ++v)
            {
              std::vector<std::string> of_run = overrides;
              add_overrides(study.sweep.back(), v, of_run);
              good = run(study, runner, of_run, study.sweep.back().values[v], series, log) && good;
            }
        if (study.against_finest)
          refer_to_last(series);
        all_series.push_back(series);
      }
    if (root)
      {
        print_tables(study, all_series, out);
        good = write_study_files(study, all_series, out) &&
               write_report(study, all_series, "amontons study " + in_shell(study_file), out) && good;
      }
    return dealii::Utilities::MPI::min(good ? 1 : 0, communicator) == 1 ? 0 : 1;
  }
} // namespace Amontons
