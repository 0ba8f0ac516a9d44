"""Unknowns of a fit, and their priors."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Parameter:
    """A parameter that is looked for."""

    name: str
    """Name of the runner's parameter."""
    row: int | None
    """Number of the row whose own it is; None where all rows share it."""

    @property
    def label(self) -> str:
        """The name, with the number of its row, from 1, where each has its own."""
        return self.name if self.row is None else f"{self.name}[{self.row + 1}]"


@dataclass(frozen=True)
class Prior:
    """Prior of a parameter."""

    name: str
    """Name of the parameter, which all rows share."""
    value: float
    """In the unit's unit."""
    error: float
    """Its standard error, in the same unit."""
