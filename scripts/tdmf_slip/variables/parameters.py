"""Parameter files: start values by variable name, in TOML or JSON."""

import json
import os
import re
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, Protocol, TypeAlias

from ..checks import near_matches, path_of, shown
from ..errors import InputError, reason
from ..given import LabelledRow
from .table import ALIASES, Model, by_full_name
from .variable import Given


class HasStartValues(Protocol):
    """Object with start values, such as a Gait."""

    @property
    def start_values(self) -> Mapping[str, Any]:
        """Start values by the unit's names."""


RunnerLike: TypeAlias = (
    HasStartValues | Model | Mapping[str, Given] | LabelledRow | str | os.PathLike[str] | None
)
"""Anything that determines a runner: a Runner; a Gait, which has a runner; start values by the unit's names
and in its units, over the unit's own, also as a Series; a model that `load_model` gives; the name of a
preset; the path of a parameter file; or None, for the runner of the paper."""
RUNNER = "a Runner or Gait, start values by name, a preset's name or a parameter file's path"
"""Allowed runners, in words."""
MAX_PARTS = 16
"""Largest number of parts of a key, with dots between them; variables have three at the most."""
_PART = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*"""
DEEP_KEY = re.compile(rf"(?<![\w-]){_PART}(?:\.[ \t]*{_PART}){{{MAX_PARTS}}}")
"""The beginning of one with more parts."""
PRESETS = Path(__file__).parent / "presets"


def preset_names() -> list[str]:
    """Names of the files that come with the package."""
    return sorted(path.stem for path in PRESETS.glob("*.toml"))


def read_parameters(name: str | os.PathLike[str], aliases: Mapping[str, str] = ALIASES) -> dict[str, Any]:
    """Start values from a file, or from one of the package's presets, as `human` or `human.toml`.

    The keys are names of the unit's variables, either whole (`"leg.stiffness"`), nested by their groups
    (TOML's `leg.stiffness`, or a table `[leg]`) or short (`stiffness`); a value is a number in the variable's
    unit, or a text with a unit, such as `"40 deg"`. Names and values are checked where they are used.

    Examples
    --------
    >>> import tdmf_slip
    >>> human = tdmf_slip.read_parameters("human")
    >>> print(human["body.mass"], human["leg.stiffness"])
    75.1 20500.0
    """
    given = path_of(name, "parameters", "the path of a file, or a preset's name")
    path = _path_of(given)
    readers: Mapping[str, Callable[[str], object]] = {".toml": _loads_toml, ".json": loads_json}
    if path.suffix not in readers:
        raise InputError(
            f"parameters {shown(str(given))}: neither a preset ({', '.join(preset_names())}) "
            f"nor a .toml or .json file{near_matches(str(given), preset_names())}"
        )
    try:
        content = parsed(path.read_text(encoding="utf-8-sig"), readers[path.suffix], "names with values")
        once = _keys_once(list(_flat(content)))  # a name may be given whole and nested
        return by_full_name(once, f"parameters {path}", "names with values", aliases)
    except RecursionError:
        raise InputError(f"parameters {path}: is nested too deeply; allowed: names with values") from None
    except (OSError, ValueError) as problem:
        raise InputError(f"parameters {path}: {reason(problem)}") from None


def _path_of(given: Path) -> Path:
    """The preset's path where a preset is named; a file of the user's own goes before `human.toml`."""
    preset = PRESETS / f"{given.name.removesuffix('.toml')}.toml"
    names_one = str(given) == given.name and preset.is_file()
    return preset if names_one and not (given.suffix and given.is_file()) else given


def start_values_of(runner: object, aliases: Mapping[str, str] = ALIASES) -> Mapping[str, Any]:
    """Start values of a runner of the package's own models, given in any way."""
    _refuse_own(runner)
    if isinstance(runner, str | os.PathLike):
        return read_parameters(runner, aliases)
    own = getattr(runner, "start_values", None)  # of a Gait
    if isinstance(own, Mapping):
        return own
    return by_full_name(runner, "runner", RUNNER, aliases)


def _refuse_own(runner: object) -> None:
    """Refuse runners of a model of one's own where only the package's own models are known."""
    given = runner, getattr(runner, "model", None), getattr(getattr(runner, "runner", None), "model", None)
    own = next((one for one in given if getattr(one, "is_page", None)), None)
    if own is not None:
        name = getattr(own, "name", own)
        raise InputError(
            f"runner of the model {name}: this function takes only the package's own models; most others, "
            "such as find_gait, sweep, Batch, strides_to_fall and simulate, take any model"
        )


def parsed(text: str, loads: Callable[[str], object], allowed: str) -> Mapping[str, Any]:
    """The names and values of a text, which is to be what `allowed` says."""
    if not text.strip():
        raise ValueError(f"is empty; allowed: {allowed}")
    try:
        content = loads(text)
    except RecursionError:
        raise ValueError(f"is nested too deeply; allowed: {allowed}") from None
    if not isinstance(content, Mapping):
        raise ValueError(f"found {type(content).__name__}; allowed: {allowed}")
    return content


def loads_json(text: str) -> object:
    """Read JSON, in which no key may be given twice."""
    try:
        return json.loads(text, object_pairs_hook=_keys_once)
    except json.JSONDecodeError as problem:
        raise ValueError(f"is not JSON: {problem}") from None


def _loads_toml(text: str) -> object:
    """Read TOML by `tomllib`, but refuse keys of many parts: its time grows with their number squared."""
    long = DEEP_KEY.search(text)
    if long is not None:
        line = text.count("\n", 0, long.start()) + 1
        raise ValueError(f"line {line}: a key of more than {MAX_PARTS} parts; allowed: names of variables")
    return tomllib.loads(text)


def _keys_once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    for name, count in Counter(name for name, _ in pairs).items():
        if count > 1:
            raise ValueError(f"{shown(name)} is given twice; allowed: once")
    return dict(pairs)


def _flat(content: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    for key, value in content.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value
