"""Strides until the fall of many runners, or on ground of many kinds, side by side."""

from collections.abc import Sequence
from dataclasses import dataclass

from ..blocks.running import run_blocks
from ..contents import ByContents
from ..library.affine_law import AffineLaw
from ..library.runner import Runner
from ..terminal.progress import progress_bar
from .first_passage import FirstPassage, strides_to_fall


@dataclass(frozen=True, eq=False)
class Place(ByContents):
    """Who runs on what: a block of work."""

    runner: Runner
    """Parameters and inputs."""
    roughness: float
    """Standard deviation of a step, m."""
    runners: int
    """How many run."""
    seed: int
    """Of the ground."""
    max_strides: int
    """A runner that has made as many is still up."""
    law: AffineLaw | None = None
    """By which the runners are set."""


def stay(place: Place) -> FirstPassage:
    """Strides until the fall at one place, by one thread.

    Parameters
    ----------
    place : Place
        Who runs on what.

    Returns
    -------
    FirstPassage
        As `strides_to_fall` gives it.
    """
    return strides_to_fall(
        place.runner,
        place.roughness,
        place.runners,
        place.seed,
        place.max_strides,
        law=place.law,
        threads=1,
    )


def stay_all(places: Sequence[Place], *, progress: bool = False) -> list[FirstPassage]:
    """`stay` at many places, side by side."""
    found: dict[int, FirstPassage] = {}
    with (
        progress_bar("rough", len(places), "means", progress) as bar,
        run_blocks(stay, places) as results,
    ):
        for number, one in results:
            found[number] = one
            bar.update()
    return [found[number] for number in range(len(places))]
