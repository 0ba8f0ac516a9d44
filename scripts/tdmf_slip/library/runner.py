"""Runners as the C library takes them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache, cached_property
from operator import itemgetter
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, Self, cast

import numpy as np
from numpy.typing import NDArray

from ..checks import near_matches, number_of, refusal, shown
from ..errors import InputError
from ..record import record_of
from ..variables import paper_units
from ..variables.parameters import RUNNER, RunnerLike, start_values_of
from ..variables.table import MODELS, STATES, Model, by_full_name, model_named, model_of
from ..variables.variable import Given, Value
from . import members
from .binding import c, check_accepted, ffi
from .c_structs import RETURN, viewed
from .events import MECHANICAL
from .members import Along, seed_of
from .returns import RunnerStrides
from .section import Apex, checked_apex
from .shared_steps import search_under_way

if TYPE_CHECKING:
    from .page_strides import Strides

TOLERANCE = 1e-13
"""Relative tolerance of the native solver: the next apex is then that of a gait to 1e-11 of the scales, and
so is the gait itself, unless it is very sensitive, as near a fold."""
_SOME = ("ground.friction", "body.mass", "leg.stiffness", "hip.stance_torque", "hip.touchdown_angle")
_PARAMETERS_OF, _INPUTS_OF, _STATES_OF = (
    itemgetter(*map(MODELS["full"].positions.__getitem__, names))
    for names in (members.names_of(members.PARAMETERS), members.names_of(members.INPUTS), STATES)
)


class Runner(Mapping[str, Value]):
    """A runner: every parameter, input and start value of the model by name, checked once.

    It cannot change, and compares, hashes and pickles by its values. `runner["leg.damping"]` is one of them,
    `runner.replace(damping=0.2)` another runner.

    Parameters
    ----------
    given : Runner, Gait, mapping of str to float, Series, str or Path, optional
        Values by the variables' names or short names, over the table's own; the name of a preset, or the path
        of a parameter file. Settings of the unit's solver are left out. By default the paper's runner.
    model : str, optional
        `full`, or `reduced` for the map of an apex's height and speed. By default that of the runner that is
        given, else `full`.
    tolerance : float, optional
        Relative tolerance of the native solver in each step, above 0 and below 1; by default 1e-13.
    **values : float, bool or str
        Values over those of `given`, as in `friction=0.43`; a text may have a unit, as in `"40 deg"`.

    Raises
    ------
    InputError
        An unknown name, or a value that is not allowed, by itself or beside the others.

    Examples
    --------
    >>> import tdmf_slip
    >>> runner = tdmf_slip.Runner(friction=0.43)
    >>> print(runner["ground.friction"], runner.replace(damping=0.25)["leg.damping"])
    0.43 0.25
    """

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
        own = given if isinstance(given, Runner) else getattr(given, "runner", None)  # of a gait
        if isinstance(own, cls):
            return own.replace(values, model=model, tolerance=tolerance)
        of = model_of(given, model)
        if (given is None or given is of) and not values and tolerance is None:
            return cast("Self", _of_start_values(of))
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
        """True if a value has this name or short name."""
        return isinstance(name, str) and self.model.aliases.get(name, name) in self.model.positions

    def __hash__(self) -> int:
        """Hash of values, model and tolerance."""
        return self._hash

    def __eq__(self, other: object) -> bool:
        """True if another runner has equal values, an equal tolerance and the same model."""
        if not isinstance(other, Runner):
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
        """True if the model is the reduced map, whose apices have a height and a speed only."""
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

    record = record_of

    parameters: NDArray[np.void]
    """The parameters as the library's struct, shape (1,), with a field for each."""
    inputs: NDArray[np.void]
    """The inputs as the library's struct, shape (1,), with a field for each."""
    c_model: Any
    """The parameters as the library's `tdmf_model *`."""
    c_inputs: Any
    """The inputs as the library's `tdmf_inputs *`."""

    def _prepared(self) -> dict[str, object]:
        """C structs of the values. Raises InputError where the library refuses them."""
        parameters = _fixed(np.array([_PARAMETERS_OF(self._values)], dtype=members.PARAMETERS))
        inputs = _fixed(np.array([_INPUTS_OF(self._values)], dtype=members.INPUTS))
        model, c_inputs = ffi.new("tdmf_model *"), ffi.from_buffer("tdmf_inputs *", inputs)
        check_accepted(c.tdmf_model_create(model, ffi.from_buffer("tdmf_parameters *", parameters)))
        check_accepted(c.tdmf_check_inputs(c_inputs))
        return {"parameters": parameters, "inputs": inputs, "c_model": model, "c_inputs": c_inputs}

    @cached_property
    def c_system(self) -> Any:
        """Parameters and inputs as the library's `tdmf_system`."""
        system: Any = ffi.new("tdmf_system *", {"model": self.c_model, "inputs": self.c_inputs})[0]
        return system

    @cached_property
    def scales(self) -> NDArray[np.float64]:
        """Scales of the coordinates: l0, l0 sqrt(k/m), l0, 1 rad, l0 sqrt(k/m), sqrt(k/m)."""
        scales = ffi.new("double[]", c.TDMF_SECTION_COUNT)
        c.tdmf_section_scales(self.c_model, scales)
        return _fixed(np.array(list(scales)[: len(self.coordinates)]))

    def scale_of(self, unit: str) -> float:
        """The scale of quantities in a unit."""
        return paper_units.scale(unit, self)

    def solver(self, log: Any | None = None) -> Any:
        """A native solver, the library's `tdmf_solver *`, which writes its events to a log."""
        solver: Any = ffi.new("tdmf_solver *", c.tdmf_solver_default())
        solver.relative_tolerance = self.tolerance
        solver.log = ffi.NULL if log is None else log
        search_under_way().hand_out(solver)
        return solver

    def stride_request(self, solver: Any, apex: Any) -> Any:
        """A `tdmf_stride_request *` from an apex; the caller keeps what it is given."""
        request = ffi.new("tdmf_stride_request *")
        request.solver, request.system, request.apex = solver, self.c_system, apex
        request.map = c.TDMF_REDUCED_MAP if self.reduced else c.TDMF_RETURN_MAP
        return request

    def stride(
        self,
        apex: NDArray[np.float64],
        until: float,
        *,
        varied: bool = False,
        along: Along | None = None,
        is_reported: bool = False,
    ) -> Strides:
        """One stride from an apex; with `is_reported` also its events and the measured quantities.

        With `varied` it is differentiated by the coordinates, and along a direction if one is given. Measured
        quantities then come from a second, plain stride, which takes less time than their derivatives.
        """
        log = ffi.new("tdmf_event_log *") if is_reported else None

        def made(varied: bool, measures: bool, log: Any | None = None) -> NDArray[Any]:
            solver, point, result = (
                self.solver(log),
                ffi.new("double[]", apex.tolist()),
                ffi.new("tdmf_return *"),
            )
            solver.without_peaks_and_positive_work = not is_reported
            request = self.stride_request(solver, point)
            request.until, request.derivatives, request.measures = until, varied, measures
            request.seeds = seed = seed_of(along if varied else None)
            request.seed_count = seed != ffi.NULL
            c.tdmf_run_stride(request, result)
            return viewed(result, RETURN)

        def measured() -> NDArray[Any]:
            plain = made(False, True)
            return plain if plain["outcome"][0] == c.TDMF_RETURN_CLOSED else made(True, True)

        return RunnerStrides(
            made(varied, is_reported and not varied, log),
            apex[None],
            self.__getitem__,
            self.reduced,
            along=([] if along is None else [along]) if varied else None,
            measured=measured if is_reported and varied else None,
            log=log,
        )

    def settle(self, apex: NDArray[np.float64], strides: int) -> tuple[NDArray[np.float64], int]:
        """The last apex of some strides from an apex, and how many of them closed."""
        section = ffi.new("double[]", apex.tolist())
        solver = self.solver()
        closed: int = c.tdmf_settle(self.stride_request(solver, section), strides, section)
        return np.array(list(section)), closed

    def apex(self) -> NDArray[np.float64]:
        """The apex section that has the height, the forward speed and the leg of the start values.

        Returns
        -------
        ndarray of float, shape (n,)
            In the order of `coordinates`; the vertical velocity is left out.
        """
        state, section = ffi.new("double[]", c.TDMF_STATE_COUNT), ffi.new("double[]", c.TDMF_SECTION_COUNT)
        state[MECHANICAL] = _STATES_OF(self._values)
        ground = c.tdmf_ground_line_of(self["ground.height"], self["ground.slope"])
        c.tdmf_section_of_state(self.c_model, ffi.new("tdmf_ground_line *", ground), state, section)
        return np.array(list(section)[: len(self.coordinates)])

    def start_apex(self) -> NDArray[np.float64]:
        """The section at the start values; a vertical velocity, which other masses make, is left out.

        Returns
        -------
        ndarray of float, shape (n,)
            In the order of `coordinates`.

        Raises
        ------
        InputError
            They are refused, or the foot is not above the ground.
        """
        apex = self.apex()
        motion = self.started(apex)
        if not motion.state[c.TDMF_STRIDE_IS_OPEN]:
            height = motion.state[c.TDMF_FOOT_Y]
            raise InputError(
                f"start values: foot.y = {height:g}: the search for a gait begins in flight; allowed: above 0"
            )
        return apex

    def started(self, apex: NDArray[np.float64]) -> Any:
        """The start of a run at an apex, as a `tdmf_motion *`. Raises InputError where it is refused."""
        motion = ffi.new("tdmf_motion *")
        self._write_state(apex, motion.state)
        check_accepted(c.tdmf_start(self.c_system, motion))
        return motion

    def state_at(self, apex: Apex) -> dict[str, float]:
        """The mechanical states at an apex; the foot, in the reduced map the centre of mass, is above x = 0.

        Parameters
        ----------
        apex : sequence of float, shape (n,)
            In the order of `coordinates`.

        Returns
        -------
        dict of str to float
            By the names in `STATES`.

        Raises
        ------
        InputError
            Other coordinates, or a parameter is refused.
        """
        state = ffi.new("double[]", c.TDMF_STATE_COUNT)
        self._write_state(checked_apex(apex, self.coordinates), state)
        return dict(zip(STATES, state[MECHANICAL], strict=True))

    def _write_state(self, apex: NDArray[np.float64], state: object) -> None:
        """The state at an apex; the reduced map has the leg where it is to be placed."""
        coordinates = ffi.new("double[]", list(apex))
        if self.reduced:
            c.tdmf_reduced_state(self.c_system, coordinates, state)
        else:
            c.tdmf_section_state(self.c_system, coordinates, state)

    def start_values(self, apex: Apex) -> dict[str, float]:
        """Everything that a run of the unit needs to begin at an apex: the runner's values, and `state_at`.

        Parameters
        ----------
        apex : sequence of float, shape (n,)
            In the order of `coordinates`.

        Returns
        -------
        dict of str to float
            By the unit's names.

        Raises
        ------
        InputError
            Other coordinates, or a parameter is refused.
        """
        return {**self, **self.state_at(apex)}


@cache
def _of_start_values(model: Model) -> Runner:
    """The runner that is meant where none is given."""
    return Runner._made(model.starts, model, TOLERANCE)


def _fixed(array: NDArray[Any]) -> NDArray[Any]:
    """Make an array read-only."""
    array.flags.writeable = False
    return array


def _checked_tolerance(given: float) -> float:
    """A tolerance above 0 and below 1."""
    tolerance = number_of(given)
    if tolerance is None or not 0.0 < tolerance < 1.0:
        raise refusal("tolerance", given, "above 0, below 1")
    return tolerance
