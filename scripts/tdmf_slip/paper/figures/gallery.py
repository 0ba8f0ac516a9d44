"""All pictures of the five published gaits, in one folder."""

from collections.abc import Callable
from pathlib import Path

from ...analysis.search import periodic_gait
from ...analysis.sweeps import Row, sweep_row
from ...library.runner import Runner
from ...pictures import animation, model
from ...pictures.panels import Stride
from ...terminal.progress import progress_bar
from ...variables.parameters import read_parameters
from ...variables.table import FRICTION
from .. import matched
from ..claims import WORDS
from ..evidence import SWEPT
from . import figure_5, figure_6, figure_7, figure_8, figure_9
from .catalogue import CLAMP, EQUAL


def draw(folder: Path, progress: bool = False) -> list[Path]:
    """Draw figures 5 to 9 of the paper, one stride as snapshots and as an animation, and the model."""
    folder.mkdir(exist_ok=True)
    runner = Runner(read_parameters("paper"))
    with progress_bar("pictures", len(WORDS) + 9, "", progress) as bar:
        strides = {}
        for friction in WORDS:
            strides[friction] = Stride(periodic_gait(runner.replace({FRICTION: friction})))
            bar.update()
        clamped = Stride(periodic_gait(runner.replace({FRICTION: figure_5.FRICTION, CLAMP: True})))
        bar.update()
        written = []
        gaits = sweep_row(runner, FRICTION, SWEPT)
        for name, drawing in _drawings(strides, clamped, gaits).items():
            drawing(folder / name)
            written.append(folder / name)
            bar.update()
    return written


def _drawings(strides: dict[float, Stride], clamped: Stride, gaits: Row) -> dict[str, Callable[[Path], None]]:
    first, second = figure_8.FRICTIONS
    return {
        "figure_5.png": lambda path: figure_5.draw(path, strides[figure_5.FRICTION], clamped),
        "figure_6.png": lambda path: figure_6.draw(path, strides[figure_6.FRICTION]),
        "figure_7.png": lambda path: figure_7.draw(path, strides[figure_7.FRICTION]),
        "figure_8.png": lambda path: figure_8.draw(path, (strides[first], strides[second])),
        "figure_9.png": lambda path: figure_9.draw(path, gaits, matched.over_friction(gaits.gaits, EQUAL)),
        "snapshots.png": lambda path: model.draw_snapshots(path, strides[model.FRICTION]),
        "stride.gif": lambda path: animation.draw(path, strides[animation.FRICTION]),
        "model.png": model.draw,
    }
