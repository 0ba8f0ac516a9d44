"""The command `optimize`: the best runner over parameters within bounds."""

from collections.abc import Sequence
from typing import Any

import click

from ..analysis.targeted import TargetNotMetError
from ..errors import InputError
from ..library.quantities import QUANTITIES, unit_of
from ..optimization.optimize import MAX_POINTS, MAX_STARTS, POINTS, STARTS, optimize, pareto_front
from ..optimization.optimum import Optimum, reported
from ..record import origin_of
from ..terminal.text import headed, table
from ..variables.display_units import DisplayUnits
from .continuation import span_of
from .options import (
    JSON_OPTION,
    TARGET_OPTION,
    Command,
    Number,
    json_text,
    pairs_given,
    targets_given,
)
from .runner import Asked, runner_options


@click.command("optimize", cls=Command)
@click.option(
    "--minimize",
    multiple=True,
    metavar="QUANTITY",
    help=f"Quantity to minimize: {', '.join(QUANTITIES)}. Two objectives give a Pareto front.",
)
@click.option(
    "--maximize", multiple=True, metavar="QUANTITY", help="Quantity to maximize, from the same list."
)
@click.option(
    "--vary",
    "ranges",
    required=True,
    multiple=True,
    metavar="NAME=A:B",
    help="Parameter or input to vary, and its bounds, as in hip.touchdown_angle='30 deg:50 deg'. Repeatable.",
)
@TARGET_OPTION
@click.option("--stable", is_flag=True, help="Only gaits whose spectral radius is at most 0.99.")
@click.option(
    "--starts",
    type=Number(1, MAX_STARTS, whole=True),
    default=STARTS,
    help="Maximum number of searches, from gaits spread over the bounds.",
)
@click.option(
    "--points",
    type=Number(2, MAX_POINTS, whole=True),
    default=POINTS,
    help="Number of runners on a Pareto front.",
)
@JSON_OPTION
@runner_options()
def optimize_command(
    asked: Asked,
    minimize: tuple[str, ...],
    maximize: tuple[str, ...],
    ranges: tuple[str, ...],
    targets: tuple[str, ...],
    stable: bool,
    starts: int,
    points: int,
    as_json_object: bool,
) -> None:
    """Find the parameters within bounds whose gait minimizes or maximizes a quantity.

    The search uses exact gradients, also across changes of the gait word. If no gait meets the targets, the
    JSON holds the nearest one, and the exit status is 1. Two objectives give a Pareto front: runners of which
    none can be improved in one objective without losing in the other.
    """
    texts = pairs_given(ranges, "--vary", "NAME=A:B")
    vary = {name: span_of(name, text) for name, text in texts.items()}
    runner = asked.runner(vary)
    display = DisplayUnits(texts, runner)
    common: dict[str, Any] = {"target": targets_given(targets), "stable": stable, "starts": starts}
    common |= {"progress": True}
    if len(minimize) + len(maximize) > 2:
        raise InputError("--minimize, --maximize: more than two quantities; allowed: one or two")
    try:
        if len(minimize) + len(maximize) == 2:
            sought: dict[str, Any] = {"minimize": minimize, "maximize": maximize, "points": points}
            objectives, optima = pareto_front.plain(runner, vary, **sought, **common)
            plain = {"objectives": list(objectives), "front": [best.as_json() for best in optima]}
            plain = {**origin_of(runner), **plain}
            print(json_text(plain) if as_json_object else _front_text(objectives, optima, display))
            return
        minimum, maximum = (next(iter(names), None) for names in (minimize, maximize))
        best = optimize(runner, vary, minimize=minimum, maximize=maximum, **common)
    except TargetNotMetError as problem:
        if as_json_object:
            nearest = {"nearest": reported(problem.nearest), "word": problem.nearest.word}
            print(json_text(problem.nearest.runner.record() | nearest))
        raise
    print(json_text(best.as_json()) if as_json_object else _text(best, display))


def _text(best: Optimum, display: DisplayUnits) -> str:
    """A table before and after, and what the optimum is."""
    header = ("", "unit", "before", "after", "bound")
    rows = [
        (
            name,
            display.unit(name),
            f"{display.value(name, best.before.runner[name]):.9g}",
            f"{display.value(name, value):.9g}",
            best.active_bounds.get(name, ""),
        )
        for name, value in best.parameters.items()
    ]
    before, after = reported(best.before), reported(best.gait)
    for name, value in after.items():
        rows.append((name, display.label(unit_of(name)), f"{before[name]:.9g}", f"{value:.9g}", ""))
    rows.append(("word", "", best.before.word, best.word, ""))
    stable = ["yes" if gait.stable else "no" for gait in (best.before, best.gait)]
    rows.append(("stable", "", stable[0], stable[1], ""))
    return f"{table(header, rows)}\n\n{_judgement(best)}"


def _front_text(objectives: Sequence[str], optima: Sequence[Optimum], display: DisplayUnits) -> str:
    """A row for each runner."""
    names = list(optima[0].parameters)
    rows = [
        (
            *(f"{reported(best.gait)[name]:.9g}" for name in objectives),
            *(f"{display.value(name, best.parameters[name]):.9g}" for name in names),
            best.word,
            "yes" if best.stable else "no",
            best.why,
        )
        for best in optima
    ]
    heads = [headed(name, display.unit(name)) for name in names]
    return table((*objectives, *heads, "word", "stable", "not shown to be an optimum"), rows)


def _judgement(best: Optimum) -> str:
    """In a sentence."""
    maximum = "least" if best.is_minimum else "most"
    if best.why:
        return f"the {maximum} {best.objective} that was found; not shown to be an optimum: {best.why}"
    words = " and ".join(best.remaining_improvement)
    where = f", on the border between {words}, by the gradients of both sides" if best.is_at_border else ""
    limits = f"; kept by {' and '.join(best.limits)}" if best.limits else ""
    scope = "a local optimum" if best.is_local else "the optimum, for no gait can have less,"
    proved = f"the {maximum} {best.objective}: {scope} to first order{where}{limits}"
    if best.starts == 1:
        return f"{proved}; one search"
    return f"{proved}; the best of {best.basins} basins that {best.starts} searches came to"
