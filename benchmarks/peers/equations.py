"""The stride of the published gait at friction 0.6, as a peer has to know it, from the runner's page.

Table 1 in units m = k = l0 = 1, on level ground. The sequence of modes is given, which spares a peer all of
the mode logic. The page runs on symbols, and what it computes is written as a function of Python, which
peers call, compile or evaluate on symbols of their own.
"""

import functools
from collections.abc import Callable, Sequence
from types import SimpleNamespace as Record
from typing import Any, TypeAlias

import numpy as np
from tdmf_slip.hybrid.expressions import forget_expressions, lift, ordered, symbol
from tdmf_slip.library.section import COORDINATES
from tdmf_slip.pages import PlainRunner
from tdmf_slip.pages.hip import PLACE, REST, RETRACT

Number: TypeAlias = Any
"""Number that a peer computes with: a float, an array of floats, or a symbol."""
State: TypeAlias = Sequence[Number]
"""The states of a mode, in the order of `FLIGHT` or `GROUND`."""
Function: TypeAlias = Callable[[Any, Any, Any], int]
"""Writes the values of (state, parameters) into the third argument; returns how many there are."""
FLIGHT = ("com_x", "com_y", "com_vx", "com_vy", "length", "angle", "length_rate", "momentum")
GROUND = ("x", "y", "vx", "vy", "foot_x", "foot_vx")
PARAMETERS = ("liftoff_angle", "driving", "way")
"""Held states of the page that differ between modes."""
SWINGS = {"place": PLACE, "retract": RETRACT, "released": RETRACT, "rest": REST}
"""Modes of flight; `released` is retract with the clamp of (12), which leads to `rest`."""
MODES = {**dict.fromkeys(SWINGS, "flight"), "stick": "stick", "slip": "slip", "graze": "graze"}
"""Modes of the page by the names of modes here."""
MOVING = {name: 8 if name in SWINGS else 4 if name == "stick" else 6 for name in MODES}
"""Number of states that change in each mode; they come first."""
EVENTS = {
    "place": ("touchdown",),
    "retract": ("apex",),
    "released": ("apex", "clamp"),
    "rest": ("apex", "release"),
    "stick": ("slips_forward", "slips_backward", "mid_stance", "lift_off"),
    "slip": ("comes_to_rest", "mid_stance", "lift_off"),
    "graze": ("graze_to_flight",),
}
"""Events of the page that may end a mode. Their guards fall to zero."""
MOST_GUARDS = max(map(len, EVENTS.values()))
STARTS_AT_ZERO = ("clamp", "release", "comes_to_rest")
ARMED = 1e-13
"""Offset of a guard that starts at zero."""
PASSED = 10.0
"""Keeps the guard of mid-stance away once it has passed."""


def names_of(name: str) -> tuple[str, ...]:
    """Names of the states in a mode."""
    return FLIGHT if name in SWINGS else GROUND


def runner_in(name: str, state: State, parameters: State = ()) -> Any:
    """The page's runner at an instant of a mode."""
    words = {"wind": "calm", "law": "constant", "swing": SWINGS.get(name, RETRACT)}
    held = dict(zip(PARAMETERS, parameters, strict=False))
    return PlainRunner.at(MODES[name], **words, **held, **dict(zip(names_of(name), state, strict=False)))


def state_of(runner: Any) -> list[Number]:
    """The states of a runner in its mode."""
    return [getattr(runner, name) for name in (FLIGHT if runner.mode == "flight" else GROUND)]


def rates(name: str, state: State, parameters: State) -> list[Number]:
    """Rates of the states that change in a mode."""
    runner = runner_in(name, state, parameters)
    found = getattr(runner, MODES[name])()
    return [found.get(of, 0) for of in names_of(name)[: MOVING[name]]]


def guards(name: str, state: State, parameters: State) -> list[Number]:
    """The quantities whose fall to zero ends a mode."""
    runner = runner_in(name, state, parameters)

    def guard(event: str) -> Number:
        if event == "mid_stance":  # the angle, as far as its sign goes, without an arctangent
            return (1 - runner.driving) * PASSED - runner.x
        value = PlainRunner.marked("is_event")[event].when(runner)
        return value + ARMED if event in STARTS_AT_ZERO else value

    return [guard(event) for event in EVENTS[name]]


def written(law: Callable[[str, State, State], list[Number]], name: str, functions: Any) -> Function:
    """A law of a mode as a function of Python; `functions` has its sine and the like."""
    forget_expressions()
    state = [symbol(f"s[{i}]") for i in range(len(names_of(name)))]
    results = [lift(x) for x in law(name, state, [symbol(f"p[{i}]") for i in range(len(PARAMETERS))])]
    texts: dict[Any, str] = {}
    lines = ["def law(s, p, out):"]
    for node in ordered(results):
        operands = [texts[operand] for operand in node.operands]
        if not operands:
            texts[node] = node.value if node.operation == "symbol" else repr(float(node.value))
            continue
        texts[node] = f"v{len(texts)}"
        if node.operation == "negative":
            text = f"-{operands[0]}"
        elif node.operation in ("+", "-", "*", "/"):
            text = node.operation.join(operands)
        else:
            text = f"functions.{node.operation}({', '.join(operands)})"
        lines.append(f" {texts[node]} = {text}")
    lines += [f" out[{i}] = {texts[result]}" for i, result in enumerate(results)]
    names: dict[str, Any] = {"functions": functions}
    exec("\n".join([*lines, f" return {len(results)}"]), names)
    found: Function = names["law"]
    return found


def values_of(law: Function, count: int, state: State, parameters: State) -> list[Number]:
    """The values of a written law."""
    values: list[Number] = [0.0] * count
    law(state, parameters, values)
    return values


# ---- between the modes: each takes the states before, and gives those after -----------------------------


def _start(_: str, section: State, __: State) -> list[Number]:
    names = PlainRunner.marked("is_section")["at_apex"].coordinates
    placed = PlainRunner.at("start_of_run").at_apex(Record(**dict(zip(names, section, strict=False))))
    return state_of(placed.to("flight", wind="calm"))


def _impact(name: str, state: State, _: State) -> list[Number]:
    flying = runner_in(name, state)
    foot = flying.foot()
    return state_of(flying.contact(flying.speed_left(foot.vx, flying.friction * -foot.vy)))


def _leave(name: str, state: State, _: State) -> list[Number]:
    runner = runner_in(name, state)
    return [*state_of(runner.to("flight", wind="calm")), runner.leg().angle]


def _apex(name: str, state: State, _: State) -> list[Number]:
    runner = runner_in(name, state)
    leg = runner.leg()
    return [runner.com_y, runner.com_vx, leg.length, leg.angle, leg.length_rate, leg.angle_rate]


@functools.cache
def _between(law: Callable[[str, State, State], list[Number]], name: str) -> Function:
    return written(law, name, np)


def start(section: State) -> list[Number]:
    """The state in place at an apex."""
    return values_of(_between(_start, "place"), len(FLIGHT), section, ())


def impact(state: State) -> list[Number]:
    """The state after an impact that slips forward."""
    return values_of(_between(_impact, "place"), len(GROUND), state, ())


def leave(state: State) -> list[Number]:
    """The state in flight and the leg's angle, from a state on the ground."""
    return values_of(_between(_leave, "graze"), len(FLIGHT) + 1, state, ())


def apex(state: State) -> list[Number]:
    """Section of an apex: height and speed of the centre of mass, and the leg."""
    return values_of(_between(_apex, "retract"), len(COORDINATES), state, ())
