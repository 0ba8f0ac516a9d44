"""Measured gaits: quantities of a stride with their standard errors, a row for each condition."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from ..analysis.targeted import MAXIMUM, MINIMUM
from ..checks import is_one_of, near_matches, number_in, number_of, path_of, refusal, shown
from ..errors import InputError, reason
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
"""Other words for quantities, from which a message about a wrong title suggests the right one."""
ERROR = "_error"
"""Suffix of a quantity's column of standard errors."""
DATA = Path(__file__).parent / "data"
"""Tables that come with the package, and the runners that their fits begin with."""
NOTHING = ("", "nan", "na", "<na>", "nat", "none", "null")
"""Cells that say that nothing was measured, in lower case; upper case counts as well."""
SMALLEST_ERROR = 1e-12
"""Smallest error over the value, or over `MINIMUM` if that is larger; gaits are no more accurate."""
COMMENT = "#"
"""Lines that begin with it are skipped: they say where the data come from."""


@dataclass(frozen=True)
class Measured:
    """A quantity as it was measured."""

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
        """How many numbers were measured."""
        return sum(len(row) for row in self.rows)


Data: TypeAlias = "Measurements | Mapping[str, Sequence[float]] | str | Path | Any"
"""Data of a fit; a DataFrame is known by what it can do."""


def shipped_names() -> list[str]:
    """Names of the files that come with the package."""
    return sorted(path.name for path in DATA.iterdir())


def shipped(name: str) -> Path:
    """The path of a file that comes with the package: a table, or the runner that its fit begins with."""
    if name not in shipped_names():
        raise InputError(f"data {name!r} do not come with the package; allowed: {', '.join(shipped_names())}")
    return DATA / name


def measurable(model: Model) -> tuple[str, ...]:
    """Quantities of a model's strides that may be measured."""
    return allowed_quantities(model) if model.is_own else MEASURABLE


def measurements_of(
    given: Data,
    units: Units | None = None,
    errors: Errors | None = None,
    model: Model = MODELS["full"],
) -> Measurements:
    """Measurements as they are given, or those of a table, of columns by name, or of a file."""
    if isinstance(given, Measurements):
        if units or errors:
            raise InputError("units, errors: Measurements have both; allowed: with a table or a file")
        return given
    units, errors = (_by_quantity(of, name, model) for of, name in ((units, "units"), (errors, "errors")))
    if is_table(given) or isinstance(given, Mapping):
        return _of_table(given, units, errors, model)
    path = path_of(given, "data", "the path of a CSV file, a DataFrame, columns by name, or Measurements")
    if str(path) in [known.stem for known in DATA.glob("*.csv")]:
        return read_measurements(shipped(f"{path}.csv"), units, errors, model, name=str(path))
    return read_measurements(path, units, errors, model)


def _by_quantity(given: object, what: str, model: Model) -> dict[str, Any]:
    """Units or errors by the names of quantities."""
    found, known = mapping_of(given, what, "a mapping of quantities"), measurable(model)
    for name in found:
        if not is_one_of(name, known):
            near = near_matches(name, known)
            raise InputError(f"{what}: {shown(name)} is no quantity{near}; allowed: {', '.join(known)}")
    return found


def _of_table(given: object, units: Units, errors: Errors, model: Model) -> Measurements:
    """Measurements from columns by name; durations are converted to seconds."""
    columns = mapping_of(given, "data", "columns by the names of quantities")
    own = {name: unit_of(name, model) for name in measurable(model)} | dict(units)
    kept = [_column(str(title).strip(), "data", own, model) for title in columns]
    rows = [row_of(of, f"data {title}", "a column of numbers") for title, of in columns.items()]
    if len({len(row) for row in rows}) != 1:
        raise InputError("data: columns of different lengths, or none; allowed: one or more, of one length")
    cells = [
        [
            _cell_of(value, unit_of(name.removesuffix(ERROR), model))
            for value, (name, _) in zip(row, kept, strict=True)
        ]
        for row in zip(*rows, strict=True)
    ]
    return Measurements(tuple(_rows(kept, cells, "data", errors, model)), "data")


def _cell_of(value: object, unit: str) -> str:
    """A value of a DataFrame as the text that a file would have."""
    number = number_of(value, unit)
    if number is not None:
        return repr(number)
    return value if isinstance(value, str) else shown(value)


def read_measurements(
    path: Path,
    units: Units | None = None,
    errors: Errors | None = None,
    model: Model = MODELS["full"],
    *,
    name: str | None = None,
) -> Measurements:
    """Measurements from a CSV file.

    The header has any of `speed [m/s]`, `frequency [Hz]`, `stance_time [s]`, `duty_factor [1]`,
    `slip_distance [m]`, `peak_force [N]`, or another unit of the quantity, and for each its standard error,
    as in `speed_error [m/s]`. `units` and `errors` give what the header does not, see `fit`. Each row is a
    condition; a quantity that was not measured in it has both of its cells empty, or NaN. Between cells is a
    comma, or a semicolon, and then the decimal sign may be a comma. Lines that begin with `#` are skipped.
    """
    where = f"table {name or path}"
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, ValueError) as problem:
        raise InputError(f"{where}: {reason(problem)}") from None
    numbered = enumerate(text.splitlines(), start=1)
    lines = [(n, line) for n, line in numbered if line.strip() and not line.lstrip().startswith(COMMENT)]
    if len(lines) < 2:
        missing = "the header and the rows" if not lines else "the rows"
        raise InputError(f"{where}: {missing} are missing; allowed: a header, and a row for each condition")
    header, *cells = [row for _, row in cells_of(lines, where)]
    columns = [_column(title, where, units or {}, model) for title in header]
    return Measurements(tuple(_rows(columns, cells, where, errors or {}, model)), where)


def _column(title: str, where: str, units: Units, model: Model) -> tuple[str, float]:
    """The name of a column, and how many of its unit make one of the quantity's."""
    name, bracket, rest = title.partition("[")
    name = name.strip()
    quantity = name.removesuffix(ERROR)
    if quantity not in measurable(model):
        known, usual = SYNONYMS.get(quantity), measurable(model) if model.is_own else USUAL
        hint = f"; near matches: {known}" if known in usual else near_matches(quantity, usual)
        others = "" if model.is_own else f", or another of {', '.join(MEASURES)}"
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


def _check_columns(columns: Sequence[str], where: str, errors: Errors, model: Model) -> None:
    """Each once, and each quantity with its error, in one place."""
    for name in errors:
        if name not in columns or f"{name}{ERROR}" in columns:
            has = "a column of errors" if name in columns else "no column"
            raise InputError(f"errors: {name} has {has} in {where}; allowed: a quantity without errors there")
    for name in columns:
        if columns.count(name) > 1:
            raise InputError(f"{where}: column {name} is there twice; allowed: once")
        other = name.removesuffix(ERROR) if name.endswith(ERROR) else f"{name}{ERROR}"
        if other not in columns and name not in errors:
            unit = unit_of(other.removesuffix(ERROR), model)
            raise InputError(
                f"{where}: column {name} without {other}; allowed: with a column {other} [{unit}], or errors="
            )


def _rows(
    columns: Sequence[tuple[str, float]],
    cells: Sequence[Sequence[str]],
    where: str,
    errors: Errors,
    model: Model,
) -> Iterator[Row]:
    factors = dict(columns)
    names = list(factors)
    _check_columns([name for name, _ in columns], where, errors, model)
    given = {name: _errors_of(name, of, len(cells)) for name, of in errors.items()}
    for number, row in enumerate(cells, start=1):
        here = f"{where}, row {number}"
        if len(row) != len(columns):
            raise InputError(f"{here}: {len(row)} cells under {len(columns)} columns; allowed: as many")
        by_name = dict(zip(names, row, strict=True))
        measured = {}
        for name in names:
            value, error = by_name[name], by_name.get(f"{name}{ERROR}", "")
            if name.endswith(ERROR) or {value.lower(), error.lower()} <= {*NOTHING}:
                continue
            factor, error_factor = factors[name], factors.get(f"{name}{ERROR}", factors[name])
            if name in given:
                share, each = given[name]
                error = repr(abs(_number(value)) * each[number - 1] if share else each[number - 1])
            low = -MAXIMUM if model.is_own or name in SIGNED else 0.0
            measured[name] = _measured(name, (value, factor), (error, error_factor), here, low)
        if not measured:
            raise InputError(f"{here}: nothing is measured; allowed: one quantity or more")
        yield measured


def _errors_of(name: str, given: object, rows: int) -> tuple[bool, list[float]]:
    """Whether errors are shares of the values, and the error of each row."""
    allowed = f"a number in the unit of the column, {rows} of them, or a text such as '2 %'"
    if isinstance(given, str):
        number, unit = split(given)
        if unit != "%" or not math.isfinite(_number(number)):
            raise refusal(f"errors: {name}", given, allowed)
        return True, [0.01 * _number(number)] * rows
    each = numbers_of(f"errors: {name}", given, allowed)
    if each.shape not in ((), (rows,)):
        raise refusal(f"errors: {name}", given, allowed)
    return False, np.broadcast_to(each, rows).tolist()


def _measured(
    name: str, value: tuple[str, float], error: tuple[str, float], here: str, low: float
) -> Measured:
    """A quantity and its error from texts, each with how many of its unit make one of the quantity's."""
    high = 1.0 if name == "duty_factor" else MAXIMUM
    measured, spread = (_number(text) / factor for text, factor in (value, error))
    if not low <= measured <= high:
        raise InputError(
            f"{here}: {name} = {value[0] or 'nothing'} is not allowed; allowed: a number {low:g} to {high:g}"
        )
    minimum = SMALLEST_ERROR * max(abs(measured), MINIMUM)
    if not minimum <= spread <= MAXIMUM:
        raise InputError(
            f"{here}: {name}{ERROR} = {error[0] or 'nothing'} is not allowed; allowed: a standard error "
            f"above 0, {minimum:.3g} to {MAXIMUM:g}"
        )
    return Measured(measured, spread)


def _number(text: str) -> float:
    try:
        return number_in(text)
    except ValueError:
        return math.nan
