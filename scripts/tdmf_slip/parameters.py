"""Parameter files: start values by variable name, in TOML or JSON."""

import json
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path

from .errors import InputError

PRESETS = Path(__file__).parent / "presets"


def preset_names() -> list[str]:
    """Names of the files that come with the package."""
    return sorted(path.stem for path in PRESETS.glob("*.toml"))


def read_parameters(name: str | Path) -> dict[str, object]:
    """Start values from a file, or from one of the package's presets.

    The keys are names of the unit's variables, either whole (`"leg.stiffness"`) or nested by their groups
    (TOML's `leg.stiffness`, or a table `[leg]`); a value is a number in the variable's unit, or a text with
    a unit, such as `"40 deg"`. Names and values are checked where they are used.

    Args:
        name: path of a .toml or .json file, or a preset's name.

    Raises:
        InputError: neither, unreadable, or not such a file.
    """
    path = PRESETS / f"{name}.toml" if str(name) in preset_names() else Path(name)
    readers = {".toml": tomllib.loads, ".json": _loads_json}
    if path.suffix not in readers:
        raise InputError(
            f"parameters {name}: neither a preset ({', '.join(preset_names())}) nor a .toml or .json file"
        )
    try:
        content = readers[path.suffix](path.read_text(encoding="utf-8"))
    except RecursionError:
        raise InputError(f"parameters {path}: nested too deeply; allowed: groups of variables") from None
    except (OSError, ValueError) as problem:  # TOMLDecodeError and JSONDecodeError are ValueErrors
        raise InputError(f"parameters {path}: {problem}") from problem
    if not isinstance(content, dict):
        raise InputError(f"parameters {path}: found {type(content).__name__}; allowed: names with values")
    try:
        return _keys_once(list(_flat(content)))  # a name may be given whole and nested
    except ValueError as problem:
        raise InputError(f"parameters {path}: {problem}") from None


def _loads_json(text: str) -> object:
    """As TOML, without leave to give a key twice."""
    return json.loads(text, object_pairs_hook=_keys_once)


def _keys_once(pairs: list[tuple[str, object]]) -> dict[str, object]:
    names = [name for name, _ in pairs]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ValueError(f"{twice} is given twice; allowed: once")
    return dict(pairs)


def _flat(content: Mapping[str, object], prefix: str = "") -> Iterator[tuple[str, object]]:
    for key, value in content.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value
