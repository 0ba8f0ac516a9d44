"""Strides from stated apices, integrated in extended precision: the data of strides.json.

    python strides.py > strides.json

It wants a long double of 64 bits or more, as on x86. This shares nothing with the library: body and foot
are two points in the plane with forces between them, the integrator is Gragg's midpoint rule with
extrapolation, and an event's time is found by secants on its guard, which has no margin. The ground is flat,
there is one friction coefficient, no thrust and no retraction. Each stride is integrated with two step sizes,
whose results agree to 13 digits at the least.
"""

import sys
from dataclasses import dataclass, field, replace

from numpy import arctan2, cos, format_float_positional, longdouble, sin, sqrt

COLUMNS = 10
CLOSE = longdouble("1e-16")
AGREED = longdouble("1e-13")
SEARCHES = 100

FLIGHT, STICK, FORWARD, BACKWARD, GRAZE = range(5)


@dataclass(frozen=True)
class Runner:
    """Body mass and leg length are 1."""

    gravity: str
    friction: str
    stiffness: str = "1"
    damping: str = "0.2"
    stance_torque: str = "0.2"
    kp: str = "0.1"
    kd: str = "0.1"
    foot_mass: str = "0.1"
    touchdown_angle: str = "0.6981317007977318"  # as the library has it: 40 degrees to double precision
    liftoff_angle_factor: str = "1.2"
    swing_clamp: bool = False


@dataclass
class Leg:
    length: longdouble
    rate: longdouble
    angle: longdouble
    angle_rate: longdouble
    sine: longdouble
    cosine: longdouble


def leg_of(state):
    """Length and angle of the leg, and their rates, from the places of foot and body."""
    x, y, vx, vy = (state[i + 4] - state[i] for i in range(4))
    length = sqrt(x * x + y * y)
    return Leg(
        length,
        (x * vx + y * vy) / length,
        arctan2(-x, y),
        (x * vy - y * vx) / length**2,
        -x / length,
        y / length,
    )


@dataclass
class Run:
    """One stride: `state` is x, y, vx, vy of the foot, then of the body."""

    runner: Runner
    step: longdouble
    state: list = field(default_factory=list)
    time: longdouble = field(default_factory=longdouble)
    mode: int = FLIGHT
    placing: bool = True
    driving: bool = False
    clamped: bool = False
    liftoff_angle: longdouble = field(default_factory=longdouble)
    events: list = field(default_factory=list)

    def __post_init__(self):
        for name, value in vars(self.runner).items():
            setattr(self, name, longdouble(value))

    # ---- laws -------------------------------------------------------------------------------------

    def axial(self, leg):
        return self.stiffness * (1 - leg.length) - self.damping * leg.rate

    def stance_torque_now(self):
        return -self.stance_torque if self.driving else longdouble(0)

    def servo(self, leg):
        target = self.touchdown_angle if self.placing else self.liftoff_angle_factor * self.liftoff_angle
        return -self.kp * (leg.angle - target) - self.kd * leg.angle_rate

    def flight_torque(self, leg):
        """Torque of the servo; before the apex, the clamp keeps it from being negative."""
        return max(self.servo(leg), longdouble(0)) if self.clamps else self.servo(leg)

    @property
    def clamps(self):
        return self.swing_clamp and not self.placing

    def normal(self, leg, torque):
        return self.axial(leg) * leg.cosine - torque / leg.length * leg.sine + self.foot_mass * self.gravity

    def sticking(self, leg, torque):
        return -self.axial(leg) * leg.sine - torque / leg.length * leg.cosine

    def torque(self, leg):
        if self.mode == FLIGHT:
            return longdouble(0) if self.clamped else self.servo(leg)
        if self.mode == GRAZE:
            load = self.axial(leg) * leg.cosine + self.foot_mass * self.gravity
            return leg.length * load / leg.sine
        return self.stance_torque_now()

    def ground(self, leg, torque):
        if self.mode in (FLIGHT, GRAZE):
            return longdouble(0), longdouble(0)
        normal = self.normal(leg, torque)
        if self.mode == STICK:
            return self.sticking(leg, torque), normal
        return (-1 if self.mode == FORWARD else 1) * self.friction * normal, normal

    def rates(self, state):
        leg = leg_of(state)
        torque = self.torque(leg)
        axial, across = self.axial(leg), torque / leg.length
        fx, fy = self.ground(leg, torque)
        body = (
            -axial * leg.sine - across * leg.cosine,
            axial * leg.cosine - across * leg.sine - self.gravity,
        )
        foot = (
            (fx + axial * leg.sine + across * leg.cosine) / self.foot_mass,
            (fy - axial * leg.cosine + across * leg.sine) / self.foot_mass - self.gravity,
        )
        if self.mode != FLIGHT:
            foot = (longdouble(0) if self.mode == STICK else foot[0], longdouble(0))
        return [state[2], state[3], *foot, state[6], state[7], *body]

    # ---- guards: what falls through zero at an event ----------------------------------------------

    def guards(self, state):
        leg = leg_of(state)
        if self.mode == FLIGHT:
            rise = (self.foot_mass * state[3] + state[7]) / (self.foot_mass + 1)
            of = {"touchdown": state[1]}
            if not self.placing:
                of["apex"] = rise
            if self.clamps:
                of["clamp"] = -self.servo(leg) if self.clamped else self.servo(leg)
            return of
        stance = self.normal(leg, self.stance_torque_now())
        if self.mode == GRAZE:
            flight = self.normal(leg, self.flight_torque(leg))
            return {"graze_to_contact": -stance, "graze_to_flight": flight}
        of = {"lift_off": stance}
        if self.driving:
            of["mid_stance"] = leg.angle
        if self.mode == STICK:
            push = self.sticking(leg, self.stance_torque_now())
            of["slip_onset_positive"] = self.friction * stance + push
            of["slip_onset_negative"] = self.friction * stance - push
        else:
            of["slip_velocity_zero"] = state[2] if self.mode == FORWARD else -state[2]
        return of

    # ---- resets -----------------------------------------------------------------------------------

    def stand(self):
        leg = leg_of(self.state)
        force = self.sticking(leg, self.stance_torque_now())
        if abs(force) <= self.friction * self.normal(leg, self.stance_torque_now()):
            self.mode = STICK
        else:
            self.mode = FORWARD if force < 0 else BACKWARD

    def touch_down(self):
        along, down = self.state[2], abs(self.state[3])
        slowed = max(abs(along) - self.friction * down, longdouble(0))
        self.state[1], self.state[3] = longdouble(0), longdouble(0)
        self.state[2] = slowed if along > 0 else -slowed
        leg = leg_of(self.state)
        self.driving = leg.angle >= 0
        assert self.normal(leg, self.stance_torque_now()) > 0, "the impact leaves at once: not followed"
        if self.state[2] == 0:
            self.stand()
        else:
            self.mode = FORWARD if self.state[2] > 0 else BACKWARD

    def lift_off(self):
        leg = leg_of(self.state)
        assert self.foot_mass * self.state[3] + self.state[7] > 0, "the centre of mass falls: not followed"
        self.liftoff_angle, self.placing = leg.angle, False
        self.clamped = self.clamps and self.servo(leg) < 0
        self.mode = GRAZE if self.normal(leg, self.flight_torque(leg)) > 0 else FLIGHT

    def take(self, event):
        if event == "touchdown":
            self.touch_down()
        elif event == "lift_off":
            self.lift_off()
        elif event == "mid_stance":
            self.driving = False
        elif event == "slip_velocity_zero":
            self.state[2] = longdouble(0)
            self.stand()
        elif event.startswith("slip_onset"):
            self.mode = FORWARD if event.endswith("positive") else BACKWARD
        elif event == "graze_to_flight":
            self.clamped = self.clamps and self.servo(leg_of(self.state)) < 0
            self.mode = FLIGHT
        elif event == "clamp":
            self.clamped = not self.clamped
        else:
            assert event == "apex", f"{event}: not followed"

    # ---- integration ------------------------------------------------------------------------------

    def midpoint(self, state, size, parts):
        h = size / parts
        before, now = state, [a + h * b for a, b in zip(state, self.rates(state), strict=True)]
        for _ in range(parts - 1):
            before, now = now, [a + 2 * h * b for a, b in zip(before, self.rates(now), strict=True)]
        return [(a + b + h * c) / 2 for a, b, c in zip(before, now, self.rates(now), strict=True)]

    def stepped(self, size):
        """The state after `size`, by extrapolation to steps of length zero."""
        row = []
        for k in range(COLUMNS):
            new = [self.midpoint(self.state, size, 2 * k + 2)]
            for j in range(k):
                factor = longdouble(k + 1) ** 2 / longdouble(k - j) ** 2 - 1
                new.append([a + (a - b) / factor for a, b in zip(new[j], row[j], strict=True)])
            row = new
        return row[-1]

    def time_of(self, event, after, size):
        """How far into the step a guard is zero, between `after` and the step's end."""
        low, high = after, size
        of_low, of_high = self.guards(self.stepped(low))[event], self.guards(self.stepped(high))[event]
        for _ in range(SEARCHES):
            middle = low - of_low * (high - low) / (of_high - of_low)
            value = self.guards(self.stepped(middle))[event]
            if abs(value) < CLOSE or high - low < CLOSE:
                return middle
            if value > 0:  # the end that stays counts half: else it might stay for ever
                low, of_low, of_high = middle, value, of_high / 2
            else:
                high, of_high, of_low = middle, value, of_low / 2
        return middle  # the guard is at the level of rounding all along, and so is what it decides

    def advance(self, begun):
        """One step, or up to the first event.

        A guard that is zero where its mode begins is looked at from a little later on.
        """
        soon = self.step / 1000 if begun else longdouble(0)
        reached = self.stepped(self.step)
        starts, ends = self.guards(self.stepped(soon) if begun else self.state), self.guards(reached)
        due = {}
        for event, value in ends.items():
            if value < -CLOSE:  # the clamp's argument may settle at zero, up to rounding
                assert starts[event] > 0, event
                due[event] = self.time_of(event, soon, self.step)
        if not due:
            self.time += self.step
            self.state = reached
            return None
        event = min(due, key=due.get)
        self.state = self.stepped(due[event])
        self.time += due[event]
        self.take(event)
        if event != "clamp":  # a kink, no event; near zero, rounding decides how often it closes
            self.events.append((event, self.time))
        return event


def stride_of(runner, apex, step):
    height, speed, length, angle, length_rate, angle_rate = map(longdouble, apex)
    share = longdouble(runner.foot_mass) / (1 + longdouble(runner.foot_mass))
    along = (-length * sin(angle), length * cos(angle))
    rate = (
        -length_rate * sin(angle) - length * angle_rate * cos(angle),
        length_rate * cos(angle) - length * angle_rate * sin(angle),
    )
    com, drift = (longdouble(0), height), (speed, longdouble(0))
    foot = [com[i] - along[i] * (1 - share) for i in range(2)] + [
        drift[i] - rate[i] * (1 - share) for i in range(2)
    ]
    body = [com[i] + along[i] * share for i in range(2)] + [drift[i] + rate[i] * share for i in range(2)]
    run = Run(runner, longdouble(step), foot + body)
    begun = False
    while not run.events or run.events[-1][0] != "apex":
        begun = run.advance(begun) is not None
    leg = leg_of(run.state)
    foot_mass = run.foot_mass
    last = (
        (foot_mass * run.state[1] + run.state[5]) / (1 + foot_mass),
        (foot_mass * run.state[2] + run.state[6]) / (1 + foot_mass),
        leg.length,
        leg.angle,
        leg.rate,
        leg.angle_rate,
    )
    return run, last


SPRINGY = {"damping": "0.5", "kd": "0.4"}
STIFF = {"damping": "0.5", "kd": "1"}
STIFFEST = {"damping": "2", "kd": "1"}
STRIDES = [
    (Runner("0.001", "0.6"), ("1.3", "0.3", "1", "1", "0", "0")),
    (Runner("0.001", "0.3", stance_torque="0.01"), ("0.95", "0.05", "1", "0.7", "0", "0")),
    (Runner("0.003", "0.43", stance_torque="0.05"), ("1", "0.2", "1", "0.7", "0", "0")),
    (Runner("0.01", "1.2"), ("1.35", "1", "1.004", "1.1", "0", "0.2")),
    (Runner("0.03", "0.6"), ("1.2", "1", "1", "0.8", "0", "0")),
    (Runner("0.1", "0.6", stiffness="4"), ("1.25", "1.5", "1", "0.6", "0", "0")),
    (
        Runner("1", "0.6", stiffness="20", kp="0.4", stance_torque="0.4", **SPRINGY),
        ("1.2", "3", "1", "0.5", "0", "0"),
    ),
    (
        Runner("1", "0.8", stiffness="50", kp="2", stance_torque="2", **STIFF),
        ("1.2", "3", "1", "0.5", "0", "0"),
    ),
    (
        Runner("1", "0.6", stiffness="100", kp="10", stance_torque="20", **STIFFEST),
        ("1.4", "10", "1", "1.2", "0", "0"),
    ),
]


def decimal(number):
    return format_float_positional(number, precision=18, trim="0")


def row(runner, apex, run, last, agreed):
    """A stride as an object of JSON, with more digits than a double has."""
    names = ("gravity", "friction", "stiffness", "damping", "stance_torque", "kp", "kd")
    given = ", ".join(f'"{name}": {getattr(runner, name)}' for name in names)
    events = ", ".join(f'["{event}", {decimal(time)}]' for event, time in run.events)
    return (
        f'  {{{given}, "swing_clamp": {str(runner.swing_clamp).lower()},\n'
        f'   "start": [{", ".join(apex)}], "apex": [{", ".join(decimal(a) for a in last[:agreed])}],\n'
        f'   "events": [{events}]}}'
    )


def agree(a, b):
    return abs(a - b) < AGREED * max(1, abs(a))


def stride_by_two_steps(runner, apex):
    """A stride, and how many coordinates of its apex both step sizes agree in.

    Under the weakest gravities the clamp opens and closes so often that some of it is lost in a step, and the
    leg swings otherwise.
    """
    runs = []
    for share in ("0.3", "0.22"):
        # A number that C reads is rounded to double precision first.
        rounded = Runner(**{k: longdouble(float(v)) for k, v in vars(runner).items()})
        step = longdouble(share) / sqrt(rounded.stiffness)
        runs.append(stride_of(rounded, [float(a) for a in apex], step))
        print(runner.gravity, share, decimal(runs[-1][0].time), file=sys.stderr, flush=True)
    (one, last), (other, last_of_other) = runs
    assert [event for event, _ in one.events] == [event for event, _ in other.events]
    for (_, a), (_, b) in zip(one.events, other.events, strict=True):
        assert abs(a / b - 1) < AGREED, "steps too long"
    same = [agree(a, b) for a, b in zip(last, last_of_other, strict=True)]
    assert same[0] and same[1], "steps too long"
    return other, last_of_other, len(same) if all(same) else 2


def main():
    rows = []
    for runner, apex in STRIDES:
        for clamp in (True, False):
            of_reading = replace(runner, swing_clamp=clamp)
            rows.append(row(of_reading, apex, *stride_by_two_steps(of_reading, apex)))
    print('{"strides": [\n' + ",\n".join(rows) + "\n]}")


if __name__ == "__main__":
    main()
