"""The statements of Or and Moravia (2016) in sections 2 to 5, each with the comparison that decides on it."""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pandas

from ..errors import counted
from ..library import classic_slip
from .along import words_over
from .claims import WORDS, Claim, Finding, both_readings
from .evidence import LEAST_FRICTION, LEG_ANGLE, SLIP_ANGLE, Evidence, lowest_stable_angle, touchdown_angle

STABLE_ANGLES = (40.0, 44.0)
"""Touchdown angles with stable gaits, about, degrees."""
STANCE_FRICTION, IMPACT_FRICTION = 0.84, 4.5
"""Friction that the gait at 40 degrees needs in stance and at the impact."""
NEAR_ANGLE = 1.0
"""Degrees within which two angles agree."""


def classic_claims() -> list[Claim]:
    """The statements about stable gaits of the classic SLIP, and the friction that one of them needs."""
    stable, *_ = classic_slip.classic_gaits(math.radians(SLIP_ANGLE))
    lowest, fold = (math.degrees(at) for at in (lowest_stable_angle(), classic_slip.classic_fold().angle))
    low, high = STABLE_ANGLES
    near = abs(lowest - low) < NEAR_ANGLE and abs(fold - high) < NEAR_ANGLE
    range_of_angles = both_readings(f"{lowest:.1f}° to {fold:.2f}°", near)
    found = [
        Claim(
            "SLIP: touchdown angles with a stable gait",
            f"small range around {low:g}° to {high:g}°",
            range_of_angles,
            "2",
        )
    ]
    for when, published, needed, digits in (
        ("in stance", STANCE_FRICTION, stable.stance_friction, 3),
        ("at impact", IMPACT_FRICTION, stable.impact_friction, 2),
    ):
        agrees = abs(needed - published) < 5.0 * 0.1**digits
        what = f"SLIP at {SLIP_ANGLE:g}°: friction needed {when}"
        finding = both_readings(f"mu > {needed:.{digits}f}", agrees)
        found.append(Claim(what, f"mu > {published:g}", finding, "3.2"))
    return found


BEST_FRICTION, SPEED_GAIN, COST_GAIN = 0.5, 12.0, -25.0
"""Friction at which the paper's runner is fastest and cheapest, and its gains over friction 10, per cent."""
SHARP_BELOW = 0.2
"""Friction below which the paper's speed drops sharply."""
ROUGHLY = 2.0
"""Per cent by which a value may be off a rough figure of the paper and agree."""
NEAR_FRICTION = 0.02
"""Distance from a rough friction of the paper at which a friction agrees."""
TINY, COUNT = 1e-2, 4
"""Bound of the eigenvalues that the paper calls very small, and how many of seven it has."""
ROUNDING = 1e-8
"""Change of an eigenvalue that counts as rounding."""
NARROW = 1.001
"""Ratio of two borders of friction that are too close for the paper to have seen the word between them."""


Judge = Callable[[Evidence], Finding]
"""Compares the evidence for one reading with a statement."""
STATEMENTS: list[tuple[Claim, Judge]] = []
"""The statements about the paper's runner, and the comparison that decides on each in one reading."""


def statement(where: str, what: str, published: str, **kind: Any) -> Callable[[Judge], Judge]:
    """Decorator of the function that judges a statement, which it adds to the list.

    `where` is the section of the paper.
    """

    def add(judge: Judge) -> Judge:
        STATEMENTS.append((Claim(what, published, {}, where, **kind), judge))
        return judge

    return add


def claims(evidence: Mapping[str, Evidence]) -> list[Claim]:
    """All statements of the paper, in its order."""
    found = [
        replace(claim, computed={reading: judge(of_reading) for reading, of_reading in evidence.items()})
        for claim, judge in STATEMENTS
    ]
    return [*classic_claims(), *found]


@statement("4", "(11) as printed, torque +tau0 in stance", "injects energy", misprint=True)
def _printed_torque(evidence: Evidence) -> Finding:
    search = evidence.printed_torque
    if search.gaits:
        return Finding("+tau0: a gait", True)
    return Finding(f"+tau0: no gait from {search.starts:,} starts; -tau0: gaits", False)


@statement("4", "slip before lift-off", "in every gait")
def _slips_last(evidence: Evidence) -> Finding:
    slips = evidence.gaits["word"].str[-1].isin(["+", "-"])
    return Finding(f"in {slips.sum()} of {counted(len(slips), 'gait')}", bool(slips.all()))


@statement("4", "trajectories", "quite similar to the SLIP's")
def _leg_at_apex(evidence: Evidence) -> Finding:
    angles = [math.degrees(gait.apex[LEG_ANGLE]) for gait in evidence.five]
    return Finding(f"leg at {min(angles):.0f}° to {max(angles):.0f}° at the apex", max(angles) < 0.0)


@statement("5.1", "words at mu = 10, 1.2, 0.6, 0.43, 0.2", ", ".join(WORDS.values()))
def _five_words(evidence: Evidence) -> Finding:
    words = [gait.word for gait in evidence.five]
    return Finding(", ".join(words), words == list(WORDS.values()))


@statement("5.1", "words as mu falls", ", ".join(WORDS.values()))
def _word_sequence(evidence: Evidence) -> Finding:
    words = [word for word, high, low in words_over(evidence.sweep) if high > NARROW * low]
    return Finding(", ".join(words), words == list(WORDS.values()))


@statement("5.1", "a further word", "not reported", beyond=True)
def _sixth_word(evidence: Evidence) -> Finding:
    narrow = [one for one in words_over(evidence.sweep) if one[1] <= NARROW * one[2]]
    text = ", ".join(f"{word} from {high:.6f} to {low:.6f}" for word, high, low in narrow)
    return Finding(text or "none", not narrow)


@statement("5.1", "theta after lift-off, mu = 10", "converges to eta theta_LO")
def _leg_after_liftoff(evidence: Evidence) -> Finding:
    gait = evidence.five[0]
    angle = math.degrees(gait.apex[LEG_ANGLE])
    wanted = math.degrees(gait.runner["hip.liftoff_angle_factor"] * gait.liftoff_angle)
    return Finding(
        f"{angle:.2f}° at the apex, eta theta_LO = {wanted:.2f}°", abs(angle - wanted) < NEAR_ANGLE
    )


@statement("5.1", "theta before touchdown, mu = 10", "converges to 40°")
def _leg_at_touchdown(evidence: Evidence) -> Finding:
    angle = math.degrees(touchdown_angle(evidence.five[0]))
    wanted = math.degrees(evidence.five[0].runner["hip.touchdown_angle"])
    return Finding(f"{angle:.2f}°", abs(angle - wanted) < NEAR_ANGLE)


@statement("5.1", "gaits below mu = 0.1", "none obtained", beyond=True)
def _low_gaits(evidence: Evidence) -> Finding:
    strides = evidence.settling
    how = "does not settle" if strides is None else f"settles in {counted(strides, 'stride')}"
    return Finding(f"down to mu = {LEAST_FRICTION:g}; simulation {how}", False)


@statement("5.2", "lambda_max", "< 1: stable")
def _stable(evidence: Evidence) -> Finding:
    values = evidence.gaits["lambda_max"]
    return Finding(f"{values.min():.4f} to {values.max():.4f}", bool(values.max() < 1.0))


@statement("5.2", "lambda_max as mu falls", "rises")
def _degrades(evidence: Evidence) -> Finding:
    values = evidence.gaits["lambda_max"]
    drops, first, last = -values.diff(), values.iloc[0], values.iloc[-1]
    text = f"{first:.4f} to {last:.4f}"
    if drops.max() > ROUNDING:
        text += f", but -{drops.max():.4f} at mu = {evidence.gaits['friction'][drops.idxmax()]:.2f}"
    return Finding(text, bool(drops.max() < 0.01 * (last - first)))


@statement("5.2", "word from mu = 7 to 2", "+0+")
def _cut_range(evidence: Evidence) -> Finding:
    word, high, low = next(one for one in words_over(evidence.sweep) if one[2] < 7.0)
    return Finding(f"{word} from {high:.2f} to {low:.2f}", word == "+0+" and high > 7.0 and low < 2.0)


@statement("5.2", "eigenvalues below mu = 0.3", "not computable", beyond=True)
def _low_eigenvalues(evidence: Evidence) -> Finding:
    gait = evidence.gaits.iloc[-1]
    return Finding(f"{gait['lambda_max']:.4f} at mu = {gait['friction']:g}", False)


@statement("5.2", "mu < 0.3, one coordinate of the apex off by 0.2 or less", "second impact after lift-off")
def _second_impacts(evidence: Evidence) -> Finding:
    count = evidence.further_touchdowns
    return Finding(f"{count or 'none'} in {counted(evidence.perturbed, 'stride')}", count > 0)


def _per_cent(evidence: Evidence, name: str) -> pandas.Series:
    """Changes of a quantity over its value at the highest friction."""
    values = evidence.gaits[name]
    return 100.0 * (values / values.iloc[0] - 1.0)


def _best(name: str, gain: float) -> Judge:
    """Compare the extreme change of a quantity over friction 10 with the paper's gain."""

    def judge(evidence: Evidence) -> Finding:
        changes = _per_cent(evidence, name)
        best = (np.sign(gain) * changes).idxmax()
        friction, change = evidence.gaits["friction"][best], changes[best]
        near = abs(friction - BEST_FRICTION) < NEAR_FRICTION and abs(change - gain) < ROUGHLY
        return Finding(f"{change:+.1f} % at mu = {friction:.2f}", bool(near))

    return judge


def _trend(
    name: str, sign: float, digits: int, *, low: bool = False, where: bool = False, steadily: bool = True
) -> Judge:
    """Compare the change of a quantity as friction falls to 0.5, or from there on, with the paper's sign.

    With `where` the text names the last friction. With `steadily` the quantity may not turn in between.
    """

    def judge(evidence: Evidence) -> Finding:
        rows = evidence.gaits[(evidence.gaits["friction"] < BEST_FRICTION) == low]
        first, last = rows[name].iloc[0], rows[name].iloc[-1]
        text = f"{first:.{digits}f} to {last:.{digits}f}"
        if where:
            text += f" at mu = {rows['friction'].iloc[-1]:g}"
        rises = (sign * rows[name]).is_monotonic_increasing if steadily else sign * last > sign * first
        return Finding(text, bool(rises))

    return judge


statement("5.2", "speed as mu falls to 0.5", "rises")(_trend("speed", 1.0, 4))
statement("5.2", "largest speed", f"≈ {SPEED_GAIN:+g} % at mu ≈ {BEST_FRICTION:g}")(
    _best("speed", SPEED_GAIN)
)


@statement("5.2", "speed below mu = 0.5", "drops, sharply below 0.2")
def _slower(evidence: Evidence) -> Finding:
    low = evidence.gaits[evidence.gaits["friction"] < BEST_FRICTION]
    steepness = low["speed"].diff() / low["friction"].diff()
    sharp = low["friction"] < SHARP_BELOW
    above, below = steepness[~sharp].mean(), steepness[sharp].mean()
    least, speed = low["friction"].iloc[-1], low["speed"].iloc[-1]
    return Finding(
        f"{speed:.3f} at mu = {least:g}; slope {below:.1f} below 0.2, {above:.1f} above",
        bool(low["speed"].is_monotonic_decreasing and below > above),
    )


@statement("5.2", "cost of transport with slip at impact", "below that without, at every mu")
def _cheaper(evidence: Evidence) -> Finding:
    slipping = _per_cent(evidence, "cost_of_transport")[evidence.gaits["word"].str.startswith("+")]
    text = f"lower in {sum(slipping < 0.0)} of {len(slipping)} gaits, by up to {-slipping.min():.1f} %"
    return Finding(text, bool(slipping.max() < 0.0))


statement("5.2", "step length as mu falls to 0.5", "increases")(_trend("length", 1.0, 1))
statement("5.2", "impact loss as mu falls to 0.5", "decreases")(
    _trend("impact_loss", -1.0, 4, steadily=False)
)
statement("5.2", "least cost of transport", f"≈ {COST_GAIN:+g} % at mu ≈ {BEST_FRICTION:g}")(
    _best("cost_of_transport", COST_GAIN)
)
statement("5.2", "cost of transport below mu = 0.5", "rises")(
    _trend("cost_of_transport", 1.0, 3, low=True, where=True)
)
statement("5.2", "step length below mu = 0.5", "decreases")(_trend("length", -1.0, 1, low=True))


@statement("5.2", "work W below mu = 0.5", "rises, by the dissipation of slip")
def _work(evidence: Evidence) -> Finding:
    work, lost = (_trend(name, 1.0, 4, low=True)(evidence) for name in ("work", "friction_loss"))
    return Finding(f"W {work.text}; friction {lost.text}", work.agrees)


@statement("5.3", "very small eigenvalues", "4 of 7, 1e-3 to 1e-5")
def _tiny_eigenvalues(evidence: Evidence) -> Finding:
    sizes = np.sort(evidence.moduli, axis=1)
    counts = np.sum(sizes < TINY, axis=1)
    few, many = int(counts.min()), int(counts.max())
    number = f"{few}" if few == many else f"{few} or {many}"
    largest = sizes[:, COUNT - 1]
    return Finding(
        f"{number} below {TINY:g}; the largest of {COUNT}: {largest.min():.0e} to {largest.max():.0e}",
        few == many == COUNT,
    )
