"""Names that were replaced: whoever asks for an old one is told the name that it has now."""

from collections.abc import Mapping

NAMES: Mapping[str, str] = {
    "Orbit": "Gait",
    "OrderNotMetError": "TargetNotMetError",
    "Unit": "Fmu",
    "find_orbit": "find_gait",
    "load": "load_fmu",
}
"""Of the package, from the old to the new."""


def sentence(old: str, new: str) -> str:
    """What a user of an old name is told."""
    return f"{old} is called {new} now"
