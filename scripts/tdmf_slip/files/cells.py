"""Tables of numbers as text: with commas, or with semicolons or tabulators, as spreadsheets write them."""

import csv
import re
from collections.abc import Iterable

from ..errors import InputError

LONGEST_CELL = 100
"""Characters: no number needs as many."""
DECIMAL_COMMA = re.compile(r"([+-]?\d*),(\d+)")
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
        cells = [cell.strip() for cell in row]
        found.append((number, cells if separator == "," else [_with_point(cell) for cell in cells]))
    return found


def _check_lengths(line: str, separator: str, here: str) -> None:
    for column, cell in enumerate(line.split(separator), start=1):
        if len(cell) > LONGEST_CELL:
            raise InputError(
                f"{here}, column {column}: a cell of {len(cell):,} characters; allowed: {LONGEST_CELL}"
            )


def _with_point(cell: str) -> str:
    """A number whose decimal sign is a comma; anything else as it is."""
    match = DECIMAL_COMMA.match(cell)
    return f"{match[1]}.{match[2]}{cell[match.end() :]}" if match and "." not in cell else cell
