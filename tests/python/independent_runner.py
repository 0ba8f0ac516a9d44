"""A stride of the level-ground runner by SciPy, written without the pages: two masses in the world's axes."""

import numpy as np
from scipy.integrate import solve_ivp


def torque_of_gains(stance_kp, stance_kd, stance_target):
    """The hip's torque in stance: that of (11), and a proportional-derivative law."""

    def torque(_time, angle, turn, drives):
        return -0.2 * drives - stance_kp * (angle - stance_target) - stance_kd * turn

    return torque


class Stride:
    """One stride from an apex at Table 1 values, with laws of one's own."""

    mass, foot_mass, gravity, length, kp, kd, target, factor = (
        1.0,
        0.1,
        0.01,
        1.0,
        0.1,
        0.1,
        np.radians(40),
        1.2,
    )

    def __init__(self, friction, torque=None, spring=None, viscosity=0.0):
        self.friction, self.viscosity = friction, viscosity
        self.torque = torque or (lambda time, angle, turn, drives: -0.2 if drives else 0.0)
        self.spring = spring or (lambda short: short)
        self.time, self.events = 0.0, []
        self.mode, self.way, self.drives, self.swing, self.liftoff = "flight", 0, False, "place", 0.0

    def leg(self, y):
        """Unit vectors along and across the leg, and its length, angle and rates."""
        dx, dy, vx, vy = y[2:4] - y[:2], None, *(y[6:8] - y[4:6])
        dx, dy = dx
        r = np.hypot(dx, dy)
        along, across = np.array([dx, dy]) / r, np.array([-dy, dx]) / r
        return along, across, r, np.arctan2(-dx, dy), along @ (vx, vy), across @ (vx, vy) / r

    def forces(self, time, y, law=None):
        """Force of the leg on the body, hip torque and rate of the leg angle."""
        along, across, r, angle, rate, turn = self.leg(y)
        push = self.spring(self.length - r) - 0.2 * rate
        law = law or {"flight": "swing", "graze": "graze"}.get(self.mode, "stance")
        if law == "graze":
            torque = r * (push * np.cos(angle) + self.foot_mass * self.gravity) / np.sin(angle)
        elif law == "stance":
            torque = self.torque(time, angle, turn, self.drives)
        else:
            aim = self.target if self.swing == "place" else self.factor * self.liftoff
            torque = -self.kp * (angle - aim) - self.kd * turn
        return push * along + torque / r * across, torque, turn

    def normal(self, time, y, law="stance"):
        return self.forces(time, y, law)[0][1] + self.foot_mass * self.gravity

    def rates(self, time, y):
        force, torque, turn = self.forces(time, y)
        body = force / self.mass - [0, self.gravity]
        foot = -force / self.foot_mass - [0, self.gravity]
        if self.mode == "stick":
            foot = np.zeros(2)
        elif self.mode == "slip":
            friction = self.friction + self.viscosity * self.way * y[4]
            foot = np.array([(-force[0] - self.way * friction * self.normal(time, y)) / self.foot_mass, 0])
        elif self.mode == "graze":
            foot[1] = 0
        return np.concatenate([y[4:8], foot, body, [torque * turn]])

    def rise(self, time, y):
        return self.foot_mass * y[5] + self.mass * y[7]

    def guards(self):
        """Guards of the mode by the name of their event: each falls through 0."""
        along = lambda t, y: self.forces(t, y, "stance")[0][0]  # noqa: E731
        cone = lambda t, y: self.friction * self.normal(t, y)  # noqa: E731
        if self.mode == "flight":
            return {"touchdown": lambda t, y: y[1]} | ({} if self.swing == "place" else {"apex": self.rise})
        if self.mode == "graze":
            return {
                "contact": lambda t, y: -self.normal(t, y),
                "flight": lambda t, y: self.normal(t, y, "swing"),
            }
        found = {"lift_off": self.normal} | ({"mid": lambda t, y: self.leg(y)[3]} if self.drives else {})
        if self.mode == "slip":
            return found | {"rest": lambda t, y: self.way * y[4]}
        return found | {
            "forward": lambda t, y: cone(t, y) + along(t, y),
            "backward": lambda t, y: cone(t, y) - along(t, y),
        }

    def take(self, name, y):
        """What an event makes of mode and state."""
        if name == "touchdown":
            lost = self.friction * abs(y[5])
            y[4] = 0.0 if abs(y[4]) <= lost else y[4] - np.sign(y[4]) * lost
            y[1] = y[5] = 0.0
            self.way, self.drives = int(np.sign(y[4])), self.leg(y)[3] >= 0
            self.mode = "slip" if self.way else "stick"
        elif name == "mid":
            self.drives = False
        elif name == "lift_off":
            self.liftoff, self.swing = self.leg(y)[3], "retract" if self.rise(0, y) >= 0 else "place"
            self.mode = "graze" if self.normal(self.time, y, "swing") > 1e-12 else "flight"
        elif name == "flight":
            self.mode = "flight"
        elif name in ("forward", "backward"):
            self.mode, self.way = "slip", 1 if name == "forward" else -1
        else:  # the foot comes to rest, or into contact
            force = self.forces(self.time, y, "stance")[0][0]
            y[4] = 0.0 if name == "rest" else y[4]
            inside = abs(force) <= self.friction * self.normal(self.time, y)
            self.mode = "stick" if inside and y[4] == 0 else "slip"
            self.way = int(np.sign(y[4])) or int(-np.sign(force))
        if self.mode in ("stick", "slip", "graze"):
            y[1] = y[5] = 0.0

    def run(self, world):
        """From the world's states by name to the next apex: time, its six coordinates, the hip's work."""
        x, height, r, angle = (world[name] for name in ("seen_x", "seen_y", "length", "angle"))
        vx, vy, rate, turn = (world[name] for name in ("seen_vx", "seen_vy", "length_rate", "angle_rate"))
        sine, cosine = np.sin(angle), np.cos(angle)
        body = [x - r * sine, height + r * cosine]
        moves = [vx - rate * sine - r * turn * cosine, vy + rate * cosine - r * turn * sine]
        y = np.array([x, height, *body, vx, vy, *moves, 0.0])
        while True:
            guards = self.guards()
            hooks = []
            for guard in guards.values():
                hook = lambda t, y, guard=guard, t0=self.time: guard(t, y) if t > t0 + 1e-5 else 1e-30  # noqa: E731
                hook.terminal, hook.direction = True, -1
                hooks.append(hook)
            found = solve_ivp(
                self.rates, (self.time, self.time + 50), y, "DOP853", events=hooks, rtol=2e-12, atol=1e-14
            )
            self.time, y = found.t[-1], found.y[:, -1].copy()
            name = list(guards)[next(i for i, times in enumerate(found.t_events) if len(times))]
            self.events.append((self.time, name))
            if name == "apex":
                _, _, r, angle, rate, turn = self.leg(y)
                total = self.mass + self.foot_mass
                com = (self.foot_mass * y[[1, 4]] + self.mass * y[[3, 6]]) / total
                return self.time, np.array([*com, r, angle, rate, turn]), y[8]
            self.take(name, y)
