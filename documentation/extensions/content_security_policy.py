"""A Content-Security-Policy in every page: the site's own files run there, and the theme's inline scripts.

Files that any server may hand out have no headers of their own, so the policy stands in the page. An inline
script runs if its hash is in the policy, and only those in the theme's templates are; a page with another
one, or with a script in an attribute, is refused when it is built. Inline styles are allowed: figures and
cells bring their own.
"""

import base64
import functools
import hashlib
import html.parser
import pathlib

import furo
from sphinx.errors import ExtensionError

POLICY = (
    "default-src 'self'; "
    "script-src 'self' {hashes}; "
    "style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data:; "
    "base-uri 'none'; "
    "form-action 'self'"
)
TEMPLATES = pathlib.Path(furo.__file__).parent / "theme" / "furo"


class Scripts(html.parser.HTMLParser):
    """The inline scripts of a page or template, and the attributes in it that a browser would run."""

    def __init__(self, text):
        """Read a page."""
        super().__init__()
        self.inline, self.attributes = [], []
        self._script = None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        """Begin an inline script; note what runs by an attribute."""
        values = dict(attributes)
        if tag == "script" and "src" not in values:
            self._script = ""
        self.attributes += [
            f'{name}="{value}"'
            for name, value in attributes
            if name.startswith("on") or (value or "").strip().lower().startswith("javascript:")
        ]

    def handle_data(self, data):
        """Go on with an inline script."""
        if self._script is not None:
            self._script += data

    def handle_endtag(self, tag):
        """End an inline script."""
        if tag == "script" and self._script is not None:
            self.inline.append(self._script)
            self._script = None


@functools.cache
def theme_scripts():
    """The inline scripts that the theme's templates may put into a page."""
    templates = [path.read_text(encoding="utf-8") for path in sorted(TEMPLATES.rglob("*.html"))]
    return sorted({script for text in templates for script in Scripts(text).inline})


def hash_of(script):
    """A script's hash as a policy has it."""
    digest = hashlib.sha256(script.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode()}'"


@functools.cache
def policy():
    """The policy of a page."""
    return POLICY.format(hashes=" ".join(map(hash_of, theme_scripts())))


def check(folder):
    """Refuse pages with scripts that the policy would not let run."""
    known = set(theme_scripts())
    wrong = []
    for path in sorted(pathlib.Path(folder).rglob("*.html")):
        scripts = Scripts(path.read_text(encoding="utf-8"))
        found = [" ".join(script.split()) for script in scripts.inline if script not in known]
        wrong += [f"{path.relative_to(folder)}: {script[:80]}" for script in found + scripts.attributes]
    if wrong:
        raise ExtensionError(
            "scripts that no page may have, because its policy forbids them: " + "; ".join(wrong)
        )


def setup(app):
    """Tell the templates of the policy, and check what was built."""
    app.connect(
        "html-page-context",
        lambda app, page, template, context, doctree: context.update(content_security_policy=policy()),
    )
    app.connect("build-finished", lambda app, failure: failure or check(app.outdir))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
