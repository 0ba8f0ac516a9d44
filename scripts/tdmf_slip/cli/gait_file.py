"""Where a run begins: the gait that `tdmf-slip gait --json` printed."""

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..errors import InputError, reason
from ..variables.parameters import loads_json, parsed

BYTE_ORDER_MARK = "\ufeff"
"""Byte-order mark with which Windows editors and shells begin a text."""
GAIT = "what `tdmf-slip gait --json` prints"


def read_gait(name: str) -> dict[str, Any]:
    """Start values of a run on a gait, from what `tdmf-slip gait --json` prints."""
    where = "standard input" if name == "-" else name
    try:
        if name == "-" and sys.stdin is None:
            raise ValueError("is closed")
        text = sys.stdin.read() if name == "-" else Path(name).read_text(encoding="utf-8")
        text = text.removeprefix(BYTE_ORDER_MARK)
        content = parsed(text, loads_json, GAIT)
    except (OSError, ValueError) as problem:
        raise InputError(f"gait of {where}: {reason(problem)}") from None
    starts = content.get("start_values")
    if not isinstance(starts, Mapping):
        raise InputError(f"gait of {where}: has no start_values; allowed: {GAIT}")
    return dict(starts)
