"""Measured gaits: quantities of a stride with their standard errors, a row for each condition."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from ..analysis.targeted import MAXIMUM, MINIMUM
from ..checks import (
    check_kind,
    check_names,
    choice_of,
    near_matches,
    number_in,
    number_of,
    path_of,
    refusal,
    shown,
)
from ..errors import InputError, counted, reason
from ..files.whole import cells_of
from ..given import is_table, mapping_of, numbers_of, row_of
from ..library.quantities import MEASURES, SIGNED, allowed_quantities, unit_of
from ..variables.table import MODELS, Model
from ..variables.units import factor as factor_of
from ..variables.units import spelled, split

USUAL = ("speed", "frequency", "stance_time", "duty_factor", "slip_distance", "peak_force")
"""Quantities that are usually measured, by names of `library.quantities.QUANTITIES`. The frequency is 1
over the period."""
MEASURABLE = (*USUAL, *MEASURES)
"""Quantities of the package's own models that may be measured."""
SYNONYMS = {"velocity": "speed", "cadence": "frequency", "contact_time": "stance_time"}
"""Other words for quantities, for which a message about a wrong title suggests the right one."""
ERROR = "_error"
"""Suffix of a quantity's column of standard errors."""
DATA = Path(__file__).parent / "data"
"""Tables that come with the package, and the runners that their fits begin with."""
NOTHING = ("", "nan", "na", "<na>", "nat", "none", "null")
"""Texts of cells without a measurement, in lower case; upper case counts as well."""
SMALLEST_ERROR = 1e-12
"""Smallest error over the value, or over `MINIMUM` if that is larger; gaits are no more accurate."""
COMMENT = "#"
"""First character of lines that are skipped: they name the source of the data."""


@dataclass(frozen=True)
class Measured:
    """Measured quantity."""

    value: float
    """Measured value in the quantity's unit."""
    error: float
    """Standard error, in the same unit."""


Row = Mapping[str, Measured]
"""Measurements in one condition, by the quantities' names."""
Units: TypeAlias = Mapping[str, str]
"""Units of columns by the names of quantities."""
Errors: TypeAlias = Mapping[str, float | str | Sequence[float]]
"""Standard errors of columns by the names of quantities: in the column's unit, or shares as `2 %`."""


@dataclass(frozen=True, eq=False)
class Measurements:
    """Conditions in which a gait was measured."""

    rows: tuple[Row, ...]
    """Rows of the table, one for each condition."""
    where: str
    """Source of the measurements, for messages."""

    @property
    def count(self) -> int:
        """Number of measured numbers."""
        return sum(len(row) for row in self.rows)


Data: TypeAlias = "Measurements | Mapping[str, Sequence[float]] | str | Path | Any"
"""Data of a fit; a DataFrame is recognized by its methods."""


def shipped_names() -> list[str]:
    """Names of the files that come with the package."""
    return sorted(path.name for path in DATA.iterdir())


def shipped(name: str) -> Path:
    """Path of a file that comes with the package: a table, or the runner with which its fit begins."""
    if name not in shipped_names():
        raise InputError(f"data {name!r} do not come with the package; allowed: {', '.join(shipped_names())}")
    return DATA / name


def measurable(model: Model) -> tuple[str, ...]:
    """Quantities of a model's strides that may be measured."""
    return allowed_quantities(model) if model.is_page else MEASURABLE


def measurements_of(
    given: Data,
    units: Units | None = None,
    errors: Errors | None = None,
    model: Model = MODELS["full"],
) -> Measurements:
    """Measurements from a table, from columns by name, or from a CSV file; or those that are given.

    Titles of a file are `speed [m/s]`, `frequency [Hz]`, `stance_time [s]`, `duty_factor [1]`,
    `slip_distance [m]`, `peak_force [N]` or others, also with another unit of the quantity. The standard
    errors of a quantity are in a second column, as `speed_error [m/s]`. `units` and `errors` supply what the
    titles lack, see `fit`. Each row is a condition. If a quantity was not measured in it, both of its cells
    are empty or NaN. Cells are separated by commas or semicolons. With semicolons, the decimal sign may be a
    comma. Lines that begin with `#` are skipped.
    """
    if isinstance(given, Measurements):
        if units or errors:
            raise InputError("units, errors: Measurements have both; allowed: with a table or a file")
        return given
    units = mapping_of(units, "units", "a mapping of quantities")
    errors = mapping_of(errors, "errors", "a mapping of quantities")
    check_names(units, measurable(model), "units")
    check_names(errors, measurable(model), "errors")
    if is_table(given) or isinstance(given, Mapping):
        where, cells = "data", _table_cells(given, model)
        units = {name: unit_of(name, model) for name in measurable(model)} | units
    else:
        path = path_of(given, "data", "the path of a CSV file, a DataFrame, columns by name, or Measurements")
        where, comes = f"table {path}", [known.stem for known in DATA.glob("*.csv")]
        cells = _file_cells(shipped(f"{path}.csv") if str(path) in comes else path, where)
    titles, *rows = cells
    factors = dict(_factor(title, where, units, model) for title in titles)
    if len(factors) != len(titles):
        names = [title.partition("[")[0].strip() for title in titles]
        twice = next(name for name in names if names.count(name) > 1)
        raise InputError(f"{where}: column {twice} is there twice; allowed: once")
    for number, row in enumerate(rows, start=1):
        if len(row) != len(titles):
            raise InputError(
                f"{where}, row {number}: {counted(len(row), 'cell')} under "
                f"{counted(len(titles), 'column')}; allowed: as many"
            )
    for name, of in errors.items():
        if name not in factors or f"{name}{ERROR}" in factors:
            has = "a column of errors" if name in factors else "no column"
            raise InputError(f"errors: {name} has {has} in {where}; allowed: a quantity without errors there")
        column = [*factors].index(name)
        added = _errors_of(name, of, [row[column] for row in rows])
        rows = [[*row, error] for row, error in zip(rows, added, strict=True)]
        factors[f"{name}{ERROR}"] = factors[name]
    for name in factors:
        other = name.removesuffix(ERROR) if name.endswith(ERROR) else f"{name}{ERROR}"
        if other not in factors:
            unit = unit_of(other.removesuffix(ERROR), model)
            raise InputError(
                f"{where}: column {name} without {other}; allowed: with a column {other} [{unit}], or errors="
            )
    measured = [
        _row(factors, row, f"{where}, row {number}", model.is_page)
        for number, row in enumerate(rows, start=1)
    ]
    return Measurements(tuple(measured), where)


def _table_cells(given: object, model: Model) -> list[list[str]]:
    """Titles and rows of a table, as texts like those of a file; durations are in seconds."""
    columns = mapping_of(given, "data", "columns by the names of quantities")
    cells = []
    for title, of in columns.items():
        check_kind(title, str, "data: a column", "the name of a quantity")
        name = title.partition("[")[0].strip().removesuffix(ERROR)
        unit = unit_of(name, model) if name in measurable(model) else ""
        column = row_of(of, f"data {title}", "a column of numbers")
        cells.append([_cell(value, unit) for value in column])
    if len({len(column) for column in cells}) != 1:
        raise InputError("data: columns of different lengths, or none; allowed: one or more, of one length")
    return [list(columns), *map(list, zip(*cells, strict=True))]


def _cell(value: object, unit: str) -> str:
    number = number_of(value, unit)
    if number is not None:
        return repr(number)
    return value if isinstance(value, str) else shown(value)


def _file_cells(path: Path, where: str) -> list[list[str]]:
    """Titles and rows of a CSV file."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, ValueError) as problem:
        raise InputError(f"{where}: {reason(problem)}") from None
    numbered = enumerate(text.splitlines(), start=1)
    lines = [(n, line) for n, line in numbered if line.strip() and not line.lstrip().startswith(COMMENT)]
    if len(lines) < 2:
        missing = "the header and the rows" if not lines else "the rows"
        raise InputError(f"{where}: {missing} are missing; allowed: a header, and a row for each condition")
    return [row for _, row in cells_of(lines, where)]


def _factor(title: str, where: str, units: Units, model: Model) -> tuple[str, float]:
    """Name in a title, and the factor from the quantity's unit to the unit of the title."""
    name, bracket, rest = title.partition("[")
    name = name.strip()
    quantity = name.removesuffix(ERROR)
    if quantity not in measurable(model):
        known, usual = SYNONYMS.get(quantity), measurable(model) if model.is_page else USUAL
        hint = f"; near matches: {known}" if known in usual else near_matches(quantity, usual)
        others = "" if model.is_page else f", or another of {choice_of(MEASURES, 'tdmf-slip gait --help')}"
        raise InputError(
            f"{where}: column {shown(title)} is unknown; allowed: {', '.join(usual)}{others}, each with "
            f"{ERROR} as well{hint}"
        )
    own = unit_of(quantity, model)
    unit = rest.strip().removesuffix("]") if bracket else units.get(quantity)
    if unit is None:
        raise InputError(f"{where}: column {shown(title)} has no unit; allowed: {name} [{own}], or units=")
    factor = factor_of(spelled(unit), own, {}) if isinstance(unit, str) and unit else None
    if factor is None or (bracket and not rest.rstrip().endswith("]")):
        raise InputError(
            f"{where}: column {shown(title)}: {shown(unit)} is no unit of {quantity}; allowed: {name} "
            f"[{own}], or another unit of the same dimension"
        )
    return name, factor


def _errors_of(name: str, given: object, values: Sequence[str]) -> list[str]:
    """Column of errors from numbers in the unit of the values' column, or from a share of the values."""
    allowed = f"a number in the unit of the column, {len(values)} of them, or a text such as '2 %'"
    if isinstance(given, str):
        number, unit = split(given)
        if unit != "%" or not math.isfinite(_number(number)):
            raise refusal(f"errors: {name}", given, allowed)
        each = [abs(_number(value)) * 0.01 * _number(number) for value in values]
    else:
        numbers = numbers_of(f"errors: {name}", given, allowed)
        if numbers.shape not in ((), (len(values),)):
            raise refusal(f"errors: {name}", given, allowed)
        each = np.broadcast_to(numbers, len(values)).tolist()
    return [
        "" if value.lower() in NOTHING else repr(error) for value, error in zip(values, each, strict=True)
    ]


def _row(factors: Mapping[str, float], cells: Sequence[str], here: str, is_own: bool) -> Row:
    """Measurements in a row; `factors` are those of the columns, by name."""
    texts, measured = dict(zip(factors, cells, strict=True)), {}
    for name in (name for name in factors if not name.endswith(ERROR)):
        value, error = texts[name], texts[f"{name}{ERROR}"]
        if {value.lower(), error.lower()} <= {*NOTHING}:
            continue
        number = _number(value) / factors[name]
        spread = _number(error) / factors[f"{name}{ERROR}"]
        low = -MAXIMUM if is_own or name in SIGNED else 0.0
        high = 1.0 if name == "duty_factor" else MAXIMUM
        least = SMALLEST_ERROR * max(abs(number), MINIMUM)
        if not low <= number <= high:
            raise InputError(
                f"{here}: {name} = {value or 'nothing'} is not allowed; allowed: a number {low:g} to {high:g}"
            )
        if not least <= spread <= MAXIMUM:
            raise InputError(
                f"{here}: {name}{ERROR} = {error or 'nothing'} is not allowed; allowed: a standard error "
                f"above 0, {least:.3g} to {MAXIMUM:g}"
            )
        measured[name] = Measured(number, spread)
    if not measured:
        raise InputError(f"{here}: nothing is measured; allowed: one quantity or more")
    return measured


def _number(text: str) -> float:
    try:
        return number_in(text)
    except ValueError:
        return math.nan
