"""The command `tdmf-slip`: its group of commands, and how it ends.

Results go to stdout (with --json one JSON object and nothing else), progress and messages to stderr. Exit
status 0: done; 1: a run failed, or a gait drifted from its reference; 2: something asked for is not possible.
"""

import ast
import contextlib
import importlib
import os
import sys
import warnings
from pathlib import Path
from typing import TextIO

import click

from ..checks import near_matches, shown
from ..errors import Note, TdmfSlipError
from ..terminal import encoding
from . import interrupts

COMMANDS = (
    "animate",
    "basin",
    "bench",
    "build",
    "compare",
    "continue",
    "figures",
    "fit",
    "gait",
    "new",
    "optimize",
    "prove",
    "rough",
    "simulate",
    "sweep",
    "validate",
    "variables",
    "viability",
)
"""Each in the module of its name, but for the following."""
MODULES = {"continue": "continuation"}
"""Modules of commands whose name is a word of Python."""


def module_of(name: str) -> str:
    """The module of a command, without this package's name."""
    return MODULES.get(name, name)


def summary_of(name: str) -> str:
    """The first sentence of what a command says of itself, read without loading what the command needs."""
    source = Path(__file__).with_name(f"{module_of(name)}.py").read_text(encoding="utf-8")
    functions = (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef))
    text = next(ast.get_docstring(node) for node in functions if node.name == f"{name}_command") or ""
    sentence = " ".join(text.partition("\n\n")[0].split())
    return sentence.partition(". ")[0].removesuffix(".") + "."


class LazyGroup(click.Group):
    """A group that imports the module of a command when the command is asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names of all commands."""
        return list(COMMANDS)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command that is asked for."""
        if args and not args[0].startswith("-") and args[0] not in COMMANDS:
            near = near_matches(args[0], COMMANDS)
            ctx.fail(f"{shown(args[0])} is not a command{near}; allowed: {', '.join(COMMANDS)}")
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Each command with its whole first sentence."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, summary_of(name)) for name in self.list_commands(ctx)])

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of a name, or None."""
        if cmd_name not in COMMANDS:
            return None
        with interrupts.deferred():
            module = importlib.import_module(f".{module_of(cmd_name)}", __package__)
        command: click.Command = getattr(module, f"{cmd_name}_command")
        return command


@click.group(
    cls=LazyGroup, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110}
)
@click.version_option(package_name="tdmf-slip", prog_name="tdmf-slip")  # looked up when it is asked for
def commands() -> None:
    """Run the legged runner whose foot can slip, through its FMI unit."""


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; the exit status, after one message on stderr where something is wrong."""
    if sys.stdout is None:
        return _complain("stdout is closed, the results cannot be printed", 1)
    encoding.prints_anything()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", Note)
            warnings.showwarning = _show_warning
            status = commands.main(args=arguments, prog_name="tdmf-slip", standalone_mode=False) or 0
        sys.stdout.flush()
        return status
    except click.exceptions.Abort:
        interrupts.ignored()  # what Python does at its end is not interrupted again
        return _complain("interrupted", 130)
    except click.exceptions.NoArgsIsHelpError as problem:
        print(problem.format_message(), file=sys.stderr)
        return 2
    except click.UsageError as problem:
        where = problem.ctx.command_path if problem.ctx else "tdmf-slip"
        return _complain(f"{problem.format_message()} (see {where} --help)", 2)
    except TdmfSlipError as problem:
        return _complain(str(problem), problem.exit_status)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 1
    except BrokenPipeError:
        _abandon_stdout()
        return 1
    except OSError as problem:  # files are dealt with where they are written
        _abandon_stdout()
        return _complain(f"the results cannot be printed: {problem.strerror}", 1)


def _abandon_stdout() -> None:
    """Python flushes once more at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _show_warning(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    """Print a note on one line of stderr, without its place in the code; drop other warnings."""
    if issubclass(category, Note):
        _complain(f"warning: {message}", 0)


def _complain(message: str, status: int) -> int:
    with contextlib.suppress(OSError):
        if sys.stderr is not None:  # else it would be printed among the results
            print(f"tdmf-slip: {message}", file=sys.stderr)
    return status
