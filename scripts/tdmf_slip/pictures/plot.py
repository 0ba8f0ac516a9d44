"""The picture of a result, by its kind."""

import importlib
import sys
from collections.abc import Mapping
from typing import Any

from matplotlib.figure import Figure

from ..errors import InputError

PICTURES: Mapping[str, str] = {
    "Attraction": "decay_diagram.of_attraction",
    "BorderProof": "eigenvalue_diagram.of_border",
    "Branch": "branch_diagram.figure_of",
    "Comparison": "quantity_diagram.of_comparison",
    "Controllability": "eigenvalue_diagram.of_controllability",
    "Curve": "curve_diagram.figure_of_one",
    "Feedback": "eigenvalue_diagram.of_feedback",
    "FirstPassage": "decay_diagram.of_falls",
    "Fit": "fit_diagram.figure_of",
    "Front": "quantity_diagram.of_front",
    "Gait": "velocity_and_ratio.of_gait",
    "Optimum": "quantity_diagram.of_optimum",
    "Proof": "eigenvalue_diagram.of_proof",
    "RareFalls": "decay_diagram.of_falls",
    "Run": "overview.figure_of",
    "Sweep": "sweep_diagram.of_sweep",
    "Validation": ".paper.drift_diagram.of_validation",
    "Viability": "viability_map.figure_of",
    "basin": "basin_map.figure_of",
    "runs": "runners_diagram.of_runs",
    "strides": "runners_diagram.of_strides",
    "sweep": "sweep_diagram.of_gaits",
}
"""Module and function by the kind of a result: the name of its class, or a dataset's attribute `result`."""


def plot(result: Any) -> Figure:
    """Draw a result of this package; a notebook shows the figure, and `savefig` writes it.

    Where `matplotlib.pyplot` is imported before, its `show` opens a window. Else no backend is chosen.

    Parameters
    ----------
    result : Gait, Run, Branch or another result, or Dataset
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
        There is no picture of such a result, or the dataset has lost its attribute `result`.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait(friction=0.6)
    >>> law = tdmf_slip.dead_beat(gait, ["hip.touchdown_angle", "hip.stance_torque"])
    >>> tdmf_slip.plot(law).axes[0].get_xlabel()
    'real part of the eigenvalue'
    """
    name = _picture_of(result)
    module, _, function = name.rpartition(".")
    home = f"{__package__}.{module}" if not module.startswith(".") else f"{__package__.split('.')[0]}{module}"
    figure: Figure = getattr(importlib.import_module(home), function)(result)
    return _handed_on(figure)


def _picture_of(result: Any) -> str:
    kinds = [kind.__name__ for kind in type(result).__mro__]
    if "Dataset" in kinds:
        kind = result.attrs.get("result")
        if kind not in PICTURES:
            raise InputError(
                f"plot: the dataset's attribute `result` is {kind!r}; it has to be one of "
                f"{', '.join(name for name in PICTURES if name.islower())}. Many operations of xarray drop "
                "attributes: use xarray.set_options(keep_attrs=True), or set it again"
            )
        return PICTURES[kind]
    name = next((kind for kind in kinds if kind in PICTURES), None)
    if name is None:
        raise InputError(f"plot: {type(result).__name__} has no picture; allowed: results of this package")
    return PICTURES[name]


def _handed_on(figure: Figure) -> Figure:
    """Hand a figure to pyplot if the user has imported it and it has windows: `pyplot.show()` opens it."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is not None:
        pyplot.figure(FigureClass=lambda **_: figure)
        if figure.canvas.required_interactive_framework is None:
            pyplot.close(figure)  # else a notebook shows it once more, at the end of the cell
    return figure
