#include <amontons/scene/text.h>
#include <amontons/verification/run_record.h>
#include <amontons/verification/summary_path.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace Amontons
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    const double unknown_number = std::numeric_limits<double>::quiet_NaN();

    std::string
    to_text(const double number)
    {
      std::ostringstream text;
      text.precision(10);
      text << number;
      return text.str();
    }

    void
    add_summary(const RunStudy &study, const Tree &summary, RunRecord &record)
    {
      record.ending        = summary.get<std::string>("status", "");
      record.failure       = summary.get<std::string>("failure", "");
      record.message       = summary.get<std::string>("message", "");
      record.cut_backs     = summary.get<unsigned int>("cut_backs", 0);
      record.linear_solves = summary.get<unsigned int>("linear_solves", 0);
      record.cells         = summary.get<unsigned long long>("cells", 0);
      record.dofs          = summary.get<unsigned long long>("dofs", 0);
      if (const auto solves = summary.get_child_optional("newton"))
        for (const auto &[key, solve] : *solves)
          record.iterations += solve.get<unsigned int>("iterations", 0);
      if (const auto meshes = summary.get_child_optional("meshes"))
        for (const auto &[key, mesh] : *meshes)
          record.increments = std::max(record.increments, mesh.get<unsigned int>("increment", 0));
      if (record.ending == "converged")
        for (unsigned int q = 0; q < study.quantities.size(); ++q)
          record.values[q] = number_at(summary, study.quantities[q].path, study.quantities[q].where);
    }

    // Exit code 1 is a message to the user; others, and signals, are bugs.
    void
    add_ending_without_summary(const RunEnd &end, RunRecord &record)
    {
      record.message = end.last_words;
      if (end.kind == RunEnd::Kind::time_limit)
        {
          record.ending  = "time limit";
          record.message = "killed after its time limit";
        }
      else if (end.kind == RunEnd::Kind::ended && end.code == 1)
        record.ending = "refused";
      else
        {
          record.ending  = "crash";
          record.message = (end.kind == RunEnd::Kind::signal ? "signal " + std::string(strsignal(end.code))
                                                             : "exit code " + std::to_string(end.code)) +
                           (end.last_words.empty() ? "" : ": " + end.last_words);
        }
    }
  } // namespace

  RunRecord
  make_record(const RunStudy &study, const RunEnd &end)
  {
    RunRecord record;
    record.values.assign(study.quantities.size(), unknown_number);
    record.wall_seconds      = end.wall_seconds;
    record.processor_seconds = end.processor_seconds;
    record.megabytes         = end.megabytes;
    if (end.summary && end.kind == RunEnd::Kind::ended && end.code <= 1)
      add_summary(study, *end.summary, record);
    else
      add_ending_without_summary(end, record);
    std::replace(record.message.begin(), record.message.end(), '\n', ' ');
    return record;
  }

  std::vector<std::string>
  record_header(const RunStudy &study)
  {
    std::vector<std::string> header = {"ending",
                                       "failure",
                                       "increments",
                                       "cut backs",
                                       "iterations",
                                       "linear solves",
                                       "cells",
                                       "dofs",
                                       "wall seconds",
                                       "processor seconds",
                                       "megabytes"};
    for (const StudyQuantity &quantity : study.quantities)
      header.push_back(quantity.path.path);
    header.emplace_back("message");
    return header;
  }

  std::vector<std::string>
  to_fields(const RunRecord &record)
  {
    std::vector<std::string> fields = {record.ending,
                                       record.failure,
                                       std::to_string(record.increments),
                                       std::to_string(record.cut_backs),
                                       std::to_string(record.iterations),
                                       std::to_string(record.linear_solves),
                                       std::to_string(record.cells),
                                       std::to_string(record.dofs),
                                       to_text(record.wall_seconds),
                                       to_text(record.processor_seconds),
                                       to_text(record.megabytes)};
    for (const double value : record.values)
      fields.push_back(to_text(value));
    fields.push_back(record.message);
    return fields;
  }

  std::optional<RunRecord>
  from_fields(const RunStudy &study, const std::vector<std::string> &fields)
  {
    const unsigned int n = study.quantities.size(), first = 2, first_value = 11;
    if (fields.size() != first_value + n + 1)
      return {};
    std::vector<double> numbers;
    for (unsigned int i = first; i < first_value + n; ++i)
      {
        const auto number = as_number(fields[i]);
        if (!number && (i < first_value || fields[i].find("nan") == std::string::npos))
          return {};
        numbers.push_back(number.value_or(unknown_number));
      }
    RunRecord record;
    record.ending            = fields[0];
    record.failure           = fields[1];
    record.message           = fields.back();
    record.increments        = numbers[0];
    record.cut_backs         = numbers[1];
    record.iterations        = numbers[2];
    record.linear_solves     = numbers[3];
    record.cells             = numbers[4];
    record.dofs              = numbers[5];
    record.wall_seconds      = numbers[6];
    record.processor_seconds = numbers[7];
    record.megabytes         = numbers[8];
    record.values.assign(numbers.begin() + (first_value - first), numbers.end());
    return record;
  }

  std::vector<double>
  errors_of(const RunStudy &study, const StudyPoint &point, const RunRecord &record)
  {
    std::vector<double> errors;
    for (unsigned int q = 0; q < study.quantities.size(); ++q)
      {
        const auto  &expected = study.quantities[q].expected;
        const double exact    = expected ? evaluate(*expected, study, point) : 0;
        const double error    = std::abs(record.values[q] - exact);
        errors.push_back(exact != 0 ? error / std::abs(exact) : error);
      }
    return errors;
  }
} // namespace Amontons
