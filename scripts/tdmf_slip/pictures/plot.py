"""The picture of a result, by its kind: what its `plot()` shows."""

import importlib
import sys
from collections.abc import Mapping
from functools import singledispatch

from matplotlib.figure import Figure

from ..analysis.branches import Branch
from ..analysis.sweeps import Sweep
from ..errors import InputError
from ..fitting.result import Fit
from ..fmu.run import Run
from ..library.gait import Gait
from ..viable_sets.result import Viability
from . import branch, branch_diagram, fit_diagram, overview, velocity_and_ratio, viability_map
from .stride import Stride

BY_NAME: Mapping[str, tuple[str, str]] = {
    "Attraction": ("decay_diagram", "of_attraction"),
    "Basin": ("basin_map", "figure_of"),
    "BorderProof": ("eigenvalue_diagram", "of_border"),
    "Comparison": ("quantity_diagram", "of_comparison"),
    "Controllability": ("eigenvalue_diagram", "of_controllability"),
    "Curve": ("curve_diagram", "figure_of_one"),
    "Feedback": ("eigenvalue_diagram", "of_feedback"),
    "FirstPassage": ("decay_diagram", "of_falls"),
    "Front": ("quantity_diagram", "of_front"),
    "GaitGrid": ("gait_map", "figure_of"),
    "Optimum": ("quantity_diagram", "of_optimum"),
    "Proof": ("eigenvalue_diagram", "of_proof"),
    "RareFalls": ("decay_diagram", "of_falls"),
    "Runs": ("runners_diagram", "of_runs"),
    "Strides": ("runners_diagram", "of_strides"),
}
"""Module and function by the kind's name: kinds whose modules are loaded only by those who use them."""


def plot(result: object) -> Figure:
    """The picture of a result."""
    return released(_figure_of(result))


def released(figure: Figure) -> Figure:
    """Hand a figure to pyplot if the user has imported it and it has windows: `pyplot.show()` opens it."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is not None:
        pyplot.figure(FigureClass=lambda **_: figure)
        if figure.canvas.required_interactive_framework is None:
            pyplot.close(figure)  # else a notebook shows it once more, at the end of the cell
    return figure


@singledispatch
def _figure_of(result: object) -> Figure:
    """Of a kind that is registered below, or that `BY_NAME` has."""
    name = next((kind.__name__ for kind in type(result).__mro__ if kind.__name__ in BY_NAME), None)
    if name is None:
        raise InputError(f"plot: {type(result).__name__} has no picture; allowed: results of this package")
    module, function = BY_NAME[name]
    figure: Figure = getattr(importlib.import_module(f"{__package__}.{module}"), function)(result)
    return figure


PICTURES = _figure_of
"""By the kind itself; other kinds are in `BY_NAME`."""


@_figure_of.register
def _run(result: Run) -> Figure:
    return overview.figure_of(result)


@_figure_of.register
def _gait(result: Gait) -> Figure:
    return velocity_and_ratio.figure_of(Stride(result))


@_figure_of.register
def _sweep(result: Sweep) -> Figure:
    return branch.figure_of(*branch.drawn_of(result))


@_figure_of.register
def _branch(result: Branch) -> Figure:
    return branch_diagram.figure_of(result)


@_figure_of.register
def _fit(result: Fit) -> Figure:
    return fit_diagram.figure_of(result)


@_figure_of.register
def _viability(result: Viability) -> Figure:
    return viability_map.figure_of(result)
