"""A runner: parameters, inputs and a start, as the C library takes them."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..checks import is_one_of, near_matches, number_of, refusal, shown
from ..contents import ByContents
from ..errors import InputError
from ..fmu import paper_units
from ..fmu.aliases import ALIASES
from ..fmu.fmu import Fmu, load_fmu
from ..fmu.names import by_full_name, full_name
from ..fmu.parameters import RUNNER, start_values_of
from ..fmu.variable import Given
from ..given import mapping_of
from ..record import completed, note_missing, record_of
from .binding import c, ffi
from .members import FLAGS, INPUTS, MOVING, PARAMETERS, STATES
from .refusals import check_accepted
from .section import COORDINATES, REDUCED, Apex, checked_apex, is_reduced
from .shared_steps import search_under_way
from .structs import Center, EventLog, Model, Solver, Struct

TOLERANCE = 1e-13
"""Relative tolerance of the native solver: the next apex is then that of a gait to 1e-11 of the scales, and
so is the gait itself, unless it is very sensitive, as near a fold."""


@dataclass(frozen=True, eq=False, repr=False)
class Runner(ByContents):
    """Parameters, inputs and a start, as the C library takes them.

    `Runner.of` makes one of the values that are given and the unit's own.
    """

    values: Mapping[str, float]
    """In the unit's units, by the unit's names: `leg.stiffness`, `ground.friction`, `foot.y`."""
    tolerance: float = TOLERANCE
    """Of the native solver, for each step; above 0 and below 1."""
    reduced: bool = False
    """Goes from apex to apex by the reduced map, whose apices are height and speed alone."""

    def __post_init__(self) -> None:
        """Check that no value is missing, and make Booleans of the flags."""
        values = mapping_of(self.values, "values", "numbers by the unit's names")
        own = completed(values)
        missing = next((name for name in (*MOVING, *STATES) if name not in own), None)
        if missing is not None:
            raise InputError(f"values: {missing} is missing; allowed: all of them, as Runner.of gives them")
        variables = load_fmu().variables
        own |= {name: variables[name].value_of(own[name], "runner") for name in FLAGS}
        object.__setattr__(self, "values", own)
        note_missing(values, "values of a runner")

    def __repr__(self) -> str:
        """In a line: what tells one from another at first sight."""
        some = ("ground.friction", "body.mass", "leg.stiffness", "hip.stance_torque", "hip.touchdown_angle")
        model = "reduced" if self.reduced else "full"
        return (
            f"<Runner, {model} model: {', '.join(f'{name} {self.values[name]:.6g}' for name in some)}, ...>"
        )

    @classmethod
    def of(
        cls, given: object = None, fmu: Fmu | None = None, *, model: str | None = None, **values: Given
    ) -> "Runner":
        """The unit's own start values, and over them those given, without those that concern runs only.

        Parameters
        ----------
        given : Runner, Gait, mapping of str to float, str or Path, optional
            Start values by the unit's names, a preset's name, a parameter file; of a gait its runner.
        fmu : Fmu, optional
            Whose start values and ranges hold; by default that of `fmu_path`.
        model : str, optional
            `full` or `reduced`, see `reduced`; by default that of the runner that is given.
        **values : float, bool or str
            Start values over those of `given`, as in `friction=0.43`.

        Returns
        -------
        Runner
            With every value that the library asks for.

        Raises
        ------
        InputError
            None of these, or a name or value that the unit refuses.
        """
        runner = given if isinstance(given, cls) else getattr(given, "runner", None)  # of a gait
        if isinstance(runner, cls):
            if values:
                changed = load_fmu(fmu).start_values(values, "start values")
                known = {name: float(value) for name, value in changed.items() if name in runner.values}
                runner = replace(runner, values={**runner.values, **known})
        else:
            by_name = {**start_values_of(given), **by_full_name(values, "start values", RUNNER)}
            fmu = load_fmu(fmu)
            checked = fmu.start_values(by_name, "start values")
            names = [n for n, v in fmu.variables.items() if v.settable and (v.type == "Real" or n in FLAGS)]
            runner = cls({name: checked.get(name, fmu.start_of(name)) for name in names})
            paper_units.warn_of_mixture(runner.values, fmu)
        return runner if model is None else replace(runner, reduced=is_reduced(model))

    def but(self, name: str, value: float | str) -> "Runner":
        """The same runner with another value.

        Parameters
        ----------
        name : str
            Of a parameter, an input or a state.
        value : float or str
            In the variable's unit, or a text with a unit.

        Returns
        -------
        Runner
            This one stays as it is.

        Raises
        ------
        InputError
            The runner has no such value, or it is no number.
        """
        name = full_name(name)
        if not is_one_of(name, self.values):
            near = near_matches(name, (*self.values, *ALIASES))
            raise InputError(f"{shown(name)} is not a name in the runner's values{near}")
        if name in FLAGS or isinstance(value, str):
            value = load_fmu().variables[name].value_of(value, "runner")
        number = value if name in FLAGS else number_of(value)
        if number is None:
            raise refusal(name, value, "a number")
        return replace(self, values={**self.values, name: number})

    record = record_of

    def __reduce__(self) -> tuple[Callable[..., "Runner"], tuple[dict[str, Any], float]]:
        """Without what the C library has made of it, which is of use in this process only."""
        return _recorded, (self.record(), self.tolerance)

    @cached_property
    def model(self) -> Model:
        """The parameters as the library's `tdmf_model *`, unless one is refused."""
        parameters = ffi.new("tdmf_parameters *")
        for member in PARAMETERS:
            member.write(parameters, self.values[member.name])
        model: Model = ffi.new("tdmf_model *")
        check_accepted(c.tdmf_model_create(model, parameters))
        return model

    @cached_property
    def inputs(self) -> Struct:
        """The inputs as the library's `tdmf_inputs *`, unless one is refused."""
        inputs: Struct = ffi.new("tdmf_inputs *")
        for member in INPUTS:
            member.write(inputs, self.values[member.name])
        check_accepted(c.tdmf_check_inputs(inputs))
        return inputs

    @cached_property
    def system(self) -> Struct:
        """Parameters and inputs as the library's `tdmf_system`, unless one is refused."""
        system: Struct = ffi.new("tdmf_system *", {"model": self.model, "inputs": self.inputs})[0]
        return system

    def label(self, unit: str) -> str:
        """The label of a unit in texts and pictures of this runner: `l0` for `m` in the paper's units."""
        return paper_units.label(unit, self.values)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Of an apex: `COORDINATES`, or `REDUCED`."""
        return REDUCED if self.reduced else COORDINATES

    @cached_property
    def scales(self) -> NDArray[np.float64]:
        """Scales of the coordinates: l0, l0 sqrt(k/m), l0, 1 rad, l0 sqrt(k/m), sqrt(k/m)."""
        scales = ffi.new("double[6]")
        c.tdmf_section_scales(self.model, scales)
        return np.array(list(scales)[: len(self.coordinates)])

    def solver(self, log: EventLog | None = None) -> Solver:
        """A native solver, the library's `tdmf_solver *`, which writes its events to a log."""
        solver: Solver = ffi.new("tdmf_solver *", c.tdmf_solver_default())
        tolerance = number_of(self.tolerance)
        if tolerance is None or not 0.0 < tolerance < 1.0:
            raise refusal("tolerance", self.tolerance, "above 0, below 1")
        solver.relative_tolerance = tolerance
        solver.log = ffi.NULL if log is None else log
        search_under_way().hand_out(solver)
        return solver

    def apex(self) -> NDArray[np.float64]:
        """The apex section that has the height, the forward speed and the leg of the start values.

        Returns
        -------
        ndarray of float, shape (n,)
            In the order of `coordinates`; the vertical velocity is left out.

        Raises
        ------
        InputError
            A parameter is refused.
        """
        motion = ffi.new("tdmf_motion *")
        motion.state[0 : len(STATES)] = [self.values[name] for name in STATES]
        center: Center = c.tdmf_center_of_mass(self.model, motion.state)
        leg = (self.values[name] for name in ("leg.length", "leg.angle", "leg.length_rate", "leg.angle_rate"))
        ground = self.values["ground.height"] + center.x * math.tan(self.values["ground.slope"])
        return np.array([center.y - ground, center.vx, *leg])[: len(self.coordinates)]

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
        motion = ffi.new("tdmf_motion *")
        self._write_state(apex, motion.state)
        check_accepted(c.tdmf_start(self.system, motion))
        if not motion.record.progress.open.began_at_apex:
            height = motion.state[STATES.index("foot.y")]
            raise InputError(
                f"start values: foot.y = {height:g}: the search for a gait begins in flight; allowed: above 0"
            )
        return apex

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
        return dict(zip(STATES, state, strict=False))

    def _write_state(self, apex: NDArray[np.float64], state: object) -> None:
        """The state at an apex; the reduced map has the leg where it is to be placed."""
        coordinates = ffi.new("double[]", list(apex))
        if self.reduced:
            c.tdmf_reduced_state(self.system, coordinates, state)
        else:
            c.tdmf_section_state(self.system, coordinates, state)

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
        return {**self.values, **self.state_at(apex)}


def _recorded(record: Mapping[str, Any], tolerance: float) -> Runner:
    """Rebuild a runner from its pickled record."""
    return Runner(record["runner"], tolerance, record["model"] == "reduced")
