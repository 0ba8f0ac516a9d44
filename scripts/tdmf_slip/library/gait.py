"""Periodic gaits as fixed points of the return map, stable or not, with their eigenvalues."""

import html
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..checks import check_kind, near_matches
from ..record import dataset, entries, origin_of, runner_in
from ..variables.table import FRICTION, MODELS, VARIABLES, model_recorded
from .events import Event, Letter, letters_of
from .members import Along
from .quantities import LEDGER as LEDGER
from .quantities import MEASURES, STRIDE_QUANTITIES
from .runner import Runner
from .section import COORDINATES, REDUCED

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

REPORTED = ("period", "length", "speed", "work", "cost_of_transport")
"""Quantities that describe a gait."""
PARTS = ("rise", "hip_work", "leg_work", *LEDGER)
"""Quantities that say where its energy comes from and goes to."""


@dataclass(frozen=True, eq=False, repr=False)
class Gait:
    """A periodic gait, which is a fixed point of the return map; units as in the model description."""

    runner: Runner
    """Runner of the gait: parameters and inputs. Its start does not matter."""
    apex: NDArray[np.float64]
    """Shape (n,), in the order of the runner's `coordinates`: six, or in the reduced map two."""
    word: str
    """The gait word: `+`, `0` or `-` for each contact mode in the order of the stance."""
    liftoff_angle: float
    """Leg angle at lift-off, rad."""
    stride: Mapping[str, float]
    """Quantities by the names in `STRIDE_QUANTITIES` and `LEDGER`; in the full model also by those in
    `quantities.MEASURES`, in the reduced map those of the apex. `positive_work` is the work of hip and leg,
    in the reduced map that of the hip alone."""
    jacobian: NDArray[np.float64]
    """Jacobian of the map, shape (n, n); [i, k] is the change of coordinate i by coordinate k."""
    along: Along | None
    """The parameter or input, or the direction of several, by which the next apex is differentiated, too."""
    by_parameter: NDArray[np.float64] | None
    """Change of the next apex along it, shape (n,); None where none was asked for."""
    error: float
    """Largest entry of the residual, over the coordinates' scales."""
    iterations: int
    """Number of iterations of Newton's method."""
    events: tuple[Event, ...] = field(repr=False)
    """Events of the stride, in their order."""
    following: tuple[NDArray[np.float64], ...] = ()
    """Apexes between the strides of a gait that takes more than one, each of shape (6,)."""
    residual: NDArray[np.float64] = field(default_factory=lambda: np.zeros(len(COORDINATES)), repr=False)
    """Last apex minus first, shape (n,), where the strides need not lead back; else zero."""

    @property
    def apexes(self) -> list[list[float]]:
        """The apex at which each of its strides begins."""
        return [[float(value) for value in apex] for apex in (self.apex, *self.following)]

    @cached_property
    def reported(self) -> dict[str, float]:
        """All quantities by name, with the frequency and the lift-off angle where the stride has a period."""
        more = {"frequency": 1.0 / self.stride["period"]} if self.stride.get("period") else {}
        return {**self.stride, **more, "liftoff_angle": self.liftoff_angle}

    @property
    def strides(self) -> int:
        """Number of strides after which the gait repeats itself. Word, quantities and Jacobian cover all."""
        return 1 + len(self.following)

    def __getattr__(self, name: str) -> float:
        """A quantity of the stride by its name, as `gait.cost_of_transport`."""
        stride = self.__dict__.get("stride", {})
        if name not in stride:
            raise AttributeError(f"a gait has no {name!r}{near_matches(name, (*stride, *dir(type(self))))}")
        quantity: float = stride[name]
        return quantity

    def __dir__(self) -> list[str]:
        """Names of all attributes, the stride's quantities included."""
        return [*super().__dir__(), *self.stride]

    def __repr__(self) -> str:
        """Friction, word, speed and stability in one line."""
        kind, label = "stable" if self.stable else "unstable", self.runner.label
        at = f" at {FRICTION} = {self.friction:.6g}" if FRICTION in self.runner else ""
        some = {"period": "s", "speed": "m/s", "cost_of_transport": ""}
        texts = [
            f"{name.replace('_', ' ')} {self.stride[name]:.6g} {label(unit) if unit else ''}".rstrip()
            for name, unit in some.items()
            if name in self.stride
        ]
        return f"<Gait {self.word}{at}: {', '.join(texts)}, {kind}, largest eigenvalue {self.lambda_max:.6g}>"

    def _repr_html_(self) -> str:
        """Box for a notebook: eight rows with units beside the eigenvalues in the unit circle."""
        label, stride = self.runner.label, self.stride
        stable = f"{'stable' if self.stable else 'unstable'}, largest eigenvalue {self.lambda_max:.4g}"
        rows = {"friction": f"{self.friction:.6g}"} if FRICTION in self.runner else {}
        rows |= {"word": self.word, "stability": stable}
        for name in ("period", "speed", "cost_of_transport", "duty_factor", "slip_distance"):
            if name not in stride:
                continue
            unit = label(self.runner.model.quantities[name].unit)
            rows[name.replace("_", " ")] = f"{stride[name]:.6g} {'' if unit == '1' else unit}".rstrip()
        cells = "".join(
            f"<tr><th>{name}</th><td>{html.escape(text)}</td></tr>" for name, text in rows.items()
        )
        marks = "".join(
            f'<circle cx="{value.real:.4f}" cy="{-value.imag:.4f}" r="0.06" fill="#b3216f"/>'
            for value in self.eigenvalues.astype(complex)
        )
        reach = 1.15 * max(1.0, self.lambda_max)
        view = " ".join(f"{side:.4f}" for side in (-reach, -reach, 2.0 * reach, 2.0 * reach))
        picture = (
            f'<svg width="160" height="160" viewBox="{view}">'
            "<title>Eigenvalues of the return map, and the unit circle</title>"
            '<g fill="none" stroke="currentColor" stroke-width="0.015"><circle r="1"/>'
            f'<path d="M{-reach:.4f} 0H{reach:.4f}M0 {-reach:.4f}V{reach:.4f}" stroke-opacity="0.4"/></g>'
            f"{marks}</svg>"
        )
        return f'<table style="display:inline-block">{cells}</table>{picture}'

    @property
    def friction(self) -> float:
        """Friction coefficient of the ground."""
        return self.runner[FRICTION]

    def plot(self) -> "Figure":
        """Draw the stride's velocities and force ratio.

        Returns
        -------
        Figure
            A Matplotlib figure, see `tdmf_slip.plot`.
        """
        figure: Figure = import_module("..pictures.plot", __package__).plot(self)
        return figure

    def to_dataset(self) -> "xarray.Dataset":
        """The gait as a dataset: quantities with units, eigenvalues as two variables, and the Jacobian.

        Returns
        -------
        xarray.Dataset
            As one point of a sweep's dataset, with `jacobian` besides.
        """
        data = gaits_dataset("gait", [self], {})
        coordinates = list(self.runner.coordinates)
        return data.assign(jacobian=(("coordinate", "by_coordinate"), self.jacobian)).assign_coords(
            coordinate=coordinates, by_coordinate=coordinates
        )

    def animate(self, path: Path | str = "stride.gif", *, frames: int = 120) -> Path:
        """Write one stride as an animation that loops, the stance in slow motion.

        Parameters
        ----------
        path : Path or str, default "stride.gif"
            File to write: .gif, .html, or .mp4 if ffmpeg is installed.
        frames : int, default 120
            Frames per stride, shown at 20 per second.

        Returns
        -------
        Path
            Path of the file.

        Raises
        ------
        InputError
            Another kind of file, or too few or too many frames.
        """
        written: Path = import_module("..pictures.animation", __package__).animate(self, path, frames)
        return written

    @cached_property
    def start_values(self) -> dict[str, float]:
        """Everything a run of the unit needs to begin at this gait's apex."""
        return self.runner.start_values(self.apex)

    @cached_property
    def section(self) -> NDArray[np.float64]:
        """The apex, in the order of the model's coordinates; in the reduced map also the leg as placed."""
        if not self.runner.reduced:
            return self.apex
        state = self.runner.state_at(self.apex)
        leg = (state[name.replace("leg_", "leg.")] for name in COORDINATES[len(REDUCED) :])
        return np.array([*self.apex[: len(REDUCED)], *leg])

    @cached_property
    def eigenvalues(self) -> NDArray[np.float64] | NDArray[np.complex128]:
        """Eigenvalues of the Jacobian, shape (n,), the largest first; complex where any is."""
        found: NDArray[Any] = np.linalg.eigvals(self.jacobian)
        return found[np.argsort(-np.abs(found), kind="stable")]

    @property
    def lambda_max(self) -> float:
        """Size of the largest eigenvalue."""
        return float(abs(self.eigenvalues[0]))

    @property
    def unstable(self) -> int:
        """Number of eigenvalues outside the unit circle."""
        return int(np.count_nonzero(np.abs(self.eigenvalues) > 1.0))

    @property
    def stable(self) -> bool:
        """All eigenvalues are inside the unit circle."""
        return bool(np.all(np.abs(self.eigenvalues) < 1.0))

    @cached_property
    def letters(self) -> tuple[Letter, ...]:
        """Letters of the word with how long each mode lasts; graze and flight add none."""
        return letters_of(self.events)

    @cached_property
    def sequence(self) -> tuple[object, ...]:
        """The word, and which guards fired in their order: the return map is smooth while they stay."""
        return self.word, *((event.guard, event.contact_after) for event in self.events)

    def as_json(self) -> dict[str, object]:
        """The gait as a plain object, eigenvalues as [re, im], start values for a run that begins on it.

        Of a gait of more than one stride, also how many, and the apexes in their order.
        """
        return {
            **origin_of(self.runner),
            **({"friction": self.friction} if FRICTION in self.runner else {}),
            "word": self.word,
            **{name: self.stride[name] for name in (*REPORTED, *PARTS) if name in self.stride},
            **entries(self, "liftoff_angle", "apex", "eigenvalues", "stable", "start_values"),
            **({"strides": self.strides, "apexes": self.apexes} if self.following else {}),
        }


def check_is_gait(given: object, what: str) -> None:
    """Refuse what is no gait of the return map."""
    check_kind(given, Gait, what, "a Gait, as find_gait gives")


def gaits_dataset(
    kind: str,
    gaits: Sequence[Gait | None],
    coordinates: Mapping[str, NDArray[np.float64]],
    runner: Runner | None = None,
    varied: Sequence[str] = (),
    **attributes: str | float,
) -> "xarray.Dataset":
    """Gaits on a grid as a dataset with units; NaN and an empty word where there is none.

    The gaits are in the order of the coordinates, the last one running fastest. The runner is theirs, or that
    of the first gait. Values that are `varied` in another way than by coordinates are coordinates, too.
    """
    over, shape = tuple(coordinates), tuple(map(len, coordinates.values()))
    runner = runner or next(gait.runner for gait in gaits if gait is not None)
    known = runner.model
    model = known.full
    modes = max((len(gait.apex) for gait in gaits if gait is not None), default=len(model.coordinates))
    spectra = np.full((len(gaits), modes), np.nan, complex)
    for row, gait in zip(spectra, gaits, strict=True):
        if gait is not None:
            row[:] = gait.eigenvalues
    eigenvalues = spectra.reshape(*shape, modes)

    def column(value_of: Callable[[Gait], float], attributes: Mapping[str, str]) -> tuple[Any, ...]:
        values = [np.nan if gait is None else value_of(gait) for gait in gaits]
        return over, np.array(values, float).reshape(shape), attributes

    def quantity(name: str) -> tuple[Any, ...]:
        return column(lambda gait: gait.reported.get(name, np.nan), model.quantities[name].attributes)

    def coordinate(number: int) -> tuple[Any, ...]:
        about = model.coordinate(model.coordinates[number]).attributes
        return column(lambda gait: float(gait.section[number]), about)

    def value(name: str) -> tuple[Any, ...]:
        return column(lambda gait: gait.runner[name], known.variables[name].attributes)

    own = (*STRIDE_QUANTITIES, "frequency", *LEDGER, "liftoff_angle", *MEASURES)
    names = dict.fromkeys(own) if model.name in MODELS else known.quantities
    variables = {name: quantity(name) for name in names}
    variables |= {f"apex_{name}": coordinate(number) for number, name in enumerate(model.coordinates)}
    variables["lambda_max"] = column(lambda gait: gait.lambda_max, {"units": "1"})
    for part in ("real", "imag"):
        about = {"units": "1", "long_name": f"{part} parts of the eigenvalues, the largest first"}
        variables[f"eigenvalue_{part}"] = (*over, "mode"), getattr(eigenvalues, part).copy(), about
    words = np.array(["" if gait is None else gait.word for gait in gaits], dtype=object).reshape(shape)
    variables["word"] = over, words, VARIABLES["stride.word"].attributes
    labels = {
        name: (name, values, model.variables[name].attributes if name in model.variables else {})
        for name, values in coordinates.items()
    }
    labels |= {name: value(name) for name in varied}
    return dataset(kind, runner.record(*coordinates, *varied), variables, labels, **attributes)


def first_runner_in(data: "xarray.Dataset") -> Runner:
    """The runner of a dataset with the first value of each name that varies in it.

    Without these names the recorded values may be refused, or seem to mix units.
    """
    model = model_recorded(data.attrs)
    first = {
        str(name): float(data[name].values.flat[0])
        for name in data.coords
        if name in model.variables and data[name].size
    }
    return Runner({**first, **runner_in(data)}, model=model)
