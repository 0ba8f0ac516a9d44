"""Loosest tolerance that reaches an accuracy, and the time that work takes."""

import time
from collections.abc import Callable, Iterator

from tdmf_slip.errors import RunError

from .results import ACCURACIES

TOLERANCES = tuple(digit * 10.0**-power for power in range(3, 13) for digit in (10, 5, 2))
REPEATS = 5


def loosest(what: str, error_at: Callable[[float], float]) -> Iterator[tuple[float, float, float]]:
    """Yield each accuracy, the loosest tolerance that reaches it as all tighter ones do, and its error."""
    errors: dict[float, float] = {}
    for accuracy in ACCURACIES:
        found = None
        for tolerance in reversed(TOLERANCES):
            if tolerance not in errors:
                errors[tolerance] = error_at(tolerance)
            if not errors[tolerance] <= accuracy:
                break
            found = tolerance
        if found is None:
            raise RunError(
                f"{what}: no tolerance down to {TOLERANCES[-1]:g} reaches an error of {accuracy:g}"
            )
        yield accuracy, found, errors[found]


def check_agrees(what: str, error_at: Callable[[float], float]) -> None:
    """Refuse a solver that does not make the same strides at its tightest tolerance."""
    error = error_at(TOLERANCES[-1])
    if not error <= ACCURACIES[0]:
        raise RunError(
            f"{what}: differs by {error:.1e} at a tolerance of {TOLERANCES[-1]:g}; allowed: {ACCURACIES[0]:g}"
        )


def fastest(work: Callable[[], object], repeats: int = REPEATS) -> float:
    """Seconds of the fastest of some repeats."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)
