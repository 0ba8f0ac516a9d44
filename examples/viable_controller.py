"""A controller that avoids falls, through the unit: at each apex the viable action nearest to a wish.

    python examples/viable_controller.py

The viable set says which settings keep the runner up for ever, as far as a grid can tell. The runner is
pushed so that with its own settings it would fall; the controller takes others wherever it has to, and its
own again as soon as they are viable. The script is the importer, as in examples/stride_feedback.py, which
drives the unit in event mode from apex to apex.
"""

import tdmf_slip
from stride_feedback import pushed, run

ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"
RUNNER = {"ground.friction": 10.0}
RANGES = {"com_height": (0.5, 3.0), "com_speed": (0.0, 3.0)}
CHOICE = {ANGLE: (0.1, 1.2, 23), TORQUE: (0.0, 0.5, 6)}
PUSH = {"foot.y": 0.96, "foot.vx": 1.1}
"""Amounts by which the first apex is higher and faster than that of the gait: m, m/s."""
STRIDES = 12


class Unchanged:
    """No controller: the runner's own settings throughout."""

    def inputs_at(self, apex):
        """Set nothing."""
        return {}


def main():
    """Run without and with the controller, and print each stride."""
    found = tdmf_slip.viability(RUNNER, axes=RANGES, vary=CHOICE, n=48, model="full")
    gait = tdmf_slip.find_gait(RUNNER)
    law = tdmf_slip.ViableController(found)
    print(f"{found.inner_share:.1%} to {found.outer_share:.1%} of the states are viable")
    alone, _ = run(Unchanged(), pushed(gait, PUSH), STRIDES)
    print(f"with its own settings it makes {len(alone) - 1} of {STRIDES} strides")
    apices, settings = run(law, pushed(gait, PUSH), STRIDES)
    print(f"with the controller {len(apices) - 1}")
    print("stride  height  speed   " + "  ".join(CHOICE) + "  which is")
    for stride, (apex, chosen) in enumerate(zip(apices, settings, strict=False)):
        reported = "  ".join(f"{value:19.3f}" for value in chosen.values())
        print(f"{stride:6}  {apex[0]:6.3f}  {apex[1]:6.3f}  {reported}  {law.grade_at(apex)}")


if __name__ == "__main__":
    main()
