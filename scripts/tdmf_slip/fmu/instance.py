"""One instance of the unit in FMPy: made, run, read, and always freed.

Inputs that change in time are followed exactly; FMPy's own way is good to one step of its solver. Its CVODE
sets inputs where it looks for events, not where it evaluates the right-hand side, and at the time of an event
those of before it once more. In Co-Simulation FMPy holds inputs over a communication step; it can set their
rates, but takes those of before where the slope changes.
"""

import contextlib
import ctypes
import functools
import importlib.util
import math
import os
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any, Protocol

import fmpy
import fmpy.simulation
import numpy as np
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from numpy.typing import NDArray

from ..errors import InputError, RunError, TdmfSlipError, counted, reason
from ..uninterrupted import stop_flag, uninterrupted
from ..variables.variable import Value
from .fmu import Fmu

TYPES = {"Real": float, "Boolean": bool}
"""Python types of variables by their FMI types; others are whole numbers, or text."""
CLOCK_ROUNDING = 1e-12
"""Relative error of FMPy's times, which are sums."""


class Input(fmpy.simulation.Input):  # type: ignore[misc] # FMPy has no types
    """FMPy's inputs, set together with the unit's clock. Once a jump is taken, the values after it hold."""

    taken = -math.inf
    next_jump = math.inf

    def __init__(self, *given: object, set_input_derivatives: bool = False, **named: object) -> None:
        """Take FMPy's arguments; with derivatives, communication steps end where an input's slope changes."""
        super().__init__(*given, **named)
        self.sets_rates = set_input_derivatives and self.t is not None
        if self.sets_rates:
            self.t_events: NDArray[np.float64] = np.unique([*self.t_events, *self.t])
        if hasattr(self.fmu, "setTime"):  # Model Exchange
            self.fmu.setTime = functools.partial(self._set_time, self.fmu.setTime)

    def _set_time(self, set_time: Callable[[float], object], time: float) -> object:
        """Set the unit's clock, and the inputs of that time, but not beyond their next jump."""
        self.apply(min(time, self.next_jump), discrete=False)
        return set_time(time)

    def nextEvent(self, time: float) -> float:  # noqa: N802 # FMPy's name
        """Return FMPy's next event, and keep it; FMPy asks before each step."""
        self.next_jump = super().nextEvent(time)
        return self.next_jump

    def apply(
        self, time: float, continuous: bool = True, discrete: bool = True, after_event: bool = False
    ) -> None:
        """Set inputs as FMPy does, but keep an event that was taken."""
        if after_event:
            self.taken = time
        super().apply(time, continuous, discrete, after_event or time == self.taken)
        if self.sets_rates and continuous:
            self._set_rates(time)

    @classmethod
    def interpolate(cls, *given: object, **named: object) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Interpolate as FMPy does; a table of one row gives one value for each input, too."""
        values, rates = super().interpolate(*given, **named)
        return values.ravel(), rates.ravel()

    def _set_rates(self, time: float) -> None:
        for vrs, _, orders, _, table, _ in self.continuous:
            rates = (ctypes.c_double * len(vrs))(*self._rates(time, table))
            self.fmu.fmi2SetRealInputDerivatives(self.fmu.component, vrs, len(vrs), orders, rates)

    def _rates(self, time: float, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """Slopes to the right of a time."""
        reached = time + CLOCK_ROUNDING * max(1.0, abs(time))
        after = int(np.searchsorted(self.t, reached, side="right"))
        if after in (0, len(self.t)):
            return np.zeros(len(table))
        slopes: NDArray[np.float64] = (table[:, after] - table[:, after - 1]) / (
            self.t[after] - self.t[after - 1]
        )
        return slopes


@functools.cache
def own_simulation() -> ModuleType:
    """A private copy of FMPy's module that uses these inputs; the module that others import is unchanged."""
    spec = importlib.util.find_spec("fmpy.simulation")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.Input = Input  # type: ignore[attr-defined]
    return module


LOADING = threading.Lock()
"""FMPy changes the working directory, which all threads share, while it loads a library."""
HEARD = threading.local()
"""`messages` of the instance that this thread calls: FMPy has one logger for all instances."""
MAX_NUMBERS = 50_000_000
"""Numbers that a run may record, rows times columns. FMPy keeps each as an object: about 2 GB."""
REFUSING_CALLS = ("fmi2Set", "fmi2ExitInitializationMode")
"""FMI calls by which the unit refuses start values: one alone, or several together."""


def _log(_environment: object, _name: bytes, _status: int, _category: bytes, message: bytes) -> None:
    HEARD.messages.append(message.decode("utf-8", errors="replace").strip())


LOGGER = fmi2CallbackLoggerTYPE(_log)
"""Logger that is never freed, unlike those that FMPy makes for each instance."""


def _set_logger() -> None:
    """Replace the logger of the newest instance, to which FMPy hands the messages of all instances."""
    with contextlib.suppress(Exception):  # no library for this platform: FMPy has no proxy either
        from fmpy.logging import addLoggerProxy

        addLoggerProxy(ctypes.byref(fmi2CallbackFunctions(logger=LOGGER)))


@dataclass(frozen=True, eq=False)
class Experiment:
    """Options of a run that FMPy makes with an instance; times in s."""

    stop_time: float
    """The run begins at 0."""
    tolerance: float
    """Relative tolerance of the importer."""
    output_interval: float
    """Time between recorded rows, s."""
    start_values: Mapping[str, Value]
    """Start values by name, checked."""
    inputs: NDArray[np.void] | None = None
    """Structured array: `time` and one column per input."""
    variables: tuple[str, ...] = ()
    """Names to record beside time."""

    @property
    def max_rows(self) -> int:
        """Rows that may be recorded."""
        return MAX_NUMBERS // (1 + len(self.variables))

    def too_many_rows(self, time: float) -> RunError:
        """The error where the most rows have been recorded by a time."""
        return RunError(
            f"{self.max_rows:,} rows of {counted(1 + len(self.variables), 'column')} by t = {time:g} s; "
            "allowed: no more; record fewer variables, or with a longer output interval"
        )


class Recorder(Protocol):
    """FMPy's recorder of a run."""

    rows: list[object]
    """Rows recorded so far."""

    def sample(self, time: float) -> None:
        """Record a row."""
        ...


class Instance:
    """An instance of the unit; use `opened`."""

    def __init__(self, fmu: Fmu, interface: str) -> None:
        """Instantiate; whatever the unit says from here on is kept in `messages`."""
        self.fmu = fmu
        self.interface = fmu.require_interface(interface)
        self.messages = HEARD.messages = list[str]()
        try:
            os.getcwd()
        except OSError as problem:
            raise RunError(
                f"the working directory cannot be used: {reason(problem)}; change to one that is there"
            ) from problem
        try:
            with LOADING:
                self._folder = fmu.folder
                try:
                    self._fmu = fmpy.simulation.instantiate_fmu(
                        self._folder, fmu.description, self.interface, logger=_log
                    )
                finally:
                    _set_logger()
        except RunError:
            raise
        except Exception as problem:  # FMPy raises bare Exceptions, and ctypes OSError, for a bad library
            raise RunError(
                f"{fmu.path}: its library for this platform ({fmpy.platform}) cannot be used: {problem}"
            ) from problem
        troubles = [c.name for c in fmu.description.logCategories or [] if c.name.startswith("logStatus")]
        self._fmu.setDebugLogging(True, troubles)

    def read(self, names: Iterable[str]) -> dict[str, float | int | bool | str]:
        """Present values by name: Real float, Integer and Enumeration int, Boolean bool, String str."""
        return {name: self.value(name) for name in names}

    def value(self, name: str) -> Any:
        """Present value of one variable."""
        variable = self.fmu.variables[name]
        get = getattr(self._fmu, f"get{variable.type.replace('Enumeration', 'Integer')}")
        (value,) = get([variable.reference])
        if variable.type == "String":
            return value.decode("utf-8")
        return TYPES.get(variable.type, int)(value)

    def simulate(
        self, experiment: Experiment, step_finished: Callable[[float, Recorder], bool]
    ) -> NDArray[np.void]:
        """Run through FMPy: Model Exchange with CVODE, recording before and after each event.

        An interrupt ends the run after a step: what is raised in CVODE's calls of Python is lost.
        """
        flag = stop_flag()

        def step(time: float, recorder: Recorder) -> bool:
            return not flag[0] and step_finished(time, recorder)

        return uninterrupted(lambda: self._simulate(experiment, step), flag)

    def _simulate(
        self, experiment: Experiment, step_finished: Callable[[float, Recorder], bool]
    ) -> NDArray[np.void]:
        simulation = fmpy.simulation if experiment.inputs is None else own_simulation()
        HEARD.messages = self.messages
        try:
            rows: NDArray[np.void] = simulation.simulate_fmu(
                self._folder,
                model_description=self.fmu.description,
                fmu_instance=self._fmu,
                fmi_type=self.interface,
                stop_time=experiment.stop_time,
                relative_tolerance=experiment.tolerance,
                output_interval=experiment.output_interval,
                start_values=dict(experiment.start_values),
                input=experiment.inputs,
                set_input_derivatives=experiment.inputs is not None,
                output=list(experiment.variables),
                step_finished=step_finished,
                terminate=False,
            )
        except Exception as problem:  # FMPy raises bare Exceptions
            raise self._account_of(problem) from problem
        return rows

    def set(self, values: Mapping[str, float | int | bool]) -> None:
        """Set inputs or tunable parameters between two steps."""
        setters = {"Real": self._fmu.setReal, "Boolean": self._fmu.setBoolean}
        for name, value in values.items():
            variable = self.fmu.variables[name]
            setters.get(variable.type, self._fmu.setInteger)([variable.reference], [value])

    def _account_of(self, problem: Exception) -> TdmfSlipError:
        said = "; ".join(dict.fromkeys(self.messages))
        if isinstance(problem, TypeError):  # FMPy formats CVODE's account of an error even if there is none
            problem = RuntimeError("CVODE failed")
        if isinstance(problem, FMICallException) and problem.function.startswith(REFUSING_CALLS):
            return InputError(f"start values: {said or problem}")
        return RunError(f"the run failed: {problem}" + (f"; the unit says: {said}" if said else ""))

    def close(self) -> None:
        """Terminate, where FMPy has not done so, and free the instance."""
        HEARD.messages = self.messages
        try:
            if self.interface == "CoSimulation":
                self._fmu.terminate()
        except FMICallException:
            pass  # after a failed call there is nothing to terminate
        finally:
            self._fmu.freeInstance()


@contextlib.contextmanager
def opened(fmu: Fmu, interface: str = "me") -> Iterator[Instance]:
    """An instance that is freed at the end, whatever happens."""
    instance = Instance(fmu, interface)
    try:
        yield instance
    finally:
        instance.close()
