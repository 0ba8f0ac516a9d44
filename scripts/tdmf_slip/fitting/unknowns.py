"""What a fit looks for, and what is known of it beside the data."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Parameter:
    """A parameter that is looked for."""

    name: str
    """Of the runner."""
    row: int | None
    """Number of the row whose own it is; None where all rows share it."""

    @property
    def label(self) -> str:
        """The name, with the number of its row, from 1, where each has its own."""
        return self.name if self.row is None else f"{self.name}[{self.row + 1}]"


@dataclass(frozen=True)
class Prior:
    """What is known of a parameter beside the data."""

    name: str
    """Of the parameter, which all rows share."""
    value: float
    """In the unit's unit."""
    error: float
    """Its standard error, in the same unit."""
