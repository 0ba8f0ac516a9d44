"""What is derived is what the pages make, and nobody has edited it."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
CORE = ROOT / "c_core"


def words(text):
    """A text without its layout: comments and macros wrap elsewhere after a formatter."""
    return re.findall(r"\w+|[^\w\s]", re.sub(r"\n \* ?|\\\n", "\n", text))


def test_derived_files_are_those_of_the_pages(tmp_path):
    """The C of the pages, the header of variables, and the units' model descriptions."""
    subprocess.run([sys.executable, "-m", "c_core.pages", tmp_path], cwd=ROOT, check=True)
    made = {path.relative_to(tmp_path) for path in tmp_path.rglob("*") if path.is_file()}
    derived = {path.relative_to(CORE) for path in (CORE / "derived").rglob("*") if path.is_file()}
    committed = {path for path in derived if path.suffix != ".pyc" and path.name != ".clang-format"}
    assert len(made) > 20 and made == committed | {Path("include/tdmf_slip/variables.h")}
    for path in made:
        texts = [words((folder / path).read_text("utf-8")) for folder in (tmp_path, CORE)]
        assert texts[0] == texts[1], f"c_core/{path}: run scripts/derive_equations"
