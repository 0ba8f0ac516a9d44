"""Plain C99 of a page: a header, the motions of its modes, and what is decided and reported at an instant.

Each mode that a run can reach is traced alone, its words being plain Python. What several modes decide or
report by the same text is one function of C.
"""

import re

from .c_text import assigned, c_text, number_text, statements, wrapped, wrapped_text
from .errors import page_error
from .expressions import forget_expressions, lift, symbol
from .motions import InstantVariation, Motion, comment, constants_in_c, lines_of
from .page import PARTS, Page, keys_of
from .tracing import trace

TOP = "/* Derived from the page {name}: edit the page, not this. */\n"
NEXT_LIMIT = 16
GIVEN = {
    "parameters": ("p", "parameters", "const "),
    "states": ("x", "states", "const "),
    "d_parameters": ("dp", "parameters", "const "),
    "d_states": ("dx", "states", "const "),
}
AT, VARIED_AT = "const real *parameters, const real *states", "const real *d_parameters, const real *d_states"
SIGNATURES = {
    "open": ("void", f"{AT}, real *constants"),
    "vary_open": ("void", f"{AT}, {VARIED_AT}, real *constants"),
    "react": ("int", f"{AT}, real *after, const int *next"),
    "vary_react": ("void", f"{AT}, {VARIED_AT}, real *after"),
    "vary_guard": ("real", f"{AT}, {VARIED_AT}"),
    "answer": ("real", AT),
    "leave": ("void", f"{AT}, real noted, real *after"),
    "vary_leave": ("void", f"{AT}, {VARIED_AT}, real noted, real *after"),
    "tell": ("void", f"{AT}, real *told"),
    "vary_tell": ("void", f"{AT}, {VARIED_AT}, real *told"),
    "set": ("void", f"{AT}, real given, real *after"),
    "map": ("void", f"{AT}, real *after"),
    "vary_map": ("void", f"{AT}, {VARIED_AT}, real *after"),
    "scale": ("void", "const real *parameters, real *of_states, real *of_events"),
}
"""What functions of an instant are given, by what they do."""


def c_name(key):
    """The name in C of a mode."""
    return "_".join([key[0], *(str(value).replace("-", "minus_") for _, value in key[1])])


class Functions:
    """Functions of C: each body once, so that modes in which a law reads the same share one."""

    def __init__(self, page_name):
        self.page_name, self.names, self.texts = page_name, {}, []

    def add(self, name, kind, body, about):
        """The name of the function with this body, which is written if it is new."""
        if (kind, body) not in self.names:
            self.names[kind, body] = name
            result, given = SIGNATURES[kind]
            casts = ""
            for argument in re.findall(r"(\w+)(?:,|$)", given):
                variable, what, const = GIVEN.get(argument, ("y", "states", ""))
                if argument == "after" and "y->" in body:
                    casts += f"    {self.page_name}_states *y = (void *)after;\n"
                elif argument in GIVEN and re.search(rf"\b{variable}->", body):
                    casts += f"    {const}{self.page_name}_{what} *{variable} = ({const}void *){argument};\n"
                elif not re.search(rf"\b{argument}\b", body):
                    casts += f"    (void){argument};\n"
            head = wrapped(f"static {result} {name}({given}) {{")
            self.texts.append(f"{comment(about)}{head}\n{casts}{body}}}\n")
        return self.names[kind, body]


def question_in_c(tree, indent="    "):
    """The tree of a page's answers."""
    if not isinstance(tree, tuple):
        return f"{indent}return {c_text(lift(int(tree) if isinstance(tree, bool) else tree))};\n"
    condition, yes, no = tree
    test = f"{c_text(condition.a)} {condition.sign} {c_text(condition.b)}"
    inner = question_in_c(yes, indent + "    ")
    return f"{indent}if ({test}) {{\n{inner}{indent}}}\n{question_in_c(no, indent)}"


def decision_in_c(tree, next_keys, vary, taken=(), names=(), indent="    "):
    """The tree of a decision: `if`s, and at its ends the states that change, or their variations."""
    taken, names = dict(taken), set(names)
    if len(tree) == 3:
        condition, yes, no = tree
        lines = statements([condition.a, condition.b], taken, names, indent)
        test = f"{c_text(condition.a, taken.get)} {condition.sign} {c_text(condition.b, taken.get)}"
        inner = decision_in_c(yes, next_keys, vary, taken, names, indent + "    ")
        outer = decision_in_c(no, next_keys, vary, taken, names, indent)
        return f"{lines}{indent}if ({test}) {{\n{inner}{indent}}}\n{outer}"
    key, changes = tree
    changes = {name: vary.of(value) for name, value in changes.items()} if vary else changes
    lines = statements(list(changes.values()), taken, names, indent)
    lines += "".join(f"{indent}y->{n} = {c_text(v, taken.get)};\n" for n, v in changes.items())
    return lines + (
        f"{indent}return;\n" if vary else f"{indent}return next[{next_keys.index(key)}]; /* {key[0]} */\n"
    )


class Instants:
    """What a page decides and reports at an instant, in C."""

    def __init__(self, page, functions, name):
        self.page, self.functions, self.name = page, functions, name

    def in_c(self, tree):
        """A decision's tree with the states' names in C."""
        if len(tree) == 3:
            return tree[0], self.in_c(tree[1]), self.in_c(tree[2])
        return tree[0], {self.page.c_names[n]: value for n, value in tree[1].items()}

    def guard_row(self, key, event_name):
        """An event as a mode watches it: the row of its table."""
        page, event, of = self.page, self.page.events[event_name], f"{c_name(key)}_{event_name}"
        about = f"{event_name}: {event.__doc__ or ''}"
        tree = self.in_c(page.decide(key, event_name))
        next_keys = keys_of(tree)
        if len(next_keys) > NEXT_LIMIT:
            raise page_error(None, event_name, f"leads to more than {NEXT_LIMIT} modes")
        row = {"event": f"EVENT_{event_name}", "is_noted": str(bool(event.noted)).lower()}
        row["react"] = self.functions.add(f"react_{of}", "react", decision_in_c(tree, next_keys, None), about)
        varied = decision_in_c(tree, next_keys, InstantVariation()).removesuffix("    return;\n")
        row["vary_react"] = self.functions.add(
            f"vary_react_{of}", "vary_react", varied, f"First variation of {event_name}."
        )
        armed = True if event.only is None else page.answer(key, event.only, event_name)
        if armed is not True:
            row["is_watched"] = self.functions.add(
                f"watches_{of}", "answer", question_in_c(armed), f"Whether {event_name} is watched."
            )
        if event.crossing is not None and page.answer(key, event.crossing, event_name) is True:
            row["is_crossing"] = "true"
        forget_expressions()
        d_guard, taken = InstantVariation().of(page.guard(key, event_name)), {}
        body = statements([d_guard], taken, set()) + f"    return {c_text(d_guard, taken.get)};\n"
        row["vary_guard"] = self.functions.add(
            f"vary_guard_{of}", "vary_guard", body, f"First variation of the guard of {event_name}."
        )
        row["next"] = f"{{{', '.join(f'MODE_{c_name(next_key)}' for next_key in next_keys)}}}"
        return row

    def changes(self, key, kind, name, changes, about):
        """A function that writes changed states, and its variation; the names of both, or nothing."""
        if not changes:
            return {}
        named = {self.page.c_names[n]: value for n, value in changes.items()}
        vary, of = InstantVariation(), f"{name}_{c_name(key)}"
        varied = {n: vary.of(value) for n, value in named.items()}
        return {
            name: self.functions.add(of, kind, assigned(named, "y->"), about),
            f"vary_{name}": self.functions.add(
                f"vary_{of}", f"vary_{kind}", assigned(varied, "y->"), f"First variation of {of}."
            ),
        }

    def leaving(self, key):
        """What is written down as an event finds a mode."""
        forget_expressions()
        before = self.page.at(key)
        after = trace(before.leaving, symbol("noted"), name="leaving")
        return self.changes(key, "leave", "leave", self.page.changes(before, after), before.leaving.__doc__)

    def telling(self, key):
        """The outputs in a mode."""
        forget_expressions()
        values = {n: self.page.number(f, key, n, f.unit) for n, f in self.page.outputs.items()}
        told = {f"[OUTPUT_{n}]": value for n, value in values.items()}
        vary, of = InstantVariation(), c_name(key)
        varied = {n: vary.of(value) for n, value in told.items()}
        return {
            "tell": self.functions.add(f"tell_{of}", "tell", assigned(told, "told"), f"Outputs in {of}."),
            "vary_tell": self.functions.add(
                f"vary_tell_{of}", "vary_tell", assigned(varied, "told"), f"First variation of tell_{of}."
            ),
        }

    def longest(self, key):
        """The longest step that the law of a mode allows."""
        function = self.page.modes[key[0]].longest
        answer = function and self.page.answer(key, function, f"longest step of {key[0]}")
        if answer is None:
            return {}
        return {
            "longest": self.functions.add(
                f"longest_{c_name(key)}", "answer", question_in_c(answer), "The longest step."
            )
        }

    def world(self, key):
        """Maps from the mode's states to the world's and back, and the world's rates."""
        page, of = self.page, self.page.modes[key[0]].of
        world_key = next((k for k in page.keys if page.modes[k[0]].of == "world"), None)
        if not world_key or of in (None, "world"):
            return {}
        row = {}
        for name, at, to in (("to_world", key, "world"), ("from_world", world_key, of)):
            forget_expressions()
            before = page.at(at)
            after = trace(before.in_coordinates, to, name=to)
            values = {
                n: lift(value)
                for n, value in after.items()
                if n in page.states and value is not getattr(before, n)
            }
            row |= self.changes(key, "map", name, values, f"{name.replace('_', ' ')}, in {key[0]}.")
        forget_expressions()
        before, rates = page.at(key), page.rates(key)
        moving = InstantVariation()
        moving.found |= {page.symbol_of(n, "x"): rates.get(n, lift(0)) for n in page.states}
        moving.found |= {page.symbol_of(n, "p", True): lift(0) for n in page.parameters}
        world = {
            n: moving.of(lift(value))
            for n, value in trace(before.in_coordinates, "world", name="world").items()
        }
        world = {n: rate for n, rate in world.items() if n in page.states}
        return row | self.changes(
            key, "map", "world_rates", world, f"Rates of the world's states in {key[0]}."
        )

    def setting(self, key, name):
        """What else changes where an importer sets a quantity."""
        forget_expressions()
        function, before = self.page.on_set[name], self.page.at(key)
        quantity = self.page.parameters.get(name) or self.page.states[name]
        after = trace(function, before, symbol("given", constant=True, dimension=quantity.dimension))
        named = {self.page.c_names[n]: v for n, v in self.page.changes(before, after).items()}
        if not named:
            return "NULL"
        return self.functions.add(
            f"set_{name}_{c_name(key)}",
            "set",
            assigned(named, "y->"),
            f"{name} is set: {function.__doc__ or ''}",
        )


def row_in_c(row):
    """A row of a table, by names of its members."""
    return wrapped(f"    {{{', '.join(f'.{name} = {value}' for name, value in row.items())}}},") + "\n"


def list_in_c(kind, name, values):
    """A table of numbers or names."""
    return wrapped(f"static const {kind} {name}[] = {{{', '.join(map(str, values or [0]))}}};") + "\n"


def enumeration(prefix, names):
    """Names for the rows of a table."""
    members = [f"{prefix}_{name}" for name in names] + [f"{prefix}_COUNT"]
    return wrapped(f"enum {{{', '.join(members)}}};") + "\n"


def struct(name, members):
    """A struct of reals with the meaning of each."""
    lines = [f"real {member};{f' /* {about} */' if about else ''}" for member, about in members] or [
        "real none;"
    ]
    return f"typedef struct {{\n{''.join(wrapped('    ' + line) + chr(10) for line in lines)}}} {name};\n"


def text_literal(text):
    """A string of C."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def quantities_in_c(page):
    """Parameters and states: their structs, their names and their defaults."""
    about = {
        n: f"{q.unit}{': ' + q.meaning if q.meaning else ''}".replace("*/", "* /")
        for n, q in [*page.parameters.items(), *page.states.items()]
    }
    structs = [
        struct(f"{page.c}_{kind}", [(page.c_names[n], about[n]) for n in names])
        for kind, names in (("parameters", page.parameters), ("states", page.states))
    ]
    return "\n".join(structs)


def derive(model):
    """The C of a page by file: a header, motions and instants."""
    return derive_with_keys(model)[0]


def derive_with_keys(model):
    """The C of a page by file, and its modes with their words in the order of C."""
    page = Page(model)
    page.c = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", model.__name__).lower()
    functions = Functions(page.c)
    instants, names = Instants(page, functions, page.c), [c_name(key) for key in page.keys]
    header = [
        TOP.format(name=model.__name__)
        + f'#ifndef {page.c.upper()}_H\n#define {page.c.upper()}_H\n\n#include "driver.h"\n',
        enumeration("MODE", names),
        enumeration("EVENT", page.events),
        enumeration("OUTPUT", page.outputs),
        quantities_in_c(page),
    ]
    motions = [TOP.format(name=model.__name__) + f'#include "{page.c}.h"\n']
    motion_rows, mode_rows, tables, motion_tables = "", "", "", ""
    most_series, most_constants = 1, 1
    for key, name in zip(page.keys, names, strict=True):
        m = Motion(page, key, name)
        header.append(m.struct("constants", m.constants))
        about = f"/* ---- {name} */\n\n{comment(m.function.__doc__)}"
        motions += [
            about + "\n".join([*m.c_of_series(), *m.c_of_variation(), *m.c_of_guards(), *m.c_of_bounds()])
        ]
        mode_row = {"motion": f"&{page.c}_motions[MODE_{name}]", "ends": str(m.function.ends).lower()}
        opens = list(constants_in_c(m, functions.add))
        mode_row |= {"open": opens[0], "vary_open": opens[1]}
        tables += f"static const tdmf_guard_kind guards_{name}[] = {{\n"
        tables += (
            "".join(row_in_c(instants.guard_row(key, e)) for e in m.watched) + "    {.event = -1},\n};\n"
        )
        tables += f"static const tdmf_watch_kind watches_{name}[] = {{\n"
        for o in m.observed.values():
            part = PARTS[PARTS.index(o.part)].upper().replace(" ", "_")
            tables += row_in_c({"part": f"TDMF_{part}", "into": list(page.states).index(o.into)})
        tables += "    {.into = -1},\n};\n"
        mode_row |= {
            "guard_count": len(m.watched),
            "guards": f"guards_{name}",
            "watch_count": len(m.observed),
            "watches": f"watches_{name}",
        }
        mode_row |= (
            instants.telling(key) | instants.longest(key) | instants.leaving(key) | instants.world(key)
        )
        mode_rows += row_in_c(mode_row)
        states = list(page.states)
        motion_tables += list_in_c(
            "tdmf_polynomial",
            f"polynomials_{name}",
            [f"guard_{name}_{n}" for n in [*m.watched, *m.observed]] or ["NULL"],
        )
        motion_tables += list_in_c("int", f"moving_{name}", [states.index(n) for n in m.moving])
        for what in ("degrees", "judged", "divisors"):
            motion_tables += list_in_c("int", f"{what}_{name}", getattr(m, what))
        motion_rows += row_in_c(
            {
                "moving_count": len(m.moving),
                "extra_count": len(m.rates) - len(m.moving),
                "moving": f"moving_{name}",
                "degrees": f"degrees_{name}",
                "judged_count": len(m.judged),
                "judged": f"judged_{name}",
                "divisor_count": len(m.divisors),
                "divisors": f"divisors_{name}",
                "polynomials": f"polynomials_{name}",
                "expand": f"expand_{name}",
                "vary": f"vary_{name}",
                "bounds": f"bounds_{name}" if m.has_bounds else "NULL",
            }
        )
        most_series, most_constants = max(most_series, len(m.series)), max(most_constants, len(m.constants))
    motions.append(f"{motion_tables}\nconst tdmf_motion_kind {page.c}_motions[] = {{\n{motion_rows}}};\n")
    set_rows = ""
    for name in page.on_set:
        if name in page.parameters or name in page.states:
            own = [instants.setting(key, name) for key in page.keys]
            tables += list_in_c("tdmf_set", f"set_{name}", own)
            is_state = name in page.states
            index = list(page.states if is_state else page.parameters).index(name)
            set_rows += row_in_c({"is_state": str(is_state).lower(), "index": index, "set": f"set_{name}"})
    forget_expressions()
    scales = {f"of_states[{i}]": page.scale(q.unit) for i, q in enumerate(page.states.values())}
    scales |= {f"of_events[EVENT_{n}]": page.scale(e.unit) for n, e in page.events.items()}
    scale = functions.add(
        "scales",
        "scale",
        assigned(scales, ""),
        "What is large in the unit of each state and of each event's guard.",
    )
    name_rows = [
        list_in_c("char *const", f"{what}_names", [text_literal(n) for n in of])
        for what, of in (
            ("mode", names),
            ("event", page.events),
            ("state", page.states),
            ("parameter", page.parameters),
            ("output", page.outputs),
        )
    ]
    defaults = [
        list_in_c("double", f"{what}_defaults", [number_text(lift(q.value).value) for q in of.values()])
        for what, of in (("parameter", page.parameters), ("state", page.states))
    ]
    model_row = {
        "state_count": len(page.states),
        "parameter_count": len(page.parameters),
        "event_count": len(page.events),
        "mode_count": len(names),
        "output_count": len(page.outputs),
        "modes": "modes",
        "scales": scale,
        "set_count": set_rows.count(".index"),
        "sets": "sets",
        "series_count": most_series,
        "constant_count": most_constants,
        **{f"{what}_names": f"{what}_names" for what in ("mode", "event", "state", "parameter", "output")},
        "parameter_defaults": "parameter_defaults",
        "state_defaults": "state_defaults",
    }
    header.append(
        f"extern const tdmf_motion_kind {page.c}_motions[];\n"
        f"extern const tdmf_model_kind {page.c}_model;\n\n#endif\n"
    )
    rest = [
        TOP.format(name=model.__name__) + f'#include "{page.c}.h"\n',
        *functions.texts,
        tables,
        f"static const tdmf_mode_kind modes[] = {{\n{mode_rows}}};\n",
        f"static const tdmf_set_kind sets[] = {{\n{set_rows}    {{.index = -1}},\n}};\n",
        *name_rows,
        *defaults,
        f"const tdmf_model_kind {page.c}_model = {{\n",
        lines_of(f".{n} = {v}," for n, v in model_row.items()) + "};\n",
    ]
    forget_expressions()
    texts = {f"{page.c}.h": header, f"{page.c}_motions.c": motions, f"{page.c}.c": rest}
    return {name: wrapped_text("\n".join(parts)) for name, parts in texts.items()}, page.keys
