"""Limits and margins, which stand in headers of C."""

import re
from pathlib import Path

C_CORE = Path(__file__).resolve().parents[1]
DRIVER, EQUATIONS, TABLE = (
    (C_CORE / header).read_text(encoding="utf-8")
    for header in ("hybrid/kernel/driver.h", "kernel/linear_equations.h", "hybrid/kernel/page_margins.h")
)
LIMITS = {n: int(limit) for n, limit in re.findall(r"TDMF_(\w+)_LIMIT = (\d+)", DRIVER + EQUATIONS)}
"""Events in zero time (PAGE_CHAIN), of a mode (GUARD) and of a page (PAGE_EVENT), modes after an event
(NEXT), observed quantities of a mode (WATCH), coordinates of a section (MAP)."""
MARGINS = {n: float(x) for n, x in re.findall(r"double (\w+)_margin = TDMF_MARGIN_FACTOR \* (\S+);", TABLE)}
"""Margins relative to the scale of a unit: of what counts as zero, and of rounding errors."""
