"""The command `optimize`: the best runner over parameters within bounds."""

from collections.abc import Sequence
from typing import Any

import click

from ..analysis.targeted import TargetNotMetError
from ..errors import InputError
from ..library.quantities import QUANTITIES, unit_of
from ..optimization.optimize import MAX_POINTS, MAX_STARTS, optimize, pareto_front
from ..optimization.optimum import Optimum, reported
from ..record import origin_of
from ..terminal.text import headed, table
from ..variables.display_units import DisplayUnits
from .command import Answer, command, option
from .options import TARGET_OPTION, Number, pairs_given, span_of, targets_given
from .runner import RunnerOptions


@command(
    "optimize",
    click.option(
        "--minimize",
        multiple=True,
        metavar="QUANTITY",
        help=f"Quantity to minimize: {', '.join(QUANTITIES)}. Two objectives give a Pareto front.",
    ),
    option("--maximize", multiple=True, metavar="QUANTITY"),
    option("--vary", "ranges", required=True, multiple=True, metavar="NAME=A:B"),
    TARGET_OPTION,
    option("--stable", is_flag=True),
    option("--starts", of=optimize, kind=Number(1, MAX_STARTS, whole=True)),
    option("--points", of=pareto_front, kind=Number(2, MAX_POINTS, whole=True)),
)
def optimize_command(
    options: RunnerOptions,
    minimize: tuple[str, ...],
    maximize: tuple[str, ...],
    ranges: tuple[str, ...],
    targets: tuple[str, ...],
    points: int,
    **given: Any,
) -> Answer:
    """Find the parameters within bounds whose gait minimizes or maximizes a quantity.

    The search uses exact gradients, also across changes of the gait word. If no gait meets the targets, the
    JSON holds the nearest one, and the exit status is 1. Two objectives give a Pareto front: runners of which
    none can be improved in one objective without losing in the other.

    Parameters
    ----------
    maximize
        Quantity to maximize, from the same list.
    ranges
        Parameter or input to vary, and its bounds, as in hip.touchdown_angle='30 deg:50 deg'. Repeatable.
    stable
        Only gaits whose spectral radius is at most 0.99.
    """
    texts = pairs_given(ranges, "--vary", "NAME=A:B")
    vary = {name: span_of(name, text) for name, text in texts.items()}
    runner = options.runner(vary)
    display = DisplayUnits(texts, runner)
    given |= {"target": targets_given(targets), "progress": True}
    if len(minimize) + len(maximize) > 2:
        raise InputError("--minimize, --maximize: more than two quantities; allowed: one or two")
    try:
        if len(minimize) + len(maximize) == 2:
            sought: dict[str, Any] = {"minimize": minimize, "maximize": maximize, "points": points}
            objectives, optima = pareto_front.plain(runner, vary, **sought, **given)
            front = {"objectives": list(objectives), "front": [best.as_json() for best in optima]}
            return Answer(origin_of(runner) | front, _front_text(objectives, optima, display))
        minimum, maximum = (next(iter(names), None) for names in (minimize, maximize))
        best = optimize(runner, vary, minimize=minimum, maximize=maximum, **given)
    except TargetNotMetError as problem:
        nearest = {"nearest": reported(problem.nearest), "word": problem.nearest.word}
        return Answer(problem.nearest.runner.record() | nearest, "", failure=problem)
    return Answer(best.as_json(), _text(best, display))


def _text(best: Optimum, display: DisplayUnits) -> str:
    """Table before and after the optimization, and the kind of optimum."""
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
    was_stable, is_stable = ("yes" if gait.stable else "no" for gait in (best.before, best.gait))
    rows.append(("stable", "", was_stable, is_stable, ""))
    return f"{table(('', 'unit', 'before', 'after', 'bound'), rows)}\n\n{_judgement(best)}"


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
    """One sentence on the kind of optimum."""
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
