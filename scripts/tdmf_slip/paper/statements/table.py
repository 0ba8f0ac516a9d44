"""All claims by section of the page of results, in the order of the page.

`claims.toml` has what each claim says; the modules beside it compute and compare.
"""

import importlib.resources
import tomllib

from . import gaits, regions, rough_ground
from .claim import Check, OwnClaim

TEXTS = tomllib.loads(importlib.resources.files(__package__).joinpath("claims.toml").read_text("utf-8"))
CHECKS: dict[str, dict[str, Check]] = {**gaits.CHECKS, **regions.CHECKS, **rough_ground.CHECKS}
SECTIONS = {
    section: tuple(
        OwnClaim(name, text["claim"], text["command"], CHECKS[section][name]) for name, text in texts.items()
    )
    for section, texts in TEXTS.items()
}
