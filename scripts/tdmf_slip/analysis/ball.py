"""Balls of attraction, the fates of starts near a gait, and gaits under a law.

A start that comes into a ball of attraction settles on the gait, so that it need not be followed. Near
the gait a stride is its Jacobian J. Let l be the left eigenvector of the largest eigenvalue and Q the
projection that takes its part away. Then the form

    P = l l' + Q' (sum over k of (J^k)' J^k / g^(2k)) Q / r^2

falls each stride, by that eigenvalue squared in its first part and by g^2 in its second (Lyapunov). With
several g and widths r, how far from the gait the norm sqrt(x' P x) still falls, over two strides, is
tried from points of the surface and of shells inside; x is over the section's scales. The ball ends
inside the tested surface, because a start that falls may lie between two points of it.
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import is_one_of, refusal
from ..errors import InputError, counted
from ..library.batch import NEAR, Batch
from ..library.gait import Gait, check_is_gait
from ..library.laws import AffineLaw, Law, check_law, is_noisy, numbers_up_to
from ..library.return_map import stride_from
from ..library.runner import Runner
from ..library.settings import setting_number
from ..library.tables import Table
from ..variables.parameters import RunnerLike
from ..variables.table import by_full_name
from .search import periodic_gait

SAME = 1e-6
"""Largest difference of a setting from the gait's at its apex, over the larger of the setting and 1."""
DIFFERENCE = 1e-5
"""Step of differences, over the scales."""
ROUNDS = 20
"""Largest number of gaits that are tried, each with the law's settings at the gait before."""
POINTS = 10_000
"""Points on which a ball is tested."""
SHELLS = tuple(0.1 * k for k in range(1, 10))
"""Radii of inner shells over the ball's. Each gets a twentieth of the points, the surface gets the rest."""
FIRST_POINTS = 500
"""Points that are tried before a radius is tested on all of them."""
RADII = tuple(0.6 * 2.0 ** (-k / 6) for k in range(30))
"""Radii that are tried, in the form's norm, which measures the slowest part: from 0.6 of the scales."""
INSIDE = 0.9
"""The ball's radius over that of the tested surface."""
WIDTHS = ((0.3, 1.5), (0.3, 2.5), (0.7, 1.5))
"""Forms that are tried: the share of the way from the second largest eigenvalue to 1 at which g is, and r."""
MARGIN = 0.75
"""Share of the way from the largest eigenvalue to 1: the norm has to fall below it in a stride."""
STRIDES = 2
"""Strides after which the norm is compared. The first may raise it for a start at another height."""
TOLERANCE = 1e-5
"""Relative tolerance of a step, as of maps and volumes."""
CHOICES = ("tested", "none")
"""Choices without a ball of one's own; with `none` a start is followed until it is near the gait."""
ACCURACY = 5e-4
"""Largest error of the apex after a stride, over the scales, from anywhere in `attraction.BOX`;
from within 0.05 of a gait by a twentieth of that. Of 24,576 starts none has another fate than at 1e-10."""
MAX_STRIDES = 400
MAX_ALONG = 16384
"""Largest number of starts along each axis of a map."""
STARTS_AT_ONCE = 4096
"""Largest number of starts in a block."""


def jacobian_under(gait: Gait, law: Law) -> NDArray[np.float64]:
    """The Jacobian of a gait's return map under a law that sets at each apex.

    That of an affine law within its limits is exact: the map's own, plus for each setting the next apex's
    change by it times its gain. That of a function is by central differences.
    """
    check_law(law, gait.runner)
    if isinstance(law, AffineLaw):
        jacobian = gait.jacobian.copy()
        for name, gain in zip(law.inputs, np.asarray(law.gain), strict=True):
            jacobian += np.outer(stride_from(gait.runner, gait.apex, name)[2], gain)
        return jacobian
    steps = DIFFERENCE * np.diag(gait.runner.scales)
    starts = gait.apex + np.concatenate([steps, -steps])
    run = Batch(gait.runner, starts, law=law, tolerance=gait.runner.tolerance).run(1)
    if (run.strides != 1).any():
        raise InputError(
            "law: strides from beside the gait's apex do not close; allowed: a law under which they do"
        )
    up, down = np.split(run.apex, 2)
    differences: NDArray[np.float64] = ((up - down) / (2.0 * DIFFERENCE * gait.runner.scales)[:, None]).T
    return differences


def check_attracts(gait: Gait, law: Law | None) -> None:
    """Refuse a law that changes the gait, or under which the gait is unstable and attracts nothing."""
    check_is_gait(gait, "gait")
    check_law(law, gait.runner)
    if law is None:
        return
    if gait.strides > 1:
        raise InputError(f"law: the gait takes {gait.strides} strides; allowed: a gait of one stride")
    for name, value in _changed(gait, law).items():
        raise InputError(
            f"law: {name} = {value:g} at the gait's apex, where the runner has {gait.runner[name]:g}; "
            "allowed: the same"
        )
    largest = float(np.max(np.abs(np.linalg.eigvals(jacobian_under(gait, law)))))
    if not largest < 1.0:
        raise InputError(
            f"law: under it the gait at friction {gait.friction:g} is unstable, with a largest eigenvalue of "
            f"{largest:.6g}: it attracts nothing; allowed: below 1"
        )


def _changed(gait: Gait, law: Law) -> dict[str, float]:
    """Settings of a law at a gait's apex that differ from those of the gait's runner."""
    quiet = replace(law, noise=None) if isinstance(law, AffineLaw) else law
    given = by_full_name(quiet(gait.apex[None], 0), "law: what it gives", "numbers or arrays by name")
    changed = {}
    for name, values in given.items():
        setting_number(name, "law")
        value, usual = float(numbers_up_to(f"law: {name}", values, 1).ravel()[0]), gait.runner[name]
        if not abs(value - usual) <= SAME * max(1.0, abs(usual)):
            changed[name] = value
    return changed


def stable_gait(runner: RunnerLike, law: Law | None = None) -> Gait:
    """The stable gait of a runner, or the gait that a law leaves unchanged.

    Near the apex of an affine law the runner has this gait. Under a function the runner has at the gait the
    settings that the function gives there; a gait with them is searched for in rounds.
    """
    runner = Runner(runner)
    check_law(law, runner)
    gait = periodic_gait(runner, guess=law.apex if isinstance(law, AffineLaw) else None)
    if law is None:
        if not gait.stable:
            raise InputError(f"the gait at friction {gait.friction:g} is unstable: it attracts nothing")
        return gait
    if not isinstance(law, AffineLaw):
        for _ in range(ROUNDS):
            changed = _changed(gait, law)
            if not changed:
                break
            for name, value in changed.items():
                runner = runner.replace({name: value})
            gait = periodic_gait(runner, guess=gait.apex)
    check_attracts(gait, law)
    return gait


@dataclass(frozen=True, eq=False)
class Ball:
    """Apices around a gait's from which every run settles on it."""

    known: str
    """Evidence: `tested` at points, or `proved`."""
    radius: float
    """Every apex no farther from the gait's in any coordinate, in units of the scales, is inside."""
    rate: float
    """Largest ratio of the norm after a stride to that before; of a tested ball the mean of two strides."""
    points: int
    """Number of points on which it was tested; 0 for a proved ball."""
    matrix: NDArray[np.float64]
    """Shape (n, n): an apex is inside where ``|matrix (apex - gait)| <= 1``."""
    tolerance: float = TOLERANCE
    """Relative tolerance of a step by which runs come into the ball."""
    near: float = NEAR
    """Distance from the gait, over the scales, at which a run counts as settled without the ball."""


def saves_time(gait: Gait, starts: int) -> bool:
    """True if a tested ball is likely to save more strides than its test takes."""
    slowest = min(max(gait.lambda_max, 1e-3), 1.0 - 1e-9)
    saved = math.log(0.1 / NEAR) / -math.log(slowest)
    return 0.5 * starts * saved > STRIDES * (POINTS + FIRST_POINTS * len(WIDTHS) * 10)


def tested_ball(gait: Gait, law: Law | None = None) -> Ball | None:
    """The largest tried ball in which the norm falls from every test point; None if there is none."""
    if gait.strides > 1 or is_noisy(law):
        return None
    scales = np.asarray(gait.runner.scales)[: len(gait.apex)]
    jacobian = gait.jacobian if law is None else jacobian_under(gait, law)
    largest = float(np.max(np.abs(np.linalg.eigvals(jacobian))))
    if not largest < 1.0:
        return None
    maximum = largest + MARGIN * (1.0 - largest)
    forms = [root / scales for root in _roots_of_forms(jacobian * scales / scales[:, None])]
    points = _points(len(scales))
    some = points[:: POINTS // FIRST_POINTS]
    for radius in RADII:
        for form in forms:
            if _rate(gait, law, form, radius * some) > maximum:
                continue
            rate = _rate(gait, law, form, radius * points)
            if rate <= maximum:
                matrix = form / (INSIDE * radius)
                return Ball("tested", cube_in(matrix * scales), rate, POINTS, matrix)
    return None


def _rate(gait: Gait, law: Law | None, form: NDArray[np.float64], points: NDArray[np.float64]) -> float:
    """The largest ratio of a norm in a stride from points around a gait; infinite if one does not close."""
    starts = gait.apex + np.linalg.solve(form, points.T).T
    run = Batch(gait.runner, starts, law=law, tolerance=TOLERANCE).run(STRIDES)
    if (run.strides != STRIDES).any():
        return math.inf
    after = (run.apex - gait.apex) @ form.T
    ratio = np.max(np.linalg.norm(after, axis=1) / np.linalg.norm(points, axis=1))
    return float(ratio ** (1.0 / STRIDES))


def _roots_of_forms(jacobian: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Matrices R whose R'R are the forms; empty where the Jacobian has no such eigenvector."""
    from scipy.linalg import solve_discrete_lyapunov  # slow to load

    values, right = np.linalg.eig(jacobian)
    order = np.argsort(-np.abs(values))
    slow, size = order[0], len(values)
    paired = bool(values[slow].imag)
    second = float(np.abs(values[order[1 + paired]]))

    def sum_of_powers(rate: float) -> NDArray[np.float64]:
        """The sum over k of (J^k)' J^k / rate^(2k) for the rest of the Jacobian."""
        summed: NDArray[np.float64] = solve_discrete_lyapunov((jacobian @ rest / rate).T, np.eye(size))
        return summed

    try:
        left = np.linalg.inv(right)[slow]
        rest = np.eye(size) - (1 + paired) * np.outer(right[:, slow], left).real
        both = np.stack([left.real, left.imag])
        forms = [
            both.T @ both + rest.T @ sum_of_powers(second + share * (1.0 - second)) @ rest / width**2
            for share, width in WIDTHS
        ]
        return [np.linalg.cholesky(form).T for form in forms]
    except np.linalg.LinAlgError:
        return []


def _points(coordinates: int) -> NDArray[np.float64]:
    """Points of the unit ball's surface and of shells inside; the same each time."""
    drawn = np.random.default_rng(0).normal(size=(POINTS, coordinates))
    radii = np.tile((*SHELLS, *[1.0] * (20 - len(SHELLS))), POINTS // 20)
    points: NDArray[np.float64] = drawn * (radii / np.linalg.norm(drawn, axis=1))[:, None]
    return points


def cube_in(matrix: NDArray[np.float64]) -> float:
    """Half the edge of the largest cube in a ball."""
    corners = np.array(list(itertools.product((-1.0, 1.0), repeat=len(matrix))))
    return 1.0 / float(np.max(np.linalg.norm(corners @ matrix.T, axis=1)))


def ball_of(gait: Gait, choice: Ball | str, starts: int, law: Law | None = None) -> Ball | None:
    """The ball that is asked for; a tested one only where it saves more than it costs."""
    if isinstance(choice, Ball):
        if choice.matrix.shape != (len(gait.apex),) * 2:
            raise InputError(
                f"ball: has {counted(len(choice.matrix), 'coordinate')}; "
                f"allowed: {len(gait.apex)}, as the gait"
            )
        return choice
    if not is_one_of(choice, CHOICES):
        raise refusal("ball", choice, f"{', '.join(CHOICES)}, or a Ball")
    return tested_ball(gait, law) if choice == "tested" and saves_time(gait, starts) else None


def attributes_of(ball: Ball | None) -> dict[str, str | float | int]:
    """Attributes of a result that describe its ball, or say that it has none."""
    if ball is None:
        return {"ball": "none"}
    return {
        "ball": ball.known,
        "ball_radius": ball.radius,
        "ball_rate": ball.rate,
        "ball_points": ball.points,
    }


def starts_at(
    point: NDArray[np.float64], columns: Sequence[int], values: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Copies of a point of the section with other values of some coordinates, shape (starts, columns)."""
    starts = np.tile(point, (len(values), 1))
    starts[:, columns] = values
    return starts


def fates(
    gait: Gait,
    starts: ArrayLike,
    *,
    law: Law | None = None,
    ball: Ball | None = None,
    tolerance: float = TOLERANCE,
    first_number: int = 0,
) -> Table:
    """Fates of runners, one for each row of starts, by the names of `Batch.run`.

    A law's noise is drawn by the numbers of the runners, which count from `first_number`. A runner that
    enters the gait's ball has settled. A ball may require a finer tolerance.
    """
    tolerance = tolerance if ball is None else min(tolerance, ball.tolerance)
    batch = Batch(gait.runner, starts, law=law, first_number=first_number, tolerance=tolerance)
    near, balls = (NEAR, None) if ball is None else (ball.near, ball.matrix[None])
    return batch.run(MAX_STRIDES, gait.apex, near=near, balls=balls)
