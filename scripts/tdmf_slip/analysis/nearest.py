"""Where a target cannot be met: the gait that is nearest to it, and which further parameter would help.

The nearest gait has the least sum of squared deviations, each over what is prescribed: by the method of
Levenberg and Marquardt along the gaits, whose tangents are the null space of what closes a stride.
"""

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import RunError
from ..library.gait import Gait
from ..library.members import VARIED
from ..numerics.newton import GOOD_ENOUGH
from ..terminal.progress import progress_bar
from .target import Iterate, Target, null_space

ITERATIONS, LOOK_AHEAD = 30, 8
"""Of the search for the nearest gait, and to see whether a further parameter helps."""
LONGEST_STEPS = (0.3, 0.03)
"""Over the scales of apex and parameters, each tried: where words change, other steps lead elsewhere."""
MIN_DAMPING, MAX_DAMPING = 1e-9, 1e2
LITTLE = 1e-3
"""Of the gap: what a step makes it smaller by is then no more worth a further one."""
HELPING = 0.95
"""A parameter helps if, varied too, it leaves at most this share of the gap."""
MAX_TRIED, STEPS = 5, 10
"""Parameters whose derivatives promise most are tried, each by so many steps towards the target."""
SETTINGS = "hip."
"""What a runner changes at will: these are tried instead of a varied parameter, too."""
NOT_THE_RUNNERS = ("gravity",)
"""Not told as a help: nobody can turn it."""


def nearest_from(
    target: Target,
    iterates: Sequence[Iterate],
    steps: Sequence[float] = LONGEST_STEPS,
    iterations: int = ITERATIONS,
) -> Iterate:
    """The gait nearest to a target, of those that are reached from some gaits."""
    return min(
        (_descended(target, iterate, step, iterations) for iterate in iterates for step in steps),
        key=target.gap,
    )


def _descended(target: Target, iterate: Iterate, longest: float, iterations: int) -> Iterate:
    """Where the gap gets no smaller."""
    damping = 1e-3
    for _ in range(iterations):
        gap = target.gap(iterate)
        tried = _stepped(target, iterate, damping, longest)
        if tried is None or target.gap(tried) >= gap:
            damping *= 10.0
            if damping > MAX_DAMPING:
                break
            continue
        iterate, damping = tried, max(0.1 * damping, MIN_DAMPING)
        if target.gap(tried) <= GOOD_ENOUGH or gap - target.gap(tried) < LITTLE * gap:
            break
    return iterate


def _stepped(target: Target, iterate: Iterate, damping: float, longest: float) -> Iterate | None:
    """A step towards the target along the gaits; None where there is no gait."""
    count = len(target.closing(iterate))
    rows = target.rows(iterate)
    tangents = null_space(rows[:count])
    slopes = rows[count:] @ tangents
    square = slopes.T @ slopes + damping * np.eye(tangents.shape[1])
    step = tangents @ np.linalg.solve(square, -slopes.T @ target.deviations(iterate))
    step *= min(1.0, longest / (float(np.linalg.norm(step)) or 1.0))
    try:
        return target.closed_near(iterate.at + step)
    except RunError:
        return None


@dataclass(frozen=True)
class Help:
    """A parameter that brings a target nearer, or meets it."""

    name: str
    """Of the parameter or input."""
    instead_of: str
    """Which varied parameter then keeps its value; empty where all of them vary."""
    left: float
    """Of the gap; 0 where the target is met."""
    changed: float
    """How far the gait that meets the target is from the first, over the scales."""

    def __str__(self) -> str:
        """Advice and its effect, in parentheses."""
        how = f"instead of {self.instead_of}" if self.instead_of else "too"
        return f"vary {self.name} {how} ({'meets the target' if self.left == 0.0 else 'comes nearer'})"


def parameters_that_help(
    target: Target, nearest: Iterate, first: Gait, progress: bool = False
) -> tuple[Help, ...]:
    """Parameters and inputs that bring the target nearer, each varied beside the others or instead of one.

    Those whose derivatives promise most, at the nearest gait or at the first one, are varied one by one from
    the first gait on, as a user who varies them begins. Those are named with which the target is met, or a
    gait is found that is nearer to it.
    """
    maximum, near = HELPING * target.gap(nearest), target.gait(nearest)
    promising = _promising(target, (near, first))
    found: list[Help] = []
    with progress_bar("what would help", len(promising), "parameters", progress) as bar:
        for name in promising:
            more = _with_one_more(target, name, first, near, maximum)
            others = target.vary if name.startswith(SETTINGS) else ()
            instead = (_with_one_instead(target, name, other, first) for other in others)
            one = more if more.left == 0.0 else next((help for help in instead if help.left == 0.0), more)
            found += [one] if one.left <= maximum else []
            bar.update()
    return tuple(sorted(found, key=lambda help: (help.left, help.changed)))


def _with_one_more(target: Target, name: str, first: Gait, near: Gait, maximum: float) -> Help:
    """What is left of the gap where one more parameter varies."""
    wider = target.with_more(name)
    try:
        begin = wider.iterate_of(first)
        there, share = wider.solved_from(begin, STEPS)
        if wider.gap(there) > maximum:
            there = nearest_from(wider, (wider.iterate_of(near),), LONGEST_STEPS[:1], LOOK_AHEAD)
    except RunError:
        return Help(name, "", np.inf, np.inf)
    changed = float(np.linalg.norm(there.at - begin.at))
    return Help(name, "", 0.0 if share == 1.0 else wider.gap(there), changed)


def _with_one_instead(target: Target, name: str, other: str, first: Gait) -> Help:
    """Whether the target is met where one parameter varies instead of another."""
    changed = target.with_one_for(other, name)
    try:
        begin = changed.iterate_of(first)
        there, share = changed.solved_from(begin)
    except RunError:
        share = 0.0
    if share < 1.0:
        return Help(name, other, np.inf, np.inf)
    return Help(name, other, 0.0, float(np.linalg.norm(there.at - begin.at)))


def _promising(target: Target, gaits: Sequence[Gait]) -> list[str]:
    """Further parameters, those first of which derivatives promise that they leave least of the gap."""
    values = gaits[0].runner
    names = [name for name in VARIED if name not in (*target.vary, *NOT_THE_RUNNERS) and values[name] != 0.0]
    widest = target.with_more(*names)
    left = dict.fromkeys(names, np.inf)
    for gait in gaits:
        with contextlib.suppress(RunError):
            iterate = widest.iterate_of(gait)
            kept = list(range(len(gait.apex) + len(target.vary)))
            for further, name in enumerate(names, len(kept)):
                left[name] = min(left[name], _promised(widest, iterate, [*kept, further]))
    return sorted(names, key=lambda name: left[name])[:MAX_TRIED]


def _promised(target: Target, iterate: Iterate, columns: list[int]) -> float:
    """The share of the gap that is left after the longest step, along gaits, by some of what is varied."""
    off, count = target.deviations(iterate), len(target.closing(iterate))
    rows = target.rows(iterate)[:, columns]
    tangents = null_space(rows[:count])
    slopes = rows[count:] @ tangents
    step = -np.linalg.lstsq(slopes, off)[0]
    step *= min(1.0, LONGEST_STEPS[0] / (float(np.linalg.norm(step)) or 1.0))
    return float(np.linalg.norm(off + slopes @ step) / np.linalg.norm(off))
