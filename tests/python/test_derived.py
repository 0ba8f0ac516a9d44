"""Derived files are those that the pages make: nobody has edited them."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def words(text):
    """A text without its layout: comments and macros wrap elsewhere after a formatter."""
    return re.findall(r"\w+|[^\w\s]", re.sub(r"\n \* ?|\\\n", "\n", text))


def test_derived_files_are_those_of_the_pages(tmp_path):
    """The C of the pages, the header of variables, and the units' model descriptions."""
    subprocess.run([sys.executable, "-m", "c_core.pages", tmp_path], cwd=ROOT, check=True)
    made = {path.relative_to(tmp_path) for path in tmp_path.rglob("*") if path.is_file()}
    derived = {path.relative_to(ROOT) for path in (ROOT / "c_core/derived").rglob("*") if path.is_file()}
    committed = {path for path in derived if path.suffix != ".pyc" and path.name != ".clang-format"}
    elsewhere = {Path("modelDescription.xml"), Path("c_core/include/tdmf_slip/variables.h")}
    assert len(made) > 20 and made == committed | elsewhere
    for path in made:
        texts = [words((folder / path).read_text("utf-8")) for folder in (tmp_path, ROOT)]
        assert texts[0] == texts[1], f"{path}: run scripts/derive_equations"
