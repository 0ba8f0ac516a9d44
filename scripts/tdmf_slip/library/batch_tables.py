"""Tables of what a batch has done: exact strides, ends of runs, and recorded strides."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..variables.table import Model
from .batch_given import Given
from .engine import FATES, SETTLED, STOPPED, Engine
from .laws import AffineLaw
from .page_model import WORD, PageModel
from .page_strides import Strides
from .quantities import LEDGER, STRIDE_QUANTITIES
from .return_map import Along
from .tables import Table

PAGE_ENDS = ("fate", "gait", "strides", "apex", "time")
"""Arrays of the ends of runs of any page; the runner's have more."""
STRIDE_FATES = ("closed", "fell", "too_long", *FATES[3:6])
"""Fates of strides: those of runners, but for a stride that closed. A run that is undecided before its last
stride is in one that takes too long. Number `NOT_MADE` is a stride after its runner had settled."""
CLOSED = STRIDE_FATES.index("closed")
NOT_MADE = STOPPED
GROUND = "ground.height"
FOOT_X = "foot.x"


_ENERGIES = ("work", "hip_work", "leg_work", *LEDGER)
ABOUT: Mapping[str, Mapping[str, Any]] = {
    **{name: {"units": "J", "long_name": f"{name.replace('_', ' ')} of the stride"} for name in LEDGER},
    "liftoff_angle": {"units": "rad", "long_name": "leg angle at lift-off"},
    "apex": {"long_name": "apex at which the stride begins"},
    "next_apex": {"long_name": "apex at which it closes"},
    "next_apex_by": {"long_name": "derivatives of the next apex by this apex and by parameters"},
    "fate": {
        "flag_values": np.arange(len(STRIDE_FATES), dtype=np.int8),
        "flag_meanings": " ".join(STRIDE_FATES),
        "comment": "fell: the body or the leg is down, or the foot was below a new ground for a whole stride",
    },
}
"""Units and descriptions of arrays that the unit does not report under their names."""
ABOUT_ENDS: Mapping[str, Mapping[str, Any]] = {
    "fate": {"flag_values": np.arange(len(FATES)), "flag_meanings": " ".join(FATES)},
    "apex": {"long_name": "apex of the last stride that closed"},
    "time": {"units": "s"},
    **{name: {"units": "m"} for name in ("distance", "foot_x")},
    **{name: {"units": "J"} for name in _ENERGIES},
}
"""Units and descriptions at the ends of runs."""


@cache
def _dimensions(
    single: bool, names: tuple[str, ...], differentiated: tuple[str, ...] | None
) -> Mapping[str, tuple[str, ...]]:
    """Dimensions of the arrays of strides, by their names."""
    over: tuple[str, ...] = () if single else ("runner",)
    found = dict.fromkeys(("outcome", "word", "why_not", *names), over) | dict.fromkeys(
        ("apex", "next_apex"), (*over, "coordinate")
    )
    if differentiated is not None:
        found["jacobian"] = (*over, "coordinate", "by_coordinate")
        found["next_apex_by"] = (*over, "coordinate", "by")
        found |= {f"{name}_by": (*over, "by") for name in differentiated}
    return found


def strides_table(
    batch: Given, parts: Sequence[Strides], along: Sequence[Along], *, is_differentiated: bool
) -> Table:
    """Strides, NaN where they have not closed; each part has derivatives along some of the directions."""
    strides, size, closed = parts[0], batch.size, parts[0].outcome == 0

    def by(value_of: Callable[[Strides], NDArray[np.float64]]) -> NDArray[np.float64]:
        """Derivatives by the coordinates, and then along all directions."""
        first, *rows = [value_of(part) for part in parts]
        return np.concatenate([first, *(row[..., size:] for row in rows)], axis=-1) if rows else first

    def made(name: str) -> NDArray[Any]:
        if name in ("apex", "next_apex"):
            return strides.points if name == "apex" else strides.next_points
        if name in ("outcome", "word"):
            return np.asarray(strides.outcome if name == "outcome" else strides.words)
        if name == "why_not":
            return np.array([strides.why_not(k) for k in range(len(batch))])
        if is_differentiated and name in ("jacobian", "next_apex_by"):
            found = by(lambda part: part.next_points_by)
            return found[..., :size] if name == "jacobian" else found
        if is_differentiated and name.endswith("_by"):
            return by(lambda part: part.derivative(name.removesuffix("_by")))
        return strides.quantity(name)

    def make(name: str) -> NDArray[Any]:
        values = made(name)
        if values.dtype.kind == "f" and name != "apex" and not closed.all():
            values = np.where(closed.reshape(-1, *[1] * (values.ndim - 1)), values, np.nan)
        one: NDArray[Any] = values[0] if batch.is_single else values
        return one

    def labels() -> dict[str, NDArray[Any]]:
        names = np.array([*batch.runner.coordinates, *map(title, along)])
        return {**labels_of(batch), "by": names, "by_coordinate": np.array(batch.runner.coordinates)}

    dimensions = _dimensions(
        batch.is_single, strides.names, strides.differentiable if is_differentiated else None
    )
    return Table(dimensions, make, labels, about_of(batch.model), batch.runner.record)


def title(direction: Along) -> str:
    """A direction in the labels of a table."""
    if isinstance(direction, str):
        return direction
    return " + ".join(f"{share:g} {name}" for name, share in direction.items())


def about_of(model: Model) -> Callable[[str], Mapping[str, Any]]:
    """Gives unit and description of an array of strides, by the names that CF gives them."""

    def about(name: str) -> Mapping[str, Any]:
        if name in ABOUT:
            return ABOUT[name]
        variables, quantities = model.variables, model.full.quantities
        known = variables.get(f"stride.{name}") or quantities.get(name) or variables.get(name)
        return {} if known is None else known.attributes

    return about


def labels_of(batch: Given) -> dict[str, NDArray[Any]]:
    """Labels of the dimensions of a batch's tables."""
    return {
        "runner": batch.first_number + np.arange(len(batch)),
        "coordinate": np.array(batch.runner.coordinates),
    }


def ends_table(batch: Given, engine: Engine, work: Mapping[str, int], recorded: Table | None) -> Table:
    """Ends of the runs, over runners."""
    over: tuple[str, ...] = () if batch.is_single else ("runner",)

    def make(name: str) -> NDArray[Any]:
        values = engine.fates if name == "fate" else engine.ends[name]
        if name == "apex":
            values = values[:, : batch.size]
        return values[0] if batch.is_single else values

    of_page = (*PAGE_ENDS, "foot_x") if batch.model.has_ground else PAGE_ENDS
    names = of_page if batch.model.is_page else engine.ends.dtype.names or ()
    dimensions = dict.fromkeys(names, over) | {"apex": (*over, "coordinate")}
    return Table(
        dimensions,
        make,
        lambda: labels_of(batch),
        lambda name: ABOUT_ENDS.get(name, {}),
        batch.runner.record,
        {"work_done": work},
        recorded,
    )


def recorded_table(batch: Given, engine: Engine, given: Mapping[str, NDArray[np.float64]]) -> Table:
    """Strides that were recorded from the first one on, over runners and strides; `given` is what was set."""
    recorded = engine.recorded
    assert recorded is not None
    size, starts = batch.size, batch.starts[:, : batch.size].copy()
    strides = np.arange(recorded.shape[1])
    closed = strides < engine.ends["strides"][:, None]
    begun = recorded["began"] == 1
    ended = np.where(engine.fates == SETTLED, NOT_MADE, engine.fates)

    def of(values: NDArray[Any], there: NDArray[np.bool_] = closed) -> NDArray[np.float64]:
        return np.where(there, values, np.nan)

    next_apex = np.where(closed[..., None], recorded["apex"][..., :size], np.nan)
    arrays: dict[str, NDArray[Any]] = {
        "fate": np.where(closed, CLOSED, ended[:, None]).astype(np.int8),
        "apex": np.concatenate([starts[:, None], next_apex[:, :-1]], axis=1),
        "next_apex": next_apex,
        **{name: of(values) for name, values in _noted(batch, engine).items()},
        "word": _words(batch.model, engine, closed),
    }
    if batch.ground.roughness:
        arrays[GROUND] = of(recorded["ground_height"], begun)
    law = batch.law
    for number, name in enumerate(law.inputs if isinstance(law, AffineLaw) else ()):
        arrays[name] = of(recorded["set"][..., number], begun)
    arrays |= {name: of(values, begun) for name, values in given.items()}
    over = ("runner", "stride", "coordinate")
    dimensions = {name: over[: values.ndim] for name, values in arrays.items()}
    labels = {**labels_of(batch), "stride": strides}
    return Table(dimensions, arrays.__getitem__, lambda: labels, about_of(batch.model), batch.runner.record)


def _noted(batch: Given, engine: Engine) -> Mapping[str, NDArray[Any]]:
    """Quantities of recorded strides, shape (runners, strides), by name."""
    model, recorded = batch.model, engine.recorded
    assert recorded is not None
    place = {FOOT_X: recorded["foot_x"]} if model.has_ground else {}
    if not isinstance(model, PageModel):
        found = {name: recorded["stride"][name] for name in STRIDE_QUANTITIES}
        return found | {name: recorded[name] for name in (*LEDGER, "liftoff_angle")} | place
    assert engine.notes is not None
    values = engine.notes.values.reshape(*recorded.shape, -1)

    def noted(state: int) -> NDArray[np.float64]:
        of_state = values[..., model.noted[state]]
        if not model.has_ground or state not in model.totals:
            return of_state
        before = np.broadcast_to(batch.held[:, state], len(batch))
        return np.diff(of_state, prepend=before[:, None])

    states = model.quantity_states.items()
    return {n: recorded["stride"]["period"] if state is None else noted(state) for n, state in states} | place


def _words(model: Model, engine: Engine, closed: NDArray[np.bool_]) -> NDArray[np.str_]:
    """Words of recorded strides, as short as the longest of them; empty where none has closed."""
    assert engine.recorded is not None
    if not isinstance(model, PageModel):
        return _texts_of(engine.recorded["stride"]["word"])
    notes = engine.notes
    assert notes is not None
    codes = notes.values[:, model.noted[model.state_numbers[WORD]]] if model.letters else ()
    words = model.words(codes, ((row[row > 0] - 1).tolist() for row in notes.events))
    return _texts_of(np.where(closed, np.array(words, object).reshape(closed.shape), ""))


def _texts_of(words: NDArray[Any]) -> NDArray[np.str_]:
    """Texts as short as the longest of them."""
    different, numbers = np.unique(words, return_inverse=True)
    texts = np.array([str(word.decode() if isinstance(word, bytes) else word) for word in different])
    return texts[numbers.reshape(words.shape)]
