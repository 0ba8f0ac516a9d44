"""A stride from apex to apex, in steps and events; each event is proved to be the first of its step."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self

from flint import arb, arb_mat, ctx

from ..hybrid import cos
from ..library.section import COORDINATES
from .dual import UndecidedError, slope_of, value_of
from .flow import Flow, Tube, Values, speeds, with_direction
from .guards import Guard, guard_of, watched
from .parameters import Forced, Mode, Parameters, at, names_of
from .starts import apex_of, degree_for, motion_at, seeded
from .transitions import Entered, Transition


class Ledger:
    """Sums of a stride."""

    def __init__(self, runner: Any) -> None:
        """Begin the sums of a stride at zero."""
        self.runner = runner
        self.along, self.hip_work, self.leg_work, self.slid = arb(0), arb(0), arb(0), arb(0)
        self.stance_time = arb(0)
        self.at_liftoff: dict[str, arb] = {}

    def add(self, flow: Flow, end: arb) -> None:
        """Add a part of a step."""
        motion, mode, runner = flow.motion(self.runner), flow.mode, self.runner
        if mode.contact == "flight":
            self.along += integral(motion.along, end)
        else:
            begun, ended = (flow.body_ahead_of_foot(time) for time in (arb(0), end))
            self.along += runner.share() * (ended - begun)
            if mode.contact != "stick":
                path = integral(motion.foot_vx, end)
                self.along += path
                if mode.contact == "slip":
                    self.slid += path * mode.sign
        if mode.touches:
            self.stance_time += end
        torque = motion.torque()
        if isinstance(torque, Tube):
            self.hip_work += integral(torque * motion.angle_rate, end)
        else:
            self.hip_work += torque * (flow.at(end)["angle"] - flow.start["angle"])

    def record(self, before: Mode, entered: Entered) -> None:
        """Record an event."""
        after = entered.mode
        if (before.touches or entered.impact) and not after.touches:
            self.at_liftoff = {"liftoff_angle": arb(value_of(entered.values["angle"]))}
        if before.thrusts != after.thrusts:
            jumping = at(self.runner, before, {"length": entered.values["length"]})
            self.leg_work += value_of(jumping.work_of_thrust(after.thrusts))

    def quantities(self, period: arb) -> dict[str, arb]:
        """Quantities of the stride by the names of the unit's group `stride`, and the angle at lift-off."""
        runner = self.runner
        length = self.along * cos(runner.slope)
        weight = (runner.body_mass + runner.foot_mass) * runner.gravity
        work = self.hip_work + self.leg_work
        return {
            "period": period,
            "length": length,
            "speed": length / period,
            "work": work,
            "hip_work": self.hip_work,
            "leg_work": self.leg_work,
            "cost_of_transport": work / (weight * length),
            "slip_distance": self.slid,
            "stance_time": self.stance_time,
            "duty_factor": self.stance_time / period,
            **self.at_liftoff,
        }


def integral(tube: Tube, end: arb) -> arb:
    """Integral of a tube from 0 to a time."""
    terms = tube.span.degree + 2
    return tube.polynomial.integral()(end) + end**terms * tube.remainder / terms * arb(0).union(arb(1))


MAX_STEPS = 5000


@dataclass(frozen=True)
class Event:
    """An event of a stride."""

    name: str
    """Name of the event, one of `guards.EVENTS`."""
    time: arb
    """Time since the apex, s, over all starts."""
    mode: Mode
    """Mode that the event leads to."""


@dataclass(frozen=True)
class Met:
    """An event as it is met in a step."""

    guard: Guard
    """Guard that falls through zero."""
    times: arb
    """Times of the event in the step, over all starts."""
    values: Values
    """Numbers of the motion at the event."""
    before: Mode
    """Mode that ends."""
    entered: Entered
    """Mode and motion that come next."""
    forced: Forced | None
    """Constraint, if the event is taken as on one side of a border."""


class Traveller:
    """A stride of a single start, not proved; `SetTraveller` proves that of a set of starts."""

    end: list[arb]
    """The apex that the centre reaches, shape (6,)."""
    derivative: arb_mat
    """Derivative of the map over all starts, shape (6, 6), or (6, 7) with the varied parameter."""
    quantities: dict[str, arb]
    """Quantities of the stride, over all starts."""

    def __init__(
        self,
        parameters: Parameters,
        centre: Sequence[arb],
        bits: int,
        forced: Forced | None = None,
    ) -> None:
        """Begin at an apex."""
        self.bits, self.parameters, self.forced = bits, parameters, forced
        self.margin = arb(0)
        """Margin of the forced event, at the centre."""
        self.margin_slopes: list[arb] = []
        """Derivatives of the margin by the start, over all starts, shape (6,) or (7,)."""
        self.varied = parameters.varied is not None
        with ctx.workprec(bits):
            self.thin = parameters.balls(centre[6] if self.varied else None)
            self.wide = self.thin
            self.centre: Values = motion_at(self.thin, list(centre[:6]), centre[6] if self.varied else None)
        self.mode = Mode("flight", places=True)
        self.time = arb(0)
        self.zeros: Mapping[str, int] = {}
        self.events: list[Event] = []
        """Events in the order in which they are taken."""
        self.letters: list[str] = []
        self.flew = True
        self.set: Values = self.centre
        self.names = names_of(self.thin, self.mode)
        self.ledger = Ledger(self.wide)
        self.rank = len(COORDINATES)
        """Bound of the rank of the derivative: one less than the numbers of the mode with the fewest."""

    @property
    def word(self) -> str:
        """The gait word, the same for all starts."""
        return "".join(self.letters)

    # ---- steps -----------------------------------------------------------------------------------------

    def stride(self) -> Self:
        """Follow to the next apex."""
        with ctx.workprec(self.bits):
            for _ in range(MAX_STEPS):
                try:
                    if self.step():
                        self._close()
                        self.quantities = self.ledger.quantities(self.time)
                        return self
                except UndecidedError as problem:
                    if problem.time is None:
                        problem.time = float(self.time.mid()) if self.time.is_finite() else None
                    raise
        raise UndecidedError("the end of the stride")

    def step(self) -> bool:
        """Go one step, or a part of one up to an event, and say whether that ends the stride."""
        flow = Flow(self.thin, self.mode, self.centre, degree_for(self.bits))
        return self._go(flow, flow)

    def _go(self, thin: Flow, flow: Flow) -> bool:
        """Go to the end of a step or to the first event, and say whether that ends the stride."""
        motion, end = flow.motion(self.wide), flow.reach
        guards = [Guard(name, guard_of(name, motion), self.zeros.get(name, 0)) for name in watched(motion)]
        while True:
            first, times = self._first(guards, flow, end)
            if first is not None:
                assert times is not None
                return self._pass(first, thin, flow, times)
            if times is None:
                self.ledger.add(flow, end)
                self._advance(thin, flow, end)
                self.time, self.zeros = self.time + end, {}
                return False
            end = times

    def _first(self, guards: list[Guard], flow: Flow, end: arb) -> tuple[Guard | None, arb | None]:
        """The guard that is first to fall through zero, and the time; otherwise the end of this step.

        (None, None) says that all guards are positive up to `end`.
        """
        begin = arb(0)
        reached = [(guard, guard.reached(begin, end)) for guard in guards]
        open_ones = [(guard, until) for guard, until in reached if until is not None]
        if not open_ones:
            return None, None
        forced = self._now()
        rival = forced.rival if forced is not None else ""
        candidates = [pair for pair in open_ones if pair[0].name != rival] or open_ones
        first, from_here = min(candidates, key=lambda pair: float(pair[1]))
        times = first.zero_after(from_here, end)
        if times is None or not self._falls(first, flow, from_here.union(times)):
            sooner = (from_here * arb("0.75")).mid()
            if not sooner > end * arb("0.001"):
                raise UndecidedError(first.name)
            return None, sooner
        latest = arb(times.upper().mid())
        for guard in guards:
            if guard is first or guard.is_positive(begin, latest):
                continue
            if guard.name != rival or not self._vanishes_with(guard, flow, latest):
                raise UndecidedError(f"{first.name} or {guard.name}, which is first")
        return first, times

    def _now(self) -> Forced | None:
        """Constraint on the next event, if it is forced."""
        forced = self.forced
        return forced if forced is not None and forced.index == len(self.events) else None

    def _vanishes_with(self, guard: Guard, flow: Flow, latest: arb) -> bool:
        """True if a guard that is zero at an event is proved to be positive before it, and to fall."""
        until = guard.reached(arb(0), latest)
        return until is None or self._falls(guard, flow, until.union(latest))

    def _falls(self, guard: Guard, flow: Flow, times: arb) -> bool:
        """True if a guard is proved to fall all the time. It then has at most one zero."""
        return bool(rate_of_guard(self.wide, self.mode, guard.name, flow.at(times)) < 0)

    def _advance(self, thin: Flow, flow: Flow, end: arb) -> None:
        self.centre = self.set = {name: value.mid() for name, value in thin.at(end).items()}

    # ---- events ----------------------------------------------------------------------------------------

    def _pass(self, guard: Guard, thin: Flow, flow: Flow, times: arb) -> bool:
        """Take the event, and return True if it ends the stride."""
        self.ledger.add(flow, times)
        at_event = flow.at(times)
        forced = self._now()
        entered = Transition(self.wide, self.mode, at_event, forced).take(guard.name)
        self.time = self.time + times
        self._note(guard.name, entered)
        before, self.mode, self.zeros = self.mode, entered.mode, entered.zeros
        self.rank = min(self.rank, len(self.names) - self.varied - 1)
        self.names = names_of(self.wide, self.mode)
        self._land(Met(guard, times, at_event, before, entered, forced), thin, flow)
        return entered.closes

    def _land(self, met: Met, thin: Flow, flow: Flow) -> None:
        entered = met.entered
        if entered.margin is not None:
            self.margin = arb(entered.margin)
        self.centre = self.set = {name: arb(entered.values[name]).mid() for name in self.names}

    def _note(self, name: str, entered: Entered) -> None:
        before, mode = self.mode, entered.mode
        self.events.append(Event(name, self.time, mode))
        self.ledger.record(before, entered)
        if not mode.letter:
            self.flew = self.flew or mode.contact == "flight"
            return
        if self.flew and self.letters:
            self.letters.append("|")
        if not self.letters or self.letters[-1] != mode.letter:
            self.letters.append(mode.letter)
        self.flew = False

    def _close(self) -> None:
        self.end = [arb(value) for value in apex_of(self.thin, self.centre)]


def gradient_of_guard(runner: Any, mode: Mode, name: str, values: Values) -> list[arb]:
    """Gradient of a guard by the numbers of the motion, in their order."""
    found = guard_of(name, at(runner, mode, with_direction(runner, seeded(values))))
    return [arb(slope_of(found, of)) for of in values]


def rate_of_guard(runner: Any, mode: Mode, name: str, values: Values) -> arb:
    """Time derivative of a guard, at an instant or over a ball of times."""
    steepness, rates = gradient_of_guard(runner, mode, name, values), speeds(runner, mode, values)
    return sum((by * rates[of] for of, by in zip(values, steepness, strict=True)), arb(0))
