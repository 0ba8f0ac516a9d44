"""Measured gaits: quantities of a stride with their standard errors, a row for each condition."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..analysis.targeted import MAXIMUM, MINIMUM
from ..checks import near_matches, number_in, number_of, path_of, shown
from ..errors import InputError, reason
from ..files.whole import cells_of
from ..given import is_table, mapping_of
from ..library.quantities import MEASURES, SIGNED, unit_of

USUAL = ("speed", "frequency", "stance_time", "duty_factor", "slip_distance", "peak_force")
"""Quantities that are usually measured, by names of `library.quantities.QUANTITIES`. The frequency is 1
over the period."""
MEASURABLE = (*USUAL, *MEASURES)
"""All quantities that may be measured."""
SYNONYMS = {"velocity": "speed", "cadence": "frequency", "contact_time": "stance_time"}
"""Other words for quantities, from which a message about a wrong title suggests the right one."""
ERROR = "_error"
"""Suffix of a quantity's column of standard errors."""
DATA = Path(__file__).parent / "data"
"""Tables that come with the package, and the runners that their fits begin with."""
NOTHING = ("", "nan", "na", "<na>", "nat", "none", "null")
"""Cells that say that nothing was measured, in lower case; upper case counts as well."""
SMALLEST_ERROR = 1e-12
"""Over the value, or over `MINIMUM` where that is less: it is beyond what a gait is computed to."""
COMMENT = "#"
"""Lines that begin with it are skipped: they say where the data come from."""


@dataclass(frozen=True)
class Measured:
    """A quantity as it was measured."""

    value: float
    """In its unit."""
    error: float
    """Its standard error, in the same unit."""


Row = Mapping[str, Measured]
"""Measurements in one condition, by the quantities' names."""


@dataclass(frozen=True, eq=False)
class Measurements:
    """Conditions in which a gait was measured."""

    rows: tuple[Row, ...]
    """One for each condition."""
    where: str
    """Where they come from, for messages."""

    @property
    def count(self) -> int:
        """How many numbers were measured."""
        return sum(len(row) for row in self.rows)


def shipped_names() -> list[str]:
    """Names of the files that come with the package."""
    return sorted(path.name for path in DATA.iterdir())


def shipped(name: str) -> Path:
    """The path of a file that comes with the package: a table, or the runner that its fit begins with."""
    if name not in shipped_names():
        raise InputError(f"data {name!r} do not come with the package; allowed: {', '.join(shipped_names())}")
    return DATA / name


def measurements_of(given: "Measurements | str | Path") -> Measurements:
    """Measurements as they are given, or those of a file."""
    if isinstance(given, Measurements):
        return given
    if is_table(given):
        return _of_table(given)
    path = path_of(given, "data", "the path of a CSV file, a DataFrame, or Measurements")
    if str(path) in [known.stem for known in DATA.glob("*.csv")]:
        return read_measurements(shipped(f"{path}.csv"), str(path))
    return read_measurements(path)


def _of_table(given: object) -> Measurements:
    """Measurements from a DataFrame with the titles that a file has; durations are converted to seconds."""
    titles = mapping_of(given, "data", "a table with the titles that a file has")
    columns = [_column(str(title).strip(), "data") for title in titles]
    _check_columns(columns, "data")
    units = [unit_of(name.removesuffix(ERROR)) for name in columns]
    cells = [
        [_cell_of(value, unit) for value, unit in zip(row, units, strict=True)]
        for row in zip(*titles.values(), strict=True)
    ]
    return Measurements(tuple(_rows(columns, cells, "data")), "data")


def _cell_of(value: object, unit: str) -> str:
    """A value of a DataFrame as the text that a file would have."""
    number = number_of(value, unit)
    if number is not None:
        return repr(number)
    return value if isinstance(value, str) else shown(value)


def read_measurements(path: Path, name: str | None = None) -> Measurements:
    """Measurements from a CSV file.

    The header has any of `speed [m/s]`, `frequency [Hz]`, `stance_time [s]`, `duty_factor [1]`,
    `slip_distance [m]`, `peak_force [N]`, and for each its standard error, as in `speed_error [m/s]`. Each
    row is a condition; a quantity that was not measured in it has both of its cells empty, or NaN. Between
    cells is a comma, or a semicolon, and then the decimal sign may be a comma. Lines that begin with `#` are
    skipped.
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
    columns = [_column(name, where) for name in header]
    _check_columns(columns, where)
    return Measurements(tuple(_rows(columns, cells, where)), where)


def _column(title: str, where: str) -> str:
    """The name of a column, whose unit is as it has to be."""
    name, bracket, rest = title.partition("[")
    name = name.strip()
    quantity = name.removesuffix(ERROR)
    if quantity not in MEASURABLE:
        known = SYNONYMS.get(quantity)
        hint = f"; near matches: {known}" if known else near_matches(quantity, USUAL)
        raise InputError(
            f"{where}: column {shown(title)} is unknown; allowed: {', '.join(USUAL)}, or another of "
            f"{', '.join(MEASURES)}, each with {ERROR} as well{hint}"
        )
    allowed = f"{name} [{unit_of(quantity)}]"
    if not bracket:
        raise InputError(f"{where}: column {shown(title)} has no unit; allowed: {allowed}")
    if rest.strip() != f"{unit_of(quantity)}]":
        raise InputError(
            f"{where}: column {shown(title)} is not in the unit that it has to be in; allowed: {allowed}"
        )
    return name


def _check_columns(columns: Sequence[str], where: str) -> None:
    """Each once, and each quantity with its error."""
    for name in columns:
        if columns.count(name) > 1:
            raise InputError(f"{where}: column {name} is there twice; allowed: once")
        other = name.removesuffix(ERROR) if name.endswith(ERROR) else f"{name}{ERROR}"
        if other not in columns:
            unit = unit_of(other.removesuffix(ERROR))
            raise InputError(
                f"{where}: column {name} without {other}; allowed: with a column {other} [{unit}]"
            )


def _rows(columns: Sequence[str], cells: Sequence[Sequence[str]], where: str) -> Iterator[Row]:
    for number, row in enumerate(cells, start=1):
        here = f"{where}, row {number}"
        if len(row) != len(columns):
            raise InputError(f"{here}: {len(row)} cells under {len(columns)} columns; allowed: as many")
        by_name = dict(zip(columns, row, strict=True))
        measured = {
            name: Measured(*_pair(name, by_name[name], by_name[f"{name}{ERROR}"], here))
            for name in columns
            if not name.endswith(ERROR)
            and not {by_name[name].lower(), by_name[f"{name}{ERROR}"].lower()} <= {*NOTHING}
        }
        if not measured:
            raise InputError(f"{here}: nothing is measured; allowed: one quantity or more")
        yield measured


def _pair(name: str, value: str, error: str, here: str) -> tuple[float, float]:
    """A quantity and its error."""
    high = 1.0 if name == "duty_factor" else MAXIMUM
    measured = _number(value)
    low = -MAXIMUM if name in SIGNED else 0.0
    if not low <= measured <= high:
        raise InputError(
            f"{here}: {name} = {value or 'nothing'} is not allowed; allowed: a number {low:g} to {high:g}"
        )
    spread = _number(error)
    minimum = SMALLEST_ERROR * max(abs(measured), MINIMUM)
    if not minimum <= spread <= MAXIMUM:
        raise InputError(
            f"{here}: {name}{ERROR} = {error or 'nothing'} is not allowed; allowed: a standard error "
            f"above 0, {minimum:.3g} to {MAXIMUM:g}"
        )
    return measured, spread


def _number(text: str) -> float:
    try:
        return number_in(text)
    except ValueError:
        return math.nan
