"""Tables of numbers as text: with commas, or with semicolons or tabulators, as spreadsheets write them."""

import csv
import re
from collections.abc import Iterable

from ..errors import InputError

LONGEST_CELL = 100
"""Characters: no number needs as many."""
DECIMAL_COMMA = re.compile(r"([+-]?\d*),(\d+)([^.]*)$")
DECIMAL_POINT = re.compile(r"[+-]?\d*\.\d*(e[+-]?\d+)?( .*)?$", re.IGNORECASE)
SEPARATORS = {",": ",", ";": ";", "\t": "a tabulator"}
"""Between cells, and how messages name them; the first that the header has, for it has no decimal comma."""


def cells_of(lines: Iterable[tuple[int, str]], where: str) -> list[tuple[int, list[str]]]:
    """The cells of lines of which the first is the header; it says what is between cells."""
    found: list[tuple[int, list[str]]] = []
    separator = ","
    for number, line in lines:
        if not found:
            separator = next((mark for mark in SEPARATORS if mark in line), separator)
        _check_lengths(line, separator, f"{where}, line {number}")
        try:
            (row,) = csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True)
        except (csv.Error, ValueError) as problem:
            raise InputError(
                f"{where}, line {number}: {problem}; allowed: cells with {SEPARATORS[separator]} between"
            ) from None
        found.append((number, [cell.strip() for cell in row]))
    return found if separator == "," else _with_points(found, where)


def _check_lengths(line: str, separator: str, here: str) -> None:
    for column, cell in enumerate(line.split(separator), start=1):
        if len(cell) > LONGEST_CELL:
            raise InputError(
                f"{here}, column {column}: a cell of {len(cell):,} characters; allowed: {LONGEST_CELL}"
            )


def _with_points(lines: list[tuple[int, list[str]]], where: str) -> list[tuple[int, list[str]]]:
    """The cells with decimal commas turned into points; a table with both decimal signs is refused."""
    with_point = next((cell for _, row in lines for cell in row if DECIMAL_POINT.match(cell)), None)
    for number, row in lines:
        for column, cell in enumerate(row):
            match = DECIMAL_COMMA.match(cell)
            if match is None:
                continue
            if with_point is not None:
                raise InputError(
                    f"{where}, line {number}: {cell} in a table that has {with_point}, too; allowed: a comma "
                    "or a point for the decimal sign, and nothing between thousands"
                )
            row[column] = f"{match[1]}.{match[2]}{match[3]}"
    return lines
