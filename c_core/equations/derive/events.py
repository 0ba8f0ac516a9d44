"""The table of events in C: what announces each, what takes it, and who watches it in what order."""

from functools import partial, update_wrapper
from typing import Any

from ..events import ALL, BANDS, BY_HAND, CONTACTS, EVENTS, Event
from .c import header
from .values import Function, symbol

TABLE = """\
static const tdmf_event_kind kinds[TDMF_GUARD_COUNT] = {{
{rows}}};

/* In the order in which they are taken at one instant. */
{lists}
#define END(events) ((events) + sizeof(events) / sizeof((events)[0]))
#define LIST(events, observed) {{events, END(events) - (observed), END(events)}}

static const watch_list watched_by[] = {{
{watched_by}}};
"""


def by_hand(event: Event) -> dict[str, str]:
    """Name the events of whose functions this one has some, by the members of its row."""
    found = {"reset": event.takes or event.name} if event.takes != "" else {}
    found |= {"vary_reset": event.name} if event.jumps else {}
    found |= {"guard": event.name} if event.band == "by hand" else {}
    is_varied = event.varied == "by hand" or (event.varied and "guard" in found)
    return found | ({"vary_guard": event.name} if is_varied else {})


def declarations() -> str:
    """Declare what is written by hand: resets, changes of states that jump, and some guards."""
    lines = [
        f"{declared.format(by_hand(event)[member])};\n"
        for member, declared in BY_HAND.items()
        for event in EVENTS
        if member in by_hand(event)
    ]
    return header("event_declarations", "events.py", '#include "events.h"\n', "".join(dict.fromkeys(lines)))


def armed(event: Event, at: Any, *arguments: Any) -> Any:
    """Give an armed guard, a pure number that is positive while the event is to come."""
    if event.only_while:
        flag = event.only_while.removeprefix("not ")
        if bool(getattr(at.mode, flag)) != (flag == event.only_while):
            return 1
    assert event.law
    value = event.law(at, *arguments)
    if event.band == "by hand":
        return value
    value = value + symbol(event.slack) if event.slack else value
    scale = getattr(at.model.scales, event.scale) if event.scale else 1
    scale = scale * symbol(event.width) if event.width else scale
    is_dead = event.band == "apex" and not at.mode.rises
    return value / scale + symbol(BANDS["dead" if is_dead else event.band])


def guards(types: dict[str, str]) -> str:
    """Write all guards that are laws, and the changes of these, up to their scale."""
    parts = []
    for event in (event for event in EVENTS if event.law is not None):
        handed = {"at": types["at"]}
        told = [symbol(text, constant=True, word=name) for name, text in event.arguments]
        if event.band == "by hand":
            handed, told = handed | {name: types[name] for name, _ in event.arguments}, []
        arguments = partial(lambda told, *given: (*given, *told), told)
        law = update_wrapper(partial(armed, event), event.law)
        parts.append(Function("double", f"{event.name}_guard", handed, law, arguments).c_of_value())
        if event.varied:
            parts.append(
                Function("double", f"{event.name}_guard", handed, event.law, arguments).c_of_change()
            )
    includes = '#include "evaluation.h"\n#include "friction_laws.h"\n\n#include <math.h>\n'
    return header("guard_laws", "events.py", includes, *parts)


def row(event: Event) -> str:
    """Write an event's row."""
    members = {"guard": f"tdmf_{event.name}_guard"}
    members |= {"vary_guard": f"tdmf_vary_{event.name}_guard"} if event.varied else {}
    for member, name in by_hand(event).items():
        members[member] = BY_HAND[member].partition("(")[0].split()[-1].format(name)
    if event.takes != "":
        members["reach"] = f"TDMF_REACH_WITHIN_{'MARGIN' if event.reach == 'margin' else 'DEAD_BAND'}"
    members |= {"is_impact": "true"} if event.is_impact else {}
    told = ", ".join(f".{member} = {text}" for member, text in members.items())
    return f"[TDMF_GUARD_{event.name.upper()}] = {{{told}}},\n"


def watch_list(contact: str) -> str:
    """Write what a contact mode watches, and how many of that have no reset, which come last."""
    watched = sorted(
        (event for event in EVENTS if contact in event.watched), key=lambda event: event.takes == ""
    )
    rows = []
    for event in watched:
        phases = event.watched[contact]
        bits = "ALWAYS" if phases == ALL else " | ".join(phase.upper() for phase in phases)
        rows.append(f"{{TDMF_GUARD_{event.name.upper()}, {bits}}},\n")
    observed = sum(event.takes == "" for event in watched)
    return (
        f"static const watched in_{contact}[] = {{\n{''.join(rows)}}};\n"
        f"enum {{ OBSERVED_IN_{contact.upper()} = {observed} }};\n"
    )


def table() -> str:
    """Write the table."""
    by_mode = [(mode, contact) for contact, modes in CONTACTS.items() for mode in modes]
    lists = [f"[TDMF_CONTACT_{m}] = LIST(in_{c}, OBSERVED_IN_{c.upper()}),\n" for m, c in by_mode]
    text = TABLE.format(
        rows="".join(map(row, EVENTS)),
        lists="\n".join(map(watch_list, CONTACTS)),
        watched_by="".join(lists),
    )
    return header(
        "event_table", "events.py", '#include "event_declarations.h"\n#include "guard_laws.h"\n', text
    )
