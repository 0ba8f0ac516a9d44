"""The command `tdmf-slip`: thin over the package's functions.

Results go to stdout (with --json one JSON object and nothing else), progress and messages to stderr. Exit
status 0: done; 1: a run failed, or a gait drifted from its reference; 2: something asked for is not possible.
"""

import contextlib
import os
import signal
import sys
from collections.abc import Mapping
from pathlib import Path

import click

from . import files
from .errors import InputError, TdmfSlipError
from .events import as_json
from .gait import DEFAULT_TOLERANCE as GAIT_TOLERANCE
from .gait_commands import basin_command, figures_command, gait_command, sweep_command
from .inputs import read_tables
from .options import (
    FRICTION_OPTION,
    JSON_OPTION,
    PARAMETERS_OPTION,
    SET_OPTION,
    Command,
    Number,
    file_values,
    json_text,
    refuse_given,
    start_values,
    values_given,
)
from .parameters import read_gait
from .simulation import (
    DEFAULT_STRIDES,
    DEFAULT_TOLERANCE,
    INTERVALS,
    MOST_STRIDES,
    TIMES,
    TOLERANCES,
    Run,
    simulate,
)
from .text import columns, quantity
from .unit import INTERFACES, Unit, load
from .version import __version__

SOLVER_TOLERANCE = "solver.relative_tolerance"


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(__version__, prog_name="tdmf-slip")
def commands() -> None:
    """Run the legged runner whose foot can slip, through its FMI unit."""


@commands.command("simulate", cls=Command)
@click.option(
    "--interface",
    type=click.Choice(list(INTERFACES)),
    default="me",
    show_default=True,
    help="FMI interface: Model Exchange or Co-Simulation.",
)
@click.option("--stop-time", type=Number(*TIMES), metavar="SECONDS", help="Stop at this time.")
@click.option(
    "--strides",
    type=Number(1, MOST_STRIDES, whole=True),
    metavar="N",
    help=f"Stop after N strides.  [default: {DEFAULT_STRIDES}, without --stop-time]",
)
@FRICTION_OPTION
@SET_OPTION
@PARAMETERS_OPTION
@click.option(
    "--from-gait",
    metavar="FILE",
    help="Begin on the gait that `tdmf-slip gait --json` wrote to a file, with its parameters; -: to stdin.",
)
@click.option(
    "--inputs",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Inputs over time: CSV with a header time,<input>,...",
)
@click.option(
    "--tolerance",
    type=Number(*TOLERANCES),
    help="Relative tolerance: of CVODE in Model Exchange; in Co-Simulation the tighter of it and "
    f"solver.relative_tolerance holds.  [default: {DEFAULT_TOLERANCE:g}]",
)
@click.option(
    "--output-interval",
    type=Number(*INTERVALS),
    metavar="SECONDS",
    help="Time between recorded rows.  [default: a tenth of sqrt(m/k)]",
)
@click.option(
    "--output", type=click.Path(path_type=Path), metavar="FILE", help="Write the rows: .csv or .nc."
)
@click.option(
    "--plot", type=click.Path(path_type=Path), metavar="FILE", help="Draw the run: .png, .svg or .pdf."
)
@JSON_OPTION
def simulate_command(
    interface: str,
    stop_time: float | None,
    strides: int | None,
    friction: float | None,
    settings: tuple[str, ...],
    parameters: str | None,
    from_gait: str | None,
    inputs: Path | None,
    tolerance: float | None,
    output_interval: float | None,
    output: Path | None,
    plot: Path | None,
    as_json_object: bool,
) -> None:
    """One run of the unit through FMPy.

    A fall ends the run and is a result, not an error.
    """
    if output is not None:
        files.check_place(output, files.WRITERS, "--output")
        for what, file in (("inputs", inputs), ("gait", from_gait and Path(from_gait))):
            if file and output.resolve() == file.resolve():
                raise InputError(f"--output {output}: holds the {what}; allowed: another file name")
        if output.exists():
            from .resume import refuse_resumable  # xarray is slow to load

            refuse_resumable(output)
    if plot is not None:
        from .pictures import overview  # matplotlib is slow to load

        files.check_place(plot, overview.FORMATS, "--plot")
    unit = load()
    if parameters is not None and from_gait is not None:
        raise InputError("--parameters: --from-gait says what the parameters are; allowed: one of the two")
    given = values_given(friction, settings)
    base = file_values(unit, parameters)
    if from_gait is not None:
        base = unit.start_values(read_gait(from_gait), f"--from-gait {from_gait}")
    starts = start_values(unit, base, given)
    _refuse_other_interface(unit, interface, given)
    if interface == "cs" and tolerance is not None:
        _refuse_loose(unit, starts, tolerance)
    tables = read_tables(inputs, unit) if inputs is not None else {}
    for name in tables:
        refuse_given(given, name, "--inputs")
    run = simulate(
        starts,
        stop_time=stop_time,
        strides=strides,
        relative_tolerance=DEFAULT_TOLERANCE if tolerance is None else tolerance,
        output_interval=output_interval,
        inputs=tables,
        interface=interface,
        show_progress=True,
        unit=unit,
    )
    if output is not None:
        files.write_table(output, run, unit)
    if plot is not None:
        overview.draw(plot, run, unit)
    print(json_text(_run_object(run)) if as_json_object else _run_text(run))


@commands.command("validate", cls=Command)
@click.option(
    "--tolerance",
    type=Number(*TOLERANCES),
    default=GAIT_TOLERANCE,
    show_default=True,
    help="Relative tolerance of CVODE.",
)
@click.option(
    "--pictures",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="Also draw the paper's figures 5 to 8, one stride, and the model.",
)
@JSON_OPTION
def validate_command(tolerance: float, pictures: Path | None, as_json_object: bool) -> None:
    """The five published gaits, published beside computed.

    The exit status is 1 where a computed value is farther from its recorded reference than allowed.
    """
    if pictures is not None:
        files.check_folder(pictures, "--pictures")
    from .validation import validate  # xarray is slow to load

    validation = validate(relative_tolerance=tolerance, show_progress=True)
    print(json_text(validation.as_json()) if as_json_object else validation.as_text())
    if pictures is not None:
        from .pictures import gallery

        gallery.draw(pictures, validation.gaits, load(), show_progress=True)
    if not validation.passed:
        raise SystemExit(1)


@commands.command("bench", cls=Command)
@click.option(
    "--effort",
    type=float,
    default=1.0,
    show_default=True,
    help="Scales how long is measured.",
)
@JSON_OPTION
def bench_command(effort: float, as_json_object: bool) -> None:
    """Solvers and the ensemble engine against their peers, on the same strides at equal accuracy."""
    from .bench import bench  # the C library is loaded when it is needed

    measured = bench(effort=effort, show_progress=True)
    print(json_text(measured.as_json()) if as_json_object else measured.as_text())


OF_INTERFACE = {"me": "Model Exchange: ", "cs": "Co-Simulation: "}
"""How the unit's description of a variable begins that has a meaning in one interface only."""


def _refuse_other_interface(unit: Unit, interface: str, given: Mapping[str, object]) -> None:
    for other, beginning in OF_INTERFACE.items():
        for name in given:
            if other != interface and unit.variables[name].description.startswith(beginning):
                raise InputError(
                    f"--set {name}: has no meaning with --interface {interface}; "
                    f"allowed: with --interface {other}"
                )


def _refuse_loose(unit: Unit, starts: Mapping[str, float | bool], tolerance: float) -> None:
    tightest = starts.get(SOLVER_TOLERANCE, unit.start_of(SOLVER_TOLERANCE))
    if tolerance > tightest:
        raise InputError(
            f"--tolerance = {tolerance:g}: in Co-Simulation the tighter of it and {SOLVER_TOLERANCE} = "
            f"{tightest:g} holds; allowed: up to that, or --set {SOLVER_TOLERANCE}={tolerance:g}"
        )


def _run_object(run: Run) -> dict[str, object]:
    return {
        "fallen": run.fallen,
        "fall_time": run.fall_time,
        "end_time": float(run.table["time"][-1]),
        "rows": len(run.table),
        "stride": run.stride,
        "apex": run.apex,
        "final": run.final,
        "events": as_json(run.events),
        "messages": run.messages,
    }


def _run_text(run: Run) -> str:
    stride = run.stride
    end = f"fell at t = {run.fall_time:g} s" if run.fallen else f"ran to t = {run.table['time'][-1]:g} s"
    lines = [f"{end}, {stride['count']} strides, {len(run.events)} events"]
    if stride["count"]:
        rows = {
            f"  {name}": value
            if isinstance(value, str)
            else quantity(value, run.units.get(f"stride.{name}", ""), 8)
            for name, value in stride.items()
            if name not in ("count", "word_code")
        }
        lines += ["last stride:", columns(rows)]
    return "\n".join([*lines, *(f"unit: {message}" for message in run.messages)])


for command in (gait_command, sweep_command, basin_command, figures_command):
    commands.add_command(command)


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; the exit status, after one message on stderr where something is wrong."""
    if sys.stdout is None:
        return _complain("stdout is closed, the results cannot be printed", 1)
    if hasattr(sys.stdout, "reconfigure"):  # names of files need not be UTF-8
        sys.stdout.reconfigure(errors="surrogateescape")
    try:
        status = commands.main(args=arguments, prog_name="tdmf-slip", standalone_mode=False) or 0
        sys.stdout.flush()
        return status
    except click.exceptions.Abort:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # what Python does at its end is not interrupted again
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
        _forget_stdout()
        return 1
    except OSError as problem:  # files are dealt with where they are written
        _forget_stdout()
        return _complain(f"the results cannot be printed: {problem.strerror}", 1)


def _forget_stdout() -> None:
    """Python flushes once more at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _complain(message: str, status: int) -> int:
    with contextlib.suppress(OSError):
        if sys.stderr is not None:  # else it would be printed among the results
            print(f"tdmf-slip: {message}", file=sys.stderr)
    return status
