#include <amontons/output/files.h>
#include <amontons/verification/run_table.h>

#include <filesystem>
#include <sstream>

namespace Amontons
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string
    csv_line(const RunTable::Row &fields)
    {
      std::string line;
      for (const std::string &field : fields)
        line += (&field == &fields.front() ? "" : ",") + csv_field(field);
      return line + "\n";
    }

    // Those that end: what was half written is none.
    std::vector<std::string>
    whole_lines(const std::string &file)
    {
      std::ifstream      in(file, std::ios::binary);
      std::ostringstream all;
      all << in.rdbuf();
      const std::string        text = all.str();
      std::vector<std::string> lines;
      for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos;
           begin = end + 1)
        lines.push_back(text.substr(begin, end - begin));
      return lines;
    }

    RunTable::Row
    joined(RunTable::Row a, const RunTable::Row &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }
  } // namespace

  RunTable::Row
  split_csv_line(const std::string &line)
  {
    RunTable::Row fields(1);
    bool          quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i)
      if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[i++];
      else if (line[i] == '"')
        quoted = !quoted;
      else if (line[i] == ',' && !quoted)
        fields.emplace_back();
      else
        fields.back() += line[i];
    return fields;
  }

  RunTable::RunTable(const std::string &file,
                     const std::string &description,
                     const Row         &header,
                     const unsigned int n_key)
      : file(file), description("# " + description), header(header), n_key(n_key)
  {
    std::error_code error;
    fs::create_directories(fs::path(file).parent_path(), error);
    read();
    std::vector<Row> keys;
    for (const auto &[key, results] : rows)
      keys.push_back(key);
    write(keys);
    stream.open(file, std::ios::app | std::ios::binary);
  }

  void
  RunTable::read()
  {
    const auto lines = whole_lines(file);
    if (lines.empty())
      return;
    if (lines[0] != description || lines.size() < 2 || split_csv_line(lines[1]) != header)
      {
        other_study = true;
        std::error_code error;
        fs::rename(file, file + ".old", error);
        return;
      }
    for (std::size_t i = 2; i < lines.size(); ++i)
      if (const Row fields = split_csv_line(lines[i]); fields.size() == header.size())
        rows[Row(fields.begin(), fields.begin() + n_key)] = Row(fields.begin() + n_key, fields.end());
  }

  void
  RunTable::write(const std::vector<Row> &keys)
  {
    std::string text = description + "\n" + csv_line(header);
    for (const Row &key : keys)
      text += csv_line(joined(key, rows.at(key)));
    write_file(file, text);
  }

  const RunTable::Row *
  RunTable::find(const Row &key) const
  {
    const auto found = rows.find(key);
    return found == rows.end() ? nullptr : &found->second;
  }

  void
  RunTable::append(const Row &key, const Row &results)
  {
    rows[key] = results;
    stream << csv_line(joined(key, results)) << std::flush;
    if (!stream)
      throw InputError(
          {file, 0, ""}, "a result cannot be written", "space in a folder that you may write to");
  }

  void
  RunTable::rewrite(const std::vector<Row> &keys)
  {
    stream.close();
    write(keys);
  }
} // namespace Amontons
