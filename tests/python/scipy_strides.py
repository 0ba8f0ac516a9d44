"""Strides of the paper's runner by SciPy, written from the equations for two point masses.

Table 1 in units m = k = l0 = 1, on level ground. Nothing here comes from the pages in `c_core/pages`.
Body and foot are points in the plane, pushed apart along the leg by F_s and across it by tau/r  (8)-(10).
The stance torque, the spring and the friction may follow laws of one's own.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp

FOOT, DAMPING, GRAVITY = 0.1, 0.2, 0.01
TORQUE, KP, KD, FACTOR, TOUCHDOWN_ANGLE = 0.2, 0.1, 0.1, 1.2, math.radians(40.0)
LONGEST = 100.0
"""Time within which every mode ends."""


def torque_of_gains(stance_kp, stance_kd, stance_target):
    """The hip's torque in stance: that of (11), and a proportional-derivative law."""

    def torque(_time, angle, turn, drives):
        return -TORQUE * drives - stance_kp * (angle - stance_target) - stance_kd * turn

    return torque


class Leg:
    """The leg between foot and body at a time, and the force along it."""

    def __init__(self, z, time, spring):
        self.z, self.time = z, time
        x, y, bx, by, vx, vy, bvx, bvy = z[:8]
        self.length, self.angle = math.hypot(bx - x, by - y), math.atan2(x - bx, by - y)
        self.sine, self.cosine = math.sin(self.angle), math.cos(self.angle)
        self.rate = -self.sine * (bvx - vx) + self.cosine * (bvy - vy)
        self.angle_rate = (-self.cosine * (bvx - vx) - self.sine * (bvy - vy)) / self.length
        self.force = spring(1.0 - self.length) - DAMPING * self.rate

    def normal(self, torque):
        """Normal force of the ground on a foot that stays on it."""
        return self.force * self.cosine - torque / self.length * self.sine + FOOT * GRAVITY

    def tangential(self, torque):
        """Tangential force that holds the foot in place."""
        return -self.force * self.sine - torque / self.length * self.cosine

    @property
    def rise(self):
        """Velocity of the centre of mass, upwards."""
        return (self.z[7] + FOOT * self.z[5]) / (1.0 + FOOT)


class Stride:
    """One stride from apex to apex.

    `torque` gets the time, the leg's angle and its rate, and whether the hip drives; `spring` gets the
    compression; friction grows by `viscosity` with the speed of the slip.
    """

    touchdown_angle = TOUCHDOWN_ANGLE

    def __init__(
        self,
        friction,
        swing_clamp=False,
        tolerance=1e-12,
        torque=None,
        spring=lambda short: short,
        viscosity=0.0,
    ):
        self.friction, self.swing_clamp, self.tolerance = friction, swing_clamp, tolerance
        self.law, self.spring, self.viscosity = torque or (lambda *at: -TORQUE * at[-1]), spring, viscosity
        self.mode, self.sign, self.phase, self.liftoff_angle = "flight", 0, "place", 0.0
        self.word, self.time = "", 0.0
        self.path = []  # start and SciPy's interpolation of each mode

    # ---- forces ----

    def leg(self, z, time):
        return Leg(z, time, self.spring)

    def stance_torque(self, leg):
        return self.law(leg.time, leg.angle, leg.angle_rate, self.phase == "drive")

    def flight_torque(self, leg):
        if self.phase == "place":
            return -KP * (leg.angle - self.touchdown_angle) - KD * leg.angle_rate
        servo = -KP * (leg.angle - FACTOR * self.liftoff_angle) - KD * leg.angle_rate
        return max(servo, 0.0) if self.swing_clamp else servo

    def torque(self, leg):
        if self.mode == "flight":
            return self.flight_torque(leg)
        if self.mode == "graze":
            return leg.length * (leg.force * leg.cosine + FOOT * GRAVITY) / leg.sine
        return self.stance_torque(leg)

    def rates(self, time, z):
        leg = self.leg(z, time)
        torque = self.torque(leg)
        across = torque / leg.length
        on_body = np.array(
            [-leg.force * leg.sine - across * leg.cosine, leg.force * leg.cosine - across * leg.sine]
        )
        on_foot = -on_body - [0.0, FOOT * GRAVITY]
        if self.mode == "stick":
            on_foot = np.zeros(2)
        elif self.mode == "slip":
            friction = self.friction + self.viscosity * self.sign * z[4]
            on_foot = np.array([on_foot[0] - self.sign * friction * leg.normal(torque), 0.0])
        elif self.mode == "graze":
            on_foot[1] = 0.0
        body = on_body - [0.0, GRAVITY]
        return [*z[4:8], *on_foot / FOOT, *body, torque * leg.angle_rate]

    # ---- events: each falls through zero ----

    def guards(self):
        if self.mode == "flight":
            return {"touchdown": lambda g: g.z[1]} if self.phase == "place" else {"apex": lambda g: g.rise}
        if self.mode == "graze":
            return {"flight": lambda g: g.normal(self.flight_torque(g)), "load": lambda g: -g.normal(0.0)}
        found = {"lift-off": lambda g: g.normal(self.stance_torque(g))}
        if self.phase == "drive":
            found["upright"] = lambda g: g.angle
        if self.mode == "slip":
            return found | {"rest": lambda g: self.sign * g.z[4]}
        return found | {"forwards": lambda g: self.room(g, 1), "backwards": lambda g: self.room(g, -1)}

    def room(self, leg, sign):
        """Margin to one edge of the friction cone; at 0 the foot at rest begins to slip."""
        torque = self.stance_torque(leg)
        return self.friction * leg.normal(torque) + sign * leg.tangential(torque)

    def stick_or_slip(self, z):
        """Set the contact mode of a foot at rest: stick, or slip where the cone is left."""
        leg = self.leg(z, self.time)
        self.mode, self.sign = "stick", 0
        for sign in (1, -1):
            if self.room(leg, sign) < 0.0:
                self.mode, self.sign = "slip", sign
        self.write()

    def write(self):
        letter = {0: "0", 1: "+", -1: "-"}[self.sign]
        self.word += letter if not self.word.endswith(letter) else ""

    def take(self, event, z):
        leg = self.leg(z, self.time)
        if event == "touchdown":
            z[1], impulse = 0.0, self.friction * abs(z[5])
            z[5] = 0.0
            self.phase = "drive" if leg.angle >= 0.0 else "coast"
            slides = abs(z[4]) > impulse
            z[4] = math.copysign(abs(z[4]) - impulse, z[4]) if slides else 0.0
            if slides:
                self.mode, self.sign = "slip", int(math.copysign(1, z[4]))
                self.write()
            else:
                self.stick_or_slip(z)
        elif event == "rest":
            z[4] = 0.0
            self.stick_or_slip(z)
        elif event in ("forwards", "backwards"):
            self.mode, self.sign = "slip", 1 if event == "forwards" else -1
            self.write()
        elif event == "upright":
            self.phase = "coast"
            if self.mode == "stick":
                self.stick_or_slip(z)
        elif event == "lift-off":
            stance, self.liftoff_angle, self.phase = self.stance_torque(leg), leg.angle, "retract"
            disagree = (self.flight_torque(leg) - stance) * leg.sine < -1e-10
            self.mode = "graze" if disagree else "flight"
        elif event == "flight":
            self.mode = "flight"
        else:
            raise AssertionError(event)

    def run(self, apex):
        """The next apex, with the duration, length and work of the stride."""
        height, speed, length, angle, rate, angle_rate = apex
        sine, cosine = math.sin(angle), math.cos(angle)
        to_body = np.array([-length * sine, length * cosine])
        turn = np.array([-length * cosine, -length * sine]) * angle_rate + rate * np.array([-sine, cosine])
        share = 1.0 / (1.0 + FOOT)
        center, velocity = np.array([0.0, height]), np.array([speed, 0.0])
        foot, body = center - share * to_body, center + (1.0 - share) * to_body
        z = np.array(
            [*foot, *body, *velocity - share * turn, *velocity + (1.0 - share) * turn, 0.0], dtype=float
        )
        while True:
            guards = self.guards()
            events = []
            for guard in guards.values():
                event = lambda time, now, guard=guard: guard(self.leg(now, time))  # noqa: E731
                event.terminal, event.direction = True, -1.0
                events.append(event)
            found = solve_ivp(
                self.rates,
                (self.time, self.time + LONGEST),
                z,
                method="DOP853",
                rtol=1e-12,
                atol=1e-14,
                events=events,
                dense_output=True,
            )
            self.path.append((self.time, found.sol))
            fired = next(n for n, times in zip(guards, found.t_events, strict=True) if len(times))
            self.time, z = found.t[-1], found.y[:, -1]
            if fired == "apex":
                return self.closed(z)
            self.take(fired, z)

    def at(self, time):
        """Foot and body with their velocities at a time of the stride that has been run."""
        _, solution = next(piece for piece in reversed(self.path) if piece[0] <= time)
        return solution(time)[:8]

    def closed(self, z):
        leg = self.leg(z, self.time)
        center = (z[2:4] + FOOT * z[0:2]) / (1.0 + FOOT)
        speed = (z[6] + FOOT * z[4]) / (1.0 + FOOT)
        end = np.array([center[1], speed, leg.length, leg.angle, leg.rate, leg.angle_rate])
        return {"apex": end, "period": self.time, "length": center[0], "work": z[8], "word": self.word}
