"""A system of two units, described by SSP: the runner, and a controller that holds its speed.

    python examples/held_runner.py

The controller, examples/stride_controller, sees the speed of each stride that has closed and sets the
touchdown angle for the next ones. The script has CMake build it and the system, held_runner.ssp, runs that by
FMPy, and compares with the runner's unit alone, whose angle the script sets at the same communication points:
a step after the one in which the stride closed, as each unit gets at the beginning of a step what the others
had at the end of the last. `fmucontainer -container held_runner.ssp:0.1` makes one unit of the system.

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
from runner import Runner

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


class Controller:
    """The controller of the system: the angle that it sets follows from the speeds of the strides."""

    def __init__(self):
        """Begin with no error."""
        self.errors = 0.0

    def angle_after(self, speed):
        """Touchdown angle that is added to the runner's own after a stride of this speed."""
        error = speed - WANTED_SPEED
        self.errors += error
        angle = PROPORTIONAL_GAIN * error + INTEGRAL_GAIN * self.errors
        return max(-LARGEST_ANGLE, min(LARGEST_ANGLE, angle))


def by_communication(step, stop_time=LONGEST):
    """The unit alone, with changes at communication points: (time, position, leg angle, speed, angle)."""
    controller, rows, time, held, sent, angle = Controller(), [], 0.0, 0.0, 0.0, 0.0
    with Runner(step) as runner:
        while time < stop_time:
            runner["control.touchdown_angle"] = held
            if runner.advance():
                angle = controller.angle_after(runner["stride.speed"])
            rows.append((time, runner["com.x"], runner["leg.angle"], runner["stride.speed"], held))
            time += step
            held, sent = sent, angle
    return rows


def at_the_apex(stop_time=LONGEST):
    """The library's run with changes at the apex itself: its position at the end."""
    controller, angle, time, position = Controller(), 0.0, 0.0, 0.0
    batch = tdmf_slip.Batch(tolerance=1e-12)
    while True:
        apex = batch.apices[0].copy()
        batch.step({"control.touchdown_angle": angle})
        stride = batch.last["stride"][0]
        if time + stride["period"] > stop_time:
            break
        time += stride["period"]
        position += stride["length"]
        angle = controller.angle_after(stride["speed"])
    held = tdmf_slip.Runner({"control.touchdown_angle": angle})
    begin, end = tdmf_slip.trajectory(held, apex, times=[0.0, stop_time - time])["com.x"].values
    return position + end - begin


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
    print(f"position off that of the unit alone by {off:.1e}")
    for step in (1.0, 0.1, 0.01):
        print(f"step {step:4}: position off that of changes at the apex by {cost_of_delay(step):.1e}")


if __name__ == "__main__":
    main()
