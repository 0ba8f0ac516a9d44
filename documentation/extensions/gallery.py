"""The directive `gallery-figure`: a figure with its command, its data, its guide, and where it runs live.

    ```{gallery-figure} figure_9
    :guide: paper
    :live: ground.friction=0.43

    What it shows.
    ```

Picture and data are beside the page in `figures`, where scripts/site puts them.
"""

from html import escape

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

FOLDER = "figures"


class GalleryFigure(SphinxDirective):
    """One figure of the gallery."""

    required_arguments = 1
    option_spec = {"guide": directives.unchanged_required, "live": directives.unchanged}  # noqa: RUF012 # docutils'
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Write picture, words, and a line of what belongs to it."""
        name = self.arguments[0]
        words = self.parse_content_to_nodes()
        caption = escape(words[0].astext())
        address = f"{FOLDER}/{name}.png"
        picture = f'<a href="{address}"><img src="{address}" alt="{caption}" loading="lazy"></a>'
        links = [f'<a href="{FOLDER}/{name}.csv" download>data</a>']
        if "guide" in self.options:
            links.append(f'<a href="guides/{self.options["guide"]}.html">guide</a>')
        if "live" in self.options:
            links.append(f'<a href="live.html#{escape(self.options["live"])}">open live</a>')
        command = f"<code>tdmf-slip figures --only {name}</code>"
        line = f'<p class="gallery-line">{command} · {" · ".join(links)}</p>'
        box = nodes.container(classes=["gallery-figure"])
        box += [nodes.raw("", picture, format="html"), *words, nodes.raw("", line, format="html")]
        return [box]


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx of the directive."""
    app.add_directive("gallery-figure", GalleryFigure)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
