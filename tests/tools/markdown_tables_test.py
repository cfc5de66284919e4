"""markdown_tables_test.py - what tools/markdown_tables.py writes, and what it refuses."""
import copy
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "markdown_tables.py"
sys.dont_write_bytecode = True
sys.path.insert(0, str(SCRIPT.parent))
import markdown_tables  # noqa: E402

BENCH = {
    "machine": {"date": "2026-01-02T03:04:05Z", "commit": "abc123", "cpu": "A processor", "instruction_set": "AVX3"},
    "page": {"title": "Measured", "parts": [
        {"heading": "Frames"},
        {"table": {"title": "t", "head": ["scene", "ms"], "rows": [["a|b", ["1.5", "1 to 2"]]], "note": "n"}},
        {"curves": {"title": "a curve"}},
    ]},
}


def changed(change):
    bench = copy.deepcopy(BENCH)
    change(bench)
    return bench


class MarkdownTables(unittest.TestCase):
    def test_a_table_has_a_head_its_rows_and_its_note(self):
        text = markdown_tables.markdown(BENCH)
        self.assertIn("| scene | ms |\n| --- | ---: |\n| a\\|b | 1.5 (1 to 2) |\n\nn\n", text)
        self.assertIn("## Frames\n", text)

    def test_the_head_names_date_commit_command_and_machine(self):
        text = markdown_tables.markdown(BENCH, "firsthit bench")
        for line in ("- measured: 2026-01-02T03:04:05Z", "- commit: abc123", "- command: firsthit bench",
                     "- machine: A processor, AVX3"):
            self.assertIn(line + "\n", text)

    def test_curves_are_left_out(self):
        self.assertNotIn("a curve", markdown_tables.markdown(BENCH))

    def test_quick_runs_are_marked(self):
        self.assertNotIn("say nothing", markdown_tables.markdown(BENCH))
        self.assertIn("say nothing", markdown_tables.markdown(changed(lambda bench: bench.update(quick=True))))

    def test_a_row_of_another_length_is_refused(self):
        bench = changed(lambda bench: bench["page"]["parts"][1]["table"]["rows"].append(["alone"]))
        with self.assertRaisesRegex(ValueError, 'a row of "t" has 1 cells, not 2'):
            markdown_tables.markdown(bench)

    def test_an_unknown_part_is_refused(self):
        bench = changed(lambda bench: bench["page"]["parts"].append({"song": ""}))
        with self.assertRaisesRegex(ValueError, "an unknown part: song"):
            markdown_tables.markdown(bench)

    def test_a_missing_page_is_refused(self):
        with self.assertRaisesRegex(ValueError, 'no "page"'):
            markdown_tables.markdown({"machine": {}})

    def test_the_program_fails_with_the_name_of_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "bench.json"
            path.write_text("{")
            done = subprocess.run([sys.executable, SCRIPT, path], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"markdown_tables.py: {path}: ", done.stderr)
            path.write_text(json.dumps(BENCH))
            done = subprocess.run([sys.executable, SCRIPT, path], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (0, markdown_tables.markdown(BENCH)))


if __name__ == "__main__":
    unittest.main()
