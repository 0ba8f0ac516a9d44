"""Figure 8: foot velocity in the stance of the two gaits at low friction."""

from pathlib import Path

from ...pictures import panels, style
from ...pictures.panels import Stride

FRICTIONS = (0.43, 0.2)


def draw(path: Path, strides: tuple[Stride, Stride]) -> None:
    """Draw one panel for each gait."""
    with style.styled():
        figure, both = style.subplots(1, 2, figsize=(8.4, 3.7))
        for axes, stride, letter in zip(both, strides, "ab", strict=True):
            panels.mark_stance(axes, stride)
            panels.mark_mid_stance(axes, stride)
            panels.foot_velocity(axes, stride, stance_only=True)
            axes.set_title(
                rf"({letter}) $\mu = {stride.gait.friction:g}$, word  {style.word(stride.gait.word)}"
            )
        figure.suptitle("Periodic gaits at low friction", x=0.02, ha="left")
        panels.key_below(figure, strides)
        style.save(figure, path)
