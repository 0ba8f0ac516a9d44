"""Files and pictures that a downloaded notebook needs where only the package is installed.

A line `% needs ../../examples/runner.py` in a guide becomes a cell, not shown on the page, that writes this
file; guides are executed in an empty folder. In notebooks for download directives become what any notebook
shows: pictures go along as attachments, programs are in the cells that write them, and
links between pages are the pages' titles, or addresses where the site has one (`html_baseurl`).
"""

import base64
import json
import pathlib
import re
import subprocess
from collections.abc import Callable
from typing import Any

from myst_nb.core import render
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

NEEDS = re.compile(r"^% needs (\S+)$", re.MULTILINE)
WRITES = re.compile(r"%%writefile (\S+)")
DIRECTIVE = re.compile(r"^```\{([\w-]+)\} ?(.*?)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
DOWNLOAD = re.compile(r"^\{nb-download\}`.*`\n*", re.MULTILINE)
PICTURE = re.compile(r"!\[(.*?)\]\((?!attachment:|https?:)(\S+?)\)")
LINK = re.compile(r"(?<!!)\[(.*?)\]\((?!attachment:|https?:|#)(\S+?)\)")
LEFT = re.compile(r"^```\{|\{[\w:-]+\}`|\[\]\(", re.MULTILINE)
KINDS = {".png": "image/png", ".gif": "image/gif", ".svg": "image/svg+xml"}

Cell = dict[str, Any]


def write_needed_files(app: Sphinx, docname: str, source: list[str]) -> None:
    """Put a cell in the place of each line that says which file a guide needs."""
    folder = pathlib.Path(app.env.doc2path(docname)).parent

    def cell(found: re.Match[str]) -> str:
        path = folder / found[1]
        app.env.note_dependency(str(path.resolve()), docname=docname)
        content = path.read_text(encoding="utf-8").rstrip()
        fence = "``````"
        return (
            f"{fence}{{code-cell}} python\n:tags: [remove-cell]\n%%writefile {path.name}\n{content}\n{fence}"
        )

    source[0] = NEEDS.sub(cell, source[0])


# ---- output that came in pieces ----


def in_one_piece(outputs: list[Cell], merge: Callable[[list[Cell]], list[Cell]]) -> list[Cell]:
    """Join the pieces of a stream as they came: MyST-NB ends each in a new line, which tears rows apart."""
    whole: list[Cell] = []
    streams: dict[str, Cell] = {}
    for output in outputs:
        if output["output_type"] != "stream":
            whole.append(output)
        elif output["name"] in streams:
            streams[output["name"]]["text"] += output["text"]
        else:
            streams[output["name"]] = output.copy()
            whole.append(streams[output["name"]])
    return merge(whole)


def _unchanged(outputs: list[Cell]) -> list[Cell]:
    return outputs


# ---- notebooks for download ----


def folded(tags: list[str]) -> Cell:
    """Metadata by which Jupyter folds what the page folds."""
    hidden = {
        "source_hidden": bool({"hide-cell", "hide-input"} & set(tags)),
        "outputs_hidden": "hide-cell" in tags,
    }
    return {"jupyter": hidden} if any(hidden.values()) else {}


class Notebook:
    """A guide's notebook on its way to one that stands alone."""

    def __init__(self, app: Sphinx, docname: str, path: pathlib.Path):
        """Read what MyST-NB has executed."""
        self.app, self.docname, self.path = app, docname, path
        self.folder = pathlib.Path(app.env.doc2path(docname)).parent
        self.content = json.loads(path.read_text(encoding="utf-8"))
        cells = self.content["cells"]
        self.written = {name for cell in cells for name in WRITES.findall("".join(cell["source"]))}

    def save(self) -> None:
        """Make it stand alone."""
        for cell in self.content["cells"]:
            if cell["cell_type"] == "markdown":
                self.plain(cell)
            elif cell["cell_type"] == "code":
                cell["outputs"] = in_one_piece(cell["outputs"], _unchanged)
                cell["metadata"] |= folded(cell["metadata"].get("tags", []))
        self.path.write_text(json.dumps(self.content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")

    def plain(self, cell: Cell) -> None:
        """Put what any notebook shows in the place of what Sphinx alone understands."""
        text = DOWNLOAD.sub("", "".join(cell["source"]))
        text = DIRECTIVE.sub(lambda found: self.directive(cell, *found.groups()), text)
        text = PICTURE.sub(lambda found: self.attached(cell, found[1], self.folder / found[2]), text)
        text = LINK.sub(lambda found: self.linked(found[1], found[2]), text)
        cell["source"] = text.strip("\n")
        left = LEFT.search(text)
        if left:
            raise ExtensionError(f"{self.docname}: in a notebook nothing shows {text[left.start() :][:60]!r}")

    def directive(self, cell: Cell, name: str, argument: str, content: str) -> str:
        """Write a directive as Markdown; what is not known stays, and is refused."""
        options = dict(re.findall(r"^:([\w-]+): *(.*)$", content, re.MULTILINE))
        if name == "image":
            return self.attached(cell, options.get("alt", ""), self.folder / argument)
        if name == "literalinclude":
            path = self.folder / argument
            text = path.read_text(encoding="utf-8").rstrip()
            return "" if path.name in self.written else f"```{options.get('language', '')}\n{text}\n```"
        if name == "graphviz":
            drawing = re.sub(r"^:.*\n", "", content, flags=re.MULTILINE)
            made = subprocess.run(["dot", "-Tsvg"], input=drawing.encode(), capture_output=True, check=True)
            return self.attach(cell, options.get("alt", ""), "drawing.svg", made.stdout)
        return f"```{{{name}}}"

    def attached(self, cell: Cell, text: str, path: pathlib.Path) -> str:
        """Let a picture go along."""
        return self.attach(cell, text, path.name, path.read_bytes())

    @staticmethod
    def attach(cell: Cell, text: str, name: str, data: bytes) -> str:
        """Let a picture go along, by its name."""
        kind = KINDS[pathlib.PurePath(name).suffix]
        cell.setdefault("attachments", {})[name] = {kind: base64.b64encode(data).decode()}
        return f"![{text}](attachment:{name})"

    def linked(self, text: str, target: str) -> str:
        """Name a page of the site; link it where the site has an address."""
        page, _, anchor = target.partition("#")
        source = (self.folder / page).resolve()
        docname = self.app.env.path2doc(str(source))
        known = docname is not None and docname in self.app.env.titles
        title = text or (self.app.env.titles[docname].astext() if known else "")
        base = self.app.config.html_baseurl
        if not base:
            return title if text else f"“{title}”"
        address = f"{docname}.html" if known else target
        return f"[{title}]({base.rstrip('/')}/{address}{'#' + anchor if anchor else ''})"


def finish_downloads(app: Sphinx, problem: Exception | None) -> None:
    """Rewrite the notebooks among the site's downloads."""
    if problem is not None or app.builder.name != "html":
        return
    for path in sorted((pathlib.Path(app.outdir) / "_downloads").glob("*/*.ipynb")):
        Notebook(app, f"guides/{path.stem}", path).save()


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx what is done when."""
    merge = render.coalesce_streams
    if merge.__module__ != __name__:
        render.coalesce_streams = lambda outputs: in_one_piece(outputs, merge)
    app.connect("source-read", write_needed_files)
    app.connect("build-finished", finish_downloads)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
