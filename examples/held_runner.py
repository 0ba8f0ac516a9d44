"""A system of two units, described by SSP: the runner, and a controller that holds its speed.

    python examples/held_runner.py

The controller, examples/stride_controller, sees the speed of each stride that has closed and sets the
touchdown angle for the next ones. The script has CMake build it and the system, held_runner.ssp, runs that by
FMPy, and compares with the library, in which the angle changes at the same communication points: a step after
the one in which the stride closed, as each unit gets at the beginning of a step what the others had at the
end of the last. `fmucontainer -container held_runner.ssp:0.1` makes one unit of the system.

How much that delay costs, against an angle set at the apex itself: after 8 strides, while the angle still
changes, the runner's position differs by 1.5e-4, 4.2e-5 and 4.1e-6 leg lengths with communication steps of 1,
0.1 and 0.01 sqrt(m/k); after 20, when the speed is held, by 1.7e-5, 3.1e-6 and 3.1e-7.
"""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import tdmf_slip
from fmpy.ssp.simulation import simulate_ssp
from tdmf_slip.library.binding import c, ffi

SOURCE = pathlib.Path(__file__).resolve().parent / "stride_controller"
WANTED_SPEED, PROPORTIONAL_GAIN, INTEGRAL_GAIN, LARGEST_ANGLE = 1.05, 4.0, 1.0, 0.1
STRIDES = 20
LONGEST = 600.0


def build(folder):
    """Build the system of both units in a folder; return its path."""
    command = ["cmake", "-S", SOURCE, "-B", folder, f"-DRUNNER={tdmf_slip.fmu_path()}"]
    subprocess.run([*command, f"-DPython3_EXECUTABLE={sys.executable}"], check=True, stdout=sys.stderr)
    subprocess.run(["cmake", "--build", folder], check=True, stdout=sys.stderr)
    return pathlib.Path(folder) / "held_runner.ssp"


class Held:
    """The library's runner, whose touchdown angle the same controller sets."""

    def __init__(self):
        """Begin at the unit's start."""
        self.model, self.motion = ffi.new("tdmf_model *"), ffi.new("tdmf_motion *")
        self.solver, self.inputs = ffi.new("tdmf_solver *"), ffi.new("tdmf_inputs *")
        self.solver[0], self.inputs[0] = c.tdmf_solver_default(), c.tdmf_default_inputs()
        parameters = ffi.new("tdmf_parameters *", c.tdmf_default_parameters())
        motion = self.motion
        c.tdmf_default_state(motion.state)
        made = c.tdmf_model_create(self.model, parameters)
        self.system = ffi.new("tdmf_system *", {"model": self.model, "inputs": self.inputs})[0]
        begun = c.tdmf_start(self.system, motion)
        assert made.variable == begun.variable == ffi.NULL
        self.errors = 0.0

    @property
    def strides(self):
        """Number of strides completed so far."""
        return int(self.motion.state[c.TDMF_STRIDE_COUNT])

    @property
    def position(self):
        """Position of the centre of mass, m."""
        outputs = ffi.new("tdmf_outputs *")
        c.tdmf_outputs_of(self.system, self.motion, outputs)
        return outputs.com.x

    def advance(self, until):
        """Run up to a time; True if a stride closed."""
        strides = self.strides
        outcome = c.tdmf_native_advance(self.solver, self.system, ffi.NULL, until, self.motion)
        assert outcome == c.TDMF_ARRIVED, ffi.string(c.tdmf_outcome_text(outcome))
        return self.strides > strides

    def advance_to_apex(self, until):
        """Run up to the apex that closes a stride, or to a time; True if a stride closed."""
        done = c.tdmf_native_stride(self.solver, self.system, until, self.motion)
        assert done.outcome == c.TDMF_ARRIVED, ffi.string(c.tdmf_outcome_text(done.outcome))
        return done.closed

    def controlled_angle(self):
        """Touchdown angle that the controller sets after a stride."""
        error = self.motion.state[c.TDMF_STRIDE_SPEED] - WANTED_SPEED
        self.errors += error
        angle = PROPORTIONAL_GAIN * error + INTEGRAL_GAIN * self.errors
        return max(-LARGEST_ANGLE, min(LARGEST_ANGLE, angle))


def by_communication(step, stop_time=LONGEST, delay=1):
    """The library's run with changes at communication points: (time, position, leg angle, speed, angle)."""
    held, rows, time, ordered = Held(), [], 0.0, [0.0] * (1 + delay)
    while time < stop_time:
        held.inputs.control.touchdown_angle = ordered[0]
        closed = held.advance(time + step)
        ordered = [*ordered[1:], held.controlled_angle() if closed else ordered[-1]]
        speed = held.motion.state[c.TDMF_STRIDE_SPEED]
        angle = held.motion.state[c.TDMF_LEG_ANGLE]
        rows.append((time, held.position, angle, speed, held.inputs.control.touchdown_angle))
        time += step
    return rows


def at_the_apex(stop_time=LONGEST):
    """The library's run with changes at the apex itself: its position at the end."""
    held = Held()
    while held.advance_to_apex(stop_time):
        held.inputs.control.touchdown_angle = held.controlled_angle()
    return held.position


def cost_of_delay(step, stop_time=500.0):
    """Error of the final position where changes wait for communication points."""
    end, position, *_ = by_communication(step, stop_time)[-1]
    return abs(position - at_the_apex(end + step))


def main():
    """Build, run, compare."""
    step = 0.1
    with tempfile.TemporaryDirectory() as folder:
        rows = simulate_ssp(str(build(folder)), stop_time=LONGEST, step_size=step)
    for i in np.flatnonzero(np.diff(rows["controller.strides"])) + 2:  # the controller's step is done
        stride, speed, angle = (rows[name][i] for name in ("controller.strides", "speed", "touchdown_angle"))
        print(f"stride {stride:2}  speed {speed:.5f}  angle {angle:+.5f} rad")
    off = max(
        abs(position - row[1]) for position, row in zip(rows["position"], by_communication(step), strict=True)
    )
    print(f"position off the library's by {off:.1e}")
    for step in (1.0, 0.1, 0.01):
        print(f"step {step:4}: position off that of changes at the apex by {cost_of_delay(step):.1e}")


if __name__ == "__main__":
    main()
