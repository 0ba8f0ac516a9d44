"""The directive `variables`: those of the unit of some causalities."""

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective
from tdmf_slip.cli.variables import row
from tdmf_slip.variables.table import VARIABLES

HEADINGS = ("name", "short name", "meaning", "unit", "default", "range")


class Variables(SphinxDirective):
    """A table; each row can be linked to, as `#stride-period`."""

    required_arguments = 1
    optional_arguments = 2

    def run(self) -> list[nodes.Node]:
        """The rows of all variables of these causalities."""
        chosen = [v for v in VARIABLES.values() if v.causality in self.arguments]
        undocumented = [v.name for v in chosen if not v.description]
        if undocumented or not chosen:
            raise ExtensionError(f"variables without a meaning: {', '.join(undocumented) or self.arguments}")
        table = nodes.table(classes=["variable-table"])
        group = nodes.tgroup(cols=len(HEADINGS))
        group += [nodes.colspec(colwidth=1) for _ in HEADINGS]
        group += nodes.thead("", _row([nodes.Text(heading) for heading in HEADINGS]))
        body = nodes.tbody()
        for variable in chosen:
            name, short, unit_name, span, default, _, meaning = row(variable)
            code = [nodes.literal(text, text) for text in (name, short)]
            cells = [*code, *map(nodes.Text, (meaning, unit_name, default, span))]
            line = _row(cells)
            line["ids"].append(nodes.make_id(name))
            body += line
        group += body
        table += group
        return [table]


def _row(cells: list[nodes.Node]) -> nodes.row:
    line = nodes.row()
    for cell in cells:
        line += nodes.entry("", nodes.paragraph("", "", cell))
    return line


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx of the directive."""
    app.add_directive("variables", Variables)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
