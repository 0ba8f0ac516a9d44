"""A menu of the site's versions, where `versions_file` says where their list is.

The list stands beside the versions, `[{"version": "0.1.0", "address": "0.1.0/index.html"}, ...]`, and is
read in the browser by versions.js: a release adds a line to it, and the older versions show that.
"""

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.osutil import relative_uri


def tell_of_versions(
    app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None
) -> None:
    """Hand the template the list's address, relative to the page."""
    list_of_versions = app.config.versions_file
    own = app.builder.get_target_uri(page)
    context["versions_file"] = relative_uri(own, list_of_versions) if list_of_versions else ""
    if list_of_versions:
        app.add_js_file("versions.js", loading_method="defer")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the setting, and the function that every page calls."""
    app.add_config_value("versions_file", "", "html")
    app.connect("html-page-context", tell_of_versions)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
