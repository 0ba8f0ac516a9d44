"""A curve of special points over two parameters, and the ranges that it is followed in."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..drawable import Drawable
from ..library.runner import Runner

LONGEST = 1 / 15
"""Of the ranges: a step along a curve."""
SHORTEST = 1e-4
"""Likewise: where no step of this length finds the next point, the curve ends."""
CLOSED = "closed: back where it has been"
"""Why a curve ends that meets itself."""


@dataclass(frozen=True, eq=False, repr=False)
class Curve(Drawable):
    """Special points of one kind over two parameters."""

    runner: Runner
    """The runner; its own values of the two parameters do not matter."""
    kind: str
    """fold, period doubling, Neimark-Sacker, or word border."""
    names: tuple[str, str]
    """Of the parameters or inputs."""
    points: NDArray[np.float64]
    """Both parameters at each point, shape (points, 2), in the curve's order."""
    began: str
    """Why it has no earlier points."""
    ended: str
    """Why it has no more."""
    words: tuple[str, str] | None = None
    """On both sides of a word border."""

    def __repr__(self) -> str:
        """In a line: what kind, over what, and how many points."""
        names = " and ".join(self.names)
        return f"<Curve of a {self.kind} over {names}: {len(self.points)} points, {self.ended}>"

    def as_json(self) -> dict[str, object]:
        """As a plain object; a point is a pair in the order of `over`."""
        words = {"from": self.words[0], "to": self.words[1]} if self.words else {}
        ends = {"began": self.began, "ended": self.ended}
        record = {**self.runner.record(*self.names), "over": list(self.names)}
        return {**record, "kind": self.kind, **words, "points": self.points.tolist(), **ends}


@dataclass(frozen=True, eq=False)
class Box:
    """The ranges of two parameters, over their scales."""

    low: NDArray[np.float64]
    """Least value of each, shape (2,)."""
    high: NDArray[np.float64]
    """Largest value of each, shape (2,)."""

    @property
    def size(self) -> NDArray[np.float64]:
        """Of both sides."""
        return self.high - self.low

    def outside(self, pair: NDArray[np.float64]) -> bool:
        """Beyond one of the ranges."""
        return bool(np.any(pair < self.low) or np.any(pair > self.high))

    def share(self, begin: NDArray[np.float64], end: NDArray[np.float64]) -> float:
        """Which part of the way from a pair inside to one outside leads to the edge."""
        way = end - begin
        edges = np.where(way > 0.0, self.high, self.low)
        with np.errstate(divide="ignore", invalid="ignore"):
            shares = np.where(way == 0.0, np.inf, (edges - begin) / way)
        return float(np.clip(np.min(shares), 0.0, 1.0))
