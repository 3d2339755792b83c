#include <amontons/base/text_file.h>
#include <amontons/scene/outline.h>
#include <amontons/scene/text.h>

#include <filesystem>
#include <sstream>

namespace Amontons
{
  namespace
  {
    const std::string byte_order_mark = "\xEF\xBB\xBF";

    struct Line
    {
      std::string text;
      int         number; // of its first part
    };

    // Lines without comments and blanks; those that end in '\' are joined with the next one.
    std::vector<Line>
    logical_lines(std::istream &stream, const std::string &file)
    {
      std::vector<Line> lines;
      std::string       text;
      bool              continued = false;
      for (int number = 1; std::getline(stream, text); ++number)
        {
          if (text.find('\0') != std::string::npos)
            throw InputError({file, number, ""}, "this is no text file", "a .prm or .json file");
          if (number == 1 && text.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
            text.erase(0, byte_order_mark.size());
          text = trim(text.substr(0, text.find('#')));
          if (text.empty() && (!continued || stream.peek() != EOF))
            continue; // also a comment between continued lines
          const bool goes_on = !text.empty() && text.back() == '\\';
          if (goes_on)
            text = trim(text.substr(0, text.size() - 1));
          if (continued)
            lines.back().text += " " + text;
          else
            lines.push_back({text, number});
          continued = goes_on;
        }
      if (continued)
        throw InputError({file, lines.back().number, ""}, "the file ends after a '\\'", "a continued line");
      return lines;
    }

    // One file; `path` holds the open sections.
    class PrmScanner
    {
    public:
      PrmScanner(const std::string &file, Outline &outline) : file(file), outline(outline) {}

      void
      scan(std::istream &stream)
      {
        for (const Line &line : logical_lines(stream, file))
          {
            const auto        blank   = line.text.find_first_of(" \t");
            const std::string keyword = line.text.substr(0, blank);
            const std::string rest    = blank == std::string::npos ? "" : trim(line.text.substr(blank));
            scan_line(line, keyword, rest);
          }
        if (!open.empty())
          throw InputError(open.back().where, "this section has no 'end'", "subsection NAME ... end");
      }

    private:
      const std::string          &file;
      Outline                    &outline;
      std::vector<OutlineSection> open;

      std::string
      section() const
      {
        return open.empty() ? "" : open.back().path;
      }

      void
      scan_line(const Line &line, const std::string &keyword, const std::string &rest)
      {
        const SourceLocation here = {file, line.number, section()};
        if (keyword == "subsection")
          enter(with_single_blanks(rest), here);
        else if (keyword == "end" && rest.empty())
          {
            if (open.empty())
              throw InputError(
                  here, "found 'end' where no section is open", "one 'end' for each 'subsection'");
            open.pop_back();
          }
        else if (keyword == "set")
          set(rest, here);
        else if (keyword == "include")
          {
            if (!open.empty())
              throw InputError(
                  here, "found 'include' within a section", "'include FILE' outside of all sections");
            const std::filesystem::path name = rest;
            read_prm((std::filesystem::path(file).parent_path() / name).string(), outline, here);
          }
        else
          throw InputError(here,
                           "found '" + (line.text.size() > 80 ? line.text.substr(0, 80) + "..." : line.text) +
                               "'" + suggestion(keyword, {"subsection", "end", "set", "include"}),
                           "subsection NAME, set NAME = VALUE, end, include FILE, # comment");
      }

      void
      enter(const std::string &name, const SourceLocation &here)
      {
        if (name.empty() || name.find('/') != std::string::npos)
          throw InputError(here, "found a section named '" + name + "'", "a name without '/'");
        const std::string path = path_of(section(), name);
        open.push_back({path, {file, here.line, path}});
        outline.add(open.back());
      }

      void
      set(const std::string &assignment, const SourceLocation &here)
      {
        const auto        equals = assignment.find('=');
        const std::string name   = with_single_blanks(assignment.substr(0, equals));
        if (equals == std::string::npos || name.empty())
          throw InputError(here, "found 'set " + assignment + "'", "set NAME = VALUE");
        outline.add(OutlineEntry{section(),
                                 name,
                                 trim(assignment.substr(equals + 1)),
                                 {file, here.line, path_of(section(), name)}});
      }
    };
  } // namespace

  void
  read_prm(const std::string &file, Outline &outline, const SourceLocation &included_from)
  {
    const SourceLocation place = included_from.file.empty() ? SourceLocation{file, 0, ""} : included_from;
    std::istringstream   stream(
        read_text_file(file, place, "the file", "a readable .prm or .json file", largest_scene_file));
    thread_local int depth = 0;
    if (depth > 20)
      throw InputError(place, "files include each other without end");
    struct Level
    {
      Level() { ++depth; }
      ~Level() { --depth; }
    } level;
    PrmScanner(file, outline).scan(stream);
  }
} // namespace Amontons
