/// Pieces of the pages that runs and studies write: one file each, without scripts.
#pragma once

#include <string>
#include <vector>

namespace Amontons
{
  using HtmlRow = std::vector<std::string>;

  /// Texts become cells; all columns but the first are numbers, at the right.
  std::string
  html_table(const HtmlRow &head, const std::vector<HtmlRow> &rows);

  /// Nothing where there is no content. title: a text; content: HTML.
  std::string
  html_section(const std::string &title, const std::string &content);

  /// Side by side, as far as there is room.
  std::string
  html_pictures(const std::vector<std::string> &svgs);

  /// On demand.
  std::string
  html_details(const std::string &summary, const std::string &content);

  /// title, word: texts; word: in a coloured pill; sub: HTML beside it.
  std::string
  html_page(const std::string &title,
            const std::string &word,
            const bool         good,
            const std::string &sub,
            const std::string &content);
} // namespace Amontons
