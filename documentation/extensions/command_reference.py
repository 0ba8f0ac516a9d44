"""The directive `command-line`: the help of `tdmf-slip` and of each of its commands, by themselves."""

import click
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from tdmf_slip.cli.main import commands

WIDTH = 100


def help_texts() -> dict[str, str]:
    """Text that `--help` prints, by command, in the order of the help."""
    texts = {"": _help(commands, click.Context(commands, info_name="tdmf-slip", max_content_width=WIDTH))}
    top = click.Context(commands, info_name="tdmf-slip", show_default=True)
    for name in commands.list_commands(top):
        command = commands.get_command(top, name)
        assert command is not None
        texts[name] = _help(
            command, click.Context(command, parent=top, info_name=name, max_content_width=WIDTH)
        )
    return texts


def _help(command: click.Command, context: click.Context) -> str:
    context.terminal_width = WIDTH
    if not command.help:
        raise ValueError(f"the command {context.command_path} tells nothing of itself")
    return command.get_help(context)


class CommandLine(SphinxDirective):
    """A section for each command."""

    def run(self) -> list[nodes.Node]:
        """Texts as the terminal shows them."""
        found: list[nodes.Node] = []
        for name, text in help_texts().items():
            title = f"tdmf-slip {name}".strip()
            section = nodes.section(ids=[nodes.make_id(title)], names=[title])
            section += nodes.title(title, title)
            section += nodes.literal_block(text, text, language="text")
            found.append(section)
        return found


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx of the directive."""
    app.add_directive("command-line", CommandLine)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
