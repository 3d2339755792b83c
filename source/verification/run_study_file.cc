#include <amontons/scene/text.h>
#include <amontons/verification/run_study.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace Amontons
{
  namespace
  {
    const std::vector<std::string> variables = {"x", "y", "z"};

    // An expression has no meaning in a parameter whose values are no numbers.
    Expression
    expression(const std::string &text, const RunStudy &study, const SourceLocation &where)
    {
      std::vector<std::string> known;
      for (unsigned int i = 0; i < std::min<std::size_t>(study.sweep.size(), variables.size()); ++i)
        {
          const SweptParameter &parameter = study.sweep[i];
          bool                  numbers   = true;
          for (unsigned int v = 0; v < parameter.values.size(); ++v)
            numbers = numbers && std::isfinite(number_of(parameter, v));
          if (numbers)
            known.push_back(variables[i]);
          else if (has_identifier(text, variables[i]))
            throw InputError(where,
                             "found '" + text + "', but the values of '" + parameter.label +
                                 "' are no numbers",
                             "expressions of swept numbers");
        }
      return Expression(text, where, known);
    }

    std::vector<StudyQuantity>
    quantities(const StudyEntries &entries, const RunStudy &study)
    {
      std::vector<StudyQuantity> result;
      for (const SummaryPath &path : entries.paths("Quantities"))
        result.push_back({path, {}, entries.where("", "Quantities")});
      const SourceLocation where = entries.where("", "Expected");
      for (const std::string &text : split(entries.text("Expected"), '|'))
        {
          const auto        equals = text.find('=');
          const std::string path   = trim(text.substr(0, equals));
          if (equals == std::string::npos || path.empty() || trim(text.substr(equals + 1)).empty())
            throw InputError(where, "found '" + text + "'", "PATH IN SUMMARY.JSON = EXPRESSION | ...");
          result.push_back({{path, path}, expression(trim(text.substr(equals + 1)), study, where), where});
        }
      return result;
    }

    std::vector<NamedSeries>
    all_series(const StudyEntries &entries)
    {
      std::vector<NamedSeries> result;
      for (const OutlineSection &section : entries.outline.sections)
        if (section.path.rfind("Series ", 0) == 0)
          result.push_back({trim(section.path.substr(7)), entries.overrides(section.path)});
      if (result.empty())
        result.emplace_back();
      return result;
    }

    std::vector<Threshold>
    thresholds(const StudyEntries &entries, const RunStudy &study)
    {
      const SourceLocation   where = entries.where("", "Threshold");
      std::vector<Threshold> result;
      for (const std::string &text : split(entries.text("Threshold"), '|'))
        {
          const auto colon = text.rfind(':');
          if (colon == std::string::npos || trim(text.substr(colon + 1)).empty())
            throw InputError(where, "found '" + text + "'", "LABEL: expression of x giving y | ...");
          const std::string y = trim(text.substr(colon + 1));
          if (has_identifier(y, "y") || has_identifier(y, "z"))
            throw InputError(where, "found '" + y + "'", "an expression of x giving y");
          expression("x+y", study, where); // both are numbers
          result.push_back({trim(text.substr(0, colon)), expression(y, study, where)});
        }
      return result;
    }

    std::vector<double>
    targets(const StudyEntries &entries)
    {
      std::vector<double> result;
      for (const std::string &text : split(entries.text("Targets"), ','))
        {
          const auto number = as_number(text);
          if (!number || *number <= 0)
            throw InputError(entries.where("", "Targets"),
                             "found '" + text + "'",
                             "errors, positive numbers separated by commas");
          result.push_back(*number);
        }
      std::sort(result.rbegin(), result.rend());
      return result;
    }

    void
    check_sweep(const StudyEntries &entries, const RunStudy &study)
    {
      const bool is_map = study.kind == StudyKind::stability;
      if (study.sweep.empty())
        throw InputError({study.file, 0, "Sweep"},
                         "nothing is swept",
                         is_map ? "entries '1' to '3'" : "entries '1' to '4'");
      if (is_map && study.sweep.size() > 3)
        throw InputError(entries.where("Sweep", "4"),
                         "a map has two axes, and a third parameter for its panels",
                         "entries '1' to '3'");
    }
  } // namespace

  RunStudy
  read_run_study(const StudyEntries &entries)
  {
    RunStudy study;
    study.kind             = entries.kind;
    study.file             = entries.file;
    study.title            = entries.or_stem("Title");
    study.output_directory = entries.or_stem("Output");
    study.scene            = entries.scene();
    study.overrides        = {"Output/VTU = false", "Output/Report = false"};
    for (const std::string &text : entries.overrides(""))
      study.overrides.push_back(text);
    const bool is_map = study.kind == StudyKind::stability;
    study.sweep       = entries.sweep(is_map ? 0 : entries.number_up_to("Vary", StudyEntries::max_swept));
    check_sweep(entries, study);
    study.series     = all_series(entries);
    study.quantities = quantities(entries, study);
    study.time_limit = entries.positive_number("Time limit", study.time_limit);
    study.targets    = targets(entries);
    if (!is_map && study.quantities.empty())
      throw InputError(
          {study.file, 0, "Quantities"}, "no quantity is given", "'Quantities' or 'Expected' with errors");
    if (is_map)
      {
        study.wrong_above = entries.positive_number("Wrong above", study.wrong_above);
        study.thresholds  = thresholds(entries, study);
        if (const std::string text = entries.text("No solution where"); !text.empty())
          study.no_solution_where = expression(text, study, entries.where("", "No solution where"));
      }
    return study;
  }

  std::string
  RunStudy::stem() const
  {
    return std::filesystem::path(file).stem().string();
  }

  std::vector<StudyPoint>
  points_of(const RunStudy &study)
  {
    std::vector<StudyPoint> result;
    for (unsigned int s = 0; s < study.series.size(); ++s)
      {
        StudyPoint point{s, std::vector<unsigned int>(study.sweep.size(), 0)};
        for (bool done = false; !done;)
          {
            result.push_back(point);
            unsigned int i = study.sweep.size();
            while (i > 0 && ++point.values[i - 1] == study.sweep[i - 1].values.size())
              point.values[--i] = 0;
            done = i == 0;
          }
      }
    return result;
  }

  std::vector<std::string>
  key_of(const RunStudy &study, const StudyPoint &point)
  {
    std::vector<std::string> key = {study.series[point.series].name};
    for (unsigned int i = 0; i < study.sweep.size(); ++i)
      key.push_back(study.sweep[i].values[point.values[i]]);
    return key;
  }

  std::vector<std::string>
  overrides_of(const RunStudy &study, const StudyPoint &point)
  {
    std::vector<std::string> result = study.overrides;
    const auto               add    = [&](const std::vector<std::string> &more) {
      result.insert(result.end(), more.begin(), more.end());
    };
    add(study.series[point.series].overrides);
    for (unsigned int i = 0; i < study.sweep.size(); ++i)
      add(study.sweep[i].overrides(point.values[i]));
    return result;
  }

  double
  number_of(const SweptParameter &parameter, const unsigned int i)
  {
    return as_number(parameter.values[i]).value_or(std::numeric_limits<double>::quiet_NaN());
  }

  double
  evaluate(const Expression &expression, const RunStudy &study, const StudyPoint &point)
  {
    dealii::Point<3> p;
    for (unsigned int i = 0; i < std::min<std::size_t>(study.sweep.size(), 3); ++i)
      if (const double number = number_of(study.sweep[i], point.values[i]); std::isfinite(number))
        p[i] = number;
    return expression.value(p, 0);
  }
} // namespace Amontons
