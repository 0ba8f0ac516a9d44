"""The region of attraction of a gait: which starts run on, over a slice of the apex section, over all of it, and
how hard a runner may be pushed."""

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray

from . import blocks, ensemble, progress
from .errors import InputError
from .files import whole
from .orbit import Orbit, Runner
from .section import COORDINATES
from .sweep import first_orbit
from .unit import Unit, load

TOLERANCE = 1e-5
"""Relative tolerance of a step for maps and volumes: a stride errs by less than 1e-5, far less than the distance of
neighbouring starts."""
MOST_STRIDES = 400
NOT_YET = -1
STARTS_AT_ONCE = 4096
"""In a block."""
BOX: Mapping[str, tuple[float, float]] = {
    "com_height": (0.0, 4.0),
    "com_speed": (-2.0, 4.0),
    "leg_length": (0.5, 1.5),
    "leg_angle": (-1.6, 1.6),
    "leg_length_rate": (-2.0, 2.0),
    "leg_angle_rate": (-4.0, 4.0),
}
"""Of the section, over its scales: where starts are drawn from. The same for every gait, to compare them."""
CONFIDENCE = 0.95
NORMAL_QUANTILE = 1.959963984540054
"""Of CONFIDENCE, two-sided."""
FARTHEST = 5.0
"""Over the scales: beyond this no disturbance is tried."""
COARSE, REFINEMENTS = 500, 2
"""Tries along the line, and how often the interval between two of them is divided again."""
EDGE_TOLERANCE = 1e-8


# ---- over a slice -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Slice:
    """Starts that differ from a gait's apex in two coordinates: a block of work."""

    runner: Runner
    apex: tuple[float, ...]
    axes: tuple[str, str]
    rows: tuple[float, ...]
    columns: tuple[float, ...]

    def starts(self) -> np.ndarray:
        """One to a row, the columns running fastest."""
        sections = np.tile(self.apex, (len(self.rows), len(self.columns), 1))
        sections[..., COORDINATES.index(self.axes[0])] = np.asarray(self.rows)[:, None]
        sections[..., COORDINATES.index(self.axes[1])] = np.asarray(self.columns)[None, :]
        return sections.reshape(-1, len(COORDINATES))


def fates_of_slice(part: Slice) -> np.ndarray:
    """What becomes of each start of a block, in its shape: the fields `fate` and `strides`."""
    ends = fates(part.runner, part.apex, part.starts())
    return ends.reshape(len(part.rows), len(part.columns))


def fates(
    runner: Runner, apex: Sequence[float], starts: np.ndarray, *, tolerance: float = TOLERANCE
) -> np.ndarray:
    """What becomes of runners that start somewhere, as `ensemble.run` tells it, by one thread."""
    case = ensemble.Case(runner, (apex,))
    return ensemble.run([case], starts, most_strides=MOST_STRIDES, tolerance=tolerance, threads=1)[0]


def stable_gait(runner: Runner, unit: Unit) -> Orbit:
    """The gait of a runner, if it attracts anything.

    Raises:
        InputError: it is unstable.
        RunError: there is none.
    """
    gait = first_orbit(runner, unit)
    if not gait.stable:
        raise InputError(f"the gait at friction {gait.friction:g} is unstable: it attracts nothing")
    return gait


def basin(
    runner: Runner,
    axes: tuple[str, str],
    ranges: tuple[Sequence[float], Sequence[float]],
    *,
    path: Path | None = None,
    scheduler: str | None = None,
    workers: int | None = None,
    show_progress: bool = False,
    unit: Unit | None = None,
) -> xarray.Dataset:
    """The fate of a runner from each point of a slice through the gait's apex.

    The other four coordinates are the gait's. With a path the result is written there as NetCDF, block by
    block, and a file of the same slice is gone on with.

    Args:
        runner: parameters and friction.
        axes: two names of `section.COORDINATES`.
        ranges: values along each.
        path: of a NetCDF file.
        scheduler: of a Dask cluster, see `blocks.run`. The result does not depend on who computes it.
        workers: processes on this machine, by default one for each processor.
        show_progress: a bar on stderr.
        unit: for units.

    Returns:
        `fate`, by the flag values of its attribute, and `strides` until then, over the two coordinates; how
        large a share of the slice settles is the attribute `settled_share`.

    Raises:
        InputError: an unknown axis, the file holds another slice, or the gait is unstable.
        RunError: there is no gait.
    """
    unit = load() if unit is None else unit
    if len(set(axes)) != 2 or any(axis not in COORDINATES for axis in axes):
        raise InputError(f"axes {', '.join(axes)}: allowed: two of {', '.join(COORDINATES)}")
    gait = stable_gait(runner, unit)
    data = _blank(gait, axes, ranges, unit)
    if path is not None and path.exists():
        data = _resumed(path, data)
    missing = [row for row in range(len(ranges[0])) if (data["fate"].values[row] == NOT_YET).any()]
    at_once = max(1, STARTS_AT_ONCE // len(ranges[1]))
    rows = [missing[i : i + at_once] for i in range(0, len(missing), at_once)]
    parts = [
        Slice(runner, tuple(gait.apex), axes, tuple(np.asarray(ranges[0])[block]), tuple(ranges[1]))
        for block in rows
    ]
    with progress.bar("basin", len(ranges[0]), "rows", show_progress) as bar:
        bar.update(len(ranges[0]) - len(missing))
        for number, ends in blocks.run(fates_of_slice, parts, scheduler=scheduler, workers=workers):
            for name in ("fate", "strides"):
                data[name].values[rows[number]] = ends[name]
            bar.update(len(rows[number]))
            if path is not None:
                with whole(path) as beside:
                    data.to_netcdf(beside)
    data.attrs["settled_share"] = float(np.mean(data["fate"].values == 0))
    return data


def _blank(
    gait: Orbit, axes: tuple[str, str], ranges: tuple[Sequence[float], Sequence[float]], unit: Unit
) -> xarray.Dataset:
    shape = len(ranges[0]), len(ranges[1])
    data = xarray.Dataset(
        {
            "fate": (axes, np.full(shape, NOT_YET, dtype="i4")),
            "strides": (axes, np.zeros(shape, dtype="i4")),
        },
        coords={axis: ((axis,), np.asarray(v, dtype=float)) for axis, v in zip(axes, ranges, strict=True)},
    )
    data["fate"].attrs = {
        "flag_values": np.arange(len(ensemble.FATES)),
        "flag_meanings": " ".join(ensemble.FATES),
    }
    data["strides"].attrs = {"units": "1", "long_name": "strides closed until then"}
    for axis, value in zip(COORDINATES, gait.apex, strict=True):
        data.attrs[f"gait_{axis}"] = float(value)
    for axis in axes:
        variable = unit.variables[f"apex.{axis}"]
        data[axis].attrs = {"units": variable.unit or "1", "long_name": variable.description}
    data.attrs |= {"word": gait.word, **gait.runner.values}
    return data


def _resumed(path: Path, blank: xarray.Dataset) -> xarray.Dataset:
    try:
        data = xarray.load_dataset(path)
    except (OSError, ValueError) as problem:
        raise InputError(f"{path}: no basin to go on with ({problem}); allowed: another file name") from None
    same = set(blank.coords) == set(data.coords) and all(
        np.array_equal(data[axis].values, blank[axis].values) for axis in blank.coords
    )
    if not same or not _same_attributes(data.attrs, blank.attrs):
        raise InputError(f"{path}: holds another slice; allowed: another file name")
    return data


def _same_attributes(found: Mapping, wanted: Mapping) -> bool:
    return all(
        np.allclose(found.get(name, np.nan), value, rtol=1e-9, atol=1e-12)
        if isinstance(value, float)
        else found.get(name) == value
        for name, value in wanted.items()
    )


# ---- over the whole section -------------------------------------------------------------------------------


@dataclass(frozen=True)
class Volume:
    """A Monte-Carlo estimate of how much of the box `BOX` a gait attracts."""

    samples: int
    settled: int
    box: float
    """The box's own volume, in the section's scales."""

    @property
    def share(self) -> float:
        """Of the samples that settle."""
        return self.settled / self.samples

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the share, by Wilson's score: sound where nearly all or nothing settles."""
        z2 = NORMAL_QUANTILE**2 / self.samples
        middle = (self.share + 0.5 * z2) / (1.0 + z2)
        spread = math.sqrt(z2 * (self.share * (1.0 - self.share) + 0.25 * z2)) / (1.0 + z2)
        return max(0.0, middle - spread), min(1.0, middle + spread)

    @property
    def volume(self) -> tuple[float, float, float]:
        """Estimate, lower and upper end, in the section's scales."""
        return tuple(share * self.box for share in (self.share, *self.interval))

    def as_json(self) -> dict[str, object]:
        """The estimate as a plain object."""
        estimate, low, high = self.volume
        return {
            "samples": self.samples,
            "share": self.share,
            "share_interval": list(self.interval),
            "volume": estimate,
            "volume_interval": [low, high],
            "confidence": CONFIDENCE,
            "box": {name: list(ends) for name, ends in BOX.items()},
        }


@dataclass(frozen=True)
class Drawing:
    """Random starts: a block of work. Its number, not its worker, decides what is drawn."""

    runner: Runner
    apex: tuple[float, ...]
    seed: int
    number: int
    count: int

    def starts(self) -> np.ndarray:
        """Uniform over the box."""
        source = np.random.default_rng([self.seed, self.number])
        low, high = np.array(list(BOX.values())).T
        return self.runner.scales * source.uniform(low, high, size=(self.count, len(COORDINATES)))


def count_settled(drawing: Drawing) -> int:
    """How many of a block's starts settle."""
    ends = fates(drawing.runner, drawing.apex, drawing.starts())
    return int(np.count_nonzero(ends["fate"] == 0))


def volume(
    gait: Orbit,
    samples: int,
    *,
    seed: int = 0,
    scheduler: str | None = None,
    workers: int | None = None,
    show_progress: bool = False,
) -> Volume:
    """Estimate the volume of a gait's region of attraction in all six coordinates.

    Args:
        gait: stable.
        samples: how many starts are drawn.
        seed: of the drawing.
        scheduler: see `blocks.run`.
        workers: see `blocks.run`.
        show_progress: a bar on stderr.

    Raises:
        InputError: no samples.
    """
    if samples < 1:
        raise InputError(f"samples {samples}: allowed: 1 or more")
    counts = [min(STARTS_AT_ONCE, samples - done) for done in range(0, samples, STARTS_AT_ONCE)]
    runner = Runner(gait.runner.values)
    drawings = [Drawing(runner, tuple(gait.apex), seed, n, count) for n, count in enumerate(counts)]
    settled = 0
    with progress.bar("volume", samples, "starts", show_progress) as bar:
        for number, found in blocks.run(count_settled, drawings, scheduler=scheduler, workers=workers):
            settled += found
            bar.update(counts[number])
    low, high = np.array(list(BOX.values())).T
    return Volume(samples, settled, float(np.prod(high - low)))


# ---- along a line -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Robustness:
    """The largest disturbances at an apex that a runner recovers from, each by itself; infinite where the
    largest that is tried is recovered from."""

    push_forward: float
    """Of the speed, m/s."""
    push_backward: float
    step_down: float
    """Of the ground, m: the runner then starts so much higher."""
    step_up: float

    def as_json(self) -> dict[str, float | None]:
        """The disturbances as a plain object."""
        values = {name: getattr(self, name) for name in self.__dataclass_fields__}
        return {name: value if math.isfinite(value) else None for name, value in values.items()}


def robustness(gait: Orbit) -> Robustness:
    """How far along height and speed the region of attraction reaches, without a gap, from the gait's apex."""
    reach = functools.partial(_reach, gait)
    return Robustness(
        push_forward=reach("com_speed", 1.0),
        push_backward=reach("com_speed", -1.0),
        step_down=reach("com_height", 1.0),
        step_up=reach("com_height", -1.0),
    )


def _reach(gait: Orbit, axis: str, direction: float) -> float:
    """The first disturbance that is not recovered from, between the tries of a line that is refined."""
    index = COORDINATES.index(axis)
    runner = Runner(gait.runner.values)
    recovered, lost = 0.0, FARTHEST * runner.scales[index]
    for _ in range(REFINEMENTS):
        tries = np.linspace(recovered, lost, COARSE + 1)[1:]
        starts = np.tile(gait.apex, (COARSE, 1))
        starts[:, index] += direction * tries
        fails = np.flatnonzero(fates(runner, gait.apex, starts, tolerance=EDGE_TOLERANCE)["fate"] != 0)
        if not fails.size:
            return math.inf
        first = fails[0]
        recovered, lost = tries[first - 1] if first else recovered, tries[first]
    return float(recovered)
