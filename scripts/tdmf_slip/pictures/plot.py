"""The picture of a result, by its kind."""

import importlib
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from ..checks import is_one_of, shown
from ..errors import InputError
from . import style

PICTURES: Mapping[str, str] = {
    "Attraction": "quantity_diagram.of_attraction",
    "BorderProof": "eigenvalue_diagram.of_border",
    "Controllability": "eigenvalue_diagram.of_controllability",
    "Feedback": "eigenvalue_diagram.of_feedback",
    "FirstPassage": "quantity_diagram.of_falls",
    "Fit": "fit_diagram.figure_of",
    "Gait": "panels.of_gait",
    "Optimum": "quantity_diagram.of_optimum",
    "Proof": "eigenvalue_diagram.of_proof",
    "RareFalls": "quantity_diagram.of_falls",
    "Sweep": "sweep_diagram.of_sweep",
    "Validation": ".paper.drift_diagram.of_validation",
    "basin": "basin_map.figure_of",
    "branch": "branch_diagram.figure_of",
    "comparison": "quantity_diagram.of_comparison",
    "curves": "branch_diagram.of_curves",
    "front": "quantity_diagram.of_front",
    "run": "overview.figure_of",
    "runs": "basin_map.of_runs",
    "strides": "basin_map.of_strides",
    "sweep": "sweep_diagram.figure_of",
    "viability": "basin_map.of_viable_set",
    "trajectory": "overview.of_trajectory",
    "gait of a model of one's own": "overview.of_own_gait",
}
"""Module and function by the kind of a result: the name of its class, or a dataset's attribute `result`."""
DATASETS: Mapping[str, tuple[str, Sequence[int]]] = {
    "basin": ("fate", (2,)),
    "branch": ("special", (1,)),
    "comparison": ("word", (2,)),
    "curves": ("curve_number", (1,)),
    "front": ("word", (1,)),
    "run": ("time", (1,)),
    "runs": ("fallen", (1,)),
    "strides": ("fate", (2,)),
    "sweep": ("word", (1, 2)),
    "viability": ("viable", (2,)),
    "trajectory": ("time", (1,)),
}
"""Datasets that have a picture: one of their variables, and how many dimensions it may have."""


def plot(result: Any) -> Figure:
    """Draw a result of this package; a notebook shows the figure, and `savefig` writes it.

    Where `matplotlib.pyplot` is imported before, its `show` opens a window. Else no backend is chosen.

    Parameters
    ----------
    result : Dataset, Gait or another result
        A dataset is drawn by its attribute `result`, which says what it is.

        - Runs are drawn over time, gaits as velocities and force ratio of a stride.
        - Sweeps and branches are drawn over their parameter, sweeps over two names as maps.
        - Fits are drawn by their residuals; optima, fronts and comparisons by their quantities.
        - Feedbacks, modes and proofs are drawn by eigenvalues beside the unit circle.
        - Basins and viable sets are drawn over their two coordinates.

    Returns
    -------
    Figure
        A Matplotlib figure.

    Raises
    ------
    InputError
        There is no picture of such a result, or the dataset has lost variables, dimensions or attributes.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait(friction=0.6)
    >>> law = tdmf_slip.dead_beat(gait, ["hip.touchdown_angle", "hip.stance_torque"])
    >>> tdmf_slip.plot(law).axes[0].get_xlabel()
    'real part of the eigenvalue'
    """
    return _handed_on(_figure_of(result))


def write_picture(path: Path, result: Any, **options: Any) -> None:
    """Draw a result into a file; the options are those of its picture."""
    figure = _figure_of(result, **options)
    with style.styled():
        style.save(figure, path)


def _figure_of(result: Any, **options: Any) -> Figure:
    kind = _kind_of(result)
    module, _, function = PICTURES[kind].rpartition(".")
    home = f"{__package__}.{module}" if not module.startswith(".") else f"{__package__.split('.')[0]}{module}"
    draw: Callable[[Any], Figure] = partial(getattr(importlib.import_module(home), function), **options)
    with style.styled():
        return _of_dataset(result, kind, draw) if kind in DATASETS else draw(result)


def _kind_of(result: Any) -> str:
    """Key of a result's picture in `PICTURES`."""
    kinds = [kind.__name__ for kind in type(result).__mro__]
    if "Dataset" in kinds:
        kind = result.attrs.get("result")
        if is_one_of(kind, DATASETS):
            return kind
        lost = (
            ". Many operations of xarray drop attributes: use xarray.set_options(keep_attrs=True), or set it "
            "again"
        )
        raise InputError(
            f"plot: the dataset's attribute `result` is {shown(kind)}; allowed: {', '.join(DATASETS)}"
            f"{lost if kind is None else ''}"
        )
    name = next((kind for kind in kinds if kind in PICTURES and kind not in DATASETS), None)
    if name is None:
        raise InputError(f"plot: {type(result).__name__} has no picture; allowed: results of this package")
    is_own = name == "Gait" and result.runner.model.is_own
    return "gait of a model of one's own" if is_own else name


def _of_dataset(data: Any, kind: str, draw: Callable[[Any], Figure]) -> Figure:
    """Draw a dataset, or refuse a selection of it that is too small."""
    variable, dimensions = DATASETS[kind]
    try:
        count = data[variable].ndim
        if count in dimensions:
            return draw(data)
    except KeyError as problem:
        raise InputError(f"plot: incomplete {kind}: {problem.args[0]}; allowed: all its variables") from None
    raise InputError(
        f"plot: {kind} over {count} dimensions; allowed: {' or '.join(map(str, dimensions))}, see Dataset.sel"
    )


def _handed_on(figure: Figure) -> Figure:
    """Hand a figure to pyplot if the user has imported it and it has windows: `pyplot.show()` opens it."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is not None:
        pyplot.figure(FigureClass=lambda **_: figure)
        if figure.canvas.required_interactive_framework is None:
            pyplot.close(figure)  # else a notebook shows it once more, at the end of the cell
    return figure
