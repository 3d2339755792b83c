/// The results of a study as a CSV file that outlives it: a line for each run, flushed, so that a killed
/// study goes on from it.
#pragma once

#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace Amontons
{
  /// A line per run: `n_key` fields that tell runs apart, then its results. The first line is a comment that
  /// says what study this is; the second one has the names of the fields.
  class RunTable
  {
  public:
    using Row = std::vector<std::string>;

    /// Reads what is there. A last line that was only half written is dropped. A file of another study, by
    /// `description` or header, is renamed to FILE.old. Throws InputError where the file cannot be written.
    RunTable(const std::string &file,
             const std::string &description,
             const Row         &header,
             const unsigned int n_key);

    /// Results, without the key; nullptr if there are none.
    const Row *
    find(const Row &key) const;

    void
    append(const Row &key, const Row &results);

    /// At the end: these rows, in this order.
    void
    rewrite(const std::vector<Row> &keys);

    bool
    was_other_study() const
    {
      return other_study;
    }

  private:
    void
    read();
    void
    write(const std::vector<Row> &keys);

    const std::string  file, description;
    const Row          header;
    const unsigned int n_key;
    bool               other_study = false;
    std::map<Row, Row> rows;
    std::ofstream      stream;
  };

  /// A line of a CSV file without its end, as fields; quotes may stand around them.
  RunTable::Row
  split_csv_line(const std::string &line);
} // namespace Amontons
