"""The picture of a result, by its kind."""

import importlib
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from matplotlib.figure import Figure

from ..checks import is_one_of, shown
from ..errors import InputError, counted
from . import style


class Picture(NamedTuple):
    """Drawing function for a kind of result."""

    draw: str
    """Module of this package, and function."""
    variable: str = ""
    """One of the variables of a dataset."""
    dimensions: Sequence[int] = ()
    """Numbers of dimensions that this variable may have."""


PICTURES: Mapping[str, Picture] = {
    "Attraction": Picture("pictures.quantity_diagram.of_attraction"),
    "BorderProof": Picture("pictures.eigenvalue_diagram.of_border"),
    "Controllability": Picture("pictures.eigenvalue_diagram.of_controllability"),
    "Feedback": Picture("pictures.eigenvalue_diagram.of_feedback"),
    "FirstPassage": Picture("pictures.quantity_diagram.of_falls"),
    "Fit": Picture("pictures.fit_diagram.figure_of"),
    "Gait": Picture("pictures.panels.of_gait"),
    "Optimum": Picture("pictures.quantity_diagram.of_optimum"),
    "Proof": Picture("pictures.eigenvalue_diagram.of_proof"),
    "RareFalls": Picture("pictures.quantity_diagram.of_falls"),
    "Sweep": Picture("pictures.sweep_diagram.of_sweep"),
    "Validation": Picture("paper.drift_diagram.of_validation"),
    "basin": Picture("pictures.basin_map.figure_of", "fate", (2,)),
    "branch": Picture("pictures.branch_diagram.figure_of", "special", (1,)),
    "comparison": Picture("pictures.quantity_diagram.of_comparison", "word", (2,)),
    "curves": Picture("pictures.branch_diagram.of_curves", "curve_number", (1,)),
    "front": Picture("pictures.quantity_diagram.of_front", "word", (1,)),
    "run": Picture("pictures.overview.figure_of", "time", (1,)),
    "runs": Picture("pictures.basin_map.of_runs", "fallen", (1,)),
    "strides": Picture("pictures.basin_map.of_strides", "fate", (2,)),
    "sweep": Picture("pictures.sweep_diagram.figure_of", "word", (1, 2)),
    "trajectory": Picture("pictures.overview.figure_of", "time", (1,)),
    "viability": Picture("pictures.basin_map.of_viable_set", "viable", (2,)),
}
"""Pictures by the kind of a result: the name of its class, or a dataset's attribute `result`."""
DATASETS = [kind for kind, picture in PICTURES.items() if picture.variable]
"""Kinds of datasets that have a picture."""


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
    module, _, function = PICTURES[kind].draw.rpartition(".")
    home = importlib.import_module(f"..{module}", __package__)
    draw: Callable[[Any], Figure] = partial(getattr(home, function), **options)
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
        raise InputError(f"plot: {type(result).__name__} cannot be drawn; allowed: results of this package")
    return name


def _of_dataset(data: Any, kind: str, draw: Callable[[Any], Figure]) -> Figure:
    """Draw a dataset, or refuse a selection of it that is too small."""
    _, variable, dimensions = PICTURES[kind]
    try:
        count = data[variable].ndim
        if count in dimensions:
            return draw(data)
    except KeyError as problem:
        raise InputError(
            f"plot: incomplete {kind}: {problem.args[0]}; allowed: one with all its variables"
        ) from None
    raise InputError(
        f"plot: {kind} over {counted(count, 'dimension')}; "
        f"allowed: {' or '.join(map(str, dimensions))}, see Dataset.sel"
    )


def _handed_on(figure: Figure) -> Figure:
    """Hand a figure to pyplot if the user has imported it and it has windows: `pyplot.show()` opens it."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is not None:
        pyplot.figure(FigureClass=lambda **_: figure)
        if figure.canvas.required_interactive_framework is None:
            pyplot.close(figure)  # else a notebook shows it once more, at the end of the cell
    return figure
