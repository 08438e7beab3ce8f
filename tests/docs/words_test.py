#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""words_test.py: tools/words.py finds expressions where they are text, names the line, and lets the number in a file only fall."""

import contextlib
import io
import os
import pathlib
import sys
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "tools"))
import words  # noqa: E402

RULES = list(words.expressions(TOP / words.LIST))


def found(name, text):
    """(line, expression) of a file with this name and text."""
    place, read = words.reader(name)
    return [(line, what) for line, what, _ in words.findings(list(read(text)) if place == "program" else list(words.segments(read(text))), place, RULES)]


class Expressions(unittest.TestCase):
    def test_of_a_page_are_found_in_its_text_only(self):
        page = "# Loops\n\nTwo laws cannot be told\napart.\n\n```\nplanted\n```\n\n    planted\n\nUse `planted`, [a page](planted.md).\n"
        self.assertEqual(found("docs/guides/loops.md", page), [(3, "told apart")])

    def test_of_a_program_are_found_between_quotation_marks(self):
        source = '// planted\nconst char* a = "planted"; // a name\ncall("what was "\n     "planted here", "the way", " back");\n'
        self.assertEqual(found("src/a.cpp", source), [(4, "planted")])

    def test_of_raw_text_are_found(self):
        self.assertEqual(found("apps/a.cpp", 'auto help = R"(first line\nwhat nobody needs)";\n'), [(2, "nobody")])

    def test_of_python_are_found_in_docstrings(self):
        self.assertEqual(found("python/setae/a.py", 'def f():\n    """What a loop says.\n\n    >>> nobody\n    """\n    return "nobody"\n'), [(1 + 1, "says")])

    def test_of_a_notebook_are_found_in_cells_of_text(self):
        self.assertEqual(found("docs/notebooks/a.py", "# %% [markdown]\n# # Loops\n# Nobody.\n\n# %%\nx = 1  # nobody\n"), [(3, "Nobody")])

    def test_bare_equation_numbers_are_found_and_named_ones_are_not(self):
        page = "The full-contact balance (Eq. 7) fits, (7) does not, nor does (S13); f(7), 3 (2019).\n"
        self.assertEqual(found("README.md", page), [(1, "(7)"), (1, "(S13)")])

    def test_sentences_that_start_with_of_or_what_are_found(self):
        page = "# What it is\n\nOf a map. A part\nof a map. What else.\n\n- What is new\n"
        self.assertEqual([line for line, _ in found("docs/a.md", page)], [1, 3, 4, 6])

    def test_of_generated_pages_decisions_and_tests_are_left_out(self):
        for name in ("docs/reference/commands/psd.md", "docs/development/adr/0001-licence.md", "src/contact/loops/tests/a.cpp", "docs/figures/a.svg"):
            self.assertIsNone(words.reader(name))

    def test_what_the_program_makes_of_a_page_is_left_out(self):
        page = "nobody\n<!-- what stands above is made by `setae` -->\n\nnobody\n"
        self.assertEqual(found("docs/reference/parameters.md", page), [(4, "nobody")])

    def test_each_has_a_use(self):
        self.assertTrue(all(use for _, _, use, _ in RULES))


class LongSentences(unittest.TestCase):
    def test_are_counted_with_their_lines(self):
        page = "Short.\n\n" + "word " * 41 + "end.\n\n| " + "word " * 60 + "|\n"
        self.assertEqual(list(words.long_sentences(words.pages(page))), [(3, 42)])


class Allowances(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.before = os.getcwd()
        os.chdir(self.folder.name)
        for name, text in (("docs/a.md", "Nobody.\n\nNobody.\n"), (words.LIST, "[[expression]]\nfind = 'nobody'\nuse = 'the user'\n")):
            pathlib.Path(name).parent.mkdir(exist_ok=True)
            pathlib.Path(name).write_text(text, encoding="utf-8")

    def tearDown(self):
        os.chdir(self.before)
        self.folder.cleanup()

    def check(self, **options):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            failed = words.check(["docs/a.md"], **options)
        return failed, output.getvalue()

    def allow(self, count):
        pathlib.Path(words.ALLOWED).write_text(f"docs/a.md\t{count}\n", encoding="utf-8")

    def allowed(self):
        return pathlib.Path(words.ALLOWED).read_text(encoding="utf-8")

    def test_more_than_allowed_fails_and_names_each(self):
        self.allow(1)
        failed, output = self.check()
        self.assertTrue(failed)
        self.assertIn('docs/a.md:3: found "Nobody"; expected: the user\n', output)

    def test_as_many_as_allowed_pass_in_silence(self):
        self.allow(2)
        failed, output = self.check()
        self.assertFalse(failed)
        self.assertNotIn("found", output)

    def test_a_file_without_an_allowance_has_none(self):
        pathlib.Path(words.ALLOWED).write_text("", encoding="utf-8")
        self.assertTrue(self.check()[0])

    def test_writing_lowers_and_never_raises(self):
        self.allow(5)
        self.assertFalse(self.check(write=True)[0])
        self.assertEqual(self.allowed(), "docs/a.md\t2\n")
        self.allow(1)
        self.assertTrue(self.check(write=True)[0])
        self.assertEqual(self.allowed(), "docs/a.md\t1\n")

    def test_the_first_writing_allows_what_there_is(self):
        self.assertFalse(self.check(write=True)[0])
        self.assertEqual(self.allowed(), "docs/a.md\t2\n")

    def test_a_key_that_is_not_known_is_an_error(self):
        pathlib.Path(words.LIST).write_text("[[expression]]\nfind = 'a'\nuse = 'b'\nexpect = 'c'\n", encoding="utf-8")
        with self.assertRaisesRegex(ValueError, "unknown key expect"):
            self.check()


if __name__ == "__main__":
    unittest.main()
