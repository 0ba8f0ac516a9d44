"""What can draw itself in a notebook; `pictures` knows how, and is loaded when it is asked."""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Drawable:
    """A result with a picture."""

    def plot(self) -> "Figure":
        """Draw it; a notebook shows the figure, and `savefig` writes it."""
        figure: Figure = importlib.import_module(f"{__package__}.pictures.plot").plot(self)
        return figure
