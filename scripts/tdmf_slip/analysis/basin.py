"""The region of attraction of a gait over a slice of the apex section: starts that run on or fall."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..blocks import in_order, run_blocks
from ..checks import check_size, is_one_of, refusal
from ..errors import InputError
from ..files.resume import NOT_YET, Resumed
from ..files.whole import check_destination
from ..given import counts_given, ends_given, is_series, is_table, mapping_of, row_of
from ..library.engine import FATES, SETTLED
from ..library.gait import Gait, check_is_gait
from ..library.laws import Law, is_noisy, text_of_law
from ..library.runner import Runner
from ..library.section import COORDINATES, check_axes
from ..library.shared_steps import shares_steps
from ..record import dataset
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from .ball import MAX_ALONG, STARTS_AT_ONCE, Ball, attributes_of, ball_of, fates, starts_at
from .ball import stable_gait as stable_gait
from .preview import PREVIEW, REFINEMENTS, preview_of

if TYPE_CHECKING:
    import xarray

AXES = ("com_height", "com_speed")
"""Default axes of a map."""
Axes = Mapping[str, tuple[float, float] | None] | Sequence[str]
"""Two coordinates with their ranges."""
LEG_LENGTH = COORDINATES.index("leg_length")
"""Index of the last positive coordinate; ranges of positive coordinates are relative to their values."""
STRIDES = "strides_until_known"
"""Name of the variable that counts strides."""
FOLLOWED = "is_followed"
"""Name of the mask of followed starts in previews."""
POINTS_AT_ONCE = 1024
"""Largest number of starts in a block of a preview."""

MAX_STARTS = MAX_ALONG**2
"""Largest number of starts of a map, which then takes 2 GB."""
MAX_AXIS = MAX_STARTS // 2


def axes_of(axes: Any, model: Model) -> dict[str, tuple[float, float] | None]:
    """The two coordinates with their ranges; None stands for a range around the gait."""
    allowed = "two coordinates of an apex with their ranges (low, high)"
    named = isinstance(axes, Mapping) or is_table(axes) or is_series(axes)
    names = mapping_of(axes, "axes", allowed) if named else row_of(axes, "axes", allowed)
    if len(names) != 2:
        raise refusal("axes", axes, allowed)
    check_axes(tuple(names), model.coordinates)
    spans = names if isinstance(names, dict) else dict.fromkeys(names)
    if len(spans) != 2:
        raise refusal("axes", axes, allowed)
    return {
        name: None
        if span is None
        else ends_given(f"axes: {name}", span, read=model.coordinate(name).without_units)
        for name, span in spans.items()
    }


def range_around(gait: Gait, axis: str) -> tuple[float, float]:
    """Ends of a range of a coordinate that contains the gait and most of its region of attraction."""
    check_is_gait(gait, "gait")
    names = gait.runner.coordinates if gait.runner.model.is_page else COORDINATES
    check_axes((axis,), names)
    index = names.index(axis)
    here, scale = gait.apex[index], gait.runner.scales[index]
    is_size = axis in COORDINATES[: LEG_LENGTH + 1]
    low, high = (0.7 * here, 1.5 * here) if is_size else (here - 0.5 * scale, here + 0.5 * scale)
    return _rounded(low), _rounded(high)


def _rounded(value: float) -> float:
    """A number to six significant digits."""
    return round(value, 5 - math.floor(math.log10(abs(value)))) if value else 0.0


@shares_steps
def basin(
    runner: RunnerLike = None,
    axes: Axes = AXES,
    n: int | tuple[int, int] = 128,
    *,
    model: str | None = None,
    law: Law | None = None,
    ball: Ball | str = "tested",
    refine: str = "exact",
    path: Path | str | None = None,
    executor: Executor | None = None,
    progress: bool = False,
) -> xarray.Dataset:
    """Compute the fate of a runner from each point of a slice through the gait's apex.

    Coordinates that do not vary are the gait's; the reduced map has none.

    Parameters
    ----------
    runner : as in `find_gait`
    axes : mapping of str to (low, high), or pair of str
        Two names of `section.COORDINATES` with ranges in the coordinate's unit; None, or the names alone, for
        ranges around the gait. By default height and speed.
    n : int or pair of int, default 128
        Starts along each axis, both ends included.
    model : as in `find_gait`
    law : callable or AffineLaw, optional
        Law that sets values at each apex, see `Batch`. The gait is that of the law, for an `AffineLaw` near
        the law's apex; the law has to make it stable.
    ball : {"tested", "none"} or Ball, default "tested"
        Ball of attraction in which a start counts as settled. A tested ball is made only where it saves time;
        simulation shows that its norm falls from 10,000 points. With `none`, each start is followed until it
        is within 0.01 of the gait, relative to the scales. A proved ball is small: starts are followed for
        longer, at a finer tolerance.

        `proved_ball` makes a proved ball.
    refine : {"exact", "preview"}, default "exact"
        `exact` follows every start. `preview` follows starts near a border between fates, and gives the other
        starts the fate of the corners of squares of at most 16 by 16 starts. For 256 by 256 starts it takes 7
        to 200 times fewer strides, but it can miss an island smaller than a square.
    path : Path or str, optional
        NetCDF file (.nc) for the result. Rows that are done are kept in a folder beside it, and the same call
        resumes a job that stopped. A preview is written when it is whole.
    executor, progress : as in `sweep`

    Returns
    -------
    xarray.Dataset
        Over the two coordinates: `fate`, a number of `library.engine.FATES`, and `strides_until_known`, that
        were closed until then; in a preview `is_followed`, 0 for painted starts. Attributes: `settled_share`
        of the starts, and `settled_area` in the coordinates' units; the gait, as `gait_com_height` and so on;
        `refine`; and the ball: `ball` ("tested", "proved" or "none"), `ball_radius` (every apex so near in
        each coordinate, over the scales, is inside), `ball_rate` (largest factor of the norm in a stride) and
        `ball_points`.

    Raises
    ------
    InputError
        An unknown axis, ball or way to refine, a preview by a law with noise, the file holds another slice,
        the gait is unstable, or the law does not keep it.
    RunError
        There is no gait.

    Examples
    --------
    >>> import tdmf_slip
    >>> axes = {"com_height": (1.2, 1.6), "com_speed": (0.9, 1.2)}
    >>> fates = tdmf_slip.basin({"ground.friction": 0.6}, axes, n=3)
    >>> print(fates["fate"].shape, fates.settled_share)
    (3, 3) 1.0
    """
    runner = Runner(runner, model=model)
    spans = axes_of(axes, runner.model)
    counts = counts_given(n, MAX_AXIS)
    size = math.prod(counts)
    check_size("n", size, f"starts ({counts[0]:,} by {counts[1]:,})", MAX_STARTS)
    path = None if path is None else check_destination(path, (".nc",), "path")
    _check_refine(refine, law)
    gait = stable_gait(runner, law)
    ends = {name: range_around(gait, name) if span is None else span for name, span in spans.items()}
    along = {
        name: gait.runner.model.coordinate(name).values_of(np.linspace(*span, count), f"range of {name}")
        for (name, span), count in zip(ends.items(), counts, strict=True)
    }
    around = ball_of(gait, ball, size, law)
    slice_ = Slice(gait, along, law, None if is_noisy(law) else around)
    made = Resumed(path, _blank(slice_, refine), "map of fates")
    if made.is_whole:
        return made.data
    if refine == PREVIEW:
        _paint(made, slice_, executor, progress)
    else:
        at_once = 1 if is_noisy(law) else max(1, STARTS_AT_ONCE // counts[1])
        made.fill_rows(slice_.rows, at_once, "basin", "starts", executor, progress)
    share = float((made.data["fate"] == SETTLED).mean())
    area = math.prod(float(np.ptp(values)) for values in along.values())
    data = made.data.assign_attrs(settled_share=share, settled_area=share * area)
    made.finish(data)
    return data


@dataclass(frozen=True, eq=False)
class Slice:
    """Starts that differ from a gait's apex in two coordinates."""

    gait: Gait
    """The gait."""
    along: Mapping[str, NDArray[np.float64]]
    """Values of the two coordinates, by name."""
    law: Law | None
    """Law that changes settings at each apex."""
    ball: Ball | None
    """Ball around the gait in which a start counts as settled."""

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of rows and columns."""
        rows, columns = map(len, self.along.values())
        return rows, columns

    def starts(self, block: Sequence[NDArray[np.intp]] | NDArray[np.intp]) -> NDArray[np.float64]:
        """Starts by their rows and columns, shape (starts, n)."""
        chosen = [values[index] for values, index in zip(self.along.values(), block, strict=True)]
        columns = [self.gait.runner.coordinates.index(name) for name in self.along]
        return starts_at(self.gait.apex, columns, np.column_stack(chosen))

    def fates(self, block: Sequence[NDArray[np.intp]]) -> NDArray[np.int32]:
        """Fate, and strides until it was known, of starts by their rows and columns, shape (2, starts).

        The noise of a law is drawn by the numbers of starts, which count on from the first of the block.
        """
        first = int(np.ravel_multi_index((block[0][0], block[1][0]), self.shape))
        run = fates(self.gait, self.starts(block), law=self.law, ball=self.ball, first_number=first)
        return np.stack([run.fate, run.strides])

    def rows(self, rows: Sequence[int]) -> dict[str, NDArray[np.int32]]:
        """Fates, and strides until they were known, of all starts in some rows, by name."""
        columns = self.shape[1]
        found = self.fates((np.repeat(rows, columns), np.tile(np.arange(columns), len(rows))))
        return dict(zip(("fate", STRIDES), found.reshape(2, -1, columns), strict=True))


def fate_counts(data: xarray.Dataset) -> dict[str, int]:
    """Number of starts with each fate, by the names of `library.engine.FATES`."""
    return {name: int((data["fate"] == number).sum()) for number, name in enumerate(FATES)}


def _blank(slice_: Slice, refine: str) -> xarray.Dataset:
    """A map without fates; a preview reports which starts it followed."""
    gait, law, axes, shape = slice_.gait, slice_.law, tuple(slice_.along), slice_.shape
    flags = {"flag_values": np.arange(len(FATES)), "flag_meanings": " ".join(FATES)}
    count = {"units": "1", "long_name": "strides closed until the fate was known"}
    variables = {
        "fate": (axes, np.full(shape, NOT_YET, dtype="i4"), flags),
        STRIDES: (axes, np.zeros(shape, dtype="i4"), count),
    }
    if refine == PREVIEW:
        about = {"long_name": "1 for a start that was followed, 0 for a painted one"}
        variables[FOLLOWED] = axes, np.zeros(shape, dtype="i1"), about
    coordinates = {
        axis: (axis, values, gait.runner.model.coordinate(axis).attributes)
        for axis, values in slice_.along.items()
    }
    apex = dict(zip(gait.runner.coordinates, map(float, gait.apex), strict=True))
    return dataset(
        "basin",
        gait.runner.record(),
        variables,
        coordinates,
        **{f"gait_{axis}": value for axis, value in apex.items()},
        word=gait.word,
        refine=refine,
        **attributes_of(slice_.ball),
        **({} if law is None else {"law": text_of_law(law, slice_.starts(np.indices(shape).reshape(2, -1)))}),
    )


def _check_refine(refine: str, law: Law | None) -> None:
    if not is_one_of(refine, REFINEMENTS):
        raise refusal("refine", refine, ", ".join(REFINEMENTS))
    if refine == PREVIEW and is_noisy(law):
        raise InputError("refine = 'preview': the law has noise; allowed: 'exact'")


def _paint(made: Resumed, slice_: Slice, executor: Executor | None, progress: bool) -> None:
    """Fill in a preview."""
    with progress_bar("basin", math.prod(slice_.shape), "starts", progress) as bar:

        def follow(rows: NDArray[np.intp], columns: NDArray[np.intp]) -> NDArray[np.int32]:
            count = -(-len(rows) // POINTS_AT_ONCE)
            parts = list(zip(np.array_split(rows, count), np.array_split(columns, count), strict=True))
            with run_blocks(slice_.fates, parts, executor) as results:
                return np.concatenate(
                    in_order(results, lambda number: bar.update(len(parts[number][0]))), axis=1
                )

        found = preview_of(slice_.shape, follow)
    data = made.data
    data["fate"][:], data[STRIDES][:], data[FOLLOWED][:] = found.fate, found.strides, found.is_followed
