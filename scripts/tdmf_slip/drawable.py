"""What can show itself: in a line, as a table of a notebook, as a picture and as a dataset.

`pictures` and `files` know how, and are loaded when they are asked.
"""

import html
import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

MAX_LISTED = 6
"""Numbers of a list that are written out in a notebook's table."""


class Drawable:
    """A result with a picture, a dataset and a table."""

    def plot(self) -> "Figure":
        """Draw it; a notebook shows the figure, and `savefig` writes it.

        Where `matplotlib.pyplot` is imported before, its `show` opens a window. Else no backend is chosen.

        A run is drawn over time, a gait as velocities and force ratio of its stride, a sweep and a branch
        over their parameter, a curve over its two; a fit by its residuals, an optimum and a comparison by
        relative changes of all quantities, a front by one objective over the other; modes, feedbacks and
        proofs by eigenvalues beside the unit circle; strides until a fall by the probability of being up
        still, an attraction by the bound of the distance from stride to stride, a basin and a viable set over
        their two coordinates, a grid of gaits over its parameters, strides by their apices, runs by their
        last strides, a validation by deviations over what is allowed.

        Returns
        -------
        Figure
            A Matplotlib figure.

        Raises
        ------
        InputError
            There is nothing to draw.

        Examples
        --------
        >>> import tdmf_slip
        >>> gait = tdmf_slip.find_gait({"ground.friction": 0.6})
        >>> law = tdmf_slip.dead_beat(gait, ["hip.touchdown_angle", "hip.stance_torque"])
        >>> law.plot().axes[0].get_xlabel()
        'real part of the eigenvalue'
        """
        figure: Figure = importlib.import_module(f"{__package__}.pictures.plot").plot(self)
        return figure

    def to_xarray(self) -> "xarray.Dataset":
        """What `as_json` gives, as a dataset.

        Returns
        -------
        xarray.Dataset
            Numbers and texts without a dimension, lists over one of their name, rows by their columns. Its
            attributes record the version, the model and the runner's values.

        Raises
        ------
        InputError
            The library xarray is missing.
        """
        module = importlib.import_module(f"{__package__}.files.plain_data")
        data: xarray.Dataset = module.dataset_of(self._shown())
        return data

    def _shown(self) -> Mapping[str, Any]:
        """What the table and the dataset show, by name."""
        shown: Mapping[str, Any] = self.as_json()  # type: ignore[attr-defined] # of each result
        return shown

    def _repr_html_(self) -> str:
        """A table for a notebook: the line that `repr` gives above it, then a row for each entry."""
        cells = ((name, _cell(value)) for name, value in self._shown().items())
        rows = "".join(
            f"<tr><th>{html.escape(name)}</th><td>{html.escape(text)}</td></tr>" for name, text in cells
        )
        return f"<table><caption>{html.escape(repr(self))}</caption>{rows}</table>"


def _cell(value: object) -> str:
    """A value in a few words."""
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list | tuple | Mapping):
        values = list(value.values() if isinstance(value, Mapping) else value)
        if len(values) <= MAX_LISTED and all(isinstance(one, int | float | str) for one in values):
            names = list(value) if isinstance(value, Mapping) else [""] * len(values)
            return ", ".join(f"{name} {_cell(one)}".strip() for name, one in zip(names, values, strict=True))
        return f"{len(values)} entries"
    return "none" if value is None else str(value)
