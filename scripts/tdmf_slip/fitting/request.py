"""Request for a fit, checked."""

from collections.abc import Mapping
from dataclasses import dataclass

from .measurements import Measurements
from .unknowns import Prior


@dataclass(frozen=True, eq=False)
class Request:
    """Data and parameters of a fit, and how to fit."""

    measurements: Measurements
    """The data."""
    shared: tuple[str, ...]
    """Parameters to be found that all rows share."""
    each: tuple[str, ...]
    """Those of which each row has its own."""
    priors: tuple[Prior, ...]
    """Priors of shared parameters."""
    robust: bool
    """Huber's loss instead of squares."""
    scale_errors: bool
    """The errors are known but for a common factor."""
    profiled: tuple[str, ...]
    """Names of parameters whose intervals are by the profile likelihood."""
    starts: int
    """Fits, at the most, of which the best counts."""
    ranges: Mapping[str, tuple[float, float]]
    """Ranges of the parameters, by name."""

    @property
    def degrees_of_freedom(self) -> int:
        """Measured numbers and priors less fitted numbers."""
        rows = len(self.measurements.rows)
        fitted = len(self.shared) + rows * len(self.each)
        return self.measurements.count + len(self.priors) - fitted
