"""The command `animate`: a gait that runs."""

from functools import partial
from pathlib import Path

from ..analysis.search import periodic_gait
from ..errors import InputError
from ..library.runner import Runner
from ..terminal.progress import progress_bar
from .command import Answer, command, option
from .options import NewPicture, Number, read_gait
from .runner import Asked

FRAMES = 12, 2000
"""The least and the most in a stride."""


@command(
    "animate",
    option("--output", kind=NewPicture("animation"), default=Path("stride.gif"), metavar="FILE"),
    option("--from-gait", metavar="FILE"),
    option("--frames", kind=Number(*FRAMES, whole=True), default=120, metavar="N"),
    model=False,
    as_json=False,
)
def animate_command(asked: Asked, output: Path, from_gait: str | None, frames: int) -> Answer:
    """Animate one stride of a runner's gait, in a loop.

    Parameters
    ----------
    output
        File to write: .gif, .html, or .mp4 if ffmpeg is installed.
    from_gait
        Gait to animate, from a file that `tdmf-slip gait --json` wrote; - reads stdin.
    frames
        Frames per stride, shown at 20 per second; the stance is in slow motion.
    """
    from ..pictures import animation  # matplotlib is slow to load
    from ..pictures.panels import Stride

    if from_gait is None:
        gait = periodic_gait(asked.runner())
    else:
        if asked.given or asked.parameters is not None:
            raise InputError("--from-gait: says what the runner is; allowed: it, or other options for that")
        runner = Runner(read_gait(from_gait))
        gait = periodic_gait(runner, guess=runner.start_apex())
    with progress_bar("animate", frames, "frames", True) as bar:
        animation.draw(output, Stride(gait), frames=frames, step_finished=partial(bar.update, 1))
    return Answer({}, "")
