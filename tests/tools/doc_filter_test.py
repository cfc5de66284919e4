"""doc_filter_test.py - what tools/doc_filter.py makes of the comments of a header."""
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tools"))
from doc_filter import convert  # noqa: E402


class DocFilter(unittest.TestCase):
    def test_the_first_line_describes_the_file(self):
        self.assertEqual(convert(["// film.h - planes."]), ["/** @file film.h @brief Planes. */"])

    def test_a_comment_behind_a_member_describes_it_with_the_lines_that_continue_it(self):
        self.assertEqual(
            convert(["    int a = 1; // of the tree", "               // and more", "    // not of a"]),
            ["    int a = 1; ///< of the tree", "               ///< and more", "    // not of a"])
        self.assertEqual(convert(["    exact, // as it is"]), ["    exact, ///< as it is"])
        self.assertEqual(convert(["} // namespace firsthit"]), ["} // namespace firsthit"])
        self.assertEqual(convert(['const char* a = "// no comment";']), ['const char* a = "// no comment";'])

    def test_facts_become_a_list(self):
        self.assertEqual(
            convert(["/// Makes it.", "/// threads  0: one a core", "/// throws   SceneError: one",
                     "///          thing", "///          DeviceError: another", "void make(int threads);"]),
            ["/// Makes it.", '/// <dl class="facts"><dt>threads</dt><dd>0: one a core',
             "/// </dd><dt>throws</dt><dd>SceneError: one", "/// thing",
             "/// <br>DeviceError: another</dd></dl>", "void make(int threads);"])

    def test_text_after_facts_is_text_again(self):
        self.assertEqual(convert(["/// a  b", "///", "/// Text."]),
            ['/// <dl class="facts"><dt>a</dt><dd>b</dd></dl>', "///", "/// Text."])

    def test_what_needs_no_words_is_left_out(self):
        self.assertEqual(convert(["    ~Film();", "    Film(const Film&) = delete;"]), ["", ""])

    def test_lines_of_every_public_header_keep_their_numbers_and_their_code(self):
        for header in sorted((ROOT / "include" / "firsthit").glob("*.h")):
            lines = header.read_text(encoding="utf-8").split("\n")
            converted = convert(lines)
            self.assertEqual(len(converted), len(lines), header)
            for line, new in zip(lines, converted):
                code = line.split("//")[0].rstrip()
                self.assertIn(new.split("//")[0].split("/**")[0].rstrip(), ("", code), header)


if __name__ == "__main__":
    unittest.main()
