"""One step of the motion in a mode: tubes of all that moves, and the derivative of the step by its start.

The remainder is enclosed by Picard inclusion in its relative form: if with x = p + t^(N+1) rho, rho in R, the
rates are f = f_0 + ... + f_N t^N + t^(N+1) S, then the solution's rho is in f_N/(N+1) + [0, h] S/(N+2), and
R holds it as soon as that lies in R. No enclosure of the step is needed beforehand.
"""

from collections.abc import Mapping
from types import SimpleNamespace as Record
from typing import Any

from flint import arb, arb_poly, ctx

from ..equations import coordinates
from .laws import fades, fading_of, rates
from .modes import Mode, kept_names, moving_names, names_of
from .recursion import coefficients
from .tube import Span, Tube
from .undecided import UndecidedError

INCLUSIONS = 8
"""How often a remainder that is not enclosed yet is widened."""
WIDENED = 2
HELPERS = ("sine", "cosine", "decay")
"""Functions of the motion's numbers that are carried along with them."""
Values = dict[str, arb]


def with_direction(runner: Any, values: Mapping[str, Any]) -> dict[str, Any]:
    """The numbers of a motion with the leg's sine and cosine over the ground."""
    angle = values["angle"] - runner.line.slope
    return {**values, "sine": angle.sin(), "cosine": angle.cos()}


def with_helpers(runner: Any, mode: Mode, values: Mapping[str, Any]) -> dict[str, Any]:
    """All that the rates ask for beside the numbers of a motion: see `laws`."""
    whole = with_direction(runner, values)
    if fades(runner, mode):
        whole["decay"] = (fading_of(runner, mode) * values["foot_speed"]).exp()
    return whole


def fall(runner: Any) -> tuple[Any, Any]:
    """Acceleration of the centre of mass in flight, along the line and away from it."""
    return runner.free_center.x, runner.free_center.y


def speeds(runner: Any, mode: Mode, values: Values) -> Values:
    """Time derivatives of all numbers that tell the motion in a mode, at an instant."""
    at = with_helpers(runner, mode, values)
    found = rates(runner, mode, Record(**at))
    if mode.contact == "flight":
        found["along"], found["off"] = fall(runner)
        found["height"] = values["off"]
    return {name: arb(found.get(name, 0)) for name in names_of(runner, mode)}


class Flow:
    """A step: what moves in it as tubes, over times from 0 to its reach."""

    def __init__(
        self, runner: Any, mode: Mode, start: Values, degree: int, maximum: arb | None = None
    ) -> None:
        """Solve from a set of starts."""
        self.runner, self.mode, self.names = runner, mode, names_of(runner, mode)
        self.start, self.degree = start, degree
        whole = with_helpers(runner, mode, start)
        self.kept = {name: start[name] for name in kept_names(runner, mode)}
        moving = (*moving_names(runner, mode), *(name for name in HELPERS if name in whole))
        begin = {name: whole[name] for name in moving}
        terms = coefficients(begin, self.kept, lambda z: rates(runner, mode, Record(**z)), degree)
        if not all(term.is_finite() for row in terms.values() for term in row):
            raise UndecidedError(f"the motion in {mode.contact}")
        reach = longest(runner, terms)
        reach = reach if maximum is None or reach < maximum else maximum
        polynomials = {name: arb_poly(row) for name, row in terms.items()}
        for _ in range(INCLUSIONS):
            self.span = Span(degree, reach)
            remainders = self._enclosed(polynomials)
            if remainders is not None:
                break
            reach = (reach * arb("0.6")).mid()
        else:
            raise UndecidedError(f"the motion in {mode.contact}")
        self.tubes = {name: Tube(self.span, p, remainders[name]) for name, p in polynomials.items()}
        if mode.contact == "flight":
            self._add_ballistic()

    @property
    def reach(self) -> arb:
        """Length of the step."""
        return self.span.reach

    def _enclosed(self, polynomials: dict[str, arb_poly]) -> dict[str, arb] | None:
        """Remainders that hold those of every solution; None where none were found."""
        step, degree = self.span.time, self.degree

        def inclusion(remainders: dict[str, arb]) -> dict[str, arb]:
            tubes = {name: Tube(self.span, p, remainders[name]) for name, p in polynomials.items()}
            found = rates(self.runner, self.mode, Record(**tubes, **self.kept))
            return {
                name: rate.polynomial[degree] / (degree + 1) + step * rate.remainder / (degree + 2)
                if isinstance(rate := found[name], Tube)
                else arb(0)
                for name in polynomials
            }

        tried = {n: widened(r) for n, r in inclusion(dict.fromkeys(polynomials, arb(0))).items()}
        for _ in range(INCLUSIONS):
            remainders = inclusion(tried)
            if not all(remainder.is_finite() for remainder in remainders.values()):
                return None
            open_ones = [name for name in polynomials if not tried[name].contains(remainders[name])]
            if not open_ones:
                return remainders
            tried |= {name: widened(remainders[name].union(tried[name])) for name in open_ones}
        return None

    def _add_ballistic(self) -> None:
        along, off = fall(self.runner)
        start, zero = self.start, arb(0)
        rows = {
            "height": [start["height"], start["off"], off / 2],
            "along": [start["along"], along],
            "off": [start["off"], off],
        }
        self.tubes |= {name: Tube(self.span, arb_poly(row), zero) for name, row in rows.items()}

    def body_ahead_of_foot(self, time: arb) -> arb:
        """How far the body is along the line at a time more than the foot."""
        at = Record(**{name: self.tubes[name].at(time) for name in ("length", "sine", "cosine")})
        return arb(coordinates.way_from_foot(at.length, at).x)

    def record(self) -> Record:
        """All tubes by name, and what is kept."""
        return Record(**self.tubes, **self.kept)

    def at(self, time: arb) -> Values:
        """The numbers of the motion at a time, or at any of a ball of times."""
        found = {name: tube.at(time) for name, tube in self.tubes.items() if name in self.names}
        return {**found, **self.kept}


def widened(remainder: arb) -> arb:
    """A wider ball around a remainder."""
    return remainder + arb(0, (abs(remainder).upper() * (WIDENED - 1) + arb(2) ** (-ctx.prec)).upper())


def longest(runner: Any, terms: Mapping[str, list[arb]]) -> arb:
    """How long the series are exact to the working precision, by their last terms; no enclosure, a choice."""
    reach = float(runner.longest_step)
    for name, row in terms.items():
        scale = runner.scales.get(name, 1.0)
        for k in (len(row) - 1, len(row) - 2):
            size = float(abs(row[k]).upper() / scale) if row[k].is_finite() else float("inf")
            if size > 0.0:
                reach = min(reach, 2.0 ** (-ctx.prec / k) * size ** (-1.0 / k))
    return arb(reach)
