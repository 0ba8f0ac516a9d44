"""Words beside curves: each is moved along its curve until it touches no other line, mark or word."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.path import Path
from matplotlib.patheffects import withStroke
from matplotlib.text import Annotation, Text
from matplotlib.transforms import Bbox
from numpy.typing import NDArray

from . import style

CLEARANCE = 1.5
"""Points left free around a word."""
DISTANCES = (5.0, 14.0, 28.0)
"""Points between a word and its place on the curve; tried in this order."""
LEADER = 10.0
"""Points from which on a thin line joins a word to its curve."""
DIRECTIONS = ((0, 1), (0, -1), (-1, 1), (1, 1), (-1, -1), (1, -1), (-1, 0), (1, 0))
ALIGNED = {
    "horizontalalignment": ("right", "center", "left"),
    "verticalalignment": ("top", "center", "bottom"),
}
"""Alignment of a word by the sign of its direction plus one."""
PLACES = 21
"""Places tried along a curve, the middle one first."""


class CurveLabel(Annotation):
    """A word that finds its place whenever it is drawn, so that it fits a figure of any size."""

    def __init__(
        self,
        axes: Axes,
        word: str,
        points: NDArray[np.float64],
        distances: Sequence[float] = DISTANCES,
        **look: Any,
    ) -> None:
        """Label the curve through `points`, shape (n, 2), in data coordinates unless `xycoords` differs."""
        super().__init__(
            word,
            tuple(points[0]),
            xytext=(0.0, 0.0),
            textcoords="offset points",
            arrowprops={
                "arrowstyle": "-",
                "color": style.FAINT,
                "linewidth": 0.8,
                "shrinkA": 0,
                "shrinkB": 0,
            },
            path_effects=[withStroke(linewidth=2.0, foreground="white")],
            zorder=7,
            **look,
        )
        self._points = points
        self._distances = distances
        axes.add_artist(self)
        self.set_in_layout(False)

    def draw(self, renderer: RendererBase) -> None:
        """Draw the word at the first place where it touches nothing, or else where it touches least."""
        lines, boxes = self._obstacles(renderer)
        least = np.inf
        best = (tuple(self._points[0]), DIRECTIONS[0], self._distances[0])
        for place in self._candidates():
            box = self._move(*place).box_of_word(renderer)
            touched = self._touched(box, lines, boxes)
            if touched < least:
                least, best = touched, place
            if not touched:
                break
        self._move(*best)
        super().draw(renderer)

    def box_of_word(self, renderer: RendererBase) -> Bbox:
        """Extent of the word without its leader."""
        self.update_positions(renderer)
        return Text.get_window_extent(self, renderer)

    def _candidates(self) -> Iterator[tuple[tuple[float, float], tuple[int, int], float]]:
        count = min(PLACES, len(self._points))
        rows = np.linspace(0, len(self._points) - 1, count).round().astype(int)
        from_middle = sorted(rows, key=lambda row: abs(2 * row - len(self._points) + 1))
        for distance in self._distances:
            for row in from_middle:
                for direction in DIRECTIONS:
                    yield tuple(self._points[row]), direction, distance

    def _move(self, at: tuple[float, float], direction: tuple[int, int], distance: float) -> "CurveLabel":
        self.xy = at
        self.set_position((distance * direction[0], distance * direction[1]))
        for (name, values), sign in zip(ALIGNED.items(), direction, strict=True):
            self.set(**{name: values[sign + 1]})
        self.arrow_patch.set_visible(distance > LEADER)  # type: ignore[union-attr]
        return self

    def _obstacles(self, renderer: RendererBase) -> tuple[list[Path], list[Bbox]]:
        """Lines of the axes, and the boxes of marks, of words drawn before and of the legend."""
        axes = self.axes
        assert axes is not None
        lines = [line.get_transform().transform_path(line.get_path()) for line in axes.lines]
        texts = list(axes.texts)
        placed = [text for text in texts[: texts.index(self)] if isinstance(text, CurveLabel)]
        boxes = [text.box_of_word(renderer) for text in placed]
        boxes += [text.get_window_extent(renderer) for text in texts if not isinstance(text, CurveLabel)]
        legend = axes.get_legend()
        if legend is not None:
            boxes.append(legend.get_window_extent(renderer))
        for line, path in zip(axes.lines, lines, strict=True):
            if line.get_marker() not in ("None", "", " ", None):
                half = 0.5 * line.get_markersize() * float(np.asarray(renderer.points_to_pixels(1.0)))
                marks = np.asarray(path.vertices)[np.isfinite(path.vertices).all(axis=1)]
                boxes += [Bbox([mark - half, mark + half]) for mark in marks]
        return [path.cleaned(remove_nans=True) for path in lines], boxes

    def _touched(self, box: Bbox, lines: list[Path], boxes: list[Bbox]) -> int:
        """Number of things that a word would touch; a place outside the axes counts as a hundred."""
        box = box.padded(CLEARANCE)
        frame = self.axes.bbox  # type: ignore[union-attr]
        inside = frame.x0 <= box.x0 and box.x1 <= frame.x1 and frame.y0 <= box.y0 and box.y1 <= frame.y1
        touched = sum(line.intersects_bbox(box, filled=False) for line in lines)
        return touched + sum(box.overlaps(other) for other in boxes) + (0 if inside else 100)
