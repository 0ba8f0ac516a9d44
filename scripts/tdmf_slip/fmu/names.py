"""Names of variables as users give them: the unit's own, or the short ones of `aliases.ALIASES`."""

from collections.abc import Mapping
from typing import Any

from ..errors import InputError
from ..given import mapping_of, row_of
from .aliases import ALIASES

SHORT_NAMES: Mapping[str, str] = {full: short for short, full in ALIASES.items()}
"""From the unit's own name to the short one."""


def full_name(name: Any) -> Any:
    """The unit's own name for a short one; anything else as it is, for others to check."""
    return ALIASES.get(name, name) if isinstance(name, str) else name


def full_names(given: object, what: str, allowed: str) -> tuple[Any, ...]:
    """The unit's own names for names in a row."""
    return tuple(map(full_name, row_of(given, what, allowed)))


def by_full_name(given: object, what: str, allowed: str) -> dict[Any, Any]:
    """What is given by name, by the unit's own names; a name may not be given both ways."""
    found: dict[Any, Any] = {}
    for name, value in mapping_of(given, what, allowed).items():
        full = full_name(name)
        if full in found:
            raise InputError(f"{what}: {full} and {SHORT_NAMES[full]} are the same; allowed: one of them")
        found[full] = value
    return found
