"""The table of events in C: what announces each, what takes it, and who watches it in what order."""

from collections.abc import Callable
from operator import attrgetter
from typing import Any

from ..events import ALL, BANDS, BY_HAND, CONTACTS, EVENTS, Event
from ..in_c import InC
from .c import header
from .values import Function, symbol

TABLE = """\
static const event_kind kinds[TDMF_GUARD_COUNT] = {{
{rows}}};

/* In the order in which they are taken at one instant. */
{lists}
#define END(events) ((events) + sizeof(events) / sizeof((events)[0]))
#define LIST(contact) {{in_##contact, END(in_##contact), first_due_in_##contact}}

static const watch_list watched_by[] = {{
{watched_by}}};
"""

WATCHED = """\
static const watched in_{contact}[] = {{
{rows}}};

static tdmf_guard first_due_in_{contact}(const tdmf_evaluation *at, int phase) {{
(void)phase;
{looks}return TDMF_GUARD_COUNT;
}}
"""


def by_hand(event: Event) -> dict[str, str]:
    """Declare the functions of C that an event's row has, and that are written by hand, by its members."""
    found = {"reset": event.takes or event.name} if event.takes != "" else {}
    found |= {"guard": event.name} if event.band == "by hand" else {}
    return {member: BY_HAND[member].format(name) for member, name in found.items()}


def declarations() -> str:
    """Declare what is written by hand: resets and some guards."""
    declared = [by_hand(event).get(member) for member in BY_HAND for event in EVENTS]
    lines = "".join(f"{line};\n" for line in dict.fromkeys(declared) if line)
    return header("event_declarations", "events.py", '#include "events.h"\n', lines)


def armed(event: Event) -> Callable[..., Any]:
    """Give an armed guard, a pure number that is positive while the event is to come."""

    def guard(at: Any, *arguments: Any) -> Any:
        if event.only_while:
            flag = event.only_while.removeprefix("not ")
            if bool(attrgetter(flag)(at)) != (flag == event.only_while):
                return 1
        assert event.law
        value = event.law(at, *arguments)
        value = value + symbol(event.slack) if event.slack else value
        scale = getattr(at.model.scales, event.scale) if event.scale else 1
        scale = scale * event.width(at, *arguments) if event.width else scale
        is_dead = event.band == "apex" and not at.mode.rises
        return value / scale + symbol(BANDS["dead" if is_dead else event.band])

    guard.__doc__ = event.law.__doc__
    return guard


def guards() -> str:
    """Write all guards that are laws."""
    parts = []
    for event in (event for event in EVENTS if event.law is not None):
        arguments = [symbol(text, constant=True, word=name) for name, text in event.arguments]
        call = None if event.band == "by hand" else lambda at, *, arguments=arguments: (at, *arguments)
        declared = f"double {event.name}_guard"
        law = event.law if event.band == "by hand" else armed(event)
        parts.append(Function(InC(declared, law, call)).c_of_value())
    includes = '#include "evaluation.h"\n#include "friction_laws.h"\n\n#include <math.h>\n'
    return header("guard_laws", "events.py", includes, *parts)


def functions_of(event: Event) -> dict[str, str]:
    """Name an event's functions, by the members of its row."""
    members = {"guard": f"tdmf_{event.name}_guard"}
    return members | {m: text.partition("(")[0].split()[-1] for m, text in by_hand(event).items()}


def row(event: Event) -> str:
    """Write an event's row."""
    arguments = ", ".join(f".{member} = {text}" for member, text in functions_of(event).items())
    return f"[TDMF_GUARD_{event.name.upper()}] = {{{arguments}}},\n"


def look(event: Event, guard: str, phases: str) -> str:
    """Write how an event is looked at: whether it is watched, and due."""
    watched = "" if phases == "ALWAYS" else f"(phase & ({phases})) != 0 && "
    due = f"{functions_of(event)['guard']}(at) <= 0.0"
    return f"if ({watched}{due}) {{\nreturn {guard};\n}}\n"


def watch_list(contact: str) -> str:
    """Write what a contact mode watches, and who looks in that order for the first transition that is due."""
    rows, looks = [], []
    for event in (event for event in EVENTS if contact in event.watched):
        phases = event.watched[contact]
        bits = "ALWAYS" if phases == ALL else " | ".join(phase.upper() for phase in phases)
        guard = f"TDMF_GUARD_{event.name.upper()}"
        rows.append(f"{{{guard}, {bits}}},\n")
        looks += [look(event, guard, bits)] if event.takes != "" else []
    return WATCHED.format(contact=contact, rows="".join(rows), looks="".join(looks))


def table() -> str:
    """Write the table."""
    lists = [f"[TDMF_CONTACT_{mode}] = LIST({c}),\n" for c, modes in CONTACTS.items() for mode in modes]
    text = TABLE.format(
        rows="".join(map(row, EVENTS)),
        lists="\n".join(map(watch_list, CONTACTS)),
        watched_by="".join(lists),
    )
    return header(
        "event_table", "events.py", '#include "event_declarations.h"\n#include "guard_laws.h"\n', text
    )


FILES = {"event_declarations.h": declarations, "event_table.h": table, "guard_laws.h": guards}
