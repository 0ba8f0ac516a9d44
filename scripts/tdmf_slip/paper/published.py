"""The statements of Or and Moravia (2016) in sections 2 to 5, each with the comparison that decides on it."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from .claims import WORDS, Claim, Finding, alike
from .evidence import LEAST_FRICTION, LEG_ANGLE, SLIP_ANGLE, ClassicEvidence, Evidence

STABLE_ANGLES = (40.0, 44.0)
"""Touchdown angles with stable gaits, about, degrees."""
STANCE_FRICTION, IMPACT_FRICTION = 0.84, 4.5
"""Friction that the gait at 40 degrees needs in stance and at the impact."""
NEAR_ANGLE = 1.0
"""Degrees within which two angles agree."""


def classic_claims(evidence: ClassicEvidence) -> list[Claim]:
    """The statements about stable gaits, and about the friction that one of them needs."""
    stable, lowest, fold = evidence.stable, math.degrees(evidence.lowest), math.degrees(evidence.fold.angle)
    low, high = STABLE_ANGLES
    return [
        Claim(
            "SLIP: touchdown angles with a stable gait",
            f"small range around {low:g}° to {high:g}°",
            alike(
                f"{lowest:.1f}° to {fold:.2f}°",
                abs(lowest - low) < NEAR_ANGLE and abs(fold - high) < NEAR_ANGLE,
            ),
            "2",
        ),
        Claim(
            f"SLIP at {SLIP_ANGLE:g}°: friction needed in stance",
            f"mu > {STANCE_FRICTION:g}",
            alike(
                f"mu > {stable.stance_friction:.3f}", abs(stable.stance_friction - STANCE_FRICTION) < 0.005
            ),
            "3.2",
        ),
        Claim(
            f"SLIP at {SLIP_ANGLE:g}°: friction needed at impact",
            f"mu > {IMPACT_FRICTION:g}",
            alike(f"mu > {stable.impact_friction:.2f}", abs(stable.impact_friction - IMPACT_FRICTION) < 0.05),
            "3.2",
        ),
    ]


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


@dataclass(frozen=True)
class Statement:
    """A statement about the paper's runner."""

    where: str
    """Section of the paper."""
    what: str
    """Quantity or property."""
    published: str
    """The paper's words or number."""
    judge: Callable[[Evidence], Finding]
    """Comparison for one reading."""
    misprint: bool = False
    """Whether it is about a formula as it is printed."""
    beyond: bool = False
    """Whether the paper says that it could not compute this."""

    def claim(self, evidence: Mapping[str, Evidence]) -> Claim:
        """The statement with its findings by reading."""
        found = {reading: self.judge(of_reading) for reading, of_reading in evidence.items()}
        return Claim(self.what, self.published, found, self.where, misprint=self.misprint, beyond=self.beyond)


def claims(evidence: Mapping[str, Evidence], classic: ClassicEvidence) -> list[Claim]:
    """All statements of the paper, in its order."""
    return [*classic_claims(classic), *(statement.claim(evidence) for statement in STATEMENTS)]


def _values(evidence: Evidence, name: str) -> NDArray[np.float64]:
    """A quantity of all gaits, by falling friction."""
    return np.array([gait.stride[name] for gait in evidence.sweep.gaits])


def _frictions(evidence: Evidence) -> NDArray[np.float64]:
    return np.array([gait.friction for gait in evidence.sweep.gaits])


def _per_cent(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Change over the first value."""
    change: NDArray[np.float64] = 100.0 * (values / values[0] - 1.0)
    return change


def _below_best(evidence: Evidence) -> NDArray[np.bool_]:
    return _frictions(evidence) < BEST_FRICTION


def _from_best(evidence: Evidence, name: str) -> NDArray[np.float64]:
    """A quantity on frictions below 0.5, by falling friction."""
    return _values(evidence, name)[_below_best(evidence)]


def _slips_last(evidence: Evidence) -> Finding:
    words = [gait.word for gait in evidence.sweep.gaits]
    slipping = sum(word[-1] in "+-" for word in words)
    return Finding(f"in {slipping} of {len(words)} gaits", slipping == len(words))


def _printed_torque(evidence: Evidence) -> Finding:
    search = evidence.printed_torque
    if search.gaits:
        return Finding("+tau0: a gait", True)
    return Finding(f"+tau0: no gait from {search.starts:,} starts; -tau0: gaits", False)


def _leg_after_liftoff(evidence: Evidence) -> Finding:
    gait = evidence.five[0]
    angle = math.degrees(gait.apex[LEG_ANGLE])
    wanted = math.degrees(gait.runner["hip.liftoff_angle_factor"] * gait.liftoff_angle)
    return Finding(
        f"{angle:.2f}° at the apex, eta theta_LO = {wanted:.2f}°", abs(angle - wanted) < NEAR_ANGLE
    )


def _leg_at_touchdown(evidence: Evidence) -> Finding:
    angle = math.degrees(evidence.touchdown_angle)
    wanted = math.degrees(evidence.five[0].runner["hip.touchdown_angle"])
    return Finding(f"{angle:.2f}°", abs(angle - wanted) < NEAR_ANGLE)


def _leg_at_apex(evidence: Evidence) -> Finding:
    angles = [math.degrees(gait.apex[LEG_ANGLE]) for gait in evidence.five]
    return Finding(f"leg at {min(angles):.0f}° to {max(angles):.0f}° at the apex", max(angles) < 0.0)


def _five_words(evidence: Evidence) -> Finding:
    words = [gait.word for gait in evidence.five]
    return Finding(", ".join(words), words == list(WORDS.values()))


def _words(evidence: Evidence) -> list[tuple[str, float, float]]:
    """Words with the frictions from which and to which they last, by falling friction."""
    borders, gaits = evidence.sweep.borders, evidence.sweep.gaits
    words = [gaits[0].word, *(border.after for border in borders)]
    edges = [gaits[0].friction, *(border.value for border in borders), gaits[-1].friction]
    return [(word, *edge) for word, edge in zip(words, pairwise(edges), strict=True)]


def _word_sequence(evidence: Evidence) -> Finding:
    words = [word for word, high, low in _words(evidence) if high > NARROW * low]
    return Finding(", ".join(words), words == list(WORDS.values()))


def _cut_range(evidence: Evidence) -> Finding:
    word, high, low = next(one for one in _words(evidence) if one[2] < 7.0)
    return Finding(f"{word} from {high:.2f} to {low:.2f}", word == "+0+" and high > 7.0 and low < 2.0)


def _sixth_word(evidence: Evidence) -> Finding:
    narrow = [one for one in _words(evidence) if one[1] <= NARROW * one[2]]
    text = ", ".join(f"{word} from {high:.6f} to {low:.6f}" for word, high, low in narrow)
    return Finding(text or "none", not narrow)


def _stable(evidence: Evidence) -> Finding:
    values = [gait.lambda_max for gait in evidence.sweep.gaits]
    return Finding(f"{min(values):.4f} to {max(values):.4f}", max(values) < 1.0)


def _degrades(evidence: Evidence) -> Finding:
    values = np.array([gait.lambda_max for gait in evidence.sweep.gaits])
    drops = -np.diff(values)
    text = f"{values[0]:.4f} to {values[-1]:.4f}"
    if drops.max() > ROUNDING:
        text += f", but -{drops.max():.4f} at mu = {_frictions(evidence)[drops.argmax() + 1]:.2f}"
    return Finding(text, bool(drops.max() < 0.01 * (values[-1] - values[0])))


def _low_eigenvalues(evidence: Evidence) -> Finding:
    gait = evidence.sweep.gaits[-1]
    return Finding(f"{gait.lambda_max:.4f} at mu = {gait.friction:g}", False)


def _low_gaits(evidence: Evidence) -> Finding:
    strides = evidence.settling
    how = "does not settle" if strides is None else f"settles in {strides} strides"
    return Finding(f"down to mu = {LEAST_FRICTION:g}; simulation {how}", False)


def _second_impacts(evidence: Evidence) -> Finding:
    count = evidence.further_touchdowns
    return Finding(f"{count or 'none'} in {evidence.perturbed:,} strides", count > 0)


def _tiny_eigenvalues(evidence: Evidence) -> Finding:
    sizes = np.array([np.sort(np.abs(gait.eigenvalues)) for gait in evidence.sweep.gaits])
    counts = np.sum(sizes < TINY, axis=1)
    few, many = int(counts.min()), int(counts.max())
    number = f"{few}" if few == many else f"{few} or {many}"
    largest = sizes[:, COUNT - 1]
    return Finding(
        f"{number} below {TINY:g}; the largest of {COUNT}: {largest.min():.0e} to {largest.max():.0e}",
        few == many == COUNT,
    )


def _faster(evidence: Evidence) -> Finding:
    speeds = _values(evidence, "speed")[~_below_best(evidence)]
    return Finding(f"{speeds[0]:.4f} to {speeds[-1]:.4f}", bool(np.all(np.diff(speeds) > 0.0)))


def _best(name: str, gain: float) -> Callable[[Evidence], Finding]:
    """Compare the extreme change of a quantity over friction 10 with the paper's gain."""

    def judge(evidence: Evidence) -> Finding:
        changes = _per_cent(_values(evidence, name))
        best = int(np.argmax(np.sign(gain) * changes))
        friction = evidence.sweep.gaits[best].friction
        near = abs(friction - BEST_FRICTION) < NEAR_FRICTION and abs(changes[best] - gain) < ROUGHLY
        return Finding(f"{changes[best]:+.1f} % at mu = {friction:.2f}", near)

    return judge


def _slower(evidence: Evidence) -> Finding:
    speeds, frictions = _from_best(evidence, "speed"), _frictions(evidence)[_below_best(evidence)]
    steepness = np.diff(speeds) / np.diff(frictions)
    sharp = frictions[1:] < SHARP_BELOW
    above, below = steepness[~sharp].mean(), steepness[sharp].mean()
    return Finding(
        f"{speeds[-1]:.3f} at mu = {frictions[-1]:g}; slope {below:.1f} below 0.2, {above:.1f} above",
        bool(np.all(np.diff(speeds) < 0.0) and below > above),
    )


def _cheaper(evidence: Evidence) -> Finding:
    changes = _per_cent(_values(evidence, "cost_of_transport"))
    slipping = changes[[gait.word[0] == "+" for gait in evidence.sweep.gaits]]
    text = f"lower in {np.sum(slipping < 0.0)} of {len(slipping)} gaits, by up to {-slipping.min():.1f} %"
    return Finding(text, bool(slipping.max() < 0.0))


def _dearer(evidence: Evidence) -> Finding:
    costs = _from_best(evidence, "cost_of_transport")
    return Finding(
        f"{costs[0]:.3f} to {costs[-1]:.3f} at mu = {evidence.sweep.gaits[-1].friction:g}",
        bool(np.all(np.diff(costs) > 0.0)),
    )


def _trend(name: str, sign: float, digits: int = 1) -> Callable[[Evidence], Finding]:
    """Compare a quantity at friction 10 with the same at 0.5."""

    def judge(evidence: Evidence) -> Finding:
        values = _values(evidence, name)[~_below_best(evidence)]
        text = f"{values[0]:.{digits}f} to {values[-1]:.{digits}f}"
        return Finding(text, bool(sign * (values[-1] - values[0]) > 0.0))

    return judge


def _shorter(evidence: Evidence) -> Finding:
    lengths = _from_best(evidence, "length")
    return Finding(f"{lengths[0]:.1f} to {lengths[-1]:.1f}", bool(np.all(np.diff(lengths) < 0.0)))


def _work(evidence: Evidence) -> Finding:
    work, lost = _from_best(evidence, "work"), _from_best(evidence, "friction_loss")
    both = zip((work, lost), ("W", "friction"), strict=True)
    text = "; ".join(f"{name} {values[0]:.4f} to {values[-1]:.4f}" for values, name in both)
    return Finding(text, bool(np.all(np.diff(work) > 0.0)))


STATEMENTS: Sequence[Statement] = (
    Statement(
        "4", "(11) as printed, torque +tau0 in stance", "injects energy", _printed_torque, misprint=True
    ),
    Statement("4", "slip before lift-off", "in every gait", _slips_last),
    Statement("4", "trajectories", "quite similar to the SLIP's", _leg_at_apex),
    Statement("5.1", "words at mu = 10, 1.2, 0.6, 0.43, 0.2", ", ".join(WORDS.values()), _five_words),
    Statement("5.1", "words as mu falls", ", ".join(WORDS.values()), _word_sequence),
    Statement("5.1", "a further word", "not reported", _sixth_word, beyond=True),
    Statement("5.1", "theta after lift-off, mu = 10", "converges to eta theta_LO", _leg_after_liftoff),
    Statement("5.1", "theta before touchdown, mu = 10", "converges to 40°", _leg_at_touchdown),
    Statement("5.1", "gaits below mu = 0.1", "none obtained", _low_gaits, beyond=True),
    Statement("5.2", "lambda_max", "< 1: stable", _stable),
    Statement("5.2", "lambda_max as mu falls", "rises", _degrades),
    Statement("5.2", "word from mu = 7 to 2", "+0+", _cut_range),
    Statement("5.2", "eigenvalues below mu = 0.3", "not computable", _low_eigenvalues, beyond=True),
    Statement(
        "5.2",
        "mu < 0.3, one coordinate of the apex off by 0.2 or less",
        "second impact after lift-off",
        _second_impacts,
    ),
    Statement("5.2", "speed as mu falls to 0.5", "rises", _faster),
    Statement(
        "5.2", "largest speed", f"≈ {SPEED_GAIN:+g} % at mu ≈ {BEST_FRICTION:g}", _best("speed", SPEED_GAIN)
    ),
    Statement("5.2", "speed below mu = 0.5", "drops, sharply below 0.2", _slower),
    Statement("5.2", "cost of transport with slip at impact", "below that without, at every mu", _cheaper),
    Statement("5.2", "step length as mu falls to 0.5", "increases", _trend("length", 1.0)),
    Statement("5.2", "impact loss as mu falls to 0.5", "decreases", _trend("impact_loss", -1.0, 4)),
    Statement(
        "5.2",
        "least cost of transport",
        f"≈ {COST_GAIN:+g} % at mu ≈ {BEST_FRICTION:g}",
        _best("cost_of_transport", COST_GAIN),
    ),
    Statement("5.2", "cost of transport below mu = 0.5", "rises", _dearer),
    Statement("5.2", "step length below mu = 0.5", "decreases", _shorter),
    Statement("5.2", "work W below mu = 0.5", "rises, by the dissipation of slip", _work),
    Statement("5.3", "very small eigenvalues", "4 of 7, 1e-3 to 1e-5", _tiny_eigenvalues),
)
