"""A stride of a whole set of starts, with its derivative.

Two motions go along: one of a single start, the centre, and tubes of all starts. The derivative of the
stride is enclosed over the set, and by the mean value theorem the set at any time lies in  centre +
derivative (set - centre), so that it does not grow by being wrapped in balls; so it does at an event, and
the event's derivative is enclosed over what is left. The centre is a point and a drift, which has all its
errors.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from flint import arb, arb_mat, ctx

from .dual import Number, slope_of, value_of
from .entered import Entered
from .flow import Flow, Values, speeds
from .forced import Forced
from .guards import FUNCTIONS
from .laws import rise
from .ledger import Ledger
from .matrices import identity
from .modes import PARAMETER
from .parameters import Parameters
from .roots import Guard
from .section import COORDINATES, apex_of, motion_at, seeds
from .spread import Drift, Spread, narrower
from .starts import Fineness, Starts
from .stride import Met, Stride, Traveller, gradient_of_guard
from .transitions import Transition
from .undecided import UndecidedError
from .varied_flow import VariedFlow

SHARPENINGS = 2
"""How often the motion at an event is enclosed by the derivative that follows from its enclosure."""
Instant = tuple[arb, Values]
"""A time, and the motion's numbers then."""


class SetTraveller(Traveller):
    """All starts of a set on their way."""

    def __init__(
        self,
        parameters: Parameters,
        starts: Starts,
        fineness: Fineness,
        coarseness: Fineness,
        forced: Forced | None = None,
    ) -> None:
        """From their apexes."""
        super().__init__(parameters, starts.centre, fineness, forced)
        self.coarse = coarseness
        self.columns = (*COORDINATES, *([PARAMETER] if self.varied else []))
        with ctx.workprec(coarseness.bits):
            balls = starts.balls()
            whole = balls[6] if self.varied else None
            self.wide = parameters.balls(whole)
            self.dual = parameters.balls(whole, dual=True)
            self.ledger = Ledger(self.wide)
            numbers = seeds(balls, self.columns)
            for number, slope in zip(numbers, starts.tilt, strict=False):
                number.gradient = {**number.gradient, PARAMETER: slope}
            begun = motion_at(self.dual, numbers[:6], numbers[6] if self.varied else None)
            self.offset = arb_mat(len(balls), 1, [arb(0, radius) for radius in starts.radii])
            self.spread = Spread(self._slopes(begun, self.names, self.columns))
            self.set = {name: arb(value_of(begun[name])) for name in self.names}
            self._check_gravity()
        self.drift = Drift(len(self.names))
        self._begin_at(self.centre, None)

    def _check_gravity(self) -> None:
        """In flight the centre of mass falls."""
        runner = self.wide
        if not rise(runner, runner.free_center.x, runner.free_center.y) < 0:
            raise UndecidedError("whether the centre of mass falls in flight", 0.0)

    @staticmethod
    def _slopes(numbers: Mapping[str, object], rows: Sequence[str], columns: Sequence[str]) -> arb_mat:
        entries = [arb(slope_of(numbers[row], column)) for row in rows for column in columns]
        return arb_mat(len(rows), len(columns), entries)

    # ---- steps -----------------------------------------------------------------------------------------

    def step(self) -> bool:
        """One step, or a part of one up to an event; whether it ends the stride."""
        with ctx.workprec(self.fine.bits):
            thin = Flow(self.thin, self.mode, self.centre, self.fine.degree)
        with ctx.workprec(self.coarse.bits):
            flow = VariedFlow(self.wide, self.mode, self.set, self.coarse.degree, maximum=thin.reach)
            return self._go(thin, flow)

    def _begin_at(self, found: Values, derivative: arb_mat | None) -> None:
        """The centre as a point, and its error as drift."""
        with ctx.workprec(self.fine.bits):
            points = {name: arb(found[name]).mid() for name in self.names}
            fresh = [arb(found[name]) - points[name] for name in self.names]
            self.centre = points
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
        with ctx.workprec(self.fine.bits):
            found = thin.at(end)
        self._begin_at(found, derivative)
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
        numbers = dict(zip(names, seeds([met.values[name] for name in names], names), strict=True))
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
        """How the event's time moves with the start, and the derivative: each column goes on by as much."""
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
        with ctx.workprec(self.fine.bits):
            own = Guard(name, FUNCTIONS[name](self.thin, mode, thin.record()), met.guard.order)
            low, high = (arb(bound.mid()) for bound in (times.lower(), times.upper()))
            when = own.zero_after(low, high) if low < high else None
            when = times if when is None else when
            at = thin.at(when)
            return (when, at), Transition(self.thin, mode, at, met.forced).take(name)

    def _close(self) -> Stride:
        with ctx.workprec(self.fine.bits):
            balls = {
                name: self.centre[name] + d for name, d in zip(self.names, self.drift.balls(), strict=True)
            }
            centre = [arb(value) for value in apex_of(self.thin, balls)]
        with ctx.workprec(self.coarse.bits):
            numbers = dict(zip(self.names, seeds([self.set[n] for n in self.names], self.names), strict=True))
            apexes = dict(zip(COORDINATES, apex_of(self.dual, numbers), strict=True))
            derivative = self._slopes(apexes, COORDINATES, self.names) * self.spread.product
            return self._closed(centre, [arb(value_of(a)) for a in apexes.values()], derivative)
