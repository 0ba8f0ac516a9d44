"""Events: mode and motion after an event, decided by signs that are proved.

A chain of events at one instant is followed as the model orders it: impact, thrust, drive to coast, contact
or graze or flight, stick or slip. Guards of the new mode that are exactly zero are reported with their order.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from flint import arb

from .dual import Number, UndecidedError, value_of
from .flow import with_direction
from .guards import EVENTS, guard_of
from .parameters import Forced, Mode, at, names_of

NARROWEST_GRAZE = arb(10) ** -10
"""Difference of the two laws' torques at a lift-off, in units of k l0^2, below which the foot flies."""


@dataclass
class Entered:
    """The mode that an event leads to."""

    mode: Mode
    """Mode after the event and all that follow it at the same instant."""
    values: dict[str, Number]
    """Numbers of the motion, by the names of the mode."""
    zeros: Mapping[str, int] = field(default_factory=dict)
    """Order in time to which each guard begins at exactly zero."""
    closes: bool = False
    """True if a stride ends here, at an apex in flight."""
    impact: bool = False
    """True if the foot came down."""
    margin: Number | None = None
    """Margin of an event that is forced: zero on the border."""


def positive(number: Number, what: str) -> bool:
    """The sign of a number that is not zero."""
    value = value_of(number)
    if value > 0:
        return True
    if value < 0:
        return False
    raise UndecidedError(what)


class Transition:
    """The model's rules at one instant, for numbers of a motion that are balls or duals of balls."""

    def __init__(
        self, runner: Any, mode: Mode, values: Mapping[str, Number], forced: Forced | None = None
    ) -> None:
        """Begin at the event, in the mode that ends."""
        self.runner, self.mode = runner, mode
        self.kind = forced.kind if forced is not None else ""
        self.forced_sign = forced.sign if forced is not None else 0
        self.margin: Number | None = None
        self.values = {"foot_vx": arb(0), **with_direction(runner, values)}
        self.zeros: dict[str, int] = {}
        self.touched = False

    def motion(self, mode: Mode) -> Any:
        """The runner now, in a mode."""
        return at(self.runner, mode, self.values)

    def is_positive(self, event: str, mode: Mode, what: str) -> bool:
        """The sign of a guard in a mode."""
        return positive(guard_of(event, self.motion(mode)), what)

    def take(self, event: str) -> Entered:
        """The mode after an event of a name in `guards.EVENTS`, by the rule that the page's event names."""
        rule = getattr(self, f"_{EVENTS[event]}", None)
        if rule is None:
            raise UndecidedError(event)
        entered: Entered = rule()
        entered.impact, entered.margin = self.touched, self.margin
        return entered

    # ---- contact ---------------------------------------------------------------------------------------

    def impact(self) -> bool:
        """The foot's velocity and the leg's rates after an impact (4)-(6); whether the foot slides on."""
        motion = self.motion(self.mode)
        foot = motion.foot()
        if positive(foot.off, "the foot's velocity into the ground"):
            raise UndecidedError("touchdown")
        lost = motion.friction * -foot.off
        stopped = motion.stopped_speed(lost)
        if self.kind == "impact at the limit of the cone":
            self.margin = foot.along * self._sign_of(foot.along) - stopped
        is_open = self.margin is None and not value_of(foot.along).is_zero()
        slides = is_open and self._slides(foot.along, stopped)
        speed: Number = arb(0)
        if slides:
            sign = self._sign_of(foot.along)
            left = motion.speed_left(foot.along * sign, lost)
            if not positive(left, "what the impact leaves of the foot's velocity"):
                raise UndecidedError("what the impact leaves of the foot's velocity")
            speed = left * sign
        self.values |= {"foot_vx": speed, **motion.kicked(foot.along - speed, foot.off)}
        return slides

    @staticmethod
    def _sign_of(velocity: Number) -> int:
        return 1 if positive(velocity, "the foot's velocity along the ground") else -1

    def _slides(self, along: Number, stopped: Number) -> bool:
        """True if the impact leaves the foot sliding. The velocity's sign may stay open if the foot stops."""
        value = value_of(along)
        if not (value > 0 or value < 0) and not abs(value) < value_of(stopped):
            raise UndecidedError("the foot's velocity along the ground")
        return positive(abs(value) - value_of(stopped), "whether the impact sticks")

    def _touchdown(self) -> Entered:
        self.touched, slides = True, self.impact()
        drives = positive(self.values["angle"], "the leg's angle at touchdown")
        if not positive(self.values["cosine"], "the leg above the ground"):
            raise UndecidedError("the body's height")
        self.mode = replace(self.mode, drives=drives, thrusts=self._is_thrusting())
        if self.is_positive("lift-off", self.mode, "the normal force after the impact"):
            return self._stand(moves=slides)
        return self._leave()

    def _is_thrusting(self) -> bool:
        if not self.runner.has_thrust or self.mode.thrusts:
            return self.mode.thrusts
        return positive(self.values["length_rate"], "the leg's rate as it is loaded")

    def _stand(self, *, moves: bool) -> Entered:
        """Stick or slip of a loaded foot; `moves` says that the speed is not zero."""
        stands = replace(self.mode, contact="stick", sign=0, places=False, clamped=False, rises=False)
        if moves:
            sign = 1 if positive(self.values["foot_vx"], "the foot's speed") else -1
            return self._enter(replace(stands, contact="slip", sign=sign))
        if self.kind == "rest at the limit of the cone":
            return self._slip_on(stands)
        cone = "the cone of a foot at rest"
        forwards = self.is_positive("slip onset forwards", stands, cone)
        backwards = self.is_positive("slip onset backwards", stands, cone)
        if forwards and backwards:
            return self._enter(stands)
        self.values["foot_vx"] = arb(0)
        self.zeros["end of slip"] = 1
        return self._enter(replace(stands, contact="slip", sign=-1 if forwards else 1))

    def _slip_on(self, stands: Mode) -> Entered:
        """Slip from the limit of the cone, as at an onset, though the foot would rest there as well."""
        sign = self.forced_sign
        onset = "slip onset forwards" if sign > 0 else "slip onset backwards"
        self.margin = guard_of(onset, self.motion(stands))
        self.mode = stands
        return self._onset(sign)

    def _onset(self, sign: int) -> Entered:
        """Begin to slip. On the cone the foot is at rest, and not accelerated if friction does not jump."""
        jumps = self.runner.is_stickier and not self.runner.falls_with_speed
        self.zeros["end of slip"] = 1 if jumps else 2
        self.values["foot_vx"] = arb(0)
        return self._enter(replace(self.mode, contact="slip", sign=sign))

    def _slips_forward(self) -> Entered:
        return self._onset(1)

    def _slips_backward(self) -> Entered:
        return self._onset(-1)

    def _comes_to_rest(self) -> Entered:
        self.values["foot_vx"] = arb(0)
        return self._stand(moves=False)

    def _mid_stance(self) -> Entered:
        self.values = with_direction(self.runner, {**self.values, "angle": arb(0)})
        self.mode = replace(self.mode, drives=False)
        return self._after_jump()

    def _greatest_compression(self) -> Entered:
        self.mode = replace(self.mode, thrusts=True)
        return self._after_jump()

    def _after_jump(self) -> Entered:
        """A force has jumped: the foot may leave, or begin to slip. In graze it may be loaded."""
        if self.is_positive("lift-off", self.mode, "the normal force after a jump"):
            return self._stand(moves=self.mode.contact != "stick")
        return self._enter(self.mode) if self.mode.contact == "graze" else self._leave()

    def _graze_to_contact(self) -> Entered:
        self.zeros["lift-off"] = 1
        self.mode = replace(self.mode, thrusts=self._is_thrusting())
        if self.runner.has_thrust and self.mode.thrusts:
            self.zeros.clear()
        return self._stand(moves=True)

    # ---- off the ground --------------------------------------------------------------------------------

    def _place_after_contact(self) -> bool:
        """True if the hip places the leg, rather than retracts it, when a contact ends."""
        if self.mode.places:
            return True
        return not self._rises()

    def _off(self) -> Mode:
        """Mode after lift-off, clamped where the servo's torque is negative."""
        places = self._place_after_contact()
        self.values["liftoff_angle"] = self.values["angle"]
        if not (self.mode.places and "placing" in self.values):
            self.values["placing"] = arb(0)
        mode = replace(self.mode, contact="graze", sign=0, places=places, clamped=False, rises=not places)
        if places or not self.runner.has_clamp:
            return mode
        return replace(mode, clamped=not self.is_positive("clamp", mode, "the clamp"))

    def _lift_off(self) -> Entered:
        mode = self._off()
        runner = self.runner
        if self.kind == "rest as it lifts off":
            self.margin = self.values["foot_vx"]
        is_free = mode.clamped or not runner.has_servo
        if is_free and not self.mode.drives:  # both laws are the torque from outside
            self.zeros["touchdown"] = self._order_of_rise()
            return self._fly(mode)
        excess = self.motion(mode).swing_torque() - self.motion(self.mode).stance_torque()
        pressing = -(excess * self.values["sine"]) - NARROWEST_GRAZE * runner.energy_scale
        if positive(pressing, "graze or flight"):
            self.zeros["load"] = 1
            return self._graze(mode)
        if not value_of(excess * self.values["sine"]) > 0:
            raise UndecidedError("graze or flight")
        self.zeros["touchdown"] = 2
        return self._fly(mode)

    def _leave(self) -> Entered:
        """The stance law does not load the foot: the flight law decides."""
        positive(self.values["sine"], "the hip's lever on the foot")
        mode = self._off()
        if self.is_positive("flight", mode, "graze or flight"):
            return self._graze(mode)
        self.zeros["touchdown"] = 2
        return self._fly(mode)

    def _graze(self, mode: Mode) -> Entered:
        if mode.places and self._rises():
            raise UndecidedError("an apex in graze, after the hip has begun to place the leg")
        return self._enter(mode)

    def _graze_to_flight(self) -> Entered:
        self.zeros["touchdown"] = self._order_of_rise()
        return self._fly(self.mode)

    def _order_of_rise(self) -> int:
        """Order of the foot's rise where no force acts on it yet: thrust that ends pulls it up at once."""
        return 2 if self.runner.has_thrust and self.mode.thrusts else 3

    def _fly(self, mode: Mode) -> Entered:
        self.values |= vars(self.motion(self._grounded()).center())
        rises = not mode.places or self._rises()
        flies = replace(mode, contact="flight", sign=0, drives=False, thrusts=False, rises=rises)
        return self._enter(flies)

    def _rises(self) -> bool:
        """True if the centre of mass rises, with the foot on the ground."""
        return self.is_positive("apex", self._grounded(), "whether the centre of mass rises")

    def _grounded(self) -> Mode:
        """The mode, with the foot on the ground; an impact may have ended a flight."""
        return replace(self.mode, contact="graze")

    def _apex(self) -> Entered:
        mode = replace(self.mode, places=True, clamped=False, rises=False)
        self.values["placing"] = arb(0)
        entered = self._enter(mode)
        entered.closes = mode.contact == "flight"
        return entered

    def _clamp(self) -> Entered:
        self.zeros["clamp"] = 1
        return self._enter(replace(self.mode, clamped=not self.mode.clamped))

    # ---- the numbers of a mode -------------------------------------------------------------------------

    def _enter(self, mode: Mode) -> Entered:
        values = {name: self.values[name] for name in names_of(self.runner, mode)}
        return Entered(mode, values, self.zeros)
