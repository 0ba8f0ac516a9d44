"""A stride of a whole set of starts, with its derivative.

Two motions go along: that of a single start, the centre, and tubes of all starts. The derivative of the
stride is enclosed over the set. By the mean value theorem, the set at any time lies in  centre + derivative
(set - centre), which does not grow by being wrapped in balls at each step. Events are treated in the same
way, with their derivative enclosed over the set at the event. The centre is a point and a drift, which has
all errors of the point.

In each step the derivative V solves V' = A V along the tube. In weighted norms, what its polynomial leaves
out is below ::

    (|V_(N+1)| + h/(N+2) (H + |B| |V|)) / (1 - h |A|/(N+2))

where H is what A V has beyond t^N and B is A's remainder.

The derivative of the stride is the product of those of steps and events. A product of enclosures, one after
the other, widens at each turn of the motion, far more than the true derivative varies over the set. For any
matrices L_0, ..., L_n with L_n = 1 the product of A_1, ..., A_n is

    A_n ... A_1 V = L_0 V + sum of (L_k A_k - L_(k-1)) A_(k-1) ... A_1 V.

Take L_(k-1) near the middle of L_k A_k, from the end to the beginning. Then each bracket is a small ball
around zero, as wide as one factor and no more. What was enclosed before serves as A_(k-1) ... A_1 V.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb, arb_mat, arb_poly, ctx

from ..errors import RunError
from ..library.section import COORDINATES
from .dual import Dual, Number, UndecidedError, identity, norm, slope_of, value_of
from .flow import Flow, Tube, Values, fades, rates, speeds
from .given import Radius, RunnerLike, ball_of, gait_of, radius_of
from .guards import Guard, guard_of
from .parameters import BALLISTIC, PARAMETER, Forced, Parameters, at, kept_names, moving_names
from .starts import Starts, apex_of, degree_for, motion_at, seeded
from .stride import Ledger, Met, Traveller, gradient_of_guard
from .transitions import Entered, Transition

OFTEN = 8
"""Number of factors after which the sum is taken; it is also taken at each event."""


class Spread:
    """The derivative of the motion by its start, of shape (numbers of the mode, numbers of the start)."""

    def __init__(self, first: arb_mat) -> None:
        """The derivative at the start."""
        self.product = self._first = first
        self._factors: list[tuple[arb_mat, arb_mat]] = []
        """Each A_k, and what was enclosed before it."""

    def follow(self, derivative: arb_mat, *, is_event: bool = False) -> None:
        """Go on by the derivative of a step or of an event."""
        self._factors.append((derivative, self.product))
        self.product = derivative * self.product
        if is_event or len(self._factors) % OFTEN == 0:
            self.product = intersected(self.product, self._telescoped())

    def _telescoped(self) -> arb_mat:
        """The product by the sum above."""
        later = identity(self.product.nrows())
        found = arb_mat(self.product.nrows(), self.product.ncols())
        for factor, before in reversed(self._factors):
            whole = later * factor
            later = whole.mid()
            found = found + (whole - later) * before
        return found + later * self._first


class Drift:
    """Difference of the true motion and the point that stands for the centre: Q e, with balls e."""

    def __init__(self, size: int) -> None:
        """Begin without drift, for a motion of `size` numbers."""
        self._frame, self._inside = identity(size), arb_mat(size, 1)

    def follow(self, derivative: arb_mat, fresh: list[arb]) -> None:
        """Go on by the derivative of a step, which adds errors of its own."""
        turned = derivative * self._frame
        self._frame, inside = _frame_of(turned, self._inside), self._inside
        back = self._frame.inv()
        self._inside = (back * turned) * inside + back * arb_mat(len(fresh), 1, fresh)

    def balls(self) -> list[arb]:
        """The drift of each number."""
        return list((self._frame * self._inside).entries())


def _frame_of(matrix: arb_mat, inside: arb_mat) -> arb_mat:
    """An orthogonal basis, to rounding, whose first directions are those in which the set is widest."""
    middle = np.array([[float(x.mid()) for x in row] for row in matrix.tolist()])
    widths = np.array([float(sum((x.rad() for x in row), arb(0)).upper()) for row in inside.tolist()])
    sizes = np.array([float(sum((abs(x) for x in row), arb(0)).upper()) for row in inside.tolist()])
    weight = widths if np.all(np.isfinite(widths)) and widths.any() else sizes
    columns = middle * weight
    order = np.argsort(-np.linalg.norm(columns, axis=0), kind="stable")
    if not np.all(np.isfinite(columns)):
        return identity(matrix.nrows())
    basis, _ = np.linalg.qr(middle[:, order], mode="complete")
    size = matrix.nrows()
    return arb_mat(size, size, [arb(float(x)) for x in basis.ravel()])


def intersected(one: arb_mat, other: arb_mat) -> arb_mat:
    """Intersection of two enclosures of a matrix."""
    pairs = zip(one.entries(), other.entries(), strict=True)
    return arb_mat(one.nrows(), one.ncols(), [narrower(a, b) for a, b in pairs])


def narrower(one: arb, other: arb) -> arb:
    """Enclosure of the intersection of two enclosures of a number; a ball, so not always less than either."""
    if not one.is_finite():
        return other
    if not other.is_finite():
        return one
    both = one.intersection(other)
    return min(one, other, both, key=lambda ball: float(ball.rad()))


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
        values = tubes | self.kept
        numbers = seeded({name: values[name] for name in self.active})
        slope = slope_of(self.dual_runner.slope, PARAMETER)
        turn = {"angle": one} if slope == 0 else {"angle": one, PARAMETER: -slope}
        numbers["sine"] = Dual(tubes["sine"], {name: tubes["cosine"] * by for name, by in turn.items()})
        numbers["cosine"] = Dual(tubes["cosine"], {name: -(tubes["sine"] * by) for name, by in turn.items()})
        if fades(self.runner, self.mode):
            numbers["decay"] = self._dual_decay()
        found = rates(self.dual_runner, self.mode, numbers)
        entries = [slope_of(found.get(row, 0), column) for row in self.active for column in self.active]
        shape = len(self.active), len(self.active)
        series = [entry.polynomial if isinstance(entry, Tube) else arb_poly([entry]) for entry in entries]
        rest = [abs(entry.remainder) if isinstance(entry, Tube) else arb(0) for entry in entries]
        matrices = [arb_mat(*shape, [own[k] for own in series]) for k in range(self.degree + 1)]
        return matrices, norm(arb_mat(*shape, rest), self._weights())

    def _dual_decay(self) -> Dual:
        """e^(-s v/v_s), by the foot's velocity and, where it is varied, by v_s."""
        decay, fading = self.tubes["decay"], at(self.dual_runner, self.mode, {}).fading_rate()
        gradient = {"foot_vx": decay * value_of(fading)}
        by_parameter = slope_of(fading, PARAMETER)
        if by_parameter != 0:
            gradient[PARAMETER] = decay * self.tubes["foot_vx"] * by_parameter
        return Dual(decay, gradient)

    def _weights(self) -> list[arb]:
        """Weights of the moving numbers in the norm; a fast swing is then as large one way as the other."""
        swing = arb(self.runner.swing_frequency)
        return [swing if name.endswith(("_rate", "_vx")) else arb(1) for name in self.active]

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
            clearance, along, off = (names.index(name) for name in BALLISTIC)
            whole[clearance, off] = time
            if PARAMETER in names:
                by = names.index(PARAMETER)
                fall = self.dual_runner.fall()
                of_along, of_off = (slope_of(part, PARAMETER) for part in (fall.along, fall.off))
                whole[clearance, by] = of_off * time * time / 2
                whole[along, by], whole[off, by] = of_along * time, of_off * time
        return whole


SHARPENINGS = 2
"""Number of times that the derivative at an event sharpens the motion, from which it is enclosed."""
Instant = tuple[arb, Values]
"""A time, and the motion's numbers then."""


class SetTraveller(Traveller):
    """A stride of all starts of a set, proved."""

    def __init__(
        self,
        parameters: Parameters,
        starts: Starts,
        bits: int,
        forced: Forced | None = None,
    ) -> None:
        """Begin at the starts' apexes."""
        super().__init__(parameters, starts.centre, bits, forced)
        self.columns = (*COORDINATES, *([PARAMETER] if self.varied else []))
        with ctx.workprec(bits):
            balls = starts.balls()
            whole = balls[6] if self.varied else None
            self.wide = parameters.balls(whole)
            self.dual = parameters.balls(whole, dual=True)
            self.ledger = Ledger(self.wide)
            numbers = seeded(dict(zip(self.columns, balls, strict=True)))
            for name, slope in zip(COORDINATES, starts.tilt, strict=False):
                numbers[name].gradient = {**numbers[name].gradient, PARAMETER: slope}
            begun = motion_at(self.dual, [numbers[name] for name in COORDINATES], numbers.get(PARAMETER))
            self.offset = arb_mat(len(balls), 1, [arb(0, radius) for radius in starts.radii])
            self.spread = Spread(self._slopes(begun, self.names, self.columns))
            self.set = {name: arb(value_of(begun[name])) for name in self.names}
            fall = self.wide.fall()
            if not self.wide.in_world(fall.along, fall.off, 0, 0).y < 0:
                raise UndecidedError("whether the centre of mass falls in flight", 0.0)
            self.drift = Drift(len(self.names))
            self._begin_at(self.centre, None)

    @staticmethod
    def _slopes(numbers: Mapping[str, object], rows: Sequence[str], columns: Sequence[str]) -> arb_mat:
        entries = [arb(slope_of(numbers[row], column)) for row in rows for column in columns]
        return arb_mat(len(rows), len(columns), entries)

    # ---- steps -----------------------------------------------------------------------------------------

    def step(self) -> bool:
        """Go one step, or a part of one up to an event, and say whether that ends the stride."""
        thin = Flow(self.thin, self.mode, self.centre, degree_for(self.bits))
        return self._go(thin, VariedFlow(self.wide, self.mode, self.set, degree_for(self.bits), thin.reach))

    def _begin_at(self, found: Values, derivative: arb_mat | None) -> None:
        """The centre as a point, and its error as drift."""
        self.centre = {name: arb(found[name]).mid() for name in self.names}
        fresh = [arb(found[name]) - self.centre[name] for name in self.names]
        around = [ball + arb(0, ball.rad()) for ball in fresh]
        self.drift.follow(identity(len(self.names)) if derivative is None else derivative, around)

    def _around(self, plain: Values) -> Values:
        """The set by the mean value theorem, or as it is where that is narrower; the centre is in it."""
        moved = self.spread.product * self.offset
        found = {}
        for i, (name, ball) in enumerate(zip(self.names, self.drift.balls(), strict=True)):
            centre = self.centre[name] + ball
            found[name] = narrower(plain[name], centre + moved[i, 0]).union(centre)
        return found

    def _advance(self, thin: Flow, flow: Flow, end: arb) -> None:
        assert isinstance(flow, VariedFlow)
        flow.vary(self.dual)
        derivative = flow.matrix(end)
        self._begin_at(thin.at(end), derivative)
        self.spread.follow(derivative)
        self.set = self._around(flow.at(end))

    # ---- events ----------------------------------------------------------------------------------------

    def _land(self, met: Met, thin: Flow, flow: Flow) -> None:
        assert isinstance(flow, VariedFlow)
        flow.vary(self.dual)
        own, landed = self._centre_after(met, thin)
        for _ in range(SHARPENINGS):
            delays, derivative = self._saltated(met, flow.matrix(met.times), flow.names)
            met = self._sharpened(met, own, derivative, delays)
        names = flow.names
        numbers = seeded({name: met.values[name] for name in names})
        reset = Transition(self.dual, met.before, numbers, met.forced).take(met.guard.name)
        if reset.margin is not None:
            self._note_margin(reset.margin, landed, derivative, names)
        derivative = self._slopes(reset.values, self.names, names) * derivative
        self._begin_at({name: arb(value_of(landed.values[name])) for name in self.names}, derivative)
        self.spread.follow(derivative, is_event=True)
        self.set = self._around({name: arb(value_of(met.entered.values[name])) for name in self.names})

    def _sharpened(self, met: Met, own: Instant, derivative: arb_mat, delays: arb_mat) -> Met:
        """The event around that of the centre, by the mean value theorem."""
        when, at = own
        away = self.spread.product * self.offset
        away = away + arb_mat(away.nrows(), 1, self.drift.balls())
        moved, delay = derivative * away, delays * away
        names = enumerate(met.values)
        values = {name: narrower(met.values[name], at[name] + moved[i, 0]) for i, name in names}
        return replace(met, times=narrower(met.times, when + delay[0, 0]), values=values)

    def _note_margin(
        self, margin: Number, landed: Entered, derivative: arb_mat, names: Sequence[str]
    ) -> None:
        """Margin of a forced event: at the centre, and its derivatives by the start."""
        assert landed.margin is not None
        slopes = self._slopes({"": margin}, ("",), names) * derivative
        drift = slopes * arb_mat(len(names), 1, self.drift.balls())
        self.margin = arb(landed.margin) + drift[0, 0]
        self.margin_slopes = list((slopes * self.spread.product).entries())

    def _saltated(self, met: Met, derivative: arb_mat, names: Sequence[str]) -> tuple[arb_mat, arb_mat]:
        """Derivatives of the event's time and of the motion at the event by the start."""
        rates = speeds(self.wide, met.before, met.values)
        values = {name: met.values[name] for name in names}
        gradient = gradient_of_guard(self.dual, met.before, met.guard.name, values)
        steepness = arb_mat(1, len(names), gradient)
        motion = arb_mat(len(names), 1, [rates[name] for name in names])
        fall = (steepness * motion)[0, 0]
        if not fall < 0:
            raise UndecidedError(met.guard.name)
        delays = steepness * derivative / -fall
        return delays, derivative + motion * delays

    def _centre_after(self, met: Met, thin: Flow) -> tuple[Instant, Entered]:
        """The centre at its own event, and just after it."""
        name, mode, times = met.guard.name, met.before, met.times
        own = Guard(name, guard_of(name, thin.motion(self.thin)), met.guard.order)
        low, high = (arb(bound.mid()) for bound in (times.lower(), times.upper()))
        when = own.zero_after(low, high) if low < high else None
        when = times if when is None else when
        found = thin.at(when)
        return (when, found), Transition(self.thin, mode, found, met.forced).take(name)

    def _close(self) -> None:
        drifts = zip(self.names, self.drift.balls(), strict=True)
        self.end = apex_of(self.thin, {name: self.centre[name] + ball for name, ball in drifts})
        numbers = seeded({name: self.set[name] for name in self.names})
        apexes = dict(zip(COORDINATES, apex_of(self.dual, numbers), strict=True))
        self.derivative = self._slopes(apexes, COORDINATES, self.names) * self.spread.product


BITS = 80
"""Working precision of a tube that is drawn."""


@dataclass(frozen=True)
class Section:
    """A tube at the end of a step or an event."""

    time: float
    """Time since the apex, s."""
    contact: str
    """Mode of the foot: flight, stick, slip or graze."""
    middle: dict[str, float]
    """Centres of the motion's numbers: the leg's, and by mode those of the centre of mass or of the foot."""
    radius: dict[str, float]
    """Distance that a start of the set may have from the middle."""


def tube_along(gait: RunnerLike = None, radius: Radius = Fraction(1, 10**8)) -> list[Section]:
    """Enclose all motions that start near a gait's apex, along one stride.

    Parameters
    ----------
    gait : runner or Gait, optional
        The gait, or the runner whose gait is found.
    radius : str, Fraction or float, default 1e-8
        Largest distance of a start from the apex in each coordinate, over the coordinate's scale.

    Returns
    -------
    list of Section
        Sections of the tube at the ends of the steps: `time`, `contact`, and the `middle` and `radius` of
        each state's enclosure.

    Raises
    ------
    InputError
        A value is not allowed.
    RunError
        The tube is too wide to decide an event.

    Examples
    --------
    >>> import tdmf_slip
    >>> tube = tdmf_slip.tube_along({"ground.friction": "0.6"}, "1e-8")
    >>> tube[-1].radius["angle"] < 1e-5
    True
    """
    found, values = gait_of(gait)
    size = radius_of(radius)
    with ctx.workprec(BITS):
        scales = [float(scale) for scale in found.runner.scales]
        starts = Starts.around([arb(float(x)) for x in found.apex], ball_of(size), scales)
        traveller = SetTraveller(Parameters(values), starts, BITS)
        sections = [_section(traveller)]
        try:
            while not traveller.step():
                sections.append(_section(traveller))
        except UndecidedError as open_question:
            raise RunError(
                f"radius = {radius}: too wide to decide {open_question}; try a smaller one"
            ) from None
        return [*sections, _section(traveller)]


def _section(traveller: SetTraveller) -> Section:
    return Section(
        float(traveller.time.mid()),
        traveller.mode.contact,
        {name: float(ball.mid()) for name, ball in traveller.set.items()},
        {name: float(ball.rad()) for name, ball in traveller.set.items()},
    )
