"""A claim of this project: what is measured, its control, and the relations that must hold between them."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import wraps
from typing import ParamSpec, TypeVar

from ...analysis.first_passage import FirstPassage
from ...analysis.rare_falls import RareFalls
from ...analysis.search import periodic_gait
from ...errors import GaitNotFoundError, RunError
from ...library.gait import Gait
from ...variables.parameters import read_parameters
from ...variables.table import FRICTION
from ...variables.variable import Given
from ..matched import match_gait

Arguments = ParamSpec("Arguments")
Found = TypeVar("Found")
TORQUE, ANGLE, THRUST = "hip.stance_torque", "hip.touchdown_angle", "leg.thrust"
SLOPE, RATE, CLAMP = "ground.slope", "hip.retraction_rate", "hip.swing_clamp"
SLIPS, STICKS = 0.2, 10.0
"""Frictions of a runner that slips all the time, and of one whose foot only sticks."""


@dataclass(frozen=True)
class Regime:
    """A runner for which claims are computed, and what distinguishes it from Table 1."""

    name: str
    """Key of stored values."""
    title: str
    """Heading of the regime's column."""
    values: Mapping[str, Given] = field(hash=False)
    """Start values that differ from the unit's own."""
    step: float = 1.0
    """Factor of every roughness: a light runner hops higher than a heavy one, and clears higher steps."""


DEFAULT = Regime("default", "Table 1", {})
CLAMPED = Regime("clamp", "Table 1, with the clamp", {CLAMP: True})
HEAVY = Regime("heavy", "weight 0.022, 45°", {"gravity": 0.02, ANGLE: "45 deg"})
HUMAN = Regime("human", "human size", read_parameters("human"), 0.03)
REGIMES = (DEFAULT, CLAMPED, HEAVY, HUMAN)


@dataclass(frozen=True)
class Estimate:
    """A number with its 95 % confidence interval, which is the number itself where chance plays no part."""

    value: float
    """The estimate itself."""
    low: float
    """Lower end of the interval."""
    high: float
    """Upper end of the interval."""

    @classmethod
    def exact(cls, value: float) -> "Estimate":
        """A number that does not depend on chance."""
        return cls(float(value), float(value), float(value))

    @classmethod
    def of_strides(cls, passage: FirstPassage | RareFalls) -> "Estimate":
        """Mean number of strides until the fall."""
        return cls(passage.mean_strides, *passage.interval)

    def __lt__(self, other: "Estimate | float") -> bool:
        """True if the interval lies below that of another estimate, or the value below a number."""
        return self.high < other.low if isinstance(other, Estimate) else self.value < other

    def __gt__(self, other: "Estimate | float") -> bool:
        """True if the interval lies above that of another estimate, or the value above a number."""
        return self.low > other.high if isinstance(other, Estimate) else self.value > other

    def __truediv__(self, other: "Estimate") -> float:
        """The ratio of two values."""
        return self.value / other.value

    def __str__(self) -> str:
        """The number, with its interval if it has one; only the lower bound where no runner fell."""
        if math.isinf(self.low):
            return "no fall"
        if math.isinf(self.value):
            return f"> {_digits(self.low)}"
        if self.low == self.high:
            return _digits(self.value)
        return f"{_digits(self.value)} ({_digits(self.low)} to {_digits(self.high)})"


def _digits(value: float) -> str:
    if math.isinf(value):
        return "∞"
    return f"{value:,.0f}" if abs(value) >= 1000.0 else f"{value:.3g}"


Cell = Estimate | str
"""A number, or the reason why there is none: "no gait", "no matched runner"."""
Measure = Callable[[Regime, int], Estimate]
"""Computes a number from regime and seed. If there is none, the message of its RunError becomes the cell."""
Which = Callable[[Regime], Gait]
"""The gait of a regime that is measured."""
Measures = dict[str, tuple[Measure, Measure | None]]
"""How value and control of claims are computed, by the claims' names; without control, None."""


@dataclass(frozen=True)
class Row:
    """Value and control of one regime."""

    value: Cell
    """Quantity of the runner that the claim is about."""
    control: Cell | None
    """Quantity of the control; None if the claim compares nothing."""

    def __str__(self) -> str:
        """Value and control."""
        return str(self.value) if self.control is None else f"{self.value} / {self.control}"

    def meets(self, relation: str) -> bool:
        """True if a relation such as `value < control` is met; false if a number is missing or NaN."""
        cells = vars(self).items()
        numbers = {
            name: cell for name, cell in cells if isinstance(cell, Estimate) and not math.isnan(cell.value)
        }
        try:
            return bool(eval(relation, {}, numbers))
        except NameError:
            return False


Rows = Mapping[str, Row]
"""Rows by the name of their regime."""


@dataclass(frozen=True)
class OwnClaim:
    """A claim of this project: its words, how it is computed, and when it holds."""

    name: str
    """Anchor of the claim on the page of results."""
    what: str
    """The claim in words, with units; it says which signs differ between the readings."""
    command: str
    """Command that recomputes the value for Table 1, or the first part of the value."""
    relations: Sequence[str]
    """Relations that must hold, each with the names of its regimes: `value < control: default clamp`."""
    measure: Measure
    """Computes the value for a regime and a seed."""
    control: Measure | None = None
    """Computes the same quantity of the control; None if the claim compares nothing."""

    def row(self, regime: Regime, seed: int) -> Row:
        """Compute value and control."""
        return Row(_cell(self.measure, regime, seed), self.control and _cell(self.control, regime, seed))

    def holds(self, rows: Rows) -> bool:
        """True if all relations are met."""
        relations = (text.split(": ") for text in self.relations)
        return all(rows[name].meets(relation) for relation, names in relations for name in names.split())


def _cell(measure: Measure, regime: Regime, seed: int) -> Cell:
    try:
        return measure(regime, seed)
    except GaitNotFoundError:
        return "no gait"
    except RunError as error:
        return str(error)


def cached_with_errors(compute: Callable[Arguments, Found]) -> Callable[Arguments, Found]:
    """A cache that also keeps errors, because finding out that there is no gait takes longest."""
    known: dict[object, Found | RunError] = {}

    @wraps(compute)
    def found(*arguments: Arguments.args, **named: Arguments.kwargs) -> Found:
        key = (arguments, *sorted(named.items()))
        if key not in known:
            try:
                known[key] = compute(*arguments, **named)
            except RunError as error:
                known[key] = error
        outcome = known[key]
        if isinstance(outcome, RunError):
            raise outcome
        return outcome

    return found


def solved(quantity: Callable[[Regime], float]) -> Measure:
    """A number that is solved and does not depend on the seed."""
    return lambda regime, seed: Estimate.exact(quantity(regime))


def of(make: Callable[..., Gait], *arguments: object) -> Which:
    """The gait that a function makes for a regime and further arguments, as in `of(gait, SLIPS)`."""
    return lambda regime: make(regime, *arguments)


def stride_quantity(which: Which, quantity: str) -> Measure:
    """A quantity of a gait's stride."""
    return solved(lambda regime: which(regime).stride[quantity])


def over_length(which: Which, quantity: str) -> Measure:
    """A length of a gait's stride, over the free length of the leg."""
    return solved(lambda regime: which(regime).stride[quantity] / which(regime).runner["leg.free_length"])


@cached_with_errors
def gait(regime: Regime, friction: float, **others: Given | None) -> Gait:
    """The gait at a friction. Other values, unless None, by the unit's names with `__` for the dot."""
    values = {name.replace("__", "."): value for name, value in others.items() if value is not None}
    return periodic_gait({**regime.values, **values, FRICTION: friction})


@cached_with_errors
def runner_on(regime: Regime, friction: float, reference: float | None = None) -> Gait:
    """The stable runner on a friction, unmatched or equal to the one on friction `reference`."""
    if reference is None:
        return _stable(gait(regime, friction))
    return equal_to(runner_on(regime, reference), gait(regime, friction))


def equal_to(reference: Gait, other: Gait) -> Gait:
    """The control: the other runner with the speed, apex height and leg angle of the reference.

    Then the foot is also equally high at the apex, where the ground steps. A control must be stable.
    """
    return _stable(match_gait(reference, other))


def _stable(one: Gait) -> Gait:
    if not one.stable:
        raise RunError("unstable")
    return one
