"""Figure 6: the gait at friction 1.2, sliding on landing and again just before lift-off."""

from pathlib import Path

from ...pictures import panels
from ...pictures.panels import Stride

FRICTION = 1.2


def draw(path: Path, stride: Stride) -> None:
    """Draw foot velocity and force ratio."""
    panels.draw_velocity_and_ratio(path, stride)
