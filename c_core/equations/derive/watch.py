"""Who watches what in a step: the kernel's search for the events of a motion, from the one table.

A guard is watched as a series of the motion. In a motion's own coordinates it is the function of the event's
name in the motion's page, if there is one; else the table's law itself, where what it asks of the runner is a
series of the motion. Either has to be one series, times a constant and plus one. What is more than that, or
is seen more cheaply for several events at once, is by hand in the kernel: `BY_HAND` has the calls.
"""

from collections.abc import Callable
from typing import Any

from .. import flight, ground
from ..events import EVENTS, Event
from .c import c_text, comment
from .expressions import Expression, derivative, forget, lift, number, ordered, symbol, trace

ORIGIN = "/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */"
MODES = {"flight": ("flight",), "ground": ("stick", "slip", "graze")}
PAGES = {"flight": flight, "ground": ground}
# Of which modes of a motion an event may be watched by all, and which flags of the case tell them apart.
CASES = {
    ("flight",): "",
    ("stick", "slip", "graze"): "",
    ("stick", "slip"): "!is.grazes",
    ("stick",): "!is.slips && !is.grazes",
    ("slip",): "is.slips",
    ("graze",): "is.grazes",
}
# Flags of the mode that must be set, or must not, as the lanes have them.
FLAGS = {"not thrusts": "c->awaits_thrust > 0.0", "mid_stance_pending": "c->drives > 0.0"}
# Series that a law of the table may ask for, and whether they go up to the order or to one less.
LEG = {"leg.length": ("length", 0), "leg.length_rate": ("length_rate", 1)}
SERIES = {"flight": LEG, "ground": LEG | {"force.normal": ("normal_force", 1)}}
CONSTANTS = {"slip_sign"}  # of a step, that a page's guard may ask for
SHORTER = {"length_rate", "normal_force", "tangential_push"}  # on the ground
FORCES = ("forces", "watch_forces(search, c, s, !is.slips);")
GRAZE = ("graze", "watch_graze(search, c, s, at->angle);")
HEIGHTS = ("heights", "watch_heights(search, c, s, tolerance, s->length[0] + length_change, com);")
BY_HAND = {
    "flight": {
        "new_ground": (
            "new_ground",
            "if (is.awaits_ground) {watch_new_ground(search, c, s, tolerance, com);}",
        ),
        "body_down": HEIGHTS,
        "touchdown": HEIGHTS,
        "apex": ("apex", "watch_apex(search, c, com, is.rising);"),
        "clamp": ("clamp", "if (is.retracts) {watch_clamp(search, c, s);}"),
    },
    "ground": {
        "mid_stance": ("mid_stance", "watch_mid_stance(search, c, s);"),
        "lift_off": FORCES,
        "slip_onset_positive": FORCES,
        "slip_onset_negative": FORCES,
        "apex": GRAZE,
        "graze_to_contact": GRAZE,
        "graze_to_flight": GRAZE,
    },
}
GIVEN = {
    "flight": "const ballistic *com, flight_case is, real length_change, double tolerance",
    "ground": "const ground_coordinates *at, ground_case is, real length_change",
}


class Runner:
    """What a law of the table is handed: of its members some are series, those of the model constants."""

    def __init__(self, motion: str, path: str = "") -> None:
        self.motion, self.path = motion, path

    def __getattr__(self, name: str) -> Any:
        """Give a member, or a record of members."""
        path = f"{self.path}.{name}".removeprefix(".")
        if path in SERIES[self.motion]:
            return symbol(f"s->{SERIES[self.motion][path][0]}")
        is_leaf = path.startswith("model.parameters.") and path.count(".") > 2
        return parameter(path) if is_leaf else Runner(self.motion, path)


def parameter(path: str) -> Expression:
    """Give a parameter that a guard is made of, as a constant of the step."""
    name = path.removeprefix("model.parameters.").replace(".", "_")
    return symbol(f"c->mode.guards.{name}", constant=True, path=path)


def guard(event: Event, motion: str) -> Expression:
    """Give an event's guard in a motion."""
    forget()
    law: Callable[..., Any] | None = getattr(PAGES[motion], event.name, None)
    if law is None:
        assert event.law, f"{event.name} has no law"
        return lift(trace(event.law, Runner(motion)))
    names = law.__code__.co_varnames[: law.__code__.co_argcount]
    given = (symbol(f"{'cs'[n not in CONSTANTS]}->{n}", constant=n in CONSTANTS) for n in names)
    return lift(trace(law, *given))


def watched(event: Event, motion: str) -> tuple[list[str], str]:
    """Write what watches an event whose guard is one series, times a constant and plus one, and its call."""
    value = guard(event, motion)
    series = [leaf for leaf in ordered([value]) if leaf.operation == "symbol" and not leaf.is_constant]
    factor = derivative(value, {series[0]: number(1)}) if len(series) == 1 else None
    if event.law is None or factor is None or not factor.is_constant:
        raise ValueError(f"{event.name}: give it a function by hand, it is more than a series in {motion}")
    start = c_text(value, lambda node: f"{node.value}[0]" if node is series[0] else None)
    weight = f"real_of({c_text(factor)})" if factor.operation == "number" else c_text(factor)
    order = "search->order - 1" if series[0].name in SHORTER else "search->order"
    band = (
        "TDMF_BEYOND_DEAD_BAND * c->mode.margin_factor" if event.band == "dead" else "search->beyond_margin"
    )
    floor = f"{band} * c->mode.{event.scale}_scale" if event.scale else band
    flag = FLAGS.get(event.only_while, "")
    by_length = series[0].name == "length" and factor.operation == "number" and abs(factor.value) == 1
    near = "not(g.start > length_change)" if by_length else ""
    name = f"watch_{event.name}_{'in' if motion == 'flight' else 'on'}_{motion}"
    more = ", length_change" if by_length else ""
    lines = [
        comment(event.law.__doc__).strip(),
        f"static inline void {name}(event_search *search, const {motion}_constants *c, "
        f"const {motion}_series *s{more.replace(' ', ' real ')}) {{",
        f"const guard_series g = {{s->{series[0].name}, {weight}, {start}, {order}}};",
        f"const choice watching = {' & '.join(filter(None, ['search->live', flag and f'({flag})', near]))};",
        "if (any(watching)) {",
        f"watch(search, TDMF_GUARD_{event.name.upper()}, watching, &g, {floor});",
        "}",
        "}",
        "",
    ]
    return lines, f"{name}(search, c, s{more});"


def by_motion(motion: str) -> list[Event]:
    """Give the events of a motion, in the table's order; what has no reset ends no step."""
    return [e for e in EVENTS if e.takes != "" and set(e.watched) & set(MODES[motion])]


def header(motion: str) -> str:
    """Write who watches what in a motion."""
    functions, calls, done = list[str](), list[str](), set[str]()
    for event in by_motion(motion):
        name, call = BY_HAND[motion].get(event.name, ("", ""))
        if name in done:
            continue
        together = [e for e in by_motion(motion) if name and BY_HAND[motion].get(e.name) == (name, call)]
        modes = {mode for e in together or [event] for mode in e.watched}
        case = CASES[tuple(mode for mode in MODES[motion] if mode in modes)]
        if name:
            done.add(name)
        else:
            lines, call = watched(event, motion)
            functions += lines
        calls += [f"if ({case}) {{", call, "}"] if case else [call]
    macro = f"TDMF_DERIVED_{motion.upper()}_WATCH_H"
    return "\n".join(
        [
            ORIGIN,
            f"#ifndef {macro}",
            f"#define {macro}",
            "",
            f'#include "{motion}_guards.h"',
            "",
            *functions,
            "/* What ends a step, in the order of the table. */",
            f"static inline void watch_{motion}(event_search *search, const {motion}_constants *c, "
            f"const {motion}_series *s, {GIVEN[motion]}) {{",
            *calls,
            "search_pending(search);",
            "}",
            "",
            "#endif",
            "",
        ]
    )


def parameters() -> str:
    """Write the struct of the parameters that guards are made of, and what fills it."""
    found: dict[str, str] = {}
    for motion in MODES:
        for event in by_motion(motion):
            if event.name not in BY_HAND[motion]:
                leaves = [leaf for leaf in ordered([guard(event, motion)]) if "path" in leaf.marks]
                found |= {str(leaf.name): leaf.marks["path"] for leaf in leaves}
    fields = [f"real {name};" for name in found]
    values = [f".{name} = real_of({path.replace('model.', 'model->', 1)})," for name, path in found.items()]
    return "\n".join(
        [
            ORIGIN,
            "#ifndef TDMF_DERIVED_GUARD_PARAMETERS_H",
            "#define TDMF_DERIVED_GUARD_PARAMETERS_H",
            "",
            '#include "tdmf_slip/parameters.h"',
            '#include "width.h"',
            "",
            "/* Parameters that guards are made of. */",
            "typedef struct {",
            *fields,
            "} guard_parameters;",
            "",
            "static inline guard_parameters guard_parameters_of(const tdmf_model *model) {",
            f"const guard_parameters values = {{{' '.join(values)}}};",
            "return values;",
            "}",
            "",
            "#endif",
            "",
        ]
    )


FILES = {
    "guard_parameters.h": parameters,
    "flight_watch.h": lambda: header("flight"),
    "ground_watch.h": lambda: header("ground"),
}
