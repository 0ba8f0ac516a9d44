"""Strides from one point of a section to the next: quantities, exact derivatives, words and events."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .binding import c, text_of
from .events import Event, recorded
from .members import Along
from .quantities import (
    APEX_QUANTITIES,
    MEASURED,
    OF_WEIGHT,
    PER_DISTANCE,
    RATES,
    STRIDE_QUANTITIES,
    differentiable,
    reported_quantities,
    weight_by,
    weight_of,
)
from .section import COORDINATES


class RunnerStrides:
    """Strides of the package's own models, from the library's structs; see `page_strides.PageStrides`.

    `value_of` gives a parameter of the runners by its name. `along` are directions of derivatives, None for
    none. `measured` makes the strides with what is measured along them; by default the structs have it.
    """

    def __init__(
        self,
        structs: NDArray[Any],
        points: NDArray[np.float64],
        value_of: Callable[[str], Any],
        reduced: bool,
        *,
        along: Sequence[Along] | None = None,
        measured: Callable[[], NDArray[Any]] | None = None,
        log: Any = None,
    ) -> None:
        self.points, self.along, self.reduced, self._log = points, along, reduced, log
        self.names, self.differentiable = reported_quantities(reduced), differentiable(reduced)
        self._structs, self._measured, self._value_of = structs, measured, value_of
        self.outcome: NDArray[Any] = structs["outcome"]
        self.next_points: NDArray[np.float64] = structs["apex"][:, : points.shape[1]]

    @property
    def _variations(self) -> NDArray[Any]:
        assert self.along is not None
        some: NDArray[Any] = self._structs["variations"][:, : self.points.shape[1] + len(self.along)]
        return some

    @property
    def next_points_by(self) -> NDArray[np.float64]:
        """Derivatives of `next_points`, shape (runners, n, by)."""
        by: NDArray[np.float64] = self._variations["apex"][..., : self.points.shape[1]].swapaxes(1, 2)
        return by

    @property
    def words(self) -> Sequence[str]:
        """Words of the strides."""
        words: list[str] = self._structs["stride"]["word"].astype(str).tolist()
        return words

    @cached_property
    def _with_measures(self) -> NDArray[Any]:
        return self._structs if self._measured is None else self._measured()

    @cached_property
    def _weights(self) -> dict[str, Any]:
        return {name: self._value_of(name) for name in OF_WEIGHT}

    @cached_property
    def _weights_by(self) -> NDArray[np.float64]:
        """Derivatives of the weight by the coordinates and along directions, shape (..., by)."""
        values = self._weights
        rows = [np.zeros(np.shape(weight_of(values)))] * self.points.shape[1]
        for direction in self.along or ():
            shares = direction if isinstance(direction, Mapping) else {direction: 1.0}
            rows.append(rows[0] + sum(share * weight_by(values, name) for name, share in shares.items()))
        return np.stack(rows, axis=-1)

    def quantity(self, name: str) -> NDArray[np.float64]:
        """A quantity of the strides, shape (runners,)."""
        if name in APEX_QUANTITIES:
            values: NDArray[np.float64] = self.points[:, COORDINATES.index(APEX_QUANTITIES[name])]
            return values
        if name == "frequency":
            return _ratio(1.0, self.quantity("period"))
        if name in MEASURED and not self.reduced:
            if name == "positive_work":
                return self.quantity("positive_hip_work") + self.quantity("positive_leg_work")
            if name == "positive_cost_of_transport":
                distance = weight_of(self._weights) * self.quantity("length")
                return _ratio(self.quantity("positive_work"), distance)
            return np.asarray(self._with_measures["measures"][name])
        return np.asarray((self._structs["stride"] if name in STRIDE_QUANTITIES else self._structs)[name])

    def derivative(self, name: str) -> NDArray[np.float64]:
        """Derivatives of a quantity by the rules of differentiation, shape (runners, by)."""
        with np.errstate(divide="ignore", invalid="ignore"):  # where a stride has not closed
            return self._derivative(name)

    def _derivative(self, name: str) -> NDArray[np.float64]:
        by = self._derivative

        def at(other: str) -> NDArray[np.float64]:
            return self.quantity(other)[..., None]

        variations = self._variations
        if name in APEX_QUANTITIES:
            row = np.eye(variations.shape[1])[COORDINATES.index(APEX_QUANTITIES[name])]
            return np.broadcast_to(row, variations.shape)
        if name == "frequency":
            return -by("period") / at("period") ** 2
        if name in RATES:
            return (by(RATES[name]) - at(name) * by("period")) / at("period")
        if name in PER_DISTANCE:
            weight = np.asarray(weight_of(self._weights))[..., None]
            product_by = self._weights_by * at("length") + weight * by("length")
            return (by(PER_DISTANCE[name]) - at(name) * product_by) / (weight * at("length"))
        if name == "positive_work":
            return by("positive_hip_work") + by("positive_leg_work")
        return np.asarray(variations["measures"][name] if name in MEASURED else variations[name])

    def why_not(self, number: int = 0) -> str:
        """Reason why a stride did not close, in words; empty where it did."""
        struct = self._structs[number]
        if struct["outcome"] == c.TDMF_RETURN_CLOSED:
            return ""
        if struct["outcome"] == c.TDMF_RETURN_UNSOLVED:
            return text_of(c.tdmf_outcome_text(int(struct["solver"])))
        return text_of(c.tdmf_return_outcome_text(int(struct["outcome"])))

    @property
    def events(self) -> tuple[Event, ...]:
        """Events of the only stride."""
        return recorded(self._log)


def _ratio(numerator: Any, denominator: NDArray[np.float64]) -> NDArray[np.float64]:
    """The ratio, 0 where the denominator is."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(denominator != 0.0, numerator / denominator, 0.0)
