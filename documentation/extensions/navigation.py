"""The navigation beside a page: made once for all pages of a folder that are no documents.

Sphinx copies the contents of the whole site for every page, and cuts away what the navigation does not show.
The sources of modules and the indices, five times as many pages as documents, are in no contents: what they
show is the same, but for how links are written, which depends on the folder alone.
"""

import functools
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx


def share_navigation(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    """Let a page that is no document have the contents that the first of its folder was given."""
    if page in app.env.found_docs:
        return
    made = app.builder.navigation_of_folders
    folder = page.rpartition("/")[0]
    context["toctree"] = made.setdefault(folder, functools.cache(context["toctree"]))


def prepare(app: Sphinx) -> None:
    """No folder's contents have been made."""
    app.builder.navigation_of_folders = {}


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx when to ask: before the theme does."""
    app.connect("builder-inited", prepare)
    app.connect("html-page-context", share_navigation, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
