"""The directive `bibtex`: how to cite, of `CITATION.cff`, and of the paper that it refers to."""

import datetime
from pathlib import Path
from typing import Any

import yaml
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

SOURCE = Path(__file__).parents[2] / "CITATION.cff"


def entry(kind: str, key: str, fields: dict[str, Any]) -> str:
    """Write one entry; what is not given is left out."""
    given = {name: value for name, value in fields.items() if value}
    lines = [f"  {name} = {{{value}}}," for name, value in given.items()]
    return "\n".join([f"@{kind}{{{key},", *lines, "}"])


def authors(of: dict[str, Any]) -> str:
    """Names as BibTeX has them; a group's in braces, for it has no family name."""
    return " and ".join(
        f"{{{one['name']}}}" if "name" in one else f"{one['family-names']}, {one['given-names']}"
        for one in of["authors"]
    )


def bibtex() -> str:
    """Write the software and its paper."""
    cited = yaml.safe_load(SOURCE.read_text(encoding="utf-8"))
    released = cited["date-released"]
    year = released.year if isinstance(released, datetime.date) else str(released)[:4]
    (paper,) = cited["references"]
    own = {
        "title": cited["title"],
        "author": authors(cited),
        "year": year,
        "version": cited["version"],
        "license": cited["license"],
        "doi": cited.get("doi"),
        "url": cited.get("repository-code"),
    }
    theirs = {
        "title": paper["title"],
        "author": authors(paper),
        "journal": paper["journal"],
        "volume": paper["volume"],
        "pages": paper["start"],
        "year": paper["year"],
        "doi": paper["doi"],
    }
    return "\n\n".join([entry("software", "tdmf_slip", own), entry("article", "or_moravia_2016", theirs)])


class Bibtex(SphinxDirective):
    """Both entries, to be copied."""

    def run(self) -> list[nodes.Node]:
        """Write them as code."""
        self.env.note_dependency(str(SOURCE))
        text = bibtex()
        return [nodes.literal_block(text, text, language="bibtex")]


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx of the directive."""
    app.add_directive("bibtex", Bibtex)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
