"""A controller of one's own at the hip: it holds the runner's speed when the ground turns slippery.

    python examples/hip_controller.py [--plot FILE]

What `hip.external_torque` is for: a separate discrete-time controller, sampled twenty times in each
sqrt(m/k), adds a torque to the unit's own hip law. It acts while the foot bears load and the hip drives; how
hard follows from the speed of each completed stride, by a proportional and an integral term. The same run
without it shows what it does.
"""

import argparse

from runner import Runner

FRICTION_BEFORE, FRICTION_AFTER = 0.6, 0.3
STRIDES_BEFORE, STRIDES = 5, 50
STEP = 0.05
LOADED = (2, 3, 4)
"""contact.mode_index of stick and of slip either way."""
DRIVE = 1
"""hip.phase_index from touchdown to mid-stance."""
LOSSES = ("energy.damper_loss", "energy.friction_loss", "energy.impact_loss")


class SpeedHolder:
    """A stride-to-stride controller of the average speed; it knows only what it measures."""

    def __init__(self, target, proportional=1.0, integral=0.2):
        """`target` is the speed to hold; gains are in torque per speed."""
        self.target = target
        self.proportional = proportional
        self.integral = integral
        self._sum_of_errors = 0.0
        self._torque = 0.0

    def stride_completed(self, speed):
        """Take the speed of the last stride into account. A negative torque drives a runner forward."""
        error = self.target - speed
        self._sum_of_errors += error
        self._torque = -(self.proportional * error + self.integral * self._sum_of_errors)

    def torque(self, mode, phase):
        """Torque of the next sampling interval."""
        return self._torque if mode in LOADED and phase == DRIVE else 0.0


def ledger_error(runner, energy_at_start):
    """Energy gained, less the work of the hip, plus all losses: nothing, if the books are right."""
    gained = runner["energy.total"] - energy_at_start
    return gained - runner["hip.work"] + sum(runner[name] for name in LOSSES)


def run(controller=None):
    """Run across the change of ground; return (word, speed) of each stride, and the error of the ledger."""
    seen = []
    with Runner(STEP) as runner:
        energy_at_start = runner["energy.total"]
        while len(seen) < STRIDES and not runner["status.fallen"]:
            runner["ground.friction"] = FRICTION_BEFORE if len(seen) < STRIDES_BEFORE else FRICTION_AFTER
            if controller:
                mode, phase = runner["contact.mode_index"], runner["hip.phase_index"]
                runner["hip.external_torque"] = controller.torque(mode, phase)
            if not runner.advance():
                continue
            seen.append((runner["stride.word"], runner["stride.speed"]))
            if controller:
                controller.stride_completed(runner["stride.speed"])
        return seen, ledger_error(runner, energy_at_start)


def speed_before():
    """Speed of the gait before the change: the first stride of a run with nothing set."""
    with Runner(STEP) as runner:
        while not runner.advance():
            pass
        return runner["stride.speed"]


def plot(path, target, alone, held):
    """Write a figure of both runs."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 3.6), layout="constrained")
    strides = range(1, STRIDES + 1)
    axes.axhline(target, color="0.6", linestyle="--", label="speed to hold")
    axes.plot(strides, [speed for _, speed in alone], ".-", label="hip law alone")
    axes.plot(strides, [speed for _, speed in held], ".-", label="with the controller")
    axes.axvline(STRIDES_BEFORE + 0.5, color="0.6", linewidth=0.8)
    axes.set(xlabel="stride", ylabel="speed (l0 √(k/m))")
    axes.set_title(f"Friction {FRICTION_BEFORE} becomes {FRICTION_AFTER} after stride {STRIDES_BEFORE}")
    axes.legend()
    figure.savefig(path, dpi=150)
    plt.close(figure)


def main():
    """Print both runs stride by stride, and draw them on demand."""
    parser = argparse.ArgumentParser(description="A controller at the hip holds the runner's speed.")
    parser.add_argument("--plot", metavar="FILE", help="write a figure of both runs")
    arguments = parser.parse_args()
    target = speed_before()
    alone, _ = run()
    held, ledger = run(SpeedHolder(target))
    print("stride  alone             with the controller")
    for stride, ((word, speed), (held_word, held_speed)) in enumerate(zip(alone, held, strict=True), start=1):
        print(f"{stride:6}  {word:8} {speed:.4f}   {held_word:8} {held_speed:.4f}")
    print(f"\nspeed to hold {target:.4f}; the energy ledger closes to {abs(ledger):.1e}")
    if arguments.plot:
        plot(arguments.plot, target, alone, held)


if __name__ == "__main__":
    main()
