"""Figure 4(a): friction that gaits of the classic SLIP need, in stance and at the impact of a small foot."""

from pathlib import Path

import numpy as np

from ...pictures import style
from ..evidence import SLIP_ANGLE
from ..published import IMPACT_FRICTION, STANCE_FRICTION
from . import figure_2


def draw(path: Path) -> None:
    """Draw the friction needed against the touchdown angle."""
    data = figure_2.gait_table()
    with style.styled():
        figure, axes = style.subplots(figsize=(5.6, 4.2))
        for (name, rows), line in zip(figure_2.branches(data), ("-", "--"), strict=True):
            angles = np.array(data["angle_degrees"])[rows]
            needed = np.array(data["impact_friction"])[rows]
            axes.plot(angles, needed, line, color=style.CURVE, label=f"at impact, {name} gait")
        order = np.argsort(data["angle_degrees"])
        angles = np.array(data["angle_degrees"])[order]
        stance = np.array(data["stance_friction"])[order]
        axes.plot(angles, stance, "-.", color=style.SECOND_CURVE, label=r"in stance: $\tan\theta_0$")
        axes.plot([SLIP_ANGLE] * 2, [STANCE_FRICTION, IMPACT_FRICTION], **style.PUBLISHED)
        axes.set_ylim(0.0, 6.0)
        axes.legend()
        style.label(axes, r"touchdown angle $\theta_0$ (°)", "friction needed μ")
        style.save(figure, path)
