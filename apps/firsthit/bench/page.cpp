// page.cpp - a page of results that needs nothing beside itself: no script, font, style or picture.
#include "bench/page.h"

#include "bench/markup.h"

#include <fmt/format.h>

namespace firsthit::cli::bench {

namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1c1f24; --paper: #ffffff; --soft: #5c6470; --line: #d5d9df;
  --band: #f4f6f8; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7eb; --paper: #14171b; --soft: #9aa3af; --line: #343a43; --band: #1d2127; } }
body { margin: 0 auto; max-width: 72rem; padding: 1.5rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; margin: 0 0 .5rem; }
h2 { font-size: 1.35rem; margin: 2.5rem 0 .5rem; border-bottom: 1px solid var(--line); }
h3 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
p { max-width: 46rem; margin: .5rem 0; }
figure { margin: 1.2rem 0; }
figcaption { font-weight: 600; margin-bottom: .4rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: right;
  vertical-align: top; }
thead th { background: var(--band); vertical-align: bottom; }
tbody th { font-weight: 500; }
th:first-child { text-align: left; }
small { display: block; color: var(--soft); font-size: .78rem; font-weight: 400; }
.note, .plot figcaption, .pictures figcaption { color: var(--soft); font-size: .9rem; font-weight: 400;
  max-width: 46rem; }
.plot svg { max-width: 100%; height: auto; color: var(--ink); }
.row { display: flex; flex-wrap: wrap; gap: 1rem; }
.row > div { flex: 1 1 18rem; max-width: 32rem; }
.row img { width: 100%; height: auto; display: block; image-rendering: auto; }
.row p { font-size: .85rem; color: var(--soft); }
@media print {
  :root { --ink: #000; --paper: #fff; --soft: #444; --line: #bbb; --band: #f4f4f4; font-size: 11px; }
  body { font-size: 11px; padding: 0; } p, .note { max-width: none; } .scroll { overflow: visible; }
  .row > div { flex-basis: 30%; } figure { break-inside: avoid; } h2, h3 { break-after: avoid; } }
)";

std::string element(std::string_view name, std::string_view text)
{
    return fmt::format("<{0}>{1}</{0}>\n", name, escaped(text));
}

} // namespace

void Page::heading(std::string_view text)
{
    body_ += element("h2", text);
}

void Page::subheading(std::string_view text)
{
    body_ += element("h3", text);
}

void Page::paragraph(std::string_view text)
{
    body_ += element("p", text);
}

void Page::add(const Table& table)
{
    body_ += table_html(table);
}

void Page::add_plot(std::string_view svg, std::string_view caption)
{
    body_ += fmt::format(
        "<figure class=\"plot\">\n{}{}</figure>\n", svg, element("figcaption", caption));
}

void Page::add_pictures(const std::vector<Shown>& pictures, std::string_view caption)
{
    body_ += "<figure class=\"pictures\">\n<div class=\"row\">\n";
    for (const Shown& shown : pictures)
        body_ += fmt::format("<div><img alt=\"{0}\" width=\"{1}\" height=\"{2}\" "
                             "src=\"data:image/png;base64,{3}\"/><p>{0}</p></div>\n",
            escaped(shown.caption), shown.picture.width, shown.picture.height,
            base64(png(shown.picture)));
    body_ += "</div>\n" + element("figcaption", caption) + "</figure>\n";
}

std::string Page::html() const
{
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
                       "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}"
                       "</body>\n</html>\n",
        escaped(title_), kStyle, body_);
}

} // namespace firsthit::cli::bench
