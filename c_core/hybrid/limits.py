"""Limits and margins, which stand in headers of C, and names of C files."""

import re
from pathlib import Path

C_CORE = Path(__file__).resolve().parents[1]
UNIT = next(folder for folder in (C_CORE / "fmu_src", C_CORE.parent / "fmu_src") if folder.is_dir())
"""The C sources that all units share, in a checkout or in the installed package."""
HEADERS = """assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdarg
    stdbool stddef stdint stdio stdlib string tgmath time wchar wctype unit unit_page unit_names"""
FILES = set(HEADERS.split())
"""Names of C files beside those of a page: the standard's headers, and all with which pages are compiled."""
for folder in (*(C_CORE / name for name in ("hybrid/kernel", "kernel", "gait")), UNIT):
    FILES |= {file.stem for file in folder.glob("*.[ch]")}
DRIVER, EQUATIONS, TABLE = (
    (C_CORE / header).read_text(encoding="utf-8")
    for header in ("hybrid/kernel/driver.h", "kernel/linear_equations.h", "hybrid/kernel/page_margins.h")
)
LIMITS = {n: int(limit) for n, limit in re.findall(r"TDMF_(\w+)_LIMIT = (\d+)", DRIVER + EQUATIONS)}
"""Events in zero time (PAGE_CHAIN), of a mode (GUARD) and of a page (PAGE_EVENT), modes after an event
(NEXT), observed quantities of a mode (WATCH), coordinates of a section (MAP)."""
MARGINS = {n: float(x) for n, x in re.findall(r"double (\w+)_margin = TDMF_MARGIN_FACTOR \* (\S+);", TABLE)}
"""Margins relative to the scale of a unit: of what counts as zero, and of rounding errors."""
