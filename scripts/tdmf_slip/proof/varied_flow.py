"""One step with the derivative of its end by its start.

The derivative V solves V' = A V along the tube; with weighted norms, what its polynomial leaves out is
below ::

    (|V_(N+1)| + h/(N+2) (H + |B| |V|)) / (1 - h |A|/(N+2))

where H is what A V has beyond t^N and B is A's remainder.
"""

from types import SimpleNamespace as Record
from typing import Any

from flint import arb, arb_mat, arb_poly

from .dual import Dual, slope_of, value_of
from .flow import Flow, fall
from .laws import fades, fading_of, rates
from .matrices import identity, norm
from .modes import BALLISTIC, PARAMETER, kept_names, moving_names
from .tube import Tube


class VariedFlow(Flow):
    """A step with the derivative by its start."""

    def vary(self, dual_runner: Any) -> None:
        """Solve the variational equation along the tubes."""
        self.dual_runner = dual_runner
        self.active = moving_names(self.runner, self.mode) + kept_names(self.runner, self.mode)
        self._solve(self._matrices())

    def _matrices(self) -> tuple[list[arb_mat], arb]:
        """Coefficients of A, the derivative of the rates, and a bound of its remainder's norm."""
        tubes, one = self.tubes, arb(1)
        numbers: dict[str, Any] = {
            name: Dual(tubes[name], {name: one}) for name in moving_names(self.runner, self.mode)
        }
        numbers |= {name: Dual(value, {name: one}) for name, value in self.kept.items()}
        turn = {"angle": one} | slopes_of_slope(self.dual_runner)
        numbers["sine"] = Dual(tubes["sine"], {name: tubes["cosine"] * by for name, by in turn.items()})
        numbers["cosine"] = Dual(tubes["cosine"], {name: -(tubes["sine"] * by) for name, by in turn.items()})
        if fades(self.runner, self.mode):
            numbers["decay"] = self._dual_decay()
        found = rates(self.dual_runner, self.mode, Record(**numbers))
        size, zero = len(self.active), arb(0)
        entries = [[slope_of(found.get(row, 0), column) for column in self.active] for row in self.active]
        rows = [[coefficients_of(entry) for entry in row] for row in entries]
        matrices = [
            arb_mat(size, size, [c[k] if k < len(c) else zero for row in rows for c in row])
            for k in range(self.degree + 1)
        ]
        rest = arb_mat(size, size, [abs(remainder_of(entry)) for row in entries for entry in row])
        return matrices, norm(rest, self._weights())

    def _dual_decay(self) -> Dual:
        """e^(-s v/v_s), by the foot's velocity and, where it is varied, by v_s."""
        decay, fading = self.tubes["decay"], fading_of(self.dual_runner, self.mode)
        gradient = {"foot_speed": decay * value_of(fading)}
        by_parameter = slope_of(fading, PARAMETER)
        if by_parameter != 0:
            gradient[PARAMETER] = decay * self.tubes["foot_speed"] * by_parameter
        return Dual(decay, gradient)

    def _weights(self) -> list[arb]:
        """Of what moves, in the norm, so that a fast swing is as large one way as the other."""
        swing = arb(self.runner.swing)
        return [swing if name.endswith(("_rate", "_speed")) else arb(1) for name in self.active]

    def _solve(self, of_rates: tuple[list[arb_mat], arb]) -> None:
        matrices, rest = of_rates
        weights = self._weights()
        size, degree, reach = len(self.active), self.degree, self.reach
        found = [identity(size)]
        for k in range(degree + 1):
            total = matrices[0] * found[k]
            for i in range(1, k + 1):
                total = total + matrices[i] * found[k - i]
            found.append(total / (k + 1))
        last = norm(found.pop(), weights)
        sizes, solved = ([norm(m, weights) for m in row] for row in (matrices, found))
        beyond = (arb_poly(sizes) * arb_poly(solved)).right_shift(degree + 1)(reach)
        all_rates = arb_poly(sizes)(reach) + reach ** (degree + 1) * rest
        contraction = reach * all_rates / (degree + 2)
        bound = last + reach / (degree + 2) * (beyond + rest * arb_poly(solved)(reach))
        self.rest = bound / (1 - contraction) if contraction < 1 else arb("inf")
        rows = [[m[i, j] for m in found] for i in range(size) for j in range(size)]
        self.entries = [arb_poly(row) for row in rows]

    def matrix(self, time: arb) -> arb_mat:
        """The derivative of the motion at a time by its start, rows and columns in the order of `names`."""
        names, size = self.names, len(self.active)
        whole = identity(len(names))
        error, weights = abs(time).upper() ** (self.degree + 1) * self.rest, self._weights()
        for i in range(size):
            for j in range(size):
                whole[i, j] = self.entries[i * size + j](time) + arb(
                    0, (error * weights[i] / weights[j]).upper()
                )
        if self.mode.contact == "flight":
            height, along, off = (names.index(name) for name in BALLISTIC)
            whole[height, off] = time
            if PARAMETER in names:
                by = names.index(PARAMETER)
                of_along, of_off = (slope_of(part, PARAMETER) for part in fall(self.dual_runner))
                whole[height, by] = of_off * time * time / 2
                whole[along, by], whole[off, by] = of_along * time, of_off * time
        return whole


def slopes_of_slope(runner: Any) -> dict[str, arb]:
    """By what is varied: how the leg's angle from the ground's normal changes."""
    slope = slope_of(runner.line.slope, PARAMETER)
    return {} if slope == 0 else {PARAMETER: -slope}


def coefficients_of(entry: Any) -> list[arb]:
    """Coefficients of an entry of a matrix: a tube's, or a number alone."""
    if isinstance(entry, Tube):
        terms: list[arb] = entry.polynomial.coeffs()
        return terms
    return [arb(value_of(entry))]


def remainder_of(entry: Any) -> arb:
    """Remainder of an entry of a matrix: a tube's, or zero."""
    return entry.remainder if isinstance(entry, Tube) else arb(0)
