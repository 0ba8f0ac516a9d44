"""Title, first sentences and picture that search engines and messengers show for a page (Open Graph).

Open Graph needs absolute addresses, so the picture is named only where the site has one (`html_baseurl`).
"""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

LONGEST = 200
"""Characters of a description."""
PICTURE = "_images/snapshots.png"
OF_THE_SITE = (
    "A spring-legged runner whose foot can stick, slip, lift off and land: simulated, analysed, live."
)


def first_sentences(doctree: nodes.document | None) -> str:
    """Cut a page's first long paragraph to a description, at the end of a word."""
    paragraphs = doctree.findall(nodes.paragraph) if doctree else []
    for paragraph in paragraphs:
        text = " ".join(paragraph.astext().split())
        if len(text) > 60:
            return text if len(text) <= LONGEST else text[:LONGEST].rsplit(" ", 1)[0].rstrip(",;:") + " …"
    return OF_THE_SITE


def describe(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    """Hand a page's description to the template."""
    base = app.config.html_baseurl
    context["page_description"] = first_sentences(doctree)
    context["page_card"] = f"{base.rstrip('/')}/{PICTURE}" if base else ""
    context["page_address"] = f"{base.rstrip('/')}/{page}.html" if base else ""


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx when to ask."""
    app.connect("html-page-context", describe)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
