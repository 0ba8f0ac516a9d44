"""Length and costs of a stride: quadratures along the tubes, over all starts."""

from typing import Any

from flint import arb

from ..equations import leg
from . import laws
from .entered import Entered
from .flow import Flow, Values
from .modes import Mode
from .tube import Tube


class Ledger:
    """Sums of a stride."""

    def __init__(self, runner: Any) -> None:
        """At its beginning."""
        self.runner = runner
        self.along, self.hip_work, self.leg_work, self.slid = arb(0), arb(0), arb(0), arb(0)
        self.stance_time, self.touchdowns = arb(0), 0
        self.liftoff_angle: arb | None = None

    def add(self, flow: Flow, end: arb) -> None:
        """A part of a step."""
        at, mode, runner = flow.record(), flow.mode, self.runner
        if mode.contact == "flight":
            self.along += integral(at.along, end)
        else:
            begun, ended = (flow.body_ahead_of_foot(time) for time in (arb(0), end))
            self.along += runner.model.body_share * (ended - begun)
            if mode.contact != "stick":
                path = integral(at.foot_speed, end)
                self.along += path
                if mode.contact == "slip":
                    self.slid += path * mode.sign
        if mode.touches:
            self.stance_time += end
        torque = laws.torque(runner, mode, at)
        if isinstance(torque, Tube):
            self.hip_work += integral(torque * at.angle_rate, end)
        elif not (mode.contact == "flight" and torque == 0):
            self.hip_work += torque * (flow.at(end)["angle"] - flow.start["angle"])

    def record(self, before: Mode, entered: Entered, values: Values) -> None:
        """An event."""
        after = entered.mode
        self.touchdowns += entered.impact
        if (before.touches or entered.impact) and not after.touches:
            self.liftoff_angle = arb(getattr(entered.values["angle"], "value", entered.values["angle"]))
        if before.thrusts != after.thrusts:
            length = entered.values["length"]
            old, new = laws.rest_length(self.runner, before), laws.rest_length(self.runner, after)
            self.leg_work += leg.work_of_jump(self.runner.model.parameters.leg.stiffness, length, old, new)

    def quantities(self, period: arb) -> dict[str, arb]:
        """Of the whole stride, by the names of the unit's group `stride`, and the angle at lift-off."""
        runner = self.runner
        length = self.along * runner.line.cosine
        weight = runner.model.total_mass * runner.model.parameters.gravity
        work = self.hip_work + self.leg_work
        found = {
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
        }
        if self.liftoff_angle is not None:
            found["liftoff_angle"] = self.liftoff_angle
        return found


def integral(tube: Tube, end: arb) -> arb:
    """Of a tube from 0 to a time."""
    terms = tube.span.degree + 2
    return tube.polynomial.integral()(end) + end**terms * tube.remainder / terms * arb(0).union(arb(1))
