"""Data of figures that take minutes to compute, kept beside these modules as they were last measured.

`tdmf-slip figures --measure` computes them anew, and writes them beside the figures.
"""

import csv
import importlib.resources

import numpy as np
from numpy.typing import NDArray


def columns(name: str) -> dict[str, NDArray[np.float64]]:
    """The numbers of a figure, by column; texts are left out.

    Parameters
    ----------
    name : str
        Of the figure.

    Returns
    -------
    dict of str to ndarray of float
        Columns, all as long.
    """
    text = importlib.resources.files(__package__).joinpath(f"{name}.csv").read_text(encoding="utf-8")
    rows = list(csv.DictReader(text.splitlines()))
    words = {"True": 1.0, "False": 0.0}
    return {
        column: np.array([words[row[column]] if row[column] in words else float(row[column]) for row in rows])
        for column in rows[0]
        if column != "word"
    }
