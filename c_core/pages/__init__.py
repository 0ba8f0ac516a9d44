"""Pages of equations: each is a model, from which C is derived by the language in c_core/hybrid."""

from .classic import ClassicSlip
from .hip import PLACE
from .reduced import PlainReducedRunner, ReducedRunner
from .runner import PlainRunner, Runner, RunnerOnOneLine

__all__ = [
    "PLACE",
    "ClassicSlip",
    "PlainReducedRunner",
    "PlainRunner",
    "ReducedRunner",
    "Runner",
    "RunnerOnOneLine",
]
