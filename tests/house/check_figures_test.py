#!/usr/bin/env python3
"""docs/lab/check-figures finds figures that hold, figures that do not, and checks that are wrong in themselves."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "lab" / "check-figures"
PAGE = """# Page

| mesh | atlas | C, dB | time |
|---|---|---|---|
| cube | strips | 91.2 % / .0031 | 5 |
|  | quad | 80 / 1,024 | 6 |

The error is 3.1e-7 at the
first of 12 texels.

<!-- check
$ burl figures
[cube | strips] 3 = [100 * j["c"], j["e"]]
[cube | quad] "C, dB" = [80, j["n"]]
"error is # at the first of # texels" = [j["f"], 12]
[cube | strips] time = [...]
-->

## Other section

The error is 5.
"""


def run(page, answer, *options):
    """Exit code, output and the page after it, of a program that prints the answer."""
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder, "program")
        program.write_text(f"#!/bin/sh\ncat <<'END'\n{answer}\nEND\n")
        os.chmod(program, 0o755)
        path = pathlib.Path(folder, "page.md")
        path.write_text(page)
        done = subprocess.run([sys.executable, SCRIPT, *options, program, path], capture_output=True, text=True)
        return done.returncode, done.stdout, path.read_text()


RIGHT = '{"c": 0.9123, "e": 0.00311, "n": 1024, "f": 3.14e-7}'


class CheckFigures(unittest.TestCase):
    def test_figures_hold(self):
        code, out, page = run(PAGE, RIGHT)
        self.assertEqual(code, 0, out)
        self.assertIn("6 figures of 1 pages hold, 0 do not, 0 checks are wrong", out)
        self.assertEqual(page, PAGE)

    def test_every_figure_may_fail(self):
        for old, new in (("0.9123", "0.9135"), ("0.00311", "0.0033"), ("1024", "1026"), ("3.14e-7", "3.3e-7")):
            code, out, _ = run(PAGE, RIGHT.replace(old, new))
            self.assertEqual(code, 1, out)
            self.assertIn("5 figures of 1 pages hold, 1 do not", out)

    def test_a_changed_page_fails(self):
        for old, new in (("91.2", "91.4"), (".0031", ".0035"), ("1,024", "1,027"), ("3.1e-7", "3.1e-6"), ("12 texels", "14 texels")):
            self.assertEqual(run(PAGE.replace(old, new), RIGHT)[0], 1, old)

    def test_slack(self):
        loose = PAGE.replace('j["e"]]\n', 'j["e"]] ~ 10 %\n')
        self.assertEqual(run(loose, RIGHT.replace("0.00311", "0.0033"))[0], 0)
        self.assertEqual(run(loose, RIGHT.replace("0.00311", "0.0035"))[0], 1)

    def test_update_writes_as_it_stood(self):
        code, _, page = run(PAGE, '{"c": 0.5, "e": 0.0123, "n": 2048, "f": 4.56e-6}', "--update")
        self.assertEqual(code, 1)
        self.assertIn("| cube | strips | 50.0 % / .0123 | 5 |", page)
        self.assertIn("80 / 2,048", page)
        self.assertIn("error is 4.6e-6 at the\nfirst of 12 texels", page)

    def test_wrong_checks(self):
        for old, new in (("[cube | strips] 3", "[sphere | strips] 3"), ('"C, dB"', "nothing"), ("error is #", "mistake is #"),
                         ('j["c"]', 'j["d"]'), ("[100 * ", "[1, 100 * "), ("burl figures", "false"), ('"error is # at', '"error is 1 at'),
                         ("$ burl figures\n", "")):
            code, out, _ = run(PAGE.replace(old, new, 1), RIGHT)
            self.assertEqual(code, 2, f"{new}: {out}")

    def test_long_checks_wait(self):
        long = PAGE.replace("<!-- check", "<!-- check long")
        self.assertIn("0 figures", run(long, RIGHT)[1])
        self.assertIn("6 figures", run(long, RIGHT, "--all")[1])


if __name__ == "__main__":
    unittest.main()
