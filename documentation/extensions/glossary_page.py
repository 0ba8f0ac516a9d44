"""The directive `words`: the glossary, of `documentation/glossary.toml`, which the live page reads, too."""

import tomllib
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

SOURCE = Path(__file__).parents[1] / "glossary.toml"


class Words(SphinxDirective):
    """Glossary in alphabetical order."""

    def run(self) -> list[nodes.Node]:
        """Write a list of definitions."""
        self.env.note_dependency(str(SOURCE))
        groups = tomllib.loads(SOURCE.read_text(encoding="utf-8")).values()
        terms = [(term["title"], term["text"]) for group in groups for term in group.values()]
        listed = "\n\n".join(
            f"{title}\n: {text[0].upper()}{text[1:]}" for title, text in sorted(terms, key=_in_order)
        )
        return self.parse_text_to_nodes(listed)


def _in_order(term: tuple[str, str]) -> str:
    return term[0].lower().removeprefix("the ")


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx of the directive."""
    app.add_directive("words", Words)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
