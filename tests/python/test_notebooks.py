# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks of examples/notebooks run from top to bottom, without Jupyter, and show what their last lines say."""

import ast
import contextlib
import io
import json
import unittest
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "examples" / "notebooks"


def shown_by(cell, names):
    """Runs a cell. @returns what its last line shows, None where that is no expression"""
    tree = ast.parse("".join(cell["source"]))
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None


class Notebooks(unittest.TestCase):
    def test_all_run(self):
        notebooks = sorted(FOLDER.glob("*.ipynb"))
        self.assertTrue(notebooks)
        for path in notebooks:
            names = {}
            for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
                if cell["cell_type"] == "code":
                    with self.subTest(path.name, cell=cell["id"]), contextlib.redirect_stdout(io.StringIO()):
                        self.assertEqual(cell["outputs"], [])
                        shown = shown_by(cell, names)
                        if hasattr(shown, "_repr_html_"):
                            self.assertIn("<iframe", shown._repr_html_())


if __name__ == "__main__":
    unittest.main()
