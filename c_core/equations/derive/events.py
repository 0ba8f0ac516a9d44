"""The table of events in C: what announces each, what takes it, and who watches it in what order."""

from ..events import ALL, EVENTS, Event
from .c import header

BANDS = {
    "": "TDMF_GUARD_MARGIN",
    "dead": "TDMF_DEAD_BAND",
    "apex": "(at->mode->rises ? TDMF_APEX_MARGIN : TDMF_DEAD_BAND)",
}
CONTACTS = {
    "flight": ["FLIGHT"],
    "stick": ["STICK"],
    "slip": ["SLIP_POSITIVE", "SLIP_NEGATIVE"],
    "graze": ["GRAZE"],
}
# Of the functions of a row, by the row's members.
SIGNATURES = {
    "reset": "void {}(tdmf_run *run)",
    "vary_reset": "void {}(const tdmf_model *model, const tdmf_inputs *inputs, "
    "const tdmf_ground_line *ground, const double before[TDMF_STATE_COUNT], "
    "const tdmf_direction *d, double d_state[TDMF_STATE_COUNT])",
    "guard": "double {}(const tdmf_evaluation *at)",
    "vary_guard": "double {}(const tdmf_evaluation *at, const tdmf_evaluation *d)",
}
VARY_JUMP = """\
double d_before[TDMF_STATE_COUNT];
memcpy(d_before, d_state, sizeof d_before);
tdmf_vary_{name}_jump(model, inputs, ground, before, tdmf_leg_direction_of(before), &d->model, &d->inputs,
                      &d->mode.ground, d_before, d_state);"""
TABLE = """\
#include <string.h>

{functions}
static const tdmf_event_kind kinds[TDMF_GUARD_COUNT] = {{
{rows}}};

/* In the order in which they are taken at one instant. */
{lists}
#define END(events) ((events) + sizeof(events) / sizeof((events)[0]))
#define LIST(events, observed) {{events, END(events) - (observed), END(events)}}

static const watch_list watched_by[] = {{
{watched_by}}};
"""


def functions_of(event: Event) -> dict[str, str]:
    """Name the C functions of an event's row; those that begin with tdmf_take and tdmf_armed are by hand."""
    name, by_hand = event.name, event.band == "by hand"
    found = {"guard": f"tdmf_armed_{name}" if by_hand else f"armed_{name}"}
    if event.varied:
        derived = f"vary_{name}" if event.arguments else f"tdmf_vary_{name}_guard"
        found["vary_guard"] = f"tdmf_vary_armed_{name}" if by_hand or event.varied == "by hand" else derived
    if event.takes != "":
        found["reset"] = f"tdmf_take_{event.takes or name}"
    if event.jump:
        found["vary_reset"] = f"tdmf_vary_take_{name}" if event.jump == "by hand" else f"vary_take_{name}"
    return found


def declarations() -> str:
    """Declare what is written by hand: resets, changes of states that jump, and some guards."""
    named = [(member, functions_of(event).get(member, "")) for member in SIGNATURES for event in EVENTS]
    by_hand = [(member, name) for member, name in named if "_take_" in name or "_armed_" in name]
    lines = [f"{SIGNATURES[member].format(name)};\n" for member, name in by_hand if name.startswith("tdmf_")]
    return header("event_declarations", "events.py", '#include "events.h"\n', "".join(dict.fromkeys(lines)))


def armed(event: Event) -> str:
    """Write an armed guard, a pure number that is positive while the event is to come."""
    arguments = ", ".join(["at", *(text for _, text in event.arguments)])
    value = f"tdmf_{event.name}_guard({arguments})"
    if event.slack:
        value = f"({value} + {event.slack})"
    scale = f"at->model->scales.{event.scale}"
    scaled = f"{value} / {f'({scale} * {event.width})' if event.width else scale}" if event.scale else value
    text = f"{scaled} + {BANDS[event.band]}"
    if event.only_while:
        flag = event.only_while.removeprefix("not ")
        wait = "!" if event.only_while == flag else ""
        text = f"{wait}at->mode->{flag} ? 1.0 : {text}"
    return f"return {text};"


def functions(event: Event) -> str:
    """Write the functions of a row that are derived here."""
    names = functions_of(event)
    arguments = ", ".join(["at", *(text for _, text in event.arguments), "d"])
    texts = {"guard": armed(event)} if event.band != "by hand" else {}
    if names.get("vary_guard") == f"vary_{event.name}":
        texts["vary_guard"] = f"return tdmf_vary_{event.name}_guard({arguments});"
    if callable(event.jump):
        texts["vary_reset"] = VARY_JUMP.format(name=event.name)
    written = [f"static {SIGNATURES[m].format(names[m])} {{\n{text}\n}}\n" for m, text in texts.items()]
    return "\n".join([*written, ""])


def row(event: Event) -> str:
    """Write an event's row."""
    members = functions_of(event)
    if event.takes != "":
        members["reach"] = f"TDMF_REACH_WITHIN_{'MARGIN' if event.reach == 'margin' else 'DEAD_BAND'}"
    if event.is_impact:
        members["is_impact"] = "true"
    told = ", ".join(f".{member} = {text}" for member, text in members.items())
    return f"[TDMF_GUARD_{event.name.upper()}] = {{{told}}},\n"


def watch_list(contact: str) -> str:
    """Write what a contact mode watches, and how many of that have no reset, which come last."""
    rows = []
    observed = [event for event in EVENTS if event.takes == "" and contact in event.watched]
    for event in [event for event in EVENTS if event not in observed] + observed:
        phases = event.watched.get(contact, ())
        if phases:
            bits = "ALWAYS" if phases == ALL else " | ".join(phase.upper() for phase in phases)
            rows.append(f"{{TDMF_GUARD_{event.name.upper()}, {bits}}},\n")
    return (
        f"static const watched in_{contact}[] = {{\n{''.join(rows)}}};\n"
        f"enum {{ OBSERVED_IN_{contact.upper()} = {len(observed)} }};\n"
    )


def table() -> str:
    """Write the table."""
    by_mode = [(mode, contact) for contact, modes in CONTACTS.items() for mode in modes]
    lists = [f"[TDMF_CONTACT_{m}] = LIST(in_{c}, OBSERVED_IN_{c.upper()}),\n" for m, c in by_mode]
    text = TABLE.format(
        functions="".join(map(functions, EVENTS)),
        rows="".join(map(row, EVENTS)),
        lists="\n".join(map(watch_list, CONTACTS)),
        watched_by="".join(lists),
    )
    includes = ("event_declarations.h", "friction_laws.h", "guard_laws.h")
    return header("event_table", "events.py", "".join(f'#include "{name}"\n' for name in includes), text)
