"""Who watches what in a step: the kernel's search for the events of a motion, from the one table.

A guard is watched as a series of the motion. In a motion's own coordinates it is the function of the event's
name in the motion's page, if there is one; else the table's law itself, where what it asks of the runner is a
series of the motion. Either has to be one series, times a constant and plus one. What is more than that, or
is seen more cheaply for several events at once, is by hand in the kernel: `BY_HAND` has the calls.
"""

from functools import partial
from types import SimpleNamespace as Record

from ..events import EVENTS, Event
from ..in_c import InC
from ..motions import BY_HAND, CASES, FLAGS, GIVEN, MODES, MOTIONS, PARAMETERS
from .c import c_text, comment, header, struct
from .expressions import Expression, begin_anew, derivative, leaves, lift, parameters, replaced
from .motion import series_of, states_of
from .values import Function, symbol

WATCH_ALL = """\
/* What ends a step, in the order of the table. */
static inline void watch_{motion}(event_search *search, const {motion}_constants *c, const {motion}_series *s,
                                  {given}) {{
{calls}search_pending(search);
}}
"""


def guard(event: Event, motion: str) -> tuple[Expression, str]:
    """Give an event's guard in a motion, and the series that it is, but for a factor and its start."""
    begin_anew()
    law = getattr(MOTIONS[motion].page, event.name, None)
    if law is None:
        traced = lift(event.law(symbol("at", pointer=True)))
        value = replaced(traced, {leaf: of_step(leaf.value, motion) for leaf in leaves([traced])})
    else:
        value = lift(law(*(of_step(name, motion) for name in parameters(law))))
    series = [leaf for leaf in leaves([value]) if not leaf.is_constant]
    if len(series) != 1 or not derivative(value, {series[0]: 1}).is_constant:
        raise ValueError(f"{event.name}: give it a function by hand, it is more than a series in {motion}")
    return value, series[0].value


def of_step(text: str, motion: str) -> Expression:
    """Give what a guard asks for, as a step has it: a parameter, a series or a constant of the motion."""
    if text.startswith(PARAMETERS):
        name = text.removeprefix(PARAMETERS).replace(".", "_")
        return symbol(f"c->mode.guards.{name}", constant=True, path=text.removeprefix("at->"))
    name = text.rpartition(".")[2]
    is_series = name in series_of(MOTIONS[motion])
    return symbol(f"s->{name}") if is_series else symbol(f"c->{name}", constant=True)


def watched(event: Event, motion: str) -> str:
    """Write the call that watches an event whose guard is one series."""
    value, series = guard(event, motion)
    factor = derivative(value, {symbol(series): 1})
    start = c_text(value, lambda node: f"{series}[0]" if node.value == series else None)
    watching = "search->live"
    if event.only_while:
        watching += f" & ({FLAGS[event.only_while]})"
    if series == "s->length" and (factor.is_number(1) or factor.is_number(-1)):
        watching += f" & mask_not({start} > length_change)"
    family, name = MOTIONS[motion], series.removeprefix("s->")
    is_whole = name in states_of(family) or name in family.rates.values()
    order = "search->order" if is_whole else "search->order - 1"
    is_dead = event.band == "dead"
    floor = "TDMF_BEYOND_DEAD_BAND * c->mode.margin_factor" if is_dead else "search->beyond_margin"
    floor += f" * c->mode.{event.scale}_scale" if event.scale else ""
    weight = f"broadcast({c_text(factor)})" if factor.operation == "number" else c_text(factor)
    law = comment(event.law.__doc__) if event.law else ""
    row = f"TDMF_GUARD_{event.name.upper()}, {watching}, {series}, {weight}, {start}, {order}, {floor}"
    return f"{law}watch_series(search, {row});\n"


def by_motion(motion: str) -> list[Event]:
    """Give the events of a motion, in the table's order; what has no reset ends no step."""
    return [event for event in EVENTS if event.takes != "" and set(event.watched) & set(MODES[motion])]


def watch(motion: str) -> str:
    """Write who watches what in a motion: each call once, in the modes of all events that it watches."""
    modes: dict[str, set[str]] = {}
    for event in by_motion(motion):
        by_hand = BY_HAND[motion].get(event.name)
        call = f"{by_hand}\n" if by_hand else watched(event, motion)
        modes.setdefault(call, set()).update(event.watched)
    cases = {call: CASES.get(tuple(m for m in MODES[motion] if m in modes[call])) for call in modes}
    calls = "".join(f"if ({case}) {{\n{call}}}\n" if case else call for call, case in cases.items())
    text = WATCH_ALL.format(motion=motion, given=GIVEN[motion], calls=calls)
    return header(f"{motion}_watch", "events.py", f'#include "{motion}_guards.h"\n', text)


def guard_parameters() -> str:
    """Write the struct of the parameters that guards are made of, and what fills it."""
    found: dict[str, str] = {}
    for motion in MODES:
        for event in (event for event in by_motion(motion) if event.name not in BY_HAND[motion]):
            asked = [leaf for leaf in leaves([guard(event, motion)[0]]) if "path" in leaf.marks]
            found |= {leaf.value.rpartition(".")[2]: leaf.marks["path"] for leaf in asked}

    def law(model: Expression) -> Record:
        """Parameters that guards are made of."""
        return Record(**{name: Expression("broadcast", symbol(path)) for name, path in found.items()})

    row = InC("guard_parameters guard_parameters_of", law, varied=False)
    includes = '#include "tdmf_slip/parameters.h"\n#include "width.h"\n'
    filled = struct("What guards are made of, in any width.", "guard_parameters", found, "real")
    return header("guard_parameters", "events.py", includes, filled, Function(row).c())


FILES = {"guard_parameters.h": guard_parameters}
FILES |= {f"{motion}_watch.h": partial(watch, motion) for motion in MODES}
