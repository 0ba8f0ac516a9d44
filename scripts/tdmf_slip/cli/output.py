"""Results as they are printed."""

import json
import math
import os
import shutil
import sys


def json_text(value: object) -> str:
    """One line of JSON, in which a number that is not finite is null."""
    return json.dumps(_finite(value), allow_nan=False)


def program() -> str:
    """The command as it can be typed: its name if the shell finds it, else the path of this call."""
    name, called = "tdmf-slip", sys.argv[0]
    found = shutil.which(name)
    by_path = os.path.basename(called) == name and os.path.isfile(called)
    return called if by_path and not (found and os.path.samefile(found, called)) else name


def _finite(value: object) -> object:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
