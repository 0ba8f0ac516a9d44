"""The picture of a result, by its kind: what `plot()` of a run, a gait, a sweep or a branch shows."""

from functools import singledispatch

import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from ..analysis.branch import Branch
from ..analysis.sweep import Sweep
from ..errors import InputError
from ..fitting.result import Fit
from ..library.gait import Gait
from ..unit.run import Run
from ..unit.unit import load_fmu
from ..viable_sets.result import Viability
from . import branch, branch_diagram, fit_diagram, overview, velocity_and_ratio, viability_map
from .stride import Stride


def plot(result: object) -> Figure:
    """The picture of a result."""
    figure = _figure_of(result)
    plt.close(figure)  # else a notebook shows it once more, at the end of the cell
    return figure


@singledispatch
def _figure_of(result: object) -> Figure:
    raise InputError(
        f"plot: {type(result).__name__} has no picture; allowed: Run, Gait, Sweep, Branch, Fit, Viability"
    )


@_figure_of.register
def _run(result: Run) -> Figure:
    return overview.figure_of(result, load_fmu())


@_figure_of.register
def _gait(result: Gait) -> Figure:
    return velocity_and_ratio.figure_of(Stride(result, load_fmu()))


@_figure_of.register
def _sweep(result: Sweep) -> Figure:
    return branch.figure_of(*branch.drawn_of(result), load_fmu())


@_figure_of.register
def _branch(result: Branch) -> Figure:
    return branch_diagram.figure_of(result)


@_figure_of.register
def _fit(result: Fit) -> Figure:
    return fit_diagram.figure_of(result)


@_figure_of.register
def _viability(result: Viability) -> Figure:
    return viability_map.figure_of(result)
