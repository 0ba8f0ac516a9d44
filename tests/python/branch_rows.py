"""Points of a branch's dataset, one by one, with their gaits."""

from typing import NamedTuple

from tdmf_slip.analysis.sweeps import gaits_in
from tdmf_slip.library.gait import Gait


class Row(NamedTuple):
    value: float
    kind: str
    gait: Gait
    words: tuple
    between: tuple
    why: str
    branch: int


def rows_of(data):
    names = data.over, "special", "before", "after", "between", "why", "branch_number"
    columns = (data[name].values.tolist() for name in names)
    return [
        Row(value, kind, gait, (before, after), tuple(between), why, branch)
        for gait, value, kind, before, after, between, why, branch in zip(
            gaits_in(data), *columns, strict=True
        )
    ]


def met(rows):
    return [row for row in rows if not row.kind]


def specials(rows, *kinds):
    return [row for row in rows if row.kind and (row.kind in kinds or not kinds)]
