"""A runner's values: an immutable mapping over the table of variables, checked once."""

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, NoReturn, Self

from ..checks import near_matches, number_of, refusal, shown
from ..errors import InputError
from . import paper_units
from .parameters import RUNNER, RunnerLike, start_values_of
from .table import MODELS, Model, by_full_name, model_named
from .variable import Given, Value

TOLERANCE = 1e-13
"""Relative tolerance of the native solver: the next apex is then that of a gait to 1e-11 of the scales, and
so is the gait itself, unless it is very sensitive, as near a fold."""
_SOME = ("ground.friction", "body.mass", "leg.stiffness", "hip.stance_torque", "hip.touchdown_angle")


class RunnerValues(Mapping[str, Value]):
    """Values of a runner by name, with its model and the solver's tolerance."""

    __array_ufunc__: ClassVar[None] = None  # arrays leave comparisons to the runner
    __slots__ = ("__dict__", "_hash", "_values", "model", "tolerance")
    _values: tuple[Value, ...]
    _hash: int
    model: Model
    """The map that goes from apex to apex, with the names of its coordinates and quantities."""
    tolerance: float
    """Relative tolerance of the native solver."""

    def __new__(
        cls,
        given: RunnerLike | Model = None,
        *,
        model: str | Model | None = None,
        tolerance: float | None = None,
        **values: Given,
    ) -> Self:
        """Return the given runner itself where nothing changes."""
        own = given if isinstance(given, RunnerValues) else getattr(given, "runner", None)  # of a gait
        if isinstance(own, cls):
            return own.replace(values, model=model, tolerance=tolerance)
        of = model_of(given, model)
        by_name = {
            **start_values_of(None if given is of else given, of.aliases),
            **by_full_name(values, "start values", RUNNER, of.aliases),
        }
        checked = of.variables.start_values(by_name, "start values")
        runner = cls._made(
            tuple(checked.get(name, start) for name, start in zip(of.names, of.starts, strict=True)),
            of,
            TOLERANCE if tolerance is None else _checked_tolerance(tolerance),
        )
        paper_units.warn_of_mixture(runner)
        return runner

    def replace(
        self,
        values: Mapping[str, Given] | None = None,
        *,
        model: str | Model | None = None,
        tolerance: float | None = None,
        **more: Given,
    ) -> Self:
        """Make another runner: this one with other values.

        Parameters
        ----------
        values : mapping of str to float, bool or str, optional
            New values by name or short name.
        model : str, optional
            Another model, `full` or `reduced`.
        tolerance : float, optional
            Another tolerance of the native solver.
        **more : float, bool or str
            More new values, as in `friction=0.2`.

        Returns
        -------
        Runner
            This one itself where nothing changes.

        Raises
        ------
        InputError
            A name that is none of a runner's values, or a value that is not allowed.
        """
        own, of = list(self._values), self.model
        new = of if model is None else model_named(model)
        if new.names != of.names:
            raise InputError(f"model {new.name}: the runner is one of {of.name}; allowed: that model")
        given = by_full_name(more, "runner", RUNNER, of.aliases)
        if values is not None:
            given = {**by_full_name(values, "runner", RUNNER, of.aliases), **given}
        for name, value in given.items():
            if name not in of.positions:
                near = near_matches(name, (*of.names, *of.aliases))
                raise InputError(f"runner: {shown(name)} is not a name in the runner's values{near}")
            own[of.positions[name]] = of.variables[name].value_of(value, "runner")
        changed = (
            tuple(own),
            new,
            self.tolerance if tolerance is None else _checked_tolerance(tolerance),
        )
        return self if changed == (self._values, self.model, self.tolerance) else self._made(*changed)

    def __getitem__(self, name: str) -> Value:
        """A value by its name or short name, in the variable's unit."""
        position = self.model.positions.get(self.model.aliases.get(name, name))
        if position is None:
            near = near_matches(name, (*self.model.names, *self.model.aliases))
            raise KeyError(f"{shown(name)} is not a name in the runner's values{near}")
        return self._values[position]

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names of all values."""
        return iter(self.model.names)

    def __len__(self) -> int:
        """Number of values."""
        return len(self.model.names)

    def __contains__(self, name: object) -> bool:
        """Whether a value has this name or short name."""
        return isinstance(name, str) and self.model.aliases.get(name, name) in self.model.positions

    def __hash__(self) -> int:
        """Hash of values, model and tolerance."""
        return self._hash

    def __eq__(self, other: object) -> bool:
        """Whether another runner has the same values, model and tolerance."""
        if not isinstance(other, RunnerValues):
            return NotImplemented
        mine, its = ((r._hash, r._values, r.tolerance, r.model) for r in (self, other))
        return mine == its

    def _refuse_change(self, name: str, *value: object) -> NoReturn:
        """Refuse: a runner cannot change."""
        raise AttributeError(f"a Runner cannot change; runner.replace({name}=...) makes another")

    __setattr__ = __delattr__ = _refuse_change

    def __reduce__(self) -> tuple[Any, tuple[tuple[Value, ...], Model, float]]:
        """Pickle the values; C structs are made anew."""
        return self._made, (self._values, self.model, self.tolerance)

    def __repr__(self) -> str:
        """One line with the values that differ most often between runners."""
        known = [name for name in _SOME if name in self] or self.model.names[: len(_SOME)]
        some = ", ".join(f"{name} {self[name]:.6g}" for name in known)
        return f"<Runner, {self.model.name} model: {some}, ...>"

    @property
    def reduced(self) -> bool:
        """Whether its model is the reduced map, whose apices are height and speed alone."""
        return self.model is MODELS["reduced"]

    def label(self, unit: str) -> str:
        """The label of a unit in texts and pictures of this runner: `l0` for `m` in the paper's units."""
        return paper_units.label(unit, self)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of an apex's coordinates."""
        return self.model.coordinates

    @classmethod
    def _made(cls, values: tuple[Value, ...], model: Model, tolerance: float) -> Self:
        """A runner with values that are each within their range."""
        runner = object.__new__(model.runner_class or cls)
        runner._set(_values=values, model=model, tolerance=tolerance)
        runner._set(_hash=hash((values, model.name, tolerance)), **runner._prepared())
        return runner

    def _set(self, **parts: object) -> None:
        for name, part in parts.items():
            object.__setattr__(self, name, part)

    def _prepared(self) -> dict[str, object]:
        """Attributes made from the values; a subclass refuses values that do not go together."""
        return {}


def model_of(given: object, model: str | Model | None) -> Model:
    """The model of a runner that is given, or the one that is named, or the full one."""
    own = getattr(given, "runner", given)
    if model is None and isinstance(own, RunnerValues):
        return own.model
    if model is None and isinstance(given, Model):
        return given
    return MODELS["full"] if model is None else model_named(model)


def _checked_tolerance(given: float) -> float:
    """A tolerance above 0 and below 1."""
    tolerance = number_of(given)
    if tolerance is None or not 0.0 < tolerance < 1.0:
        raise refusal("tolerance", given, "above 0, below 1")
    return tolerance
