"""Tables and quantities for a terminal."""

from collections.abc import Mapping, Sequence


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Rows under a header, in columns as wide as they need to be."""
    widths = [max(map(len, column)) for column in zip(header, *rows, strict=True)]
    lines = [header, ["-" * width for width in widths], *rows]
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines)


def columns(rows: Mapping[str, str]) -> str:
    """Names and values, a line for each."""
    width = max(map(len, rows)) + 2
    return "\n".join(f"{name:{width}}{value}" for name, value in rows.items())


def headed(name: str, unit: str) -> str:
    """The head of a column, with the unit of its numbers."""
    return f"{name} ({unit or '1'})"


def quantity(value: float, unit: str, digits: int) -> str:
    """A number with its unit, if it has one."""
    return f"{value:.{digits}g}{'' if unit in ('', '1') else f' {unit}'}"
