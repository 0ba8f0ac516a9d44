"""All claims by section of the page of results, in the order of the page.

`claims.toml` has what each claim says; the module of its section computes and compares.
"""

import importlib
import importlib.resources
import tomllib
from collections.abc import Mapping

from .claim import OwnClaim


def _section(name: str, texts: Mapping[str, Mapping[str, str]]) -> tuple[OwnClaim, ...]:
    checks = importlib.import_module(f".{name}", __package__).CHECKS
    if list(checks) != list(texts):
        raise ValueError(f"claims.toml and {name}.py have different claims")
    return tuple(OwnClaim(of, text["claim"], text["command"], checks[of]) for of, text in texts.items())


TEXTS = tomllib.loads(importlib.resources.files(__package__).joinpath("claims.toml").read_text("utf-8"))
SECTIONS = {name: _section(name, texts) for name, texts in TEXTS.items()}
