"""A law from apex to settings that the ensemble engine follows by itself, with limits and noise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import check_kind, checked_whole, shown
from ..contents import ByContents
from ..errors import InputError
from ..given import numbers_of, row_of
from ..variables.table import full_names
from .binding import c, ffi
from .rough_ground import LAST_RUNNER, LAST_SEED, MAX_STEPS
from .runner import Runner
from .section import COORDINATES, REDUCED, Apex, checked_apex
from .settings import check_acts, checked_values, setting_number
from .structs import Struct

LARGEST = 1e100
"""Of the numbers of a law, so that sums of their products are finite."""


@dataclass(frozen=True, eq=False)
class AffineLaw(ByContents):
    """Settings that a runner has from each apex on, as a controller makes them that measures the apex.

    Setting i is `nominal[i]` plus the sum of `gain[i][j]` times (measured coordinate j minus `apex[j]`), but
    not below `low[i]` nor above `high[i]`. Measured is the apex as the engine has it, with its height above
    the ground that the runner came from, before the ground steps; and to coordinate j the sensor adds a
    normal deviate of standard deviation `noise[j]`, drawn by a counter from `seed`, the runner's number, the
    stride's and the coordinate's: by Philox as the steps of rough ground, but independent of them.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    >>> by_height = tdmf_slip.AffineLaw(
    ...     ["hip.touchdown_angle"], gait.apex, [gait.runner["hip.touchdown_angle"]],
    ...     [[0.1, 0, 0, 0, 0, 0]], low=[0.3], high=[1.0],
    ... )
    >>> by_height.inputs_at(gait.apex) == {"hip.touchdown_angle": by_height.nominal[0]}
    True
    """

    inputs: Sequence[str]
    """Names of what is set: one or more of `settings.SETTINGS`."""
    apex: Apex
    """Where the settings are nominal, shape (n,): in the order of `COORDINATES`, or `REDUCED`."""
    nominal: Sequence[float] | NDArray[np.float64]
    """Values of the settings there, shape (k,), in their units; so are the limits."""
    gain: ArrayLike
    """Of each setting by each coordinate, shape (k, n)."""
    low: Sequence[float] | NDArray[np.float64]
    """Least value of each setting, shape (k,), within its range."""
    high: Sequence[float] | NDArray[np.float64]
    """Largest value of each setting, shape (k,), within its range."""
    noise: Sequence[float] | NDArray[np.float64] | None = None
    """Standard deviation of what is added to each coordinate, shape (n,); by default none is."""
    seed: int = 0
    """Of the noise."""

    def __post_init__(self) -> None:
        """Make all of it plain numbers; refuse values that are none, out of range or of another shape."""
        allowed = "one or more names in a list"
        names = full_names(self.inputs, "inputs", allowed)
        if not names:
            raise InputError(f"inputs = {shown(self.inputs)} is not allowed; allowed: {allowed}")
        for number, name in enumerate(names):
            setting_number(name, "inputs")
            if name in names[:number]:
                raise InputError(f"inputs: {name} is there twice; allowed: once")
        given = row_of(self.apex, "apex", f"numbers for {', '.join(COORDINATES)}")
        coordinates = REDUCED if len(given) == len(REDUCED) else COORDINATES
        n, k = len(coordinates), len(names)
        rows = {
            "apex": _numbers("apex", checked_apex(self.apex, coordinates), (n,)),
            "nominal": _numbers("nominal", self.nominal, (k,)),
            "low": _numbers("low", self.low, (k,)),
            "high": _numbers("high", self.high, (k,)),
            "noise": _numbers("noise", np.zeros(n) if self.noise is None else self.noise, (n,)),
        }
        gain = _numbers("gain", self.gain, (k, n))
        if (rows["noise"] < 0.0).any():
            raise InputError(f"noise = {rows['noise'].tolist()} is not allowed; allowed: 0 or above")
        for name, low, high in zip(names, rows["low"], rows["high"], strict=True):
            checked_values(name, low, "low", {})
            checked_values(name, high, "high", {})
            if low > high:
                raise InputError(f"low: {name} = {low:g} is not allowed; allowed: up to high = {high:g}")
        object.__setattr__(self, "inputs", names)
        for what, values in rows.items():
            object.__setattr__(self, what, tuple(values.tolist()))
        object.__setattr__(self, "gain", tuple(tuple(row) for row in gain.tolist()))
        object.__setattr__(self, "seed", checked_whole("seed", self.seed, 0, LAST_SEED))

    @property
    def is_noisy(self) -> bool:
        """Whether the sensor adds anything."""
        return any(self.noise or ())

    def inputs_at(self, apex: Apex, runner: int = 0, stride: int = 0) -> dict[str, float]:
        """What is set at an apex.

        Parameters
        ----------
        apex : sequence of float, shape (n,)
            In the order of the law's own.
        runner : int, default 0
            The runner's number, from 0 on, by which the noise is drawn.
        stride : int, default 0
            Likewise the number of the stride that begins.

        Returns
        -------
        dict of str to float
            By the names of the settings.

        Raises
        ------
        InputError
            Other coordinates, or a number is out of range.
        """
        coordinates = COORDINATES[: len(self.apex)]
        section = ffi.new(
            "double[6]", list(_numbers("apex", checked_apex(apex, coordinates), (len(coordinates),)))
        )
        values = ffi.new("double[]", len(self.inputs))
        runner = checked_whole("runner", runner, 0, LAST_RUNNER)
        stride = checked_whole("stride", stride, 0, MAX_STEPS)
        law, kept = self.c_law()
        c.tdmf_affine_settings(law, section, runner, stride, values)
        del kept
        return dict(zip(self.inputs, map(float, values), strict=True))

    def as_json(self) -> dict[str, object]:
        """The law as a plain object, by the names of its arguments."""
        return asdict(self)

    def check_fits(self, runner: Runner) -> None:
        """Refuse a runner whose apices are of other coordinates, or on whom a setting does not act."""
        if len(self.apex) != len(runner.coordinates):
            raise InputError(
                f"law: of {len(self.apex)} coordinates; allowed, as the runner has: "
                f"{', '.join(runner.coordinates)}"
            )
        for name in self.inputs:
            check_acts(name, runner, self.inputs, "law")

    def c_law(self) -> tuple[Struct, object]:
        """The law as the library takes it, a `tdmf_affine_law *`, and what has to live as long."""
        law = ffi.new("tdmf_affine_law *")
        gain = np.zeros((len(self.inputs), len(COORDINATES)))
        gain[:, : len(self.apex)] = self.gain
        kept = {
            "settings": ffi.new("int[]", [setting_number(name, "inputs") for name in self.inputs]),
            "nominal": ffi.new("double[]", list(self.nominal)),
            "gain": ffi.new("double[][6]", gain.tolist()),
            "low": ffi.new("double[]", list(self.low)),
            "high": ffi.new("double[]", list(self.high)),
        }
        for name, values in kept.items():
            setattr(law, name, values)
        law.count, law.seed = len(self.inputs), self.seed
        law.apex[0 : len(self.apex)] = list(self.apex)
        law.noise[0 : len(self.apex)] = list(self.noise or ())
        return law, (law, kept)


def check_law(law: object, runner: Runner) -> None:
    """Refuse what is no affine law for a runner."""
    if law is not None:
        check_kind(law, AffineLaw, "law", "an AffineLaw")
        assert isinstance(law, AffineLaw)
        law.check_fits(runner)


def _numbers(what: str, given: object, shape: tuple[int, ...]) -> NDArray[np.float64]:
    values = numbers_of(what, given, f"numbers of shape {shape}")
    if values.shape != shape:
        raise InputError(f"{what} of shape {values.shape}: allowed: {shape}")
    if not (np.abs(values) <= LARGEST).all():
        raise InputError(
            f"{what} = {values.tolist()} is not allowed; allowed: numbers up to {LARGEST:g} in size"
        )
    return values
