"""The command `tdmf-slip`: its group of commands, and its exit status.

Results go to stdout (with --json one JSON object and nothing else), progress and messages to stderr. Exit
status 0: done; 1: a run failed, a file could not be written, or a gait drifted from its reference; 2: the
request is not possible.
"""

import contextlib
import importlib
import os
import sys
import warnings
from collections.abc import Mapping
from typing import TextIO

import click

from ..checks import near_matches, shown
from ..errors import Note, TdmfSlipError
from ..terminal import encoding
from . import interrupts

COMMANDS: Mapping[str, str] = {
    "animate": "Animate one stride of a runner's gait, in a loop.",
    "basin": "Compute the region of attraction of a gait: a map of a slice, its volume and its robustness.",
    "bench": "Time the solvers and the ensemble engine against other programs at equal accuracy.",
    "build": "Build a C library and FMI units from a page: a folder with page.py, or a Python file.",
    "compare": "Match runners in speed, foot clearance or other quantities, to rule these out as causes.",
    "continue": "Follow a branch of gaits along a parameter, past folds, and locate its bifurcations.",
    "figures": "Draw the paper's figures and our own, each with its data as CSV.",
    "fit": "Fit parameters of the runner to measured gaits, with 95 % intervals.",
    "gait": "Find the periodic gait, stable or not, and the eigenvalues of its return map.",
    "new": "Start a page of your own: a folder with a page, parameters, a test and a README.",
    "optimize": "Find the parameters within bounds whose gait minimizes or maximizes a quantity.",
    "prove": "Prove that exactly one gait lies in a box, with its word, stability and enclosures.",
    "rough": "Estimate the mean number of strides until a runner falls on rough ground, with its confidence "
    "interval.",
    "simulate": "Simulate one run of the FMI unit through FMPy.",
    "sweep": "Find gaits over a range of one or two parameters, and the borders between gait words.",
    "validate": "Check the paper's gaits and statements by both readings of its swing law, and our claims.",
    "variables": "List every variable of the unit with its short name, unit, range, default and meaning.",
    "viability": "Compute the viable set: the apices from which some choice of actions avoids a fall "
    "forever.",
}
"""Summaries by the names of commands; each is the first sentence of the command's help."""
MODULES = {"continue": "continuation"}
"""Modules of commands whose name is a word of Python."""


def module_of(name: str) -> str:
    """The module of a command, without this package's name."""
    return MODULES.get(name, name)


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
            formatter.write_dl(list(COMMANDS.items()))

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of a name, or None."""
        if cmd_name not in COMMANDS:
            return None
        with interrupts.deferred():
            module = importlib.import_module(f".{module_of(cmd_name)}", __package__)
        command: click.Command = getattr(module, f"{cmd_name}_command")
        return command


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110, "show_default": True},
)
@click.version_option(package_name="tdmf-slip", prog_name="tdmf-slip")  # looked up when it is asked for
def commands() -> None:
    """Simulate and analyse a legged runner whose foot can slip."""


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and return the exit status; an error is one message on stderr."""
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
        interrupts.ignored()  # a second interrupt does not disturb Python's shutdown
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
    """Redirect stdout to the null device, because Python flushes it again at exit."""
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
