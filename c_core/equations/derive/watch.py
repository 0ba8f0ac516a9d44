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
from .c import c_text, comment, header, struct
from .expressions import Expression, derivative, forget, leaves, lift, symbol, trace

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
FORCES = "watch_forces(search, c, s, !is.slips);"
GRAZE = "watch_graze(search, c, s, at->angle);"
HEIGHTS = "watch_heights(search, c, s, tolerance, s->length[0] + length_change, com);"
# Calls of what is by hand, of which one may watch several events.
BY_HAND = {
    "flight": {
        "new_ground": "if (is.awaits_ground) {watch_new_ground(search, c, s, tolerance, com);}",
        "body_down": HEIGHTS,
        "touchdown": HEIGHTS,
        "apex": "watch_apex(search, c, com, is.rising);",
        "clamp": "if (is.retracts) {watch_clamp(search, c, s);}",
    },
    "ground": {
        "mid_stance": "watch_mid_stance(search, c, s);",
        **dict.fromkeys(("lift_off", "slip_onset_positive", "slip_onset_negative"), FORCES),
        **dict.fromkeys(("apex", "graze_to_contact", "graze_to_flight"), GRAZE),
    },
}
GIVEN = {
    "flight": "const ballistic *com, flight_case is, real length_change, double tolerance",
    "ground": "const ground_coordinates *at, ground_case is, real length_change",
}

WATCH = """\
{what}static inline void {name}(event_search *search, const {motion}_constants *c,
                          const {motion}_series *s{given}) {{
    const guard_series g = {{s->{series}, {weight}, {start}, {order}}};
    const mask watching = {watching};
    if (any(watching)) {{
        watch(search, TDMF_GUARD_{guard}, watching, &g, {floor});
    }}
}}
"""
WATCH_ALL = """\
/* What ends a step, in the order of the table. */
static inline void watch_{motion}(event_search *search, const {motion}_constants *c, const {motion}_series *s,
                                  {given}) {{
{calls}search_pending(search);
}}
"""
PARAMETERS = """\
/* Parameters that guards are made of. */
{struct}
static inline guard_parameters guard_parameters_of(const tdmf_model *model) {{
    const guard_parameters values = {{{values}}};
    return values;
}}
"""


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


def watched(event: Event, motion: str) -> tuple[str, str]:
    """Write what watches an event whose guard is one series, times a constant and plus one, and its call."""
    value = guard(event, motion)
    series = [leaf for leaf in leaves([value]) if not leaf.is_constant]
    factor = derivative(value, {series[0]: 1}) if len(series) == 1 else None
    if event.law is None or factor is None or not factor.is_constant:
        raise ValueError(f"{event.name}: give it a function by hand, it is more than a series in {motion}")
    dead = "TDMF_BEYOND_DEAD_BAND * c->mode.margin_factor"
    band = dead if event.band == "dead" else "search->beyond_margin"
    flag = FLAGS.get(event.only_while, "")
    by_length = series[0].name == "length" and (factor.is_number(1) or factor.is_number(-1))
    near = "mask_not(g.start > length_change)" if by_length else ""
    name = f"watch_{event.name}_{'in' if motion == 'flight' else 'on'}_{motion}"
    text = WATCH.format(
        what=comment(event.law.__doc__),
        name=name,
        motion=motion,
        given=", real length_change" if by_length else "",
        series=series[0].name,
        weight=f"broadcast({c_text(factor)})" if factor.operation == "number" else c_text(factor),
        start=c_text(value, lambda node: f"{node.value}[0]" if node is series[0] else None),
        order="search->order - 1" if series[0].name in SHORTER else "search->order",
        watching=" & ".join(filter(None, ["search->live", flag and f"({flag})", near])),
        guard=event.name.upper(),
        floor=f"{band} * c->mode.{event.scale}_scale" if event.scale else band,
    )
    return text, f"{name}(search, c, s{', length_change' if by_length else ''});\n"


def by_motion(motion: str) -> list[Event]:
    """Give the events of a motion, in the table's order; what has no reset ends no step."""
    return [e for e in EVENTS if e.takes != "" and set(e.watched) & set(MODES[motion])]


def watch(motion: str) -> str:
    """Write who watches what in a motion: functions, and the calls of all, each once."""
    functions, calls = list[str](), dict[str, str]()
    for event in by_motion(motion):
        together = [e for e in by_motion(motion) if e is event or shares(e, event, motion)]
        modes = {mode for e in together for mode in e.watched}
        case = CASES[tuple(mode for mode in MODES[motion] if mode in modes)]
        if event.name in BY_HAND[motion]:
            call = BY_HAND[motion][event.name] + "\n"
        else:
            function, call = watched(event, motion)
            functions.append(function)
        calls[call] = f"if ({case}) {{\n{call}}}\n" if case else call
    text = WATCH_ALL.format(motion=motion, given=GIVEN[motion], calls="".join(calls.values()))
    return header(f"{motion}_watch", "events.py", f'#include "{motion}_guards.h"\n', *functions, text)


def shares(event: Event, other: Event, motion: str) -> bool:
    """Whether one function by hand watches both."""
    calls = [BY_HAND[motion].get(e.name) for e in (event, other)]
    return calls[0] is not None and calls[0] == calls[1]


def parameters() -> str:
    """Write the struct of the parameters that guards are made of, and what fills it."""
    found: dict[str, str] = {}
    for motion in MODES:
        for event in by_motion(motion):
            if event.name not in BY_HAND[motion]:
                given = [leaf for leaf in leaves([guard(event, motion)]) if "path" in leaf.marks]
                found |= {str(leaf.name): leaf.marks["path"] for leaf in given}
    values = [f".{name} = broadcast({path.replace('model.', 'model->', 1)})," for name, path in found.items()]
    text = PARAMETERS.format(struct=struct("guard_parameters", found, "real"), values=" ".join(values))
    includes = '#include "tdmf_slip/parameters.h"\n#include "width.h"\n'
    return header("guard_parameters", "events.py", includes, text)


FILES = {
    "guard_parameters.h": parameters,
    "flight_watch.h": lambda: watch("flight"),
    "ground_watch.h": lambda: watch("ground"),
}
