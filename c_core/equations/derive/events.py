"""The table of events in C: what announces each, what takes it, and who watches it in what order."""

from ..events import ALL, EVENTS, Event

BANDS = {
    "": "TDMF_GUARD_MARGIN",
    "dead": "TDMF_DEAD_BAND",
    "apex": "(at->mode->rises ? TDMF_APEX_MARGIN : TDMF_DEAD_BAND)",
}
REACHES = {"margin": "TDMF_REACH_WITHIN_MARGIN", "dead": "TDMF_REACH_WITHIN_DEAD_BAND"}
CONTACTS = {
    "flight": ["FLIGHT"],
    "stick": ["STICK"],
    "slip": ["SLIP_POSITIVE", "SLIP_NEGATIVE"],
    "graze": ["GRAZE"],
}
ORIGIN = "/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */\n"


JUMP_CHANGE = (
    "const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground, "
    "const double before[TDMF_STATE_COUNT], const tdmf_direction *d, double d_state[TDMF_STATE_COUNT]"
)


def taken_by(event: Event) -> str:
    """Name the C function of an event's reset."""
    return "NULL" if event.takes == "" else f"tdmf_take_{event.takes or event.name}"


def is_varied_by_hand(event: Event) -> bool:
    """Whether C has the change of an event's guard."""
    return event.varied == "by hand" or bool(event.band == "by hand" and event.varied)


def declarations() -> str:
    """Declare what is written by hand: resets, changes of states that jump, and some guards."""
    takes = dict.fromkeys(taken_by(event) for event in EVENTS if event.takes != "")
    lines = [f"void {name}(tdmf_run *run);" for name in takes]
    lines += [f"void {jump_change_of(event)}({JUMP_CHANGE});" for event in EVENTS if event.jump == "by hand"]
    lines += [
        f"double tdmf_armed_{e.name}(const tdmf_evaluation *at);" for e in EVENTS if e.band == "by hand"
    ]
    lines += [
        f"double tdmf_vary_armed_{e.name}(const tdmf_evaluation *at, const tdmf_evaluation *d);"
        for e in EVENTS
        if is_varied_by_hand(e)
    ]
    guard = "TDMF_DERIVED_EVENT_DECLARATIONS_H"
    opening = f'#ifndef {guard}\n#define {guard}\n\n#include "events.h"\n\n'
    return ORIGIN + opening + "\n".join(lines) + "\n\n#endif\n"


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
    return f"static double armed_{event.name}(const tdmf_evaluation *at) {{\nreturn {text};\n}}\n"


def varied(event: Event) -> str:
    """Write the change of a guard that has further arguments."""
    arguments = ", ".join(["at", *(text for _, text in event.arguments), "d"])
    return (
        f"static double vary_{event.name}(const tdmf_evaluation *at, const tdmf_evaluation *d) {{\n"
        f"return tdmf_vary_{event.name}_guard({arguments});\n}}\n"
    )


def change_of(event: Event) -> str:
    """Name the C function of the change of an event's guard."""
    if is_varied_by_hand(event):
        return f"tdmf_vary_armed_{event.name}"
    return f"vary_{event.name}" if event.arguments else f"tdmf_vary_{event.name}_guard"


def jump_change_of(event: Event) -> str:
    """Name the C function of what an event's jump makes of a change of the state."""
    return f"{'tdmf_' * (event.jump == 'by hand')}vary_take_{event.name}"


def varied_jump(event: Event) -> str:
    """Write what a jump that is a law makes of a change of the state."""
    return (
        f"static void {jump_change_of(event)}({JUMP_CHANGE}) {{\ndouble d_before[TDMF_STATE_COUNT];\n"
        "memcpy(d_before, d_state, sizeof d_before);\n"
        f"tdmf_vary_{event.name}_jump(model, inputs, ground, before, tdmf_leg_direction_of(before), "
        "&d->model, &d->inputs, &d->mode.ground, d_before, d_state);\n}\n"
    )


def row(event: Event) -> str:
    """Write an event's row."""
    by_hand = event.band == "by hand"
    members = [
        f".guard = {'tdmf_armed_' if by_hand else 'armed_'}{event.name}",
        *([f".vary_guard = {change_of(event)}"] if event.varied else []),
        *([f".reset = {taken_by(event)}"] if event.takes != "" else []),
        *([f".reach = {REACHES[event.reach]}"] if event.takes != "" else []),
        *([f".vary_reset = {jump_change_of(event)}"] if event.jump else []),
        *([".is_impact = true"] if event.is_impact else []),
    ]
    return f"[TDMF_GUARD_{event.name.upper()}] = {{{', '.join(members)}}},\n"


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
    by_table = [event for event in EVENTS if event.band != "by hand"]
    watched_by = "".join(
        f"[TDMF_CONTACT_{mode}] = LIST(in_{contact}, OBSERVED_IN_{contact.upper()}),\n"
        for contact, modes in CONTACTS.items()
        for mode in modes
    )
    return "\n".join(
        [
            ORIGIN,
            '#include "event_declarations.h"\n#include "friction_laws.h"\n#include "guard_laws.h"\n',
            "#include <string.h>\n",
            *(armed(event) for event in by_table),
            *(varied(event) for event in by_table if event.varied is True and event.arguments),
            *(varied_jump(event) for event in EVENTS if callable(event.jump)),
            "static const tdmf_event_kind kinds[TDMF_GUARD_COUNT] = {\n" + "".join(map(row, EVENTS)) + "};\n",
            "/* In the order in which they are taken at one instant. */",
            *(watch_list(contact) for contact in CONTACTS),
            "#define END(events) ((events) + sizeof(events) / sizeof((events)[0]))\n"
            "#define LIST(events, observed) {events, END(events) - (observed), END(events)}\n",
            "static const watch_list watched_by[] = {\n" + watched_by + "};\n",
        ]
    )
