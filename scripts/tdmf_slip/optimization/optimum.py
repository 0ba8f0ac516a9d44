"""Best runner of all searches, beside the runner with which the first one began."""

from collections.abc import Mapping
from dataclasses import dataclass

from ..library.gait import Gait
from ..library.quantities import known_quantities, quantities_of, unit_of
from ..record import entries, origin_of

FOLD, STABILITY = "fold", "stability"
"""Limits of an optimum other than bounds."""
NEVER_NEGATIVE = (
    *("slip_distance", "greatest_slip_velocity", "friction_loss", "positive_hip_work"),
    *("positive_leg_work", "positive_work", "positive_cost_of_transport"),
)
"""Quantities that cannot be negative."""
NONE = 1e-9
"""Values below this, relative to the runner's scale, count as zero."""


def reported(gait: Gait) -> dict[str, float]:
    """Quantities of the stride that are reported for an optimum, with the spectral radius."""
    return quantities_of(gait, known_quantities(gait.runner)) | {"lambda_max": gait.lambda_max}


@dataclass(frozen=True, eq=False, repr=False)
class Optimum:
    """Best runner found, with the evidence that no better one lies near it."""

    objective: str
    """Quantity that was minimized or maximized."""
    is_minimum: bool
    """True if the objective was minimized."""
    parameters: Mapping[str, float]
    """Values of the varied parameters by name, in the unit's units."""
    gait: Gait
    """Gait of the optimum; its runner has these parameters."""
    before: Gait
    """Gait of the runner with which the search began."""
    active_bounds: Mapping[str, str]
    """Active bounds, `lower` or `upper`, by name of the parameter."""
    limits: tuple[str, ...]
    """Other active limits: `stability`, `fold`."""
    remaining_improvement: Mapping[str, float]
    """Largest improvement of the objective, to first order and relative to its scale, that a step across the
    whole width of the bounds could still bring. One entry for each gait word beside the optimum: two where
    it lies on a border between words. Zero at an optimum, up to rounding."""
    why: str
    """Reason why this is not shown to be an optimum; empty for an optimum."""
    starts: int
    """Number of searches, of which this is the best result."""
    basins: int
    """Number of different optima that the searches found."""

    def __repr__(self) -> str:
        """Objective, parameters, gait word and stability in one line."""
        values = ", ".join(f"{name} {value:.6g}" for name, value in self.parameters.items())
        maximum = "least" if self.is_minimum else "most"
        kind = "stable" if self.gait.stable else "unstable"
        scope = "local" if self.is_local else "global"
        return (
            f"<Optimum, {scope}: {maximum} {self.objective} {self.value:.6g}: {values}; {self.word}, {kind}>"
        )

    @property
    def is_local(self) -> bool:
        """True if a better gait may exist that no search has found.

        Searches from many starts do not exclude it. False only where no gait can have less, such as a slip
        distance of zero.
        """
        if not self.is_minimum or self.objective not in NEVER_NEGATIVE:
            return True
        runner = self.gait.runner
        return self.value > NONE * runner.scale_of(unit_of(self.objective, runner.model))

    @property
    def value(self) -> float:
        """Value of the objective."""
        return reported(self.gait)[self.objective]

    @property
    def word(self) -> str:
        """Gait word."""
        return self.gait.word

    @property
    def stable(self) -> bool:
        """True if the gait is stable."""
        return self.gait.stable

    @property
    def is_at_border(self) -> bool:
        """True if the optimum lies on a border where the word or the order of events changes."""
        return len(self.remaining_improvement) > 1

    def as_json(self) -> dict[str, object]:
        """Dictionary for JSON; `before` and `after` hold the quantities of the two gaits."""
        return {
            **origin_of(self.gait.runner),
            "objective": self.objective,
            "is_least": self.is_minimum,
            "parameters": dict(self.parameters),
            "before": reported(self.before),
            "after": reported(self.gait),
            **entries(self, "word", "stable", "active_bounds", "limits", "remaining_improvement"),
            "problem": self.why or None,
            "local": self.is_local,
            **entries(self, "starts", "basins"),
            "word_before": self.before.word,
            **entries(self.gait, "apex", "start_values"),
        }
