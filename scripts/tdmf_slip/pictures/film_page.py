"""An animation as a page of HTML that needs nothing else: its frames, a slider, and a script of a few lines.

Matplotlib's own page fetches its buttons from elsewhere.
"""

import base64
import io
from pathlib import Path

from matplotlib.animation import AbstractMovieWriter

PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>TDMF-SLIP</title>
<style>
  body {{ font: 16px sans-serif; max-width: 50rem; margin: 1rem auto; padding: 0 1rem; }}
  img {{ width: 100%; }}
  div {{ display: flex; gap: 1rem; align-items: center; }}
  input {{ flex: 1; }}
</style>
<img id="frame" alt="One stride of the runner, frame by frame">
<div>
  <button id="play">Pause</button>
  <input id="at" type="range" min="0" max="{last}" value="0" aria-label="frame">
</div>
<script>
  const frames = [{frames}];
  const [frame, at, play] = ["frame", "at", "play"].map((id) => document.getElementById(id));
  let playing = true;
  function show() {{ frame.src = "data:image/png;base64," + frames[at.value]; }}
  at.oninput = () => {{ playing = false; play.textContent = "Play"; show(); }};
  play.onclick = () => {{ playing = !playing; play.textContent = playing ? "Pause" : "Play"; }};
  function next() {{ if (playing) {{ at.value = (+at.value + 1) % frames.length; show(); }} }}
  setInterval(next, {milliseconds});
  show();
</script>
</html>
"""


class PageWriter(AbstractMovieWriter):
    """Keeps the frames as PNG files in the page."""

    def setup(self, fig, outfile, dpi=None):  # type: ignore[no-untyped-def] # as Matplotlib declares it
        """Begin a page."""
        super().setup(fig, outfile, dpi=dpi)
        self._frames: list[str] = []

    def grab_frame(self, **options: object) -> None:
        """Add a frame."""
        picture = io.BytesIO()
        self.fig.savefig(picture, format="png", dpi=self.dpi, metadata={"Software": None})
        self._frames.append(base64.b64encode(picture.getvalue()).decode())

    def finish(self) -> None:
        """Write the page."""
        frames = ",\n".join(f'"{frame}"' for frame in self._frames)
        page = PAGE.format(last=len(self._frames) - 1, frames=frames, milliseconds=round(1000 / self.fps))
        Path(self.outfile).write_text(page, encoding="utf-8")
