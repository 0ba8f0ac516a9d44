"""Inputs that change in time, as tables."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import number_in, refusal
from ..errors import InputError, reason
from ..files.whole import cells_of
from ..given import is_series, is_table, numbers_of, row_of
from ..variables.table import by_full_name
from ..variables.variable import Value, Variable
from .fmu import Fmu

PAIR = "a pair of times and values"
TIME = "time"
"""Name of the column of times in a table."""
InputTables = Mapping[str, tuple[ArrayLike, ArrayLike]]
"""Times in s, ascending, and values, by the name of an input or a tunable parameter. Values of a continuous
input are interpolated linearly, and a time given twice is a jump; a discrete input and a tunable parameter
keep a value until the next. Before and after the table its first and last value hold. A DataFrame with a
column or an index `time`, and a column for each input, will do, too, and a Series over such an index for an
input."""


def signals(
    fmu: Fmu, tables: InputTables | None, start_values: Mapping[str, Value]
) -> NDArray[np.void] | None:
    """Inputs and tunable parameters that have tables, on FMPy's one time grid; None without tables."""
    checked = {name: _checked(fmu, name, table, "inputs") for name, table in _tables(tables).items()}
    if not checked:
        return None
    grid = _grid([times for times, _ in checked.values()])
    inputs = list(dict.fromkeys([*fmu.variables.names("input"), *checked]))
    array = np.zeros(len(grid), dtype=[("time", float), *((name, float) for name in inputs)])
    array["time"] = grid
    for name in inputs:
        if name in checked:
            array[name] = _on_grid(grid, *checked[name])
        else:  # FMPy warns on stdout of an input without a column
            array[name] = start_values.get(name, fmu.variables.start_of(name))
    return array


def _tables(given: object) -> InputTables:
    """Pairs of times and values by name: as they are given, or of the columns of a table over the time."""
    if _is_over_time(given):
        given = given.to_frame()
    if not is_table(given):
        tables = by_full_name(given, "inputs", "pairs of times and values, by the names of inputs")
        return {
            name: (table.index, table) if _is_over_time(table) else table for name, table in tables.items()
        }
    columns = by_full_name(given, "inputs", "")
    index = getattr(given, "index", None)
    times = columns.pop(TIME) if TIME in columns else index if getattr(index, "name", "") == TIME else None
    if times is None:
        raise InputError(
            f"inputs with the columns {', '.join(map(str, columns))}: allowed: with one called {TIME}, or an "
            "index of that name"
        )
    return {name: (np.asarray(times), values) for name, values in columns.items()}


def _is_over_time(given: object) -> TypeGuard[Any]:
    """True for a Series whose labels are times."""
    return is_series(given) and getattr(getattr(given, "index", None), "name", "") == TIME


def read_tables(path: Path | str, fmu: Fmu) -> InputTables:
    """Input tables from a CSV file: a header `time,<input>,...`, then a row per time; no matter empty lines.

    Columns may be of tunable parameters, too. A value is a number in its column's unit, or has a unit after a
    space.
    """
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8-sig")  # Excel writes a mark at the beginning
    except (OSError, ValueError) as problem:
        raise InputError(f"{path}: not a table of inputs: {reason(problem)}") from problem
    numbered = ((number, line) for number, line in enumerate(text.splitlines(), start=1) if line.strip())
    lines = [(number, cells) for number, cells in cells_of(numbered, str(path)) if any(cells)]
    header = lines[0][1] if lines else []
    if header[:1] != [TIME] or len(set(header)) != len(header) or len(header) < 2 or len(lines) < 2:
        raise InputError(
            f"{path}: the header has to be time,<input>,..., each once, with rows below; "
            f"found {','.join(header) or 'nothing'}"
        )
    inputs = [fmu.variables.find(name, str(path)) for name in header[1:]]
    columns = np.array([_numbers(path, line, row, inputs) for line, row in lines[1:]]).T
    tables = {of.name: (columns[0], column) for of, column in zip(inputs, columns[1:], strict=True)}
    return {name: _checked(fmu, name, table, str(path)) for name, table in tables.items()}


def _numbers(path: Path, line: int, row: list[str], inputs: Sequence[Variable]) -> list[float]:
    where = f"{path}, line {line}"
    if len(row) != 1 + len(inputs):
        raise InputError(f"{where}: has {len(row)} of the {1 + len(inputs)} columns in the header")
    try:
        time = number_in(row[0])
    except ValueError as problem:
        raise InputError(f"{where}: {problem}; allowed: numbers") from None
    return [time, *(_number(cell, variable, where) for cell, variable in zip(row[1:], inputs, strict=True))]


def _number(cell: str, variable: Variable, where: str) -> float:
    try:
        return number_in(cell)
    except ValueError:
        return variable.value_of(cell, where)


def _checked(
    fmu: Fmu, name: str, table: tuple[ArrayLike, ArrayLike], where: str
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    variable = fmu.variables.find(name, where)
    if variable.causality != "input" and variable.variability != "tunable":
        inputs = ", ".join(fmu.variables.names("input"))
        raise InputError(f"{where}: {name} is neither an input nor tunable; inputs: {inputs}")
    pair = row_of(table, f"{where}: {name}", PAIR)
    if len(pair) != 2:
        raise refusal(f"{where}: {name}", table, PAIR)
    times = numbers_of(f"{where}: times of {name}", pair[0], "times in s, or durations", "s")
    values = numbers_of(f"{where}: {name}", pair[1], unit=variable.unit)
    if times.ndim != 1 or times.shape != values.shape or not len(times):
        raise InputError(
            f"{where}: {name}: times {times.shape} and values {values.shape} have to be equally long"
        )
    if not np.all(np.isfinite(times)) or np.any(np.diff(times) < 0):
        raise InputError(f"{where}: {name}: times have to be finite and ascending")
    for time, value in zip(times, values, strict=True):
        variable.value_of(float(value), f"{where}, time {time:g}")
    return (times, values) if variable.variability == "continuous" else _steps(times, values)


def _steps(
    times: NDArray[np.float64], values: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The table that keeps each value until the next; of several at one time the last counts."""
    last = np.append(np.diff(times) > 0, True)
    times, values = times[last], values[last]
    return np.repeat(times, 2)[1:], np.repeat(values, 2)[:-1]


def _grid(all_times: list[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Every time of any table; twice where any table jumps."""
    times = np.unique(np.concatenate(all_times))
    jumps = np.concatenate([table[1:][np.diff(table) == 0] for table in all_times])
    return np.repeat(times, np.where(np.isin(times, jumps), 2, 1))


def _on_grid(
    grid: NDArray[np.float64], times: NDArray[np.float64], values: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Values on the grid; at a time that it has twice, the limits from the left and from the right."""
    limits: dict[str, NDArray[np.float64]] = {}
    for side in ("left", "right"):
        after = np.searchsorted(times, grid, side=side)
        low, high = np.clip([after - 1, after], 0, len(times) - 1)
        span = times[high] - times[low]
        share = np.divide(grid - times[low], span, out=np.zeros(len(grid)), where=span > 0.0)
        limits[side] = values[low] + share * (values[high] - values[low])
    return np.where(np.append(np.diff(grid) == 0.0, False), limits["left"], limits["right"])
