"""report_test.py - what tools/report.py draws, and what it refuses. Usage: report_test.py [unittest's options]"""
import base64
import copy
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock
from xml.etree import ElementTree

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "report.py"
sys.dont_write_bytecode = True
sys.path.insert(0, str(SCRIPT.parent))
import report  # noqa: E402

NASTY = "<script>\"a\" & 'b'</script>"
PNG = b"\x89PNG\r\n\x1a\nnot really"
SVG = "{http://www.w3.org/2000/svg}"


def bench_of(*parts):
    return {"page": {"title": "Measured", "parts": list(parts)}}


def drawn(*parts, folder="."):
    """The page's root element: a page that is not well-formed raises ParseError."""
    return ElementTree.fromstring(report.page_html(bench_of(*parts), folder))


def curves(*series, **axes):
    return {"curves": {"title": "t", "x": axes.get("x", {"label": "x"}), "y": axes.get("y", {"label": "y"}),
        "series": list(series), "caption": "c"}}


def bars(parts, *rows):
    return {"bars": {"title": "t", "label": "%", "parts": parts, "caption": "c",
        "bars": [{"name": f"bar {k}", "values": values} for k, values in enumerate(rows)]}}


def shapes(root, name):
    return list(root.iter(SVG + name))


def all_numbers(root):
    """Of every attribute that says where something stands."""
    for node in root.iter():
        for key in ("x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "width", "height", "points", "viewBox"):
            for word in re.split("[ ,]", node.get(key, "")):
                if word:
                    yield float(word)


class Axes(unittest.TestCase):
    def test_heights_begin_at_zero_and_end_at_a_tick(self):
        scale = report.Scale({}, [3, 47])
        self.assertEqual(scale.ticks, [0, 10, 20, 30, 40, 50])
        self.assertEqual([scale.place(value) for value in (0, 25, 50)], [0, 0.5, 1])
        self.assertEqual(report.Scale({}, [100.00000000000001]).ticks[-1], 100)
        self.assertEqual(report.Scale({}, [-3, 47]).ticks, [-10, 0, 10, 20, 30, 40, 50])

    def test_may_begin_where_the_values_do(self):
        scale = report.Scale({"from_zero": False}, [100, 104])
        self.assertEqual(scale.ticks, [100, 101, 102, 103, 104])
        self.assertEqual((scale.place(100), scale.place(104)), (0, 1))

    def test_logarithms_have_powers_of_ten(self):
        scale = report.Scale({"log": True}, [1e3, 1e7])
        self.assertEqual(scale.ticks, [1e3, 1e4, 1e5, 1e6, 1e7])
        for k, tick in enumerate(scale.ticks):
            self.assertAlmostEqual(scale.place(tick), k / 4)

    def test_few_logarithms_have_twos_and_fives_too(self):
        self.assertEqual(report.Scale({"log": True}, [3, 80]).ticks, [2, 5, 10, 20, 50, 100])

    def test_what_cannot_be_shown_is_left_out(self):
        scale = report.Scale({"log": True}, [-1, 0, math.nan, math.inf, 10, 20])
        self.assertEqual([scale.holds(value) for value in (0, -1, math.nan, 15)], [False, False, False, True])
        self.assertEqual((scale.place(10), scale.place(20)), (0, 1))

    def test_any_values_give_a_few_rising_ticks_on_the_axis(self):
        seed = random.randrange(2**32)
        chance = random.Random(seed)
        cases = [[], [0, 0], [5, 5], [1e300, -1e300], [1e-300, 2e-300], [0, 5e-324], [1, 1 + 1e-15]]
        for _ in range(3000):
            size = 10 ** chance.uniform(-300, 299)
            cases.append([chance.uniform(-1, 1) * size + chance.choice([0, 1, 1e6]) for _ in range(3)])
        for values in cases:
            for axis in ({}, {"from_zero": False}, {"log": True}):
                with self.subTest(seed=seed, values=values, axis=axis):
                    scale = report.Scale(axis, values)
                    self.assertTrue(1 <= len(scale.ticks) <= 13, scale.ticks)
                    self.assertTrue(all(a < b for a, b in zip(scale.ticks, scale.ticks[1:])), scale.ticks)
                    shown = [value for value in values if scale.holds(value)]
                    for place in map(scale.place, scale.ticks + shown):
                        self.assertTrue(-1e-3 <= place <= 1.001, place)

    def test_tick_texts_are_short(self):
        texts = {0: "0", 0.5: "0.5", 2000: "2000", 20000: "20k", 1e7: "10M", 0.1 * 3: "0.3", 1e12: "1e+12"}
        for value, text in texts.items():
            self.assertEqual(report.tick_text(value), text)


class Curves(unittest.TestCase):
    def test_a_curve_is_interrupted_where_it_has_no_value(self):
        for missing in (None, math.nan, -math.inf, "7", True, 10**400):
            root = drawn(curves({"name": "n", "x": [1, 2, 3, 4, 5], "y": [2, 3, missing, 1, 2]}))
            runs = [len(run.get("points").split()) for run in shapes(root, "polyline")]
            self.assertEqual(runs, [2, 2, 2])  # the last is the legend's
            self.assertEqual(len(shapes(root, "circle")), 4)
            self.assertTrue(all(map(math.isfinite, all_numbers(root))))

    def test_points_stand_where_the_axes_say(self):
        root = drawn(curves({"name": "n", "x": [0, 5, 10], "y": [0, 50, 100]}))
        dots = [(float(dot.get("cx")), float(dot.get("cy"))) for dot in shapes(root, "circle")]
        self.assertEqual(dots, [(75, 345), (362.5, 192.5), (650, 40)])

    def test_quartiles_are_bars_and_none_are_none(self):
        points = {"name": "n", "x": [1, 2], "y": [4, 4]}
        without = drawn(curves(points))
        within = drawn(curves({**points, "lower": [3, None], "upper": [4, None]}))
        self.assertEqual(len(shapes(within, "line")), len(shapes(without, "line")) + 1)

    def test_dashed_curves_have_no_dots(self):
        root = drawn(curves({"name": "n", "x": [1, 2], "y": [1, 2], "dashed": True}))
        self.assertEqual(len(shapes(root, "circle")), 0)
        self.assertTrue(all(curve.get("stroke-dasharray") for curve in shapes(root, "polyline")))

    def test_many_series_have_room_in_the_legend(self):
        root = drawn(curves(*({"name": "one of many", "x": [], "y": []} for _ in range(40))))
        self.assertEqual([text.text for text in shapes(root, "text")].count("one of many"), 40)
        self.assertEqual(shapes(root, "svg")[0].get("viewBox"), "0 0 900 860")

    def test_nothing_to_show_is_still_a_plot(self):
        for axis in ({"label": ""}, {"label": "", "log": True}):
            self.assertGreater(len(shapes(drawn(curves(x=axis, y=axis)), "line")), 3)


class Bars(unittest.TestCase):
    def test_have_a_box_for_every_part_that_is_above_zero(self):
        root = drawn(bars(["a", "b"], [25, 75], [100, 0], [math.nan, -3], [None, None], [1]))
        self.assertEqual(len(shapes(root, "rect")), 4 + 2)  # and the legend's
        self.assertTrue(all(value >= 0 for value in all_numbers(root)))

    def test_stand_behind_one_another(self):
        first, second = shapes(drawn(bars(["a", "b"], [25, 75])), "rect")[:2]
        end = float(first.get("x")) + float(first.get("width"))
        self.assertAlmostEqual(end, float(second.get("x")), delta=0.11)
        self.assertAlmostEqual(float(second.get("width")) / float(first.get("width")), 3, delta=0.01)
        self.assertEqual(first.find(SVG + "title").text, "bar 0, a: 25")

    def test_nothing_to_show_is_still_a_plot(self):
        self.assertEqual(len(shapes(drawn(bars([])), "svg")), 1)


class Pages(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, content):
        Path(self.path(name)).write_bytes(content)
        return self.path(name)

    def run_script(self, *arguments):
        return subprocess.run([sys.executable, "-I", SCRIPT, *arguments], capture_output=True, timeout=60)

    def every_part(self, text):
        plot = curves({"name": text, "x": [1, 2], "y": [3, 4], "lower": [2, 3], "upper": [4, 5]})["curves"]
        plot.update(title=text, caption=text, x={"label": text}, y={"label": text, "log": True})
        stacked = bars([text, "shading"], [25, 75])["bars"]
        stacked.update(title=text, label=text, caption=text)
        stacked["bars"][0]["name"] = text
        table = {"title": text, "head": ["", text], "rows": [[text, ["1", text]], ["two", "22"]], "note": text}
        picture = {"file": "figure-1.png", "width": 2, "height": 1, "caption": text}
        return [{"heading": text}, {"subheading": text}, {"paragraph": text}, {"table": table}, {"curves": plot},
            {"bars": stacked}, {"pictures": {"caption": text, "pictures": [picture]}}]

    def test_names_stay_names(self):
        self.write("figure-1.png", PNG)
        usual = drawn(*self.every_part("x"), folder=self.folder.name)
        nasty = drawn(*self.every_part(NASTY), folder=self.folder.name)
        self.assertEqual([node.tag for node in nasty.iter()], [node.tag for node in usual.iter()])
        self.assertEqual("".join(nasty.itertext()).count(NASTY), "".join(usual.itertext()).count("x") - "".join(
            drawn(*self.every_part(""), folder=self.folder.name).itertext()).count("x"))
        self.assertEqual(nasty.find(".//img").get("alt"), NASTY)

    def test_what_xml_forbids_is_replaced(self):
        for text in ("a\x01z", "a\ud800z", "a\uffffz", "a\x00z"):
            self.assertEqual(drawn({"heading": text}).find(".//h2").text, "a\ufffdz")
        kept = "a\u00e9\u20ac\U0001f407\tz"
        self.assertEqual(drawn({"heading": kept}).find(".//h2").text, kept)

    def test_cells_have_their_notes(self):
        table = {"title": "t", "head": ["a", "b"], "rows": [["x", ["-", "no OpenGL"]]]}
        row = drawn({"table": table}).find(".//tbody/tr")
        self.assertEqual([cell.tag for cell in row], ["th", "td"])
        self.assertEqual((row[1].text, row[1].find("small").text), ("-", "no OpenGL"))

    def test_a_page_needs_nothing_beside_it(self):
        self.write("figure-1.png", PNG)
        page = report.page_html(bench_of(*self.every_part("x")), self.folder.name)
        self.assertIn("data:image/png;base64," + base64.b64encode(PNG).decode(), page)
        page = page.replace('xmlns="http://www.w3.org/2000/svg"', "")
        for word in ("http", "<script", "<link", "url(", "@import", "<iframe", 'src="/', 'src="f'):
            self.assertNotIn(word, page)

    def test_a_picture_that_is_missing_is_told(self):
        bench = self.write("bench.json", json.dumps(bench_of(*self.every_part("x"))).encode())
        made = self.run_script(bench)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertIn(b"figure-1.png", made.stderr)
        self.assertIn("figure-1.png is missing", Path(self.path("index.html")).read_text("utf-8"))

    def test_pictures_are_taken_from_the_folder_alone(self):
        self.write("outside.png", PNG)
        for name in ("../outside.png", self.path("outside.png"), "a/b.png", "", "a\0b", 7):
            part = {"pictures": {"caption": "", "pictures": [
                {"file": name, "width": 1, "height": 1, "caption": ""}]}}
            with self.assertRaises(ValueError):
                report.page_html(bench_of(part), self.path("below"))

    def test_the_page_lies_beside_the_json_or_where_it_is_asked_for(self):
        bench = self.write("bench.json", json.dumps(bench_of({"heading": "h"})).encode())
        expected = report.page_html(bench_of({"heading": "h"}), "").encode()
        for arguments, path in (([], "index.html"), (["-o", self.path("other.html")], "other.html")):
            made = self.run_script(bench, *arguments)
            self.assertEqual((made.returncode, made.stdout, made.stderr), (0, b"", b""))
            self.assertEqual(Path(self.path(path)).read_bytes(), expected)
        self.assertEqual(self.run_script(bench, "-o", "-").stdout, expected)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["bench.json", "index.html", "other.html"])

    def test_a_page_that_cannot_be_written_leaves_nothing_behind(self):
        old = self.write("index.html", b"old")
        with mock.patch("os.replace", side_effect=OSError("no room")), self.assertRaises(OSError):
            report.write_whole(old, "new")
        self.assertEqual(os.listdir(self.folder.name), ["index.html"])
        self.assertEqual(Path(old).read_bytes(), b"old")

    def test_what_is_no_bench_json_is_refused_and_the_old_page_stays(self):
        old = self.write("index.html", b"old")
        for text in (b"", b"{", b"[]", b"7", b"{}", b"\xff", b'{"page": 7}', b'{"page": {"title": "t"}}',
                b"[" * 100000, b'{"page": {"title": "t", "parts": [{"song": 1}]}}'):
            made = self.run_script(self.write("bench.json", text))
            self.assertEqual(made.returncode, 1, text[:40])
            self.assertRegex(made.stderr, rb"^report.py: .*bench.json: .+\n$")
            self.assertEqual(Path(old).read_bytes(), b"old")
        self.assertEqual(self.run_script(self.path("nowhere.json")).returncode, 1)
        self.assertEqual(self.run_script().returncode, 2)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["bench.json", "index.html"])

    def test_a_page_with_anything_wrong_in_it_is_drawn_or_refused(self):
        self.write("figure-1.png", PNG)
        seed = random.randrange(2**32)
        chance = random.Random(seed)
        odd = [None, True, -1, 0, 1e308, math.nan, math.inf, 10**400, "", NASTY, [], [None], {}, {"label": 1}]
        for k in range(2000):
            parts = self.every_part("x")
            node, path = chance.choice(parts), []
            while isinstance(node, (dict, list)) and node:
                key = chance.choice(list(node) if isinstance(node, dict) else range(len(node)))
                path.append((node, key))
                node = node[key]
            holder, key = chance.choice(path)
            holder[key] = copy.deepcopy(chance.choice(odd))
            with self.subTest(seed=seed, case=k, parts=parts):
                try:
                    page = report.page_html(bench_of(*parts), self.folder.name)
                except ValueError:
                    continue
                self.assertTrue(all(map(math.isfinite, all_numbers(ElementTree.fromstring(page)))))


if __name__ == "__main__":
    unittest.main()
