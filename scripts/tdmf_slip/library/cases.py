"""What runners of the ensemble engine are given: parameters, gaits, ground and a law."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind
from ..contents import ByContents
from ..errors import InputError
from ..given import numbers_by, numbers_of
from .affine_law import AffineLaw, check_law
from .binding import ffi
from .maps import refuse_patch
from .rough_ground import RoughGround
from .runner import Runner
from .section import COORDINATES, Apex
from .structs import Struct

CONSTANT_ON_TERRAIN = ("ground.height", "ground.slope", "body.external_fx", "body.external_fy")
"""What no law sets on a terrain."""
LARGEST = 1e100
"""Of a ball's numbers: beyond, the library refuses them."""


@dataclass(frozen=True, eq=False)
class Case(ByContents):
    """Whose parameters runners have, and what they may settle on.

    Start values by name stand for the runner that they make.
    """

    runner: Runner
    """Parameters and inputs."""
    gaits: Sequence[Apex] | NDArray[np.float64] = field(default=())
    """Apices, shape (gaits, n); without any, runners make the most strides or fall."""

    ground: RoughGround = field(default_factory=RoughGround)
    """Rough or, by default, level, or as the runner's inputs say."""

    law: AffineLaw | None = None
    """By which settings are made anew at each apex, the start's too; by default none are."""

    balls: Sequence[NDArray[np.float64]] = field(default=())
    """One for each gait, shape (n, n): a runner has settled, too, where `|ball (apex - gait)| <= 1`."""

    def __post_init__(self) -> None:
        """Make the runner; refuse gaits that are none, and a law that does not fit the runner."""
        object.__setattr__(self, "runner", Runner(self.runner))
        check_kind(self.ground, RoughGround, "ground", "a RoughGround")
        self.ground.check_runner(self.runner, self.runner.scales)
        gaits = numbers_by("gaits", self.gaits, self.runner.coordinates)
        object.__setattr__(self, "gaits", np.atleast_1d(gaits))
        check_law(self.law, self.runner)
        if len(self.gaits) or self.runner.reduced:
            refuse_patch(self.runner)
        if len(self.gaits) and self.ground.segment_length:
            raise InputError(
                f"gaits on a terrain (segment_length = {self.ground.segment_length:g} m), where no apex "
                "comes back; allowed: one of the two"
            )
        if self.law is not None and self.ground.segment_length:
            _check_keeps_terrain(self.law)
        if len(self.balls) not in (0, len(self.gaits)):
            raise InputError(f"balls: {len(self.balls)}; allowed: none, or one for each of the gaits")


def _check_keeps_terrain(law: AffineLaw) -> None:
    for name in law.inputs:
        if name in CONSTANT_ON_TERRAIN:
            raise InputError(f"law sets {name} on a terrain (segment_length); allowed: it sets others")


def check_alike(cases: Sequence[Case]) -> None:
    """Refuse cases that the engine does not run together."""
    reduced = cases[0].runner.reduced
    if any(case.runner.reduced != reduced for case in cases):
        raise InputError("cases: by the full model and by the reduced map; allowed: all by one of them")
    if reduced and any(case.ground.is_drawn for case in cases):
        raise InputError("cases: on rough ground by the reduced map; allowed: by the full model")


def c_cases(cases: Sequence[Case], max_strides: int, near: float) -> tuple[Struct, list[object]]:
    """The cases as the library takes them, and what has to live as long."""
    made = ffi.new("tdmf_ensemble_case[]", len(cases))
    kept: list[object] = []
    for case, its in zip(cases, made, strict=True):
        coordinates = case.runner.coordinates
        gaits = case.gaits if len(case.gaits) else np.empty((0, len(coordinates)))
        apices = sections_of("gaits", gaits, coordinates)
        if not np.isfinite(apices).all():
            raise InputError(f"gaits: {apices.tolist()}: allowed: finite numbers")
        c_gaits = ffi.new("double[][6]", apices.tolist())
        its.model, its.inputs = case.runner.c_model, case.runner.c_inputs[0]
        its.rules.gaits, its.rules.gait_count = c_gaits, len(case.gaits)
        its.rules.distance, its.rules.max_strides = near, max_strides
        kept += [c_gaits, case.runner, *case.ground.write(its.rules)]
        if len(case.balls):
            c_balls = _c_balls(case.balls, len(coordinates))
            its.rules.balls = c_balls
            kept.append(c_balls)
        if case.law is not None:
            c_law, arrays = case.law.c_law()
            its.rules.law = c_law
            kept += [c_law, arrays]
    return made, kept


def _c_balls(balls: Sequence[NDArray[np.float64]], coordinates: int) -> Any:
    made: Any = ffi.new("tdmf_ball[]", len(balls))
    for ball, c_ball in zip(balls, made, strict=True):
        matrix = numbers_of("balls", ball)
        if matrix.shape != (coordinates, coordinates) or not np.all(np.abs(matrix) <= LARGEST):
            raise InputError(
                f"balls: of shape {matrix.shape}; allowed: {coordinates} by {coordinates}, up to {LARGEST:g}"
            )
        for i, row in enumerate(matrix.tolist()):
            c_ball.matrix[i][0:coordinates] = row
    return made


def sections_of(name: str, given: object, coordinates: Sequence[str]) -> NDArray[np.float64]:
    """Apices one to a row, with zeros for the coordinates that the reduced map has not."""
    apices = np.ascontiguousarray(numbers_by(name, given, coordinates))
    if apices.ndim != 2 or apices.shape[1] != len(coordinates):
        raise InputError(f"{name} of shape {apices.shape}: allowed: rows of {', '.join(coordinates)}")
    if len(coordinates) == len(COORDINATES):
        return apices
    sections = np.zeros((len(apices), len(COORDINATES)))
    sections[:, : len(coordinates)] = apices
    return sections
