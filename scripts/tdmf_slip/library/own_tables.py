"""Tables of batches of models of one's own: strides with derivatives, ends of runs, and recorded strides."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .batch_given import Given
from .batch_tables import ABOUT_ENDS, CLOSED, NOT_MADE, about_of, labels_of, texts_of, title
from .engine import SETTLED
from .laws import AffineLaw
from .members import Along
from .own_engine import OwnEngine
from .own_model import OwnModel
from .own_runs import SEEDS, OwnStrides, seeds_of, strides_of
from .tables import Table


def own_strides(batch: Given, differentiated: bool, along: Sequence[Along]) -> Table:
    """One stride of each runner."""
    model, size = batch.model, batch.size
    assert isinstance(model, OwnModel)
    names = list(model.quantities)

    def made(some: Sequence[Along]) -> OwnStrides:
        return strides_of(
            model,
            batch.models,
            batch.held,
            batch.starts[:, :size],
            tolerance=batch.runner.tolerance,
            seeds=seeds_of(model, some) if differentiated else None,
            step_limit=batch.step_limit or 0,
            threads=batch.threads or 1,
        )

    parts = [made(along[first : first + SEEDS]) for first in range(0, max(len(along), 1), SEEDS)]
    strides = parts[0]
    closed = strides.outcome == 0

    def by(value_of: Any) -> NDArray[np.float64]:
        """Derivatives by the coordinates, and then along all directions."""
        rows = [value_of(part) for part in parts]
        return np.concatenate([rows[0], *(row[..., size:] for row in rows[1:])], axis=-1)

    def array(name: str) -> NDArray[Any]:
        if name == "outcome":
            return strides.outcome
        if name == "word":
            return np.array(strides.words)
        if name == "why_not":
            return np.array([strides.why_not(k) or "" for k in range(len(batch))])
        if name in ("apex", "next_apex"):
            return strides.points if name == "apex" else strides.next_points
        if name in ("jacobian", "next_apex_by"):
            found = by(lambda part: part.next_points_by)
            return found[..., :size] if name == "jacobian" else found
        if name.endswith("_by") and differentiated:
            return by(lambda part: part.derivative(name.removesuffix("_by")))
        return strides.quantity(name)

    def make(name: str) -> NDArray[Any]:
        values = array(name)
        if values.dtype.kind == "f" and name != "apex":
            values = np.where(closed.reshape(-1, *[1] * (values.ndim - 1)), values, np.nan)
        one: NDArray[Any] = values[0] if batch.is_single else values
        return one

    over: tuple[str, ...] = () if batch.is_single else ("runner",)
    found = dict.fromkeys(("outcome", "word", "why_not", *names), over)
    found |= dict.fromkeys(("apex", "next_apex"), (*over, "coordinate"))
    if differentiated:
        found |= {
            "jacobian": (*over, "coordinate", "by_coordinate"),
            "next_apex_by": (*over, "coordinate", "by"),
        }
        found |= {f"{name}_by": (*over, "by") for name in names}

    def labels() -> dict[str, NDArray[Any]]:
        coordinates = np.array(model.coordinates)
        return {
            **labels_of(batch),
            "by": np.array([*model.coordinates, *map(title, along)]),
            "by_coordinate": coordinates,
        }

    return Table(found, make, labels, about_of(batch.model), batch.runner.record)


def own_ends(batch: Given, engine: OwnEngine, work: Mapping[str, int], recorded: Table | None) -> Table:
    """Ends of the runs, over runners."""
    over: tuple[str, ...] = () if batch.is_single else ("runner",)

    def make(name: str) -> NDArray[Any]:
        values: NDArray[Any] = engine.fates if name == "fate" else engine.ends[name]
        return values[0] if batch.is_single else values

    dimensions = dict.fromkeys(engine.ends.dtype.names or (), over) | {"apex": (*over, "coordinate")}
    return Table(
        dimensions,
        make,
        lambda: labels_of(batch),
        lambda name: ABOUT_ENDS.get(name, {}),
        batch.runner.record,
        {"work_done": work},
        recorded,
    )


def own_recorded(batch: Given, engine: OwnEngine, given: Mapping[str, NDArray[np.float64]]) -> Table:
    """Strides that were recorded from the first one on, over runners and strides; `given` is what was set."""
    recorded = engine.recorded
    assert recorded is not None
    strides = np.arange(recorded.shape[1])
    closed = strides < engine.ends["strides"][:, None]
    ended = np.where(engine.fates == SETTLED, NOT_MADE, engine.fates)
    next_apex = np.where(closed[..., None], recorded["apex"], np.nan)
    starts = batch.starts[:, None, : batch.size]
    arrays: dict[str, NDArray[Any]] = {
        "fate": np.where(closed, CLOSED, ended[:, None]).astype(np.int8),
        "apex": np.concatenate([starts, next_apex[:, :-1]], axis=1),
        "next_apex": next_apex,
        **{name: np.where(closed, recorded[name], np.nan) for name in engine.names},
        "word": texts_of(recorded["word"]),
    }
    law = batch.law
    for number, name in enumerate(law.inputs if isinstance(law, AffineLaw) else ()):
        arrays[name] = np.where(recorded["began"], recorded["set"][..., number], np.nan)
    arrays |= {name: np.where(recorded["began"], values, np.nan) for name, values in given.items()}
    over = ("runner", "stride", "coordinate")
    dimensions = {name: over[: values.ndim] for name, values in arrays.items()}
    labels = {**labels_of(batch), "stride": strides}
    return Table(dimensions, arrays.__getitem__, lambda: labels, about_of(batch.model), batch.runner.record)
