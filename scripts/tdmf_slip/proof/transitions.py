"""Events: mode and motion after an event, decided by signs that are proved.

A chain of events at one instant is followed as the model orders it: impact, thrust, drive to coast, contact
or graze or flight, stick or slip. Guards of the new mode that are exactly zero are reported with their order.
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import SimpleNamespace as Record
from typing import Any

from flint import arb

from . import laws
from .dual import Number, UndecidedError, value_of
from .flow import with_direction
from .guards import cone_backwards, cone_forwards, holding, normal_force, servo
from .laws import Entered, absolute, foot_rests, positive
from .parameters import PARAMETER, Forced, Mode

NARROWEST_GRAZE = arb(10) ** -10
"""In units of k l0^2: nearer than this both laws agree at a lift-off, and the foot flies."""


class Transition:
    """The model's rules at one instant, for numbers of a motion that are balls or duals of balls."""

    def __init__(
        self, runner: Any, mode: Mode, values: Mapping[str, Number], forced: Forced | None = None
    ) -> None:
        """At the event, in the mode that ends."""
        self.runner, self.mode = runner, mode
        self.kind = forced.kind if forced is not None else ""
        self.forced_sign = forced.sign if forced is not None else 0
        self.margin: Number | None = None
        self.at = Record(**with_direction(runner, values))
        self.speed: Number = arb(0)
        self.zeros: dict[str, int] = {}
        self.touched = False
        if mode.contact in ("slip", "graze"):
            self.speed = self.at.foot_speed

    def take(self, event: str) -> Entered:
        """The mode after an event of a name in `guards.FUNCTIONS`."""
        steps: dict[str, Callable[[], Entered]] = {
            "touchdown": self._touchdown,
            "apex": self._apex,
            "clamp": self._clamp,
            "lift-off": self._lift_off,
            "slip onset forwards": lambda: self._onset(1),
            "slip onset backwards": lambda: self._onset(-1),
            "end of slip": self._end_of_slip,
            "mid-stance": self._mid_stance,
            "greatest compression": self._thrust,
            "load": self._load,
            "flight": self._flight,
        }
        if event not in steps:
            raise UndecidedError(event)
        entered = steps[event]()
        if self.runner.varied:
            entered.values[PARAMETER] = self.at.parameter
        entered.impact, entered.margin = self.touched, self.margin
        return entered

    # ---- contact ---------------------------------------------------------------------------------------

    def impact(self) -> bool:
        """The foot's velocity and the leg's rates after an impact (4)-(6); whether the foot slides on."""
        at, runner = self.at, self.runner
        foot = laws.foot_velocity(runner, at)
        if positive(foot.off, "the foot's velocity into the ground"):
            raise UndecidedError("touchdown")
        fall = -foot.off
        if self.kind == "impact at the limit of the cone":
            sign = 1 if positive(foot.along, "the foot's velocity along the ground") else -1
            self.margin = foot.along * sign - laws.sticking_speed(runner, fall)
        slides = (
            self.margin is None
            and not foot_rests(foot.along)
            and positive(
                absolute(foot.along, "the foot's velocity along the ground", runner, fall)
                - laws.sticking_speed(runner, fall),
                "whether the impact sticks",
            )
        )
        if slides:
            sign = 1 if positive(foot.along, "the foot's velocity along the ground") else -1
            left = laws.impulse_taken(runner, foot.along * sign, fall)
            if not positive(left, "what the impact leaves of the foot's velocity"):
                raise UndecidedError("what the impact leaves of the foot's velocity")
            self.speed = left * sign
        lost = laws.kick(at, foot.along - self.speed, foot.off)
        at.length_rate, at.angle_rate = lost.length_rate, lost.angle_rate
        return slides

    def _touchdown(self) -> Entered:
        at = self.at
        self.touched, slides = True, self.impact()
        drives = positive(at.angle, "the leg's angle at touchdown")
        if not positive(at.cosine, "the leg above the ground"):
            raise UndecidedError("the body's height")
        self.mode = replace(self.mode, drives=drives, thrusts=self._is_thrusting())
        if positive(normal_force(self.runner, self.mode, at), "the normal force after the impact"):
            return self._stand(moves=slides)
        self._check_lever()
        return self._leave(self._place_after_contact(), latched=at.angle)

    def _is_thrusting(self) -> bool:
        if not self.runner.has_thrust or self.mode.thrusts:
            return self.mode.thrusts
        return positive(self.at.length_rate, "the leg's rate as it is loaded")

    def _check_lever(self) -> None:
        positive(self.at.sine, "the hip's lever on the foot")

    def _stand(self, *, moves: bool) -> Entered:
        """On a loaded foot: stick or slip; `moves` says whether its speed is not zero."""
        stands = replace(self.mode, contact="stick", sign=0, places=False, clamped=False, rises=False)
        if moves:
            sign = 1 if positive(self.speed, "the foot's speed") else -1
            return self._enter(replace(stands, contact="slip", sign=sign))
        if self.kind == "rest at the limit of the cone":
            return self._slip_on(stands)
        forwards = positive(cone_forwards(self.runner, stands, self.at), "the cone of a foot at rest")
        backwards = positive(cone_backwards(self.runner, stands, self.at), "the cone of a foot at rest")
        if forwards and backwards:
            return self._enter(stands)
        self.speed = arb(0)
        self.zeros["end of slip"] = 1
        return self._enter(replace(stands, contact="slip", sign=-1 if forwards else 1))

    def _slip_on(self, stands: Mode) -> Entered:
        """At the limit of the cone, as at an onset, though the foot would rest there as well."""
        sign = self.forced_sign
        cone = cone_forwards if sign > 0 else cone_backwards
        self.margin = cone(self.runner, stands, self.at)
        self.mode = stands
        return self._onset(sign)

    def _onset(self, sign: int) -> Entered:
        """At the edge of the cone the foot is at rest and not accelerated, if friction does not jump."""
        jumps = self.runner.is_stickier and not self.runner.friction_falls
        self.zeros["end of slip"] = 1 if jumps else 2
        self.speed = arb(0)
        return self._enter(replace(self.mode, contact="slip", sign=sign))

    def _end_of_slip(self) -> Entered:
        self.speed = arb(0)
        return self._stand(moves=False)

    def _mid_stance(self) -> Entered:
        upright = {**vars(self.at), "angle": arb(0)}
        self.at = Record(**with_direction(self.runner, upright))
        mode = self.mode = replace(self.mode, drives=False)
        if mode.contact == "graze":
            return self._resume()
        return self._after_jump()

    def _thrust(self) -> Entered:
        self.mode = replace(self.mode, thrusts=True)
        return self._after_jump()

    def _after_jump(self) -> Entered:
        """A force has jumped: the foot may leave, or begin to slip."""
        if positive(normal_force(self.runner, self.mode, self.at), "the normal force after a jump"):
            return self._stand(moves=self.mode.contact == "slip")
        self._check_lever()
        return self._leave(self._place_after_contact(), latched=self.at.angle)

    def _load(self) -> Entered:
        self.zeros["lift-off"] = 1
        self.mode = replace(self.mode, thrusts=self._is_thrusting())
        if self.runner.has_thrust and self.mode.thrusts:
            self.zeros.clear()
        return self._stand(moves=True)

    # ---- off the ground --------------------------------------------------------------------------------

    def _place_after_contact(self) -> bool:
        """Whether the hip goes to place, rather than to retract, where a contact ends."""
        if self.mode.places:
            return True
        flown = laws.fly(self.runner, self.at, self.speed)
        return not positive(
            laws.rise(self.runner, flown.along, flown.off), "whether the centre of mass rises"
        )

    def _off(self, places: bool, latched: Number) -> Mode:
        """Mode after lift-off, clamped where the servo's torque is negative; sets latched angle and clock."""
        at = self.at
        at.latched_angle = latched
        if not (self.mode.places and places and hasattr(at, "clock")):
            at.clock = arb(0)
        mode = replace(self.mode, contact="graze", sign=0, places=places, clamped=False, rises=not places)
        if places or not self.runner.has_clamp:
            return mode
        return replace(mode, clamped=not positive(servo(self.runner, mode, at), "the clamp"))

    def _lift_off(self) -> Entered:
        mode = self._off(self._place_after_contact(), self.at.angle)
        runner = self.runner
        if self.kind == "rest as it lifts off":
            self.margin = self.speed
        if (
            mode.clamped or not runner.has_servo
        ) and not self.mode.drives:  # both laws are the torque from outside
            self.zeros["touchdown"] = self._order_of_rise()
            return self._fly(mode)
        excess = laws.flight_torque(runner, mode, self.at) - laws.stance_torque(runner, self.mode)
        pressing = -(excess * self.at.sine) - NARROWEST_GRAZE * runner.energy_scale
        if positive(pressing, "graze or flight"):
            self.zeros["load"] = 1
            return self._graze(mode)
        if not value_of(excess * self.at.sine) > 0:
            raise UndecidedError("graze or flight")
        self.zeros["touchdown"] = 2
        return self._fly(mode)

    def _leave(self, places: bool, latched: Number) -> Entered:
        """The stance law does not load the foot: the flight law decides."""
        mode = self._off(places, latched)
        if positive(holding(self.runner, mode, self.at), "graze or flight"):
            return self._graze(mode)
        self.zeros["touchdown"] = 2
        return self._fly(mode)

    def _graze(self, mode: Mode) -> Entered:
        if mode.places and self._rises():
            raise UndecidedError("an apex in graze, after the hip has begun to place the leg")
        return self._enter(mode)

    def _flight(self) -> Entered:
        self.zeros["touchdown"] = self._order_of_rise()
        return self._fly(self.mode)

    def _order_of_rise(self) -> int:
        """Order of the foot's rise where no force acts on it yet: thrust that ends pulls it up at once."""
        return 2 if self.runner.has_thrust and self.mode.thrusts else 3

    def _fly(self, mode: Mode) -> Entered:
        flown = laws.fly(self.runner, self.at, self.speed)
        self.at.height, self.at.along, self.at.off = flown.height, flown.along, flown.off
        rises = not mode.places or self._rises()
        flies = replace(mode, contact="flight", sign=0, drives=False, thrusts=False, rises=rises)
        return self._enter(flies)

    def _rises(self) -> bool:
        flown = laws.fly(self.runner, self.at, self.speed)
        velocity = laws.rise(self.runner, flown.along, flown.off)
        return positive(velocity, "whether the centre of mass rises")

    def _apex(self) -> Entered:
        mode = replace(self.mode, places=True, clamped=False, rises=False)
        self.at.clock = arb(0)
        entered = self._enter(mode)
        entered.closes = mode.contact == "flight"
        return entered

    def _clamp(self) -> Entered:
        self.zeros["clamp"] = 1
        return self._enter(replace(self.mode, clamped=not self.mode.clamped))

    def _resume(self) -> Entered:
        """In graze the stance law has lost its drive: contact, flight or graze."""
        if positive(normal_force(self.runner, self.mode, self.at), "the normal force after a jump"):
            return self._stand(moves=True)
        return self._enter(self.mode)

    # ---- the numbers of a mode -------------------------------------------------------------------------

    def _enter(self, mode: Mode) -> Entered:
        at = self.at
        values = {name: getattr(at, name) for name in ("length", "angle", "length_rate", "angle_rate")}
        if mode.contact in ("slip", "graze"):
            values["foot_speed"] = self.speed
        if mode.contact == "flight":
            values |= {name: getattr(at, name) for name in ("height", "along", "off")}
        if not mode.touches:
            if not mode.places:
                values["latched_angle"] = at.latched_angle
            elif self.runner.retracts:
                values["clock"] = at.clock
        return Entered(mode, values, self.zeros)
