#include <amontons/base/version.h>
#include <amontons/scene/text.h>
#include <amontons/verification/process_study.h>
#include <amontons/verification/run_table.h>
#include <amontons/verification/gnuplot.h>
#include <amontons/verification/study_report.h>
#include <amontons/verification/work_precision.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace Amontons
{
  namespace
  {
    namespace fs = std::filesystem;

    // FNV-1a: of the same text the same number on all machines.
    std::string
    fingerprint_of_file(const std::string &file)
    {
      std::ifstream      in(file, std::ios::binary);
      std::ostringstream text, result;
      text << in.rdbuf();
      std::uint64_t hash = 14695981039346656037u;
      for (const char c : text.str())
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
      result << std::hex << hash;
      return result.str();
    }

    // All that the result of a point depends on beside its key.
    std::string
    description(const RunStudy &study)
    {
      std::string text = "amontons " + std::string(version) + " " + commit + "; " + study.scene + " (" +
                         fingerprint_of_file(study.scene) + "); " + join(study.overrides, " | ");
      for (const NamedSeries &series : study.series)
        text += "; " + series.name + ": " + join(series.overrides, " | ");
      for (const SweptParameter &parameter : study.sweep)
        text += "; " + join(parameter.names, " & ");
      return text + "; " + std::to_string(study.time_limit) + " s";
    }

    RunTable::Row
    header(const RunStudy &study)
    {
      RunTable::Row fields = {"series"};
      for (const SweptParameter &parameter : study.sweep)
        fields.push_back(parameter.label);
      for (const std::string &name : record_header(study))
        fields.push_back(name);
      return fields;
    }

    // The record of a point that the table has.
    std::optional<RunRecord>
    known(const RunStudy &study, const RunTable &table, const StudyPoint &point)
    {
      const RunTable::Row *const fields = table.find(key_of(study, point));
      return fields == nullptr ? std::nullopt : from_fields(study, *fields);
    }

    void
    run_missing(const RunStudy                &study,
                const std::vector<StudyPoint> &points,
                const StudyOptions            &options,
                const RunProcess              &run,
                RunTable                      &table,
                std::ostream                  &out)
    {
      const fs::path          folder = fs::path(study.output_directory) / (study.stem() + "_runs");
      std::error_code         error;
      std::vector<StudyPoint> missing;
      std::vector<RunOrder>   orders;
      fs::remove_all(folder, error); // of a study that was killed
      for (const StudyPoint &point : points)
        if (!known(study, table, point))
          {
            missing.push_back(point);
            orders.push_back({study.scene,
                              overrides_of(study, point),
                              (folder / std::to_string(orders.size())).string(),
                              study.time_limit});
          }
      out << study.title << ": " << points.size() << " runs";
      if (missing.size() < points.size())
        out << ", of which " << points.size() - missing.size() << " are known";
      out << '\n' << std::flush;
      StudyProgress progress(points.size() - missing.size(), points.size(), out);
      run_all(orders, options.n_jobs, run, [&](const unsigned int i, const RunEnd &end) {
        table.append(key_of(study, missing[i]), to_fields(make_record(study, end)));
        progress.one_more();
      });
      progress.finish();
      fs::remove_all(folder, error);
    }
  } // namespace

  int
  run_process_study(const StudyEntries &entries,
                    const StudyOptions &options,
                    const RunProcess   &run,
                    std::ostream       &out)
  {
    RunStudy study = read_run_study(entries);
    if (!options.output.empty())
      study.output_directory = options.output;
    const std::string  csv = (fs::path(study.output_directory) / (study.stem() + ".csv")).string();
    RunTable           table(csv, description(study), header(study), study.sweep.size() + 1);
    const StopOnSignal stop;
    if (table.was_other_study())
      out << csv << " was of another study, scene or program: it is " << csv << ".old now\n";
    const auto points = points_of(study);
    run_missing(study, points, options, run, table, out);

    std::vector<RunTable::Row> keys;
    std::vector<StudyResult>   results;
    for (const StudyPoint &point : points)
      if (const auto record = known(study, table, point))
        {
          keys.push_back(key_of(study, point));
          results.push_back({point, *record, errors_of(study, point, *record)});
        }
    if (StopOnSignal::signal() != 0)
      {
        out << "Stopped: " << results.size() << " of " << points.size() << " runs are in " << csv
            << "; the same command goes on." << std::endl;
        return 128 + StopOnSignal::signal();
      }
    table.rewrite(keys);
    const std::string command = "amontons study " + in_shell(study.file) +
                                (options.output.empty() ? "" : " --output " + in_shell(options.output));
    const bool good = (study.kind == StudyKind::stability ? show_stability_map(study, results, out)
                                                          : show_work_precision(study, results, out)) &&
                      write_report(study, results, command, out);
    return good ? 0 : 1;
  }
} // namespace Amontons
