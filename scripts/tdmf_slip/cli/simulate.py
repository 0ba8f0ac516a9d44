"""The command `simulate`: one run of the unit."""

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from ..errors import InputError, counted
from ..fmu.fmu import INTERFACES, Fmu, load_fmu
from ..fmu.inputs import read_tables
from ..fmu.run import WRITERS, Run, dataset_of, write_table
from ..fmu.simulation import (
    DEFAULT_TOLERANCE,
    INTERVALS,
    MAX_STRIDES,
    ONLY_IN,
    TIMES,
    TOLERANCES,
    run_unit,
    simulate,
)
from ..terminal.text import columns, quantity
from ..variables.variable import Value
from .command import Answer, command, option
from .options import NewFile, Number, read_gait
from .runner import RunnerOptions, file_values, refuse_given, start_values

SOLVER_TOLERANCE = "solver.relative_tolerance"


@command(
    "simulate",
    option("--interface", kind=click.Choice(list(INTERFACES)), default="me"),
    option("--stop-time", of=simulate, kind=Number(*TIMES), metavar="SECONDS"),
    option("--strides", of=simulate, kind=Number(1, MAX_STRIDES, whole=True), metavar="N"),
    option("--from-gait", metavar="FILE"),
    option("--inputs", kind=click.Path(path_type=Path), metavar="FILE"),
    option(
        "--tolerance",
        of=simulate,
        kind=Number(*TOLERANCES),
        default=None,
        show_default=f"{DEFAULT_TOLERANCE:g}",
    ),
    option("--output-interval", of=simulate, kind=Number(*INTERVALS), metavar="SECONDS"),
    option("--output", kind=NewFile(*WRITERS), metavar="FILE"),
    model=False,
    plot="the run",
)
def simulate_command(
    options: RunnerOptions,
    interface: str,
    from_gait: str | None,
    inputs: Path | None,
    tolerance: float | None,
    output: Path | None,
    **given: Any,
) -> Answer:
    """Simulate one run of the FMI unit through FMPy.

    A fall ends the run. It is a result, not an error.

    Parameters
    ----------
    interface
        FMI interface: Model Exchange or Co-Simulation.
    from_gait
        Start on the gait in a file that `tdmf-slip gait --json` wrote, with its parameters; - reads
        stdin.
    inputs
        Inputs over time: CSV with the header time,<input>,...
    output
        Write the rows: .csv or .nc.
    """
    if output is not None:
        for what, file in (("inputs", inputs), ("gait", from_gait and Path(from_gait))):
            if file and output.resolve() == file.resolve():
                raise InputError(f"--output {output}: holds the {what}; allowed: another file name")
        if output.suffix.lower() == ".nc":
            from ..files.resume import refuse_resumable  # xarray is slow to load

            refuse_resumable(output)
    fmu = load_fmu()
    if options.parameters is not None and from_gait is not None:
        raise InputError("--parameters and --from-gait both give the runner; allowed: one of the two")
    base = file_values(options.parameters, fmu.variables)
    if from_gait is not None:
        base = fmu.variables.start_values(read_gait(from_gait), f"--from-gait {from_gait}")
    starts = start_values(base, options.given, fmu.variables)
    _refuse_other_interface(interface, options.given)
    if tolerance is None:
        tolerance = DEFAULT_TOLERANCE
    elif interface == "cs":
        _refuse_loose(fmu, starts, tolerance)
    tables = read_tables(inputs, fmu) if inputs is not None else {}
    for name in tables:
        refuse_given(options.given, name, "--inputs")
    given |= {"tolerance": tolerance, "inputs": tables, "interface": interface}
    run = run_unit(starts, progress=True, fmu=fmu, **given)
    if output is not None:
        write_table(output, run)
    return Answer(_run_object(run), _run_text(run), lambda: dataset_of(run))


def _refuse_other_interface(interface: str, given: Mapping[str, object]) -> None:
    for name in given:
        only = ONLY_IN.get(name, interface)
        if only != interface:
            raise InputError(
                f"--set {name}: has no meaning with --interface {interface}; allowed: with --interface {only}"
            )


def _refuse_loose(fmu: Fmu, starts: Mapping[str, Value], tolerance: float) -> None:
    tightest = starts.get(SOLVER_TOLERANCE, fmu.variables.start_of(SOLVER_TOLERANCE))
    if tolerance > tightest:
        raise InputError(
            f"--tolerance = {tolerance:g}: in Co-Simulation the tighter of it and {SOLVER_TOLERANCE} = "
            f"{tightest:g} holds; allowed: up to that, or --set {SOLVER_TOLERANCE}={tolerance:g}"
        )


def _run_object(run: Run) -> dict[str, object]:
    return {
        **run.record,
        "fallen": run.fallen,
        "fall_time": run.fall_time,
        "end_time": float(run.table["time"][-1]),
        "rows": len(run.table),
        "stride": run.stride,
        "apex": run.apex,
        "final": run.final,
        "events": [asdict(event) for event in run.events],
        "messages": run.messages,
    }


def _run_text(run: Run) -> str:
    stride = run.stride
    time = run.fall_time if run.fallen else run.table["time"][-1]
    end = f"{'fell at' if run.fallen else 'ran to'} t = {time:g} {run.label('s')}"
    lines = [f"{end}, {counted(stride['count'], 'stride')}, {counted(len(run.events), 'event')}"]
    if stride["count"]:
        rows = {
            f"  {name}": value
            if isinstance(value, str)
            else quantity(value, run.label(run.variables[f"stride.{name}"].unit), 8)
            for name, value in stride.items()
            if name not in ("count", "word_code")
        }
        lines += ["last stride:", columns(rows)]
    return "\n".join([*lines, *(f"unit: {message}" for message in run.messages)])
