"""The best runner that was found, beside the one that the search began with."""

from collections.abc import Mapping
from dataclasses import dataclass

from ..contents import ByContents
from ..drawable import Drawable
from ..library.gait import Gait
from ..library.quantities import known_quantities, quantities_of
from ..library.scales import scale_of
from ..record import origin_of

FOLD, STABILITY = "fold", "stability"
"""Limits of an optimum beside bounds."""
NEVER_NEGATIVE = {
    "slip_distance": "m",
    "greatest_slip_velocity": "m/s",
    "friction_loss": "J",
    "positive_hip_work": "J",
    "positive_leg_work": "J",
    "positive_work": "J",
    "positive_cost_of_transport": "1",
}
"""Quantities of which no gait has less than zero, with their units."""
NONE = 1e-9
"""Over the runner's scale: as little counts as zero."""


def reported(gait: Gait) -> dict[str, float]:
    """What an optimum is told by: quantities of the stride, and the spectral radius."""
    return quantities_of(gait, known_quantities(gait.runner)) | {"lambda_max": gait.lambda_max}


@dataclass(frozen=True, eq=False, repr=False)
class Optimum(ByContents, Drawable):
    """The best runner that was found: a gait, and what says that there is no better one near it."""

    objective: str
    """The quantity that is the least, or the most."""
    is_minimum: bool
    """Which of them."""
    parameters: Mapping[str, float]
    """What was varied, by name, in the unit's units."""
    gait: Gait
    """The gait; its runner has these parameters."""
    before: Gait
    """The gait of the runner that was given."""
    active_bounds: Mapping[str, str]
    """By name of the parameters that are at a bound: `lower` or `upper`."""
    limits: tuple[str, ...]
    """What else keeps it: `stability`, `fold`."""
    falls: Mapping[str, float]
    """By word of each region beside the gait, two where it is on a border between words: how much better the
    objective could be there, to first order, over its scale, for a step by the whole width of the bounds.
    Zero at an optimum, up to rounding."""
    why: str
    """What kept the search from an optimum; empty where this is one."""
    starts: int
    """Of how many searches this is the best."""
    basins: int
    """How many different optima these ended at."""

    def __repr__(self) -> str:
        """In a line: what is best, by what."""
        values = ", ".join(f"{name} {value:.6g}" for name, value in self.parameters.items())
        maximum = "least" if self.is_minimum else "most"
        kind = "stable" if self.gait.stable else "unstable"
        scope = "local" if self.is_local else "global"
        return (
            f"<Optimum, {scope}: {maximum} {self.objective} {self.value:.6g}: {values}; {self.word}, {kind}>"
        )

    @property
    def is_local(self) -> bool:
        """Whether a better gait may exist that no search has led to.

        Searches from many starts prove nothing of the rest. False only where no gait can have less, as of a
        slip of zero.
        """
        if not self.is_minimum or self.objective not in NEVER_NEGATIVE:
            return True
        return self.value > NONE * scale_of(self.gait.runner, NEVER_NEGATIVE[self.objective])

    @property
    def value(self) -> float:
        """Of the objective."""
        return reported(self.gait)[self.objective]

    @property
    def word(self) -> str:
        """Of the gait."""
        return self.gait.word

    @property
    def stable(self) -> bool:
        """Whether the gait is."""
        return self.gait.stable

    @property
    def is_at_border(self) -> bool:
        """Whether it lies where the word, or the order of events, changes."""
        return len(self.falls) > 1

    def as_json(self) -> dict[str, object]:
        """As a plain object; `before` and `after` are quantities of the two gaits."""
        return {
            **origin_of(reduced=self.gait.runner.reduced),
            "objective": self.objective,
            "is_least": self.is_minimum,
            "parameters": dict(self.parameters),
            "before": reported(self.before),
            "after": reported(self.gait),
            "word": self.word,
            "stable": self.stable,
            "active_bounds": dict(self.active_bounds),
            "limits": list(self.limits),
            "falls": dict(self.falls),
            "problem": self.why or None,
            "local": self.is_local,
            "starts": self.starts,
            "basins": self.basins,
            "word_before": self.before.word,
            "apex": [float(value) for value in self.gait.apex],
            "start_values": self.gait.start_values,
        }
