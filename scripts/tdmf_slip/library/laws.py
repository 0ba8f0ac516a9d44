"""Laws: from apices to what is set there. Any function is one; the engine follows an affine one by itself."""

from __future__ import annotations

import inspect
import json
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked_whole, refusal, shown
from ..errors import InputError, counted
from ..given import numbers_of, row_of
from ..record import without_record
from ..variables.table import MODELS, Model, by_full_name, full_names, model_named
from .binding import c, ffi
from .c_structs import WIDTH
from .ground import LAST_RUNNER, LAST_SEED, MAX_STEPS, RoughGround
from .runner import Runner
from .section import REDUCED, Apex, checked_apex
from .settings import check_acts, check_settings, checked_values, setting_number

LARGEST = 1e100
"""Largest number in a law: sums of products stay finite."""
Law: TypeAlias = Callable[[NDArray[np.float64], int], Mapping[str, ArrayLike]]
"""Function of apices, shape (runners, n), and the number of the stride that begins there. It gives settings
by name, each as a number, or as one for each runner. Each row is set by itself. Rows of runners whose run is
over are NaN."""


@dataclass(frozen=True)
class AffineLaw:
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
    """Apex at which the settings are nominal, shape (n,): in the order of `COORDINATES`, or `REDUCED`."""
    nominal: Sequence[float] | NDArray[np.float64]
    """Values of the settings there, shape (k,), in their units; so are the limits."""
    gain: ArrayLike
    """Gain of each setting by each coordinate, shape (k, n)."""
    low: Sequence[float] | NDArray[np.float64]
    """Least value of each setting, shape (k,), within its range."""
    high: Sequence[float] | NDArray[np.float64]
    """Largest value of each setting, shape (k,), within its range."""
    noise: Sequence[float] | NDArray[np.float64] | None = None
    """Standard deviation of what is added to each coordinate, shape (n,); by default none is."""
    seed: int = 0
    """Seed of the noise."""
    model: Model = field(default=MODELS["full"], repr=False, compare=False)
    """The model of the runners that obey; by the full one's law go those of the reduced map, too."""

    def __post_init__(self) -> None:
        """Make all of it plain numbers; refuse values that are none, out of range or of another shape."""
        allowed = "one or more names in a list"
        model = model_named(self.model)
        names = full_names(self.inputs, "inputs", allowed, model.aliases)
        if not names:
            raise InputError(f"inputs = {shown(self.inputs)} is not allowed; allowed: {allowed}")
        for number, name in enumerate(names):
            setting_number(name, "inputs", model)
            if name in names[:number]:
                raise InputError(f"inputs: {name} is there twice; allowed: once")
        given = row_of(self.apex, "apex", f"numbers for {', '.join(model.coordinates)}")
        is_reduced = model is MODELS["full"] and len(given) == len(REDUCED)
        coordinates = REDUCED if is_reduced else model.coordinates
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
            checked_values(name, low, "low", {}, model)
            checked_values(name, high, "high", {}, model)
            if low > high:
                raise InputError(f"low: {name} = {low:g} is not allowed; allowed: up to high = {high:g}")
        object.__setattr__(self, "inputs", names)
        for what, values in rows.items():
            object.__setattr__(self, what, tuple(values.tolist()))
        object.__setattr__(self, "gain", tuple(tuple(row) for row in gain.tolist()))
        object.__setattr__(self, "seed", checked_whole("seed", self.seed, 0, LAST_SEED))

    @property
    def is_noisy(self) -> bool:
        """True if the sensor adds noise."""
        return any(self.noise or ())

    @cached_property
    def in_c(self) -> tuple[Any, Mapping[str, Any]]:
        """The law as the library's `tdmf_affine_law *`, and the arrays that it points to."""
        gain = np.zeros((len(self.inputs), WIDTH))
        gain[:, : len(self.apex)] = self.gain
        numbers = [setting_number(name, "inputs", self.model) for name in self.inputs]
        law = ffi.new("tdmf_affine_law *", {"count": len(numbers), "seed": self.seed})
        law.apex[0 : len(self.apex)] = self.apex
        law.noise[0 : len(self.apex)] = self.noise
        arrays = {"settings": ffi.new("int[]", numbers), "gain": ffi.new(f"double[][{WIDTH}]", gain.tolist())}
        arrays |= {
            name: ffi.new("double[]", list(getattr(self, name))) for name in ("nominal", "low", "high")
        }
        for name, array in arrays.items():
            setattr(law, name, array)
        return law, arrays

    def __getstate__(self) -> dict[str, object]:
        """State without what the library takes, which holds addresses of this process."""
        return {name: value for name, value in self.__dict__.items() if name != "in_c"}

    def __call__(
        self, apices: NDArray[np.float64], stride_number: int = 0, first_number: int = 0
    ) -> dict[str, NDArray[np.float64]]:
        """Settings at the apices of many runners, as the engine computes them.

        Parameters
        ----------
        apices : ndarray of float, shape (runners, n)
            In the order of the law's own.
        stride_number : int, default 0
            Number of the stride that begins; the noise depends on it.
        first_number : int, default 0
            Number of the first runner, from which the others are counted; the noise depends on it, too.

        Returns
        -------
        dict of str to ndarray
            By the names of the settings, shape (runners,).
        """
        law, sections = self.in_c[0], np.zeros((len(apices), WIDTH))
        sections[:, : len(self.apex)] = apices
        values = np.empty((len(apices), len(self.inputs)))
        for number, (section, row) in enumerate(zip(sections, values, strict=True), first_number):
            begin, out = ffi.from_buffer("double[]", section), ffi.from_buffer("double[]", row)
            c.tdmf_affine_settings(law, begin, number, stride_number, out)
        return dict(zip(self.inputs, values.T, strict=True))

    def inputs_at(self, apex: Apex, runner: int = 0, stride: int = 0) -> dict[str, float]:
        """Settings at an apex.

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
        coordinates = self.model.coordinates[: len(self.apex)]
        section = _numbers("apex", checked_apex(apex, coordinates), (len(coordinates),))
        runner = checked_whole("runner", runner, 0, LAST_RUNNER)
        stride = checked_whole("stride", stride, 0, MAX_STEPS)
        return {name: float(row[0]) for name, row in self(section[None], stride, runner).items()}

    def as_json(self) -> dict[str, object]:
        """The law as a plain object, by the names of its arguments."""
        return {f.name: getattr(self, f.name) for f in fields(self) if f.name != "model"}

    def check_fits(self, runner: Runner) -> None:
        """Refuse a runner whose apices are of other coordinates, or on whom a setting does not act."""
        fits = self.model.names == runner.model.names
        if not fits or len(self.apex) != len(runner.coordinates):
            raise InputError(
                f"law: has {counted(len(self.apex), 'coordinate')}; allowed: those of the runner, "
                f"{', '.join(runner.coordinates)}"
            )
        for name in self.inputs:
            check_acts(name, runner, self.inputs, "law")


def text_of_law(law: Law, apices: NDArray[np.float64] | None = None) -> str:
    """A law as results record it: an affine one as JSON, a function by name and what it sets at apices."""
    if isinstance(law, AffineLaw):
        return json.dumps(without_record(law.as_json()))
    name = getattr(law, "__qualname__", type(law).__qualname__)
    if apices is None:
        return str(name)
    made = law(apices.copy(), 0)
    numbers = np.concatenate([np.ravel(np.asarray(made[setting], float)) for setting in sorted(made)])
    return f"{name}, check sum of settings {zlib.crc32(numbers.tobytes()):08x}"


def is_noisy(law: Law | None) -> bool:
    """True if the sensors of a law add noise, which is drawn by the numbers of runners."""
    return isinstance(law, AffineLaw) and law.is_noisy


def check_law(law: object, runner: Runner) -> None:
    """Refuse a value that is no law, and an affine law that does not fit a runner."""
    if isinstance(law, AffineLaw):
        law.check_fits(runner)
    elif law is not None:
        allowed = "a function of apices and the number of the stride, or an AffineLaw"
        if not callable(law):
            raise refusal("law", law, allowed)
        try:
            inspect.signature(law).bind(None, 0)
        except ValueError:  # a function of C that does not say
            return
        except TypeError:
            raise refusal("law", law, allowed) from None


class CheckedLaw:
    """A function as a law; what it sets is checked at each stride."""

    def __init__(
        self, law: Law, runner: Runner, ground: RoughGround, set_too: Sequence[str], inputs: Sequence[str]
    ):
        self.law, self.runner, self.ground = law, runner, ground
        self.set_too, self.inputs = set_too, inputs
        self.names: tuple[str, ...] | None = None

    def __call__(
        self, apices: NDArray[np.float64], stride_number: int, under_way: NDArray[np.bool_]
    ) -> dict[str, NDArray[np.float64]]:
        """Settings at apices, shape (runners,); the runner's own values where a run is over."""
        what = f"law: stride {stride_number}"
        allowed, aliases = "numbers or arrays by name", self.runner.model.aliases
        given = by_full_name(self.law(apices, stride_number), f"{what}: what it gives", allowed, aliases)
        if self.names is None:
            names = tuple(given)
            check_settings(names, self.runner, self.ground, "law", set_too=self.set_too, inputs=self.inputs)
            self.names = names
        if set(given) != set(self.names):
            raise InputError(f"{what}: {', '.join(given)}; allowed: {', '.join(self.names)}, as at first")
        return {name: self._values(name, given[name], what, under_way) for name in self.names}

    def _values(
        self, name: str, given: ArrayLike, what: str, under_way: NDArray[np.bool_]
    ) -> NDArray[np.float64]:
        values = numbers_up_to(f"{what}: {name}", given, 1)
        if values.shape not in ((), (1,), under_way.shape):
            raise InputError(
                f"{what}: {name} of shape {values.shape}; allowed: {under_way.shape}, or one for all"
            )
        of_all = np.broadcast_to(values, under_way.shape)
        usual = self.runner[name]
        return checked_values(
            name, np.where(under_way, of_all, usual), what, {"runner": 0}, self.runner.model
        )


def numbers_up_to(what: str, given: object, dimensions: int) -> NDArray[np.float64]:
    """An array of numbers with at most `dimensions` dimensions."""
    values = numbers_of(what, given)
    if values.ndim > dimensions or not values.size:
        raise InputError(
            f"{what} of shape {values.shape}; allowed: one or more numbers, {dimensions} dimensions"
        )
    return values


def _numbers(what: str, given: object, shape: tuple[int, ...]) -> NDArray[np.float64]:
    values = numbers_of(what, given, f"numbers of shape {shape}")
    if values.shape != shape:
        raise InputError(f"{what} of shape {values.shape}: allowed: {shape}")
    if not (np.abs(values) <= LARGEST).all():
        raise InputError(
            f"{what} = {values.tolist()} is not allowed; allowed: numbers up to {LARGEST:g} in size"
        )
    return values
