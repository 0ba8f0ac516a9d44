"""Runners as the C library takes them."""

from functools import cached_property
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..record import record_of
from ..variables.table import MODELS, STATES, scale
from ..variables.values import RunnerValues
from . import members
from .binding import c, check_accepted, ffi
from .section import Apex, checked_apex
from .shared_steps import search_under_way

_PARAMETERS_OF, _INPUTS_OF, _STATES_OF = (
    itemgetter(*map(MODELS["full"].positions.__getitem__, names))
    for names in (members.names_of(members.PARAMETERS), members.names_of(members.INPUTS), STATES)
)


class Runner(RunnerValues):
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
        scales = self.c_model.scales
        return scale(unit, scales.length, scales.time, scales.energy / scales.speed**2)

    def solver(self, log: Any | None = None) -> Any:
        """A native solver, the library's `tdmf_solver *`, which writes its events to a log."""
        solver: Any = ffi.new("tdmf_solver *", c.tdmf_solver_default())
        solver.relative_tolerance = self.tolerance
        solver.log = ffi.NULL if log is None else log
        search_under_way().hand_out(solver)
        return solver

    def apex(self) -> NDArray[np.float64]:
        """The apex section that has the height, the forward speed and the leg of the start values.

        Returns
        -------
        ndarray of float, shape (n,)
            In the order of `coordinates`; the vertical velocity is left out.
        """
        state, section = ffi.new("double[]", c.TDMF_STATE_COUNT), ffi.new("double[]", c.TDMF_SECTION_COUNT)
        state[0 : len(STATES)] = _STATES_OF(self._values)
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
        motion = ffi.new("tdmf_motion *")
        self._write_state(apex, motion.state)
        check_accepted(c.tdmf_start(self.c_system, motion))
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


def _fixed(array: NDArray[Any]) -> NDArray[Any]:
    """Make an array read-only."""
    array.flags.writeable = False
    return array
