#include <amontons/output/html.h>
#include <amontons/output/svg_chart.h>

namespace Amontons
{
  namespace
  {
    const char *const style =
        "body{font:15px/1.5 system-ui,sans-serif;color:#222;background:#f6f7f8;margin:0}"
        "main{max-width:1180px;margin:auto;padding:24px}h1{font-size:26px;margin:0 0 4px}"
        "h2{font-size:18px;margin:0 0 10px}section{background:#fff;border:1px solid "
        "#e2e5e8;border-radius:8px;"
        "padding:18px 22px;margin:16px "
        "0;overflow-x:auto}.pictures{display:flex;flex-wrap:wrap;align-items:flex-start;gap:18px}"
        "svg{max-width:100%;height:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}"
        "th,td{padding:3px 14px 3px 0;text-align:left;vertical-align:top;border-bottom:1px solid #eef0f2}"
        "th{font-weight:600;color:#555}td.n,th.n{text-align:right}td.n{white-space:nowrap}td.t{min-width:"
        "28em}.status{display:inline-"
        "block;padding:1px "
        "10px;"
        "border-radius:10px;color:#fff;background:#b3402a;font-size:13px}.good{background:#2a8a55}"
        "details{margin-top:10px}summary{cursor:pointer;color:#555}.sub{color:#666}pre{white-space:pre-wrap;"
        "margin:0}code,pre{font:13px/1.45 ui-monospace,monospace}td:first-child{white-space:nowrap}"
        "table+table{margin-top:14px}table.map{margin:0 24px 10px 0}.map td,.map th{padding:3px "
        "7px;border:1px solid #fff;text-align:center;font-size:12px;min-width:22px}.map "
        "th{color:#555;font-weight:400}.map th.y{text-align:right}.swatch{display:inline-block;width:12px;"
        "height:12px;margin:0 6px 0 14px;vertical-align:-1px}.swatch:first-child{margin-left:0}";
  } // namespace

  std::string
  html_table(const HtmlRow &head, const std::vector<HtmlRow> &rows)
  {
    std::string html = "<table><tr>";
    for (std::size_t c = 0; c < head.size(); ++c)
      html += (c == 0 ? "<th>" : "<th class=\"n\">") + escaped(head[c]) + "</th>";
    for (const HtmlRow &row : rows)
      {
        html += "</tr>\n<tr>";
        for (std::size_t c = 0; c < row.size(); ++c)
          {
            const bool is_text = row[c].size() > 40; // not a number: it needs room, and lines
            html += (c == 0    ? "<td>"
                     : is_text ? "<td class=\"t\">"
                               : "<td class=\"n\">") +
                    escaped(row[c]) + "</td>";
          }
      }
    return html + "</tr></table>\n";
  }

  std::string
  html_section(const std::string &title, const std::string &content)
  {
    return content.empty() ? "" : "<section><h2>" + escaped(title) + "</h2>\n" + content + "</section>\n";
  }

  std::string
  html_pictures(const std::vector<std::string> &svgs)
  {
    std::string html;
    for (const std::string &svg : svgs)
      html += svg;
    return html.empty() ? "" : "<div class=\"pictures\">\n" + html + "</div>\n";
  }

  std::string
  html_details(const std::string &summary, const std::string &content)
  {
    return "<details><summary>" + escaped(summary) + "</summary>\n" + content + "</details>\n";
  }

  std::string
  html_page(const std::string &title,
            const std::string &word,
            const bool         good,
            const std::string &sub,
            const std::string &content)
  {
    const std::string heading = escaped(title);
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + heading +
           "</title><meta name=\"viewport\" content=\"width=device-width\"><style>" + style +
           "</style></head>\n<body><main>\n<h1>" + heading + "</h1>\n<p class=\"sub\"><span class=\"status" +
           (good ? " good" : "") + "\">" + escaped(word) + "</span> " + sub + "</p>\n" + content +
           "</main></body></html>\n";
  }
} // namespace Amontons
