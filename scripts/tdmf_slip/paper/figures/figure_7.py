"""Figure 7: the gait at friction 0.6, with three slips, parted by two sticks."""

from pathlib import Path

from ...pictures import panels
from ...pictures.panels import Stride

FRICTION = 0.6


def draw(path: Path, stride: Stride) -> None:
    """Draw foot velocity and force ratio."""
    panels.draw_velocity_and_ratio(path, stride)
