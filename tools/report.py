#!/usr/bin/env python3
"""report.py - draws the page of `firsthit bench`: bench.json in, one HTML file out.

    tools/report.py DIR/bench.json [-o FILE]     FILE: default DIR/index.html; - is standard output

`firsthit bench -o DIR` runs it by itself. It needs Python 3.8 or newer and no packages. The page needs nothing
beside itself: plots are SVG elements, pictures are embedded, there is no script, font or address in it.

Input. bench.json has what was measured, for programs to read ("machine", "quick", "paper", "baseline"), and as
"page" what is to be shown. Nothing but "page" is read here:

    "page": {"title": text, "parts": [part, ...]}     the parts from top to bottom, each of one member:

    {"heading": text}, {"subheading": text}, {"paragraph": text}
    {"table": {"title": text, "head": [text, ...], "rows": [[cell, ...], ...], "note": text}}
        cell       text, or [text, note]: the note is set smaller below the text. The first column has names.
    {"curves": {"title": text, "x": axis, "y": axis, "series": [series, ...], "caption": text}}
        axis       {"label": text with the unit, "log": false, "from_zero": true}. log: powers of ten are equally
                   far apart, and only values above 0 are shown. from_zero: an axis that is not log begins at 0.
        series     {"name": text, "x": [number, ...], "y": [number, ...], "lower": [...], "upper": [...],
                   "dashed": false}. In order of x. lower, upper: the quartiles of y, drawn as a bar.
                   dashed: for what others measured.
    {"bars": {"title": text, "label": text with the unit, "parts": [text, ...],
              "bars": [{"name": text, "values": [number, ...]}, ...], "caption": text}}
        Stacked bars, a value for each part, from top to bottom.
    {"pictures": {"caption": text, "pictures": [{"file": name, "width": px, "height": px, "caption": text}, ...]}}
        Side by side. file: a PNG beside bench.json; where it is missing, the page says so.

A number that is null, not finite, or not above 0 on a log axis is not shown: it interrupts its curve, and in a
bar counts as 0. "note", "lower", "upper" and whatever has a value above may be left out. Texts are shown as they
are, whatever is in them.

Exit codes: 0 done, 1 failed (the reason is printed), 2 wrong usage. FILE appears whole or not at all.
"""
import argparse
import base64
import json
import math
import os
import re
import sys
from html import escape

STYLE = """
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
"""

# Told apart on white and on black; taken in turn.
COLORS = ("#2f7ed8", "#d9541e", "#2e9e4f", "#b0419f", "#c79a00", "#13a3b5", "#d6336c", "#7d7f88")

# Everything that XML 1.0 has no place for, lone surrogates included.
NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def text_of(value):
    """Text for elements and attributes: & < > " ' as entities, what XML forbids as U+FFFD."""
    if not isinstance(value, str):
        raise ValueError(f"a text is expected, not {value!r:.60}")
    return escape(NO_XML.sub("\ufffd", value))


def tag(name, content=None, **attributes):
    """An element around `content`, which is markup. Floats are rounded to a tenth; _ in names stands for -."""
    words = [name]
    for key, value in attributes.items():
        value = f"{value:.1f}" if isinstance(value, float) else text_of(str(value))
        words.append(f'{key.strip("_").replace("_", "-")}="{value}"')
    opening = " ".join(words)
    return f"<{opening}/>\n" if content is None else f"<{opening}>{content}</{name}>\n"


def number(value):
    """A float; NaN for null and whatever cannot be drawn. The bounds keep the arithmetic of axes finite."""
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return float(value) if is_number and -1e300 < value < 1e300 else math.nan


def tick_text(value):
    """Short: "0.5", "20", "50k", "10M"."""
    size = abs(value)
    if size >= 1e9 or 0 < size < 1e-4:
        return f"{value:.3g}"
    if size >= 1e6:
        return f"{value / 1e6:.6g}M"
    return f"{value / 1e3:.6g}k" if size >= 1e4 else f"{value:.6g}"


class Scale:
    """An axis that holds all values. `ticks` are the values to write beside it, rising: steps of 1, 2 or 5 times
    a power of ten; of a log axis powers of ten, with 2 and 5 times these where there are few."""

    def __init__(self, axis, values):
        self.log = bool(axis.get("log", False))
        shown = [value for value in values if self.holds(value)]
        if self.log:
            self.low = round_log(min(shown), up=False) if shown else 1.0
            self.high = round_log(max(shown), up=True) if shown else 10.0
            if self.high <= self.low:
                self.high = 10 * self.low
            self.ticks = log_ticks(self.low, self.high)
            return
        from_zero = bool(axis.get("from_zero", True))
        self.low, self.high = (min(shown), max(shown)) if shown else (0.0, 1.0)
        if from_zero:
            self.low, self.high = min(self.low, 0.0), max(self.high, 0.0)
        # Values that rounding hardly tells apart count as equal: steps between them would not be exact.
        if self.high - self.low <= max(1e-290, 1e-12 * max(abs(self.low), abs(self.high))):
            self.high = self.low + max(1.0, abs(self.low))
        step = nice_step((self.high - self.low) / 6)
        # Heights end at a tick, so that none sticks out; what does not begin at 0 keeps its range.
        if from_zero:
            self.low = math.floor(self.low / step + 1e-6) * step
            self.high = math.ceil(self.high / step - 1e-6) * step
        first, last = math.ceil(self.low / step - 1e-6), math.floor(self.high / step + 1e-6)
        self.ticks = [k * step for k in range(first, last + 1)]

    def holds(self, value):
        return math.isfinite(value) and (not self.log or value > 1e-290)

    def place(self, value):
        """0 at the axis' begin, 1 at its end."""
        if self.log:
            return (math.log(value) - math.log(self.low)) / (math.log(self.high) - math.log(self.low))
        return (value - self.low) / (self.high - self.low)


def nice_step(rough):
    """The next 1, 2, 5 or 10 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(rough))
    return next((factor * power for factor in (1, 2, 5) if rough <= factor * power * 1.0001), 10 * power)


def round_log(value, up):
    """The next 1, 2 or 5 times a power of ten, at or below (up: above) the value."""
    steps = [factor * 10.0 ** math.floor(math.log10(value)) for factor in (0.5, 1, 2, 5, 10, 20)]
    if up:
        return next(step for step in steps if value <= step * 1.0001)
    return max(step for step in steps if step <= value * 1.0001)


def log_ticks(low, high):
    factors = (1, 2, 5) if high / low < 1000 else (1,)
    decades = range(math.floor(math.log10(low) + 1e-9), math.floor(math.log10(high) + 1e-9) + 1)
    ticks = [factor * 10.0**decade for decade in decades for factor in factors]
    ticks = [tick for tick in ticks if low * 0.9999 <= tick <= high * 1.0001]
    return ticks[:: math.ceil(len(ticks) / 12)]


# Plots, in pixels. The legend stands at the right, where names of 30 letters have room.
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 900, 400, 75.0, 650.0, 40.0, 345.0
LEGEND, LINE = 670.0, 20
MOST_DOTS = 40  # a curve of more points has none
FAINT, STRONG = "0.18", "0.7"  # opacities


def words(x, y, text, anchor, **more):
    return tag("text", text_of(text), x=float(x), y=float(y), text_anchor=anchor, **more)


def line(begin, end, opacity, color="currentColor"):
    return tag("line", x1=begin[0], y1=begin[1], x2=end[0], y2=end[1], stroke=color, stroke_opacity=opacity)


def curve(places, color, dashed):
    if len(places) < 2:
        return ""
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    more = {"stroke_dasharray": "6 4"} if dashed else {}
    return tag("polyline", points=points, fill="none", stroke=color, stroke_width=2, stroke_linejoin="round", **more)


def box(x, y, width, height, color, title):
    return tag("rect", tag("title", text_of(title)), x=x, y=y, width=width, height=height, fill=color)


def svg(height, title, shapes):
    """With its title to be seen, and for readers who cannot see it."""
    shown = words(LEFT, 22, title, "start", font_size=15, font_weight=600)
    return tag("svg", "\n" + tag("title", text_of(title)) + shown + "".join(shapes),
        xmlns="http://www.w3.org/2000/svg", viewBox=f"0 0 {WIDTH} {height:g}", width=WIDTH, height=f"{height:g}",
        role="img", font_family="sans-serif", font_size=12, fill="currentColor")


def points_of(series):
    """(x, y, lower, upper) of each point."""
    columns = [[number(value) for value in series.get(name, [])] for name in ("x", "y", "lower", "upper")]
    count = min(len(columns[0]), len(columns[1]))
    return list(zip(*((column + count * [math.nan])[:count] for column in columns)))


def curves_svg(plot):
    points = [points_of(series) for series in plot["series"]]
    x = Scale(plot["x"], [point[0] for run in points for point in run])
    y = Scale(plot["y"], [value for run in points for point in run for value in point[1:]])

    def place(px, py):
        return LEFT + x.place(px) * (RIGHT - LEFT), BOTTOM - y.place(py) * (BOTTOM - TOP)

    shapes = []
    for tick in x.ticks:
        at = place(tick, y.low)[0]
        shapes += [line((at, TOP), (at, BOTTOM), FAINT), words(at, BOTTOM + 18, tick_text(tick), "middle")]
    for tick in y.ticks:
        at = place(x.low, tick)[1]
        shapes += [line((LEFT, at), (RIGHT, at), FAINT), words(LEFT - 8, at + 4, tick_text(tick), "end")]
    shapes += [line((LEFT, BOTTOM), (RIGHT, BOTTOM), STRONG), line((LEFT, TOP), (LEFT, BOTTOM), STRONG)]
    shapes.append(words((LEFT + RIGHT) / 2, BOTTOM + 42, plot["x"]["label"], "middle"))
    upright = f"translate(20.0 {(TOP + BOTTOM) / 2:.1f}) rotate(-90)"
    shapes.append(tag("text", text_of(plot["y"]["label"]), transform=upright, text_anchor="middle"))

    for k, series in enumerate(plot["series"]):
        color, dashed = COLORS[k % len(COLORS)], bool(series.get("dashed", False))
        run = []
        for px, py, lower, upper in points[k]:
            if not x.holds(px) or not y.holds(py):
                shapes.append(curve(run, color, dashed))
                run = []
                continue
            run.append(place(px, py))
            if len(points[k]) <= MOST_DOTS and not dashed:
                shapes.append(tag("circle", cx=run[-1][0], cy=run[-1][1], r=3, fill=color))
            if y.holds(lower) and y.holds(upper):
                shapes.append(line(place(px, lower), place(px, upper), STRONG, color))
        shapes.append(curve(run, color, dashed))
        at = TOP + 10 + LINE * k
        shapes.append(curve([(LEGEND, at), (LEGEND + 24, at)], color, dashed))
        shapes.append(words(LEGEND + 32, at + 4, series["name"], "start"))
    return svg(max(HEIGHT, TOP + 20 + LINE * len(points)), plot["title"], shapes)


def bars_svg(plot):
    thick, gap, left, parts = 24.0, 14, 190.0, plot["parts"]
    bars = []  # (bars, parts); what cannot be drawn is 0
    for entry in plot["bars"]:
        values = [number(value) for value in entry["values"][: len(parts)]]
        bars.append([value if value > 0 else 0.0 for value in values])
    scale = Scale({}, [sum(values) for values in bars])
    bottom = TOP + gap + (thick + gap) * len(bars)

    def column(value):
        return left + scale.place(value) * (RIGHT - left)

    shapes = []
    for tick in scale.ticks:
        at = column(tick)
        shapes += [line((at, TOP), (at, bottom), FAINT), words(at, bottom + 18, tick_text(tick), "middle")]
    for k, values in enumerate(bars):
        name, top = plot["bars"][k]["name"], TOP + gap + (thick + gap) * k
        shapes.append(words(left - 8, top + thick / 2 + 4, name, "end"))
        for part, value in enumerate(values):
            begin, end = column(sum(values[:part])), column(sum(values[: part + 1]))
            title = f"{name}, {parts[part]}: {tick_text(float(f'{value:.3g}'))}"
            if value > 0:
                shapes.append(box(begin, top, end - begin, thick, COLORS[part % len(COLORS)], title))
    shapes.append(line((left, TOP), (left, bottom), STRONG))
    shapes.append(words((left + RIGHT) / 2, bottom + 42, plot["label"], "middle"))
    for part, name in enumerate(parts):
        at = TOP + 10 + LINE * part
        shapes.append(box(LEGEND, at - 6, 24.0, 12.0, COLORS[part % len(COLORS)], name))
        shapes.append(words(LEGEND + 32, at + 4, name, "start"))
    return svg(max(bottom + 55, TOP + 20 + LINE * len(parts)), plot["title"], shapes)


def cell_html(cell, first):
    text, note = (cell, "") if isinstance(cell, str) else cell
    inside = text_of(text) + (f"<small>{text_of(note)}</small>" if note else "")
    return f'<th scope="row">{inside}</th>' if first else f"<td>{inside}</td>"


def table_html(table):
    head = "".join(f'<th scope="col">{text_of(name)}</th>' for name in table["head"])
    rows = ["".join(cell_html(cell, k == 0) for k, cell in enumerate(row)) for row in table["rows"]]
    body = "".join(f"<tr>{row}</tr>\n" for row in rows)
    note = table.get("note", "")
    return tag("figure",
        "\n" + tag("figcaption", text_of(table["title"])) + '<div class="scroll"><table>\n'
        f"<thead><tr>{head}</tr></thead>\n<tbody>\n{body}</tbody>\n</table></div>\n"
        + (tag("p", text_of(note), class_="note") if note else ""), class_="table")


def plot_html(shapes, plot):
    return tag("figure", "\n" + shapes + tag("figcaption", text_of(plot["caption"])), class_="plot")


def picture_html(picture, folder):
    caption, name = text_of(picture["caption"]), picture["file"]
    # A name, no path: the page shows nothing but what lies beside its bench.json.
    if text_of(name) != name or os.path.basename(name) != name or not name:
        raise ValueError(f"a picture's file is a plain name without a folder, not {name!r:.60}")
    try:
        with open(os.path.join(folder, name), "rb") as file:
            source = "data:image/png;base64," + base64.b64encode(file.read()).decode("ascii")
    except OSError as error:
        print(f"report.py: warning: {os.path.join(folder, name)}: {error.strerror}", file=sys.stderr)
        return f"<div><p>{caption} ({name} is missing)</p></div>\n"
    size = f'width="{int(number(picture["width"]))}" height="{int(number(picture["height"]))}"'
    return f'<div><img alt="{caption}" {size} src="{source}"/><p>{caption}</p></div>\n'


def pictures_html(figure, folder):
    row = "".join(picture_html(picture, folder) for picture in figure["pictures"])
    return tag("figure",
        f'\n<div class="row">\n{row}</div>\n' + tag("figcaption", text_of(figure["caption"])), class_="pictures")


# From a kind of part to what draws it: of its content and the folder of pictures.
PARTS = {
    "heading": lambda text, _: tag("h2", text_of(text)),
    "subheading": lambda text, _: tag("h3", text_of(text)),
    "paragraph": lambda text, _: tag("p", text_of(text)),
    "table": lambda table, _: table_html(table),
    "curves": lambda plot, _: plot_html(curves_svg(plot), plot),
    "bars": lambda plot, _: plot_html(bars_svg(plot), plot),
    "pictures": pictures_html,
}


def page_html(bench, folder):
    """The whole page of a read bench.json whose pictures lie in `folder`. Raises ValueError."""
    try:
        title, body = text_of(bench["page"]["title"]), ""
        for part in bench["page"]["parts"]:
            ((kind, content),) = part.items()
            body += PARTS[kind](content, folder)
    except (KeyError, TypeError, AttributeError, ValueError, OverflowError) as error:
        raise ValueError(f'no "page" as report.py describes it: {type(error).__name__}: {error}') from error
    return ('<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1"/>\n'
        f"<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{body}"
        "</body>\n</html>\n")


def write_whole(path, text):
    """Under another name beside it, renamed at the end. A link is followed, a device written directly."""
    path = os.path.realpath(path)
    direct = os.path.exists(path) and not os.path.isfile(path)
    temporary = path if direct else f"{path}.{os.getpid()}"
    file = open(temporary, "w" if direct else "x", encoding="utf-8")
    try:
        with file:
            file.write(text)
        if not direct:
            os.replace(temporary, path)
    except BaseException:
        if not direct:
            os.unlink(temporary)
        raise


def main():
    parser = argparse.ArgumentParser("report.py", description="Draws the page of `firsthit bench`.")
    parser.add_argument("input", metavar="bench.json", help="what `firsthit bench` wrote")
    parser.add_argument("-o", metavar="FILE", dest="output", help="default index.html beside it; -: stdout")
    asked = parser.parse_args()
    folder = os.path.dirname(asked.input)
    try:
        with open(asked.input, encoding="utf-8") as file:
            page = page_html(json.load(file), folder)
        if asked.output == "-":
            sys.stdout.buffer.write(page.encode("utf-8"))
        else:
            write_whole(asked.output or os.path.join(folder, "index.html"), page)
    except (ValueError, RecursionError, OSError) as error:
        print(f"report.py: {asked.input}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
