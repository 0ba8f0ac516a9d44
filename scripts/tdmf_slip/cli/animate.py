"""The command `animate`: one stride of a gait as an animation."""

from functools import partial
from pathlib import Path

from ..analysis.search import periodic_gait
from ..errors import InputError
from ..library.gait import Gait
from ..library.runner import Runner
from ..terminal.progress import progress_bar
from .command import Answer, command, option
from .options import NewPicture, Number, read_gait
from .runner import RunnerOptions

FRAMES = 12, 2000
"""Smallest and largest number of frames in a stride."""


@command(
    "animate",
    option("--output", "path", of=Gait.animate, kind=NewPicture("animation"), metavar="FILE"),
    option("--from-gait", metavar="FILE"),
    option("--frames", of=Gait.animate, kind=Number(*FRAMES, whole=True), metavar="N"),
    model=False,
    as_json=False,
)
def animate_command(options: RunnerOptions, path: Path, from_gait: str | None, frames: int) -> Answer:
    """Animate one stride of a runner's gait, in a loop.

    Parameters
    ----------
    from_gait
        Gait to animate, from a file that `tdmf-slip gait --json` wrote; - reads stdin.
    """
    from ..pictures import animation  # matplotlib is slow to load
    from ..pictures.panels import Stride

    if from_gait is None:
        gait = periodic_gait(options.runner())
    else:
        if options.given or options.parameters is not None:
            raise InputError(
                "--from-gait gives the whole runner; allowed: no other option that describes one"
            )
        runner = Runner(read_gait(from_gait))
        gait = periodic_gait(runner, guess=runner.start_apex())
    with progress_bar("animate", frames, "frames", True) as bar:
        animation.draw(path, Stride(gait), frames=frames, step_finished=partial(bar.update, 1))
    return Answer({}, "")
