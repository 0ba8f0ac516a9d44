"""Pages of equations: each is a model, from which C is derived by the language in c_core/hybrid."""

from .classic import ClassicSlip
from .reduced import PlainReducedRunner, ReducedRunner
from .runner import PlainRunner, Runner, RunnerOnOneLine

__all__ = ["ClassicSlip", "PlainReducedRunner", "PlainRunner", "ReducedRunner", "Runner", "RunnerOnOneLine"]
