"""How much of the plane of apices some choice of actions can save, over the friction, at equal kinematics."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from ...analysis.comparison import compare
from ...library.runner import Runner
from ...pictures import style
from ...unit.unit import FRICTION
from ...viable_sets.result import Viability
from ...viable_sets.viability import viability
from . import figure_9
from .columns import Columns

FRICTIONS = (0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.43, 0.6, 0.85, 1.2, 2.5, 5.0, 10.0)
REFERENCE = 0.6
"""The friction whose gait the matched runners have."""
HOLD, VARY = ("speed", "apex_height"), ("hip.stance_torque", "hip.touchdown_angle")
AXES = {"com_height": (0.3, 4.0), "com_speed": (0.0, 4.0)}
ANGLES, TORQUES = (0.1, 1.3, 24), (0.0, 0.6, 5)
CELLS = 64
CHOICES: Mapping[str, Mapping[str, tuple[float, float, int]]] = {
    "angle": {"hip.touchdown_angle": ANGLES},
    "angle and torque": {"hip.touchdown_angle": ANGLES, "hip.stance_torque": TORQUES},
}
"""What is chosen at each apex."""
COLOURS = {"angle": "#1f5fa8", "angle and torque": "#b3216f"}

Measured = Sequence[tuple[float, str, Viability]]
"""Frictions, what is chosen, and what was found."""


def measure(runner: Runner, *, progress: bool = False) -> Measured:
    """The viable sets of matched runners, at each friction and for each choice.

    Parameters
    ----------
    runner : Runner
        Whose length of leg is 1, by the reduced map.
    progress : bool, default False
        Bars on stderr.

    Returns
    -------
    sequence of (float, str, Viability)
        Frictions, what is chosen, and what was found; frictions at which the speed and height of the
        reference are not to be had are left out.
    """
    found = compare([runner.but(FRICTION, mu) for mu in (REFERENCE, *FRICTIONS)], hold=HOLD, vary=VARY)
    missed = {of.runner for of in found.not_held}
    return [
        (
            matched.after.runner.values[FRICTION],
            choice,
            viability(matched.after.runner, axes=AXES, vary=vary, n=CELLS, progress=progress),
        )
        for number, matched in enumerate(found.runners)
        if number and number not in missed
        for choice, vary in CHOICES.items()
    ]


def table(measured: Measured) -> Columns:
    """The figure's data, by column."""
    return {
        "friction": [friction for friction, _, _ in measured],
        "choice": [choice for _, choice, _ in measured],
        **{
            name: [found.runner.values[name] for _, _, found in measured]
            for name in ("hip.stance_torque", "hip.touchdown_angle")
        },
        "inner_share": [found.inner_share for _, _, found in measured],
        "outer_share": [found.outer_share for _, _, found in measured],
        "inner_robustness": [float(found.inner_robustness.mean()) for _, _, found in measured],
        "outer_robustness": [float(found.outer_robustness.mean()) for _, _, found in measured],
    }


def draw(path: Path, data: Columns) -> None:
    """Draw both shares over the friction, each as a band from the inner to the outer set."""
    with style.styled():
        figure, axes = plt.subplots(2, 1, figsize=(7.6, 6.6), sharex=True, layout="constrained")
        _bands(axes[0], data, "share")
        axes[0].set_title("(a) share of the plane that is viable, from the inner to the outer set")
        _bands(axes[1], data, "robustness")
        axes[1].set_ylim(bottom=0.0)
        axes[1].legend(title="chosen at each apex", loc="lower left")
        axes[1].set_title("(b) share of the actions that are viable, in the mean over the plane")
        figure_9.friction_axis(axes[1], FRICTIONS)
        style.save(figure, path)


def _bands(axes: Axes, data: Columns, what: str) -> None:
    choices = np.asarray(data["choice"])
    for choice, colour in COLOURS.items():
        of = choices == choice
        friction, inner, outer = (
            np.asarray(data[name], float)[of] for name in ("friction", f"inner_{what}", f"outer_{what}")
        )
        axes.fill_between(friction, inner, outer, color=colour, alpha=0.3, linewidth=0, label=choice)
        for ends in (inner, outer):
            axes.plot(friction, ends, ".-", color=colour, linewidth=0.9, markersize=4)
