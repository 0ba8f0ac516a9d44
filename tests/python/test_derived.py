"""The derived C is what the pages make, and nobody has edited it."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
CORE = ROOT / "c_core"


def words(text):
    """C without its layout: comments and macros wrap elsewhere after a formatter."""
    return re.findall(r"\w+|[^\w\s]", re.sub(r"\n \* ?|\\\n", "\n", text))


def test_derived_files_are_those_of_the_pages(tmp_path):
    subprocess.run([sys.executable, "-m", "c_core.pages", tmp_path], cwd=ROOT, check=True)
    made = {path.name: path.read_text() for path in tmp_path.iterdir()}
    committed = {path.name: path.read_text() for path in (CORE / "derived/pages").glob("*.[ch]")}
    assert len(made) >= 6
    assert made.keys() == committed.keys()
    for name, text in made.items():
        assert words(text) == words(committed[name]), f"derived/pages/{name}: run scripts/derive_equations"


def test_declarations_are_those_of_the_table_of_variables(tmp_path):
    made = tmp_path / "variables.h"
    script = ROOT / "scripts/generate_variables.py"
    subprocess.run([sys.executable, script, "declarations", ROOT / "modelDescription.xml", made], check=True)
    committed = (CORE / "include/tdmf_slip/variables.h").read_text()
    assert words(made.read_text()) == words(committed), "run scripts/derive_equations"
    assert len(words(committed)) > 500
