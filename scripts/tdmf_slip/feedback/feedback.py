"""A feedback: an affine law from the apex to settings, with what its closed loop does to first order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..checks import is_one_of, near_matches, refusal, shown
from ..errors import InputError
from ..given import numbers_of, row_of
from ..library.laws import AffineLaw
from ..variables.table import FRICTION, VARIABLES, by_full_name
from .linearization import Linearization

Limits: TypeAlias = Mapping[str, tuple[float, float]]
"""The least and the largest value of settings, by name, in their units."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Feedback(AffineLaw):
    """An affine law that holds a gait, as `law=` takes it; `dataclasses.replace` gives it noise or limits."""

    linearization: Linearization
    """The gait and its settings, to first order."""
    eigenvalues: NDArray[Any]
    """Eigenvalues of the closed loop within its limits, shape (n,), largest first; complex where any is."""
    strides: int | None = None
    """After so many a dead-beat law has moved every mode that it does not leave alone; None of another."""

    def __repr__(self) -> str:
        """In a line: what is set, at which gait, and the closed loop's largest eigenvalue."""
        gait = self.linearization.gait
        return (
            f"<Feedback by {', '.join(self.inputs)} at the gait {gait.word}, {FRICTION} = "
            f"{gait.friction:.6g}: largest eigenvalue {self.lambda_max:.4g}, {gait.lambda_max:.4g} without>"
        )

    @property
    def lambda_max(self) -> float:
        """Size of the largest eigenvalue."""
        return float(abs(self.eigenvalues[0]))

    def as_json(self) -> dict[str, object]:
        """The law as a plain object, by names as of an `AffineLaw`, with its eigenvalues as [re, im]."""
        law: dict[str, object] = {item.name: getattr(self, item.name) for item in fields(AffineLaw)}
        eigenvalues = self.eigenvalues.astype(complex)
        return {
            **self.linearization.gait.runner.record(),
            **law,
            "eigenvalues": [[float(value.real), float(value.imag)] for value in eigenvalues],
        }

    @property
    def closed_loop(self) -> NDArray[np.float64]:
        """A + B G over the scales, shape (n, n): the next apex's deviation by this one's."""
        return self.linearization.closed_loop(np.asarray(self.gain))


def feedback_of(
    model: Linearization,
    gain: NDArray[np.float64],
    limits: Limits | None = None,
    *,
    strides: int | None = None,
) -> Feedback:
    """The feedback that a gain makes."""
    low, high = _checked_limits(model, limits)
    found: NDArray[Any] = np.linalg.eigvals(model.closed_loop(gain))
    return Feedback(
        inputs=model.inputs,
        apex=model.gait.apex,
        nominal=model.nominal,
        gain=gain,
        low=low,
        high=high,
        linearization=model,
        eigenvalues=found[np.argsort(-np.abs(found), kind="stable")],
        strides=strides,
    )


def _checked_limits(
    model: Linearization, limits: Limits | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    given = by_full_name(limits, "limits", "pairs of numbers by setting")
    unknown = next((name for name in given if not is_one_of(name, model.inputs)), None)
    if unknown is not None:
        raise InputError(
            f"limits: {shown(unknown)} is not allowed; allowed: {', '.join(model.inputs)}"
            f"{near_matches(unknown, model.inputs)}"
        )
    found = []
    for name, nominal in zip(model.inputs, model.nominal, strict=True):
        variable = VARIABLES[name]
        asked = given.get(name, (variable.minimum, variable.maximum))
        allowed = f"two numbers within {variable.allowed} with {nominal:g}, the gait's own, between them"
        pair = numbers_of(f"limits: {name}", row_of(asked, f"limits: {name}", allowed), allowed)
        if pair.shape != (2,) or pair[0] == pair[1]:
            raise refusal(f"limits: {name}", asked, allowed)
        if not variable.minimum <= pair[0] <= nominal <= pair[1] <= variable.maximum:
            raise refusal(f"limits: {name}", asked, allowed)
        found.append(pair)
    low, high = np.array(found).T
    return low, high
