#include <amontons/scene/text.h>
#include <amontons/verification/gnuplot.h>
#include <amontons/verification/work_precision.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

namespace Amontons
{
  const std::array<CostKind, 4> cost_kinds = {
      {{"processor seconds", [](const RunRecord &record) { return record.processor_seconds; }},
       {"degrees of freedom", [](const RunRecord &record) { return static_cast<double>(record.dofs); }},
       {"megabytes", [](const RunRecord &record) { return record.megabytes; }},
       {"linear solves", [](const RunRecord &record) { return static_cast<double>(record.linear_solves); }}}};

  namespace
  {
    // Words in columns; the first one is left-justified.
    using TextTable = std::vector<std::vector<std::string>>;

    void
    print_text_table(const TextTable &table, std::ostream &out)
    {
      std::vector<std::size_t> widths;
      for (const auto &row : table)
        for (std::size_t c = 0; c < row.size(); ++c)
          {
            widths.resize(std::max(widths.size(), c + 1));
            widths[c] = std::max(widths[c], row[c].size());
          }
      for (const auto &row : table)
        {
          for (std::size_t c = 0; c < row.size(); ++c)
            out << (c == 0 ? std::left : std::right) << (c == 0 ? "" : "  ")
                << std::setw(static_cast<int>(widths[c])) << row[c];
          out << std::right << '\n';
        }
    }

    std::string
    short_text(const double number, const int digits)
    {
      std::ostringstream text;
      text << std::setprecision(digits) << number;
      return text.str();
    }

    std::string
    error_text(const double error)
    {
      std::ostringstream text;
      text << std::setprecision(2) << std::scientific << error;
      return text.str();
    }

    std::vector<const StudyResult *>
    on_the_front(const std::vector<StudyResult> &results, const unsigned int quantity)
    {
      std::vector<CostAndError>        runs;
      std::vector<const StudyResult *> all, front;
      for (const StudyResult &result : results)
        if (has_answer(result))
          {
            all.push_back(&result);
            runs.push_back({cost_kinds[0].of(result.record), result.errors[quantity]});
          }
      for (const unsigned int i : pareto_front(runs))
        front.push_back(all[i]);
      return front;
    }

    void
    print_curves(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
    {
      std::vector<std::set<const StudyResult *>> fronts;
      for (unsigned int q = 0; q < study.quantities.size(); ++q)
        {
          const auto front = on_the_front(results, q);
          fronts.emplace_back(front.begin(), front.end());
        }
      for (const WorkCurve &curve : work_curves(study, results))
        {
          TextTable table = {{study.sweep.back().label, "dofs", "solves", "MB", "seconds"}};
          for (const StudyQuantity &quantity : study.quantities)
            table[0].push_back(quantity.path.label + "  ");
          for (const StudyResult *const run : curve.runs)
            {
              const RunRecord &record = run->record;
              table.push_back({study.sweep.back().values[run->point.values.back()],
                               std::to_string(record.dofs),
                               std::to_string(record.linear_solves),
                               short_text(record.megabytes, 3),
                               short_text(record.processor_seconds, 3)});
              for (unsigned int q = 0; q < study.quantities.size() && has_answer(*run); ++q)
                table.back().push_back(error_text(run->errors[q]) + (fronts[q].count(run) > 0 ? " *" : "  "));
              if (!has_answer(*run))
                table.back().push_back(record.ending);
            }
          out << '\n' << curve.label << (curve.label.empty() ? "" : "\n");
          print_text_table(table, out);
        }
    }

    void
    print_targets(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
    {
      for (unsigned int q = 0; q < study.quantities.size() && !study.targets.empty(); ++q)
        {
          out << "\nThe cheapest run that reaches these errors of " << study.quantities[q].path.label
              << ":\n";
          TextTable table = {{""}};
          for (const double target : study.targets)
            table[0].push_back(short_text(target, 3));
          for (const WorkCurve &curve : work_curves(study, results))
            {
              table.push_back({curve.label.empty() ? study.title : curve.label});
              for (const double target : study.targets)
                {
                  const StudyResult *const run = cheapest(curve, q, target);
                  table.back().push_back(run == nullptr
                                             ? "not reached"
                                             : short_text(run->record.processor_seconds, 2) + " s, " +
                                                   std::to_string(run->record.dofs) + " dofs (" +
                                                   study.sweep.back().values[run->point.values.back()] + ")");
                }
            }
          print_text_table(table, out);
        }
    }
  } // namespace

  bool
  has_answer(const StudyResult &result)
  {
    return result.record.ending == "converged";
  }

  std::vector<WorkCurve>
  work_curves(const RunStudy &study, const std::vector<StudyResult> &results)
  {
    std::vector<WorkCurve>                                            curves;
    std::map<std::pair<unsigned, std::vector<unsigned>>, std::size_t> places;
    for (const StudyResult &result : results)
      {
        auto others = result.point.values;
        others.pop_back();
        const auto [place, is_new] = places.insert({{result.point.series, others}, curves.size()});
        if (is_new)
          {
            curves.push_back({study.series[result.point.series].name, {}});
            for (unsigned int i = 0; i < others.size(); ++i)
              if (study.sweep[i].values.size() > 1)
                curves.back().label += (curves.back().label.empty() ? "" : ", ") + study.sweep[i].label +
                                       " = " + study.sweep[i].values[others[i]];
          }
        curves[place->second].runs.push_back(&result);
      }
    return curves;
  }

  std::vector<unsigned int>
  pareto_front(const std::vector<CostAndError> &runs)
  {
    std::vector<unsigned int> order(runs.size()), front;
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const unsigned int a, const unsigned int b) {
      return runs[a].cost != runs[b].cost ? runs[a].cost < runs[b].cost : runs[a].error < runs[b].error;
    });
    for (const unsigned int i : order)
      if (runs[i].error > 0 && std::isfinite(runs[i].error) &&
          (front.empty() || runs[i].error < runs[front.back()].error))
        front.push_back(i);
    return front;
  }

  const StudyResult *
  cheapest(const WorkCurve &curve, const unsigned int quantity, const double target)
  {
    const StudyResult *best = nullptr;
    for (const StudyResult *const run : curve.runs)
      if (has_answer(*run) && run->errors[quantity] <= target &&
          (best == nullptr || run->record.processor_seconds < best->record.processor_seconds))
        best = run;
    return best;
  }

  void
  print_work_precision(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
  {
    out << '\n' << study.title << '\n' << std::string(study.title.size(), '=') << '\n';
    out << "*: no other run of the study has a smaller error in less processor time.\n";
    print_curves(study, results, out);
    print_targets(study, results, out);
    for (const StudyResult &result : results)
      if (!has_answer(result))
        out << "Without an answer: " << join(key_of(study, result.point), ", ") << ": "
            << result.record.message << '\n';
    out << std::endl;
  }

  bool
  show_work_precision(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
  {
    print_work_precision(study, results, out);
    std::ostringstream script;
    write_work_script(study, results, script);
    return draw(study.output_directory, study.stem(), script.str(), out);
  }
} // namespace Amontons
