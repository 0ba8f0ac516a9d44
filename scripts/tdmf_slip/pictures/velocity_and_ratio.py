"""A gait's stance, as in figures 6 and 7: foot velocity and force ratio, in the stance, side by side."""

from pathlib import Path

from matplotlib.figure import Figure

from ..library.gait import Gait
from . import panels, style
from .panels import Stride


def draw(path: Path, stride: Stride) -> None:
    """Draw the two panels."""
    style.save(figure_of(stride), path)


def of_gait(gait: Gait) -> Figure:
    """The two panels of a gait's stride."""
    return figure_of(Stride(gait))


def figure_of(stride: Stride) -> Figure:
    """The two panels."""
    with style.styled():
        figure, (left, right) = style.subplots(1, 2, figsize=(8.4, 3.7))
        for axes in (left, right):
            panels.mark_stance(axes, stride)
            panels.mark_mid_stance(axes, stride)
        panels.foot_velocity(left, stride, stance_only=True)
        left.set_title("(a) foot velocity; the jump is the slipping impact")
        panels.force_ratio(right, stride)
        right.set_title("(b) force ratio; × impulses at the impact")
        figure.suptitle(
            rf"Periodic gait at $\mu = {stride.gait.friction:g}$, word  {style.word(stride.gait.word)}",
            x=0.02,
            ha="left",
        )
        panels.key_below(figure, [stride])
    return figure
