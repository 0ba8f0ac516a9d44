"""Functions of an instant in C: constants of modes, decisions, outputs, maps, and jumps of quantities."""

import re
from collections import Counter
from types import SimpleNamespace

from .c_text import assigned, c_text, function_in_c, lines_of, statements, uses_of
from .errors import page_error
from .expressions import forget_expressions, lift, ordered, symbol
from .limits import LIMITS
from .motions import InstantVariation
from .page import keys_of
from .tables import c_boolean, list_in_c, row_in_c, rows_in_c
from .tracing import trace

GIVEN = {
    "parameters": ("p", "parameters", "const "),
    "states": ("x", "states", "const "),
    "d_parameters": ("dp", "parameters", "const "),
    "d_states": ("dx", "states", "const "),
    "after": ("y", "states", ""),
}
AT, VARIED_AT = "const real *parameters, const real *states", "const real *d_parameters, const real *d_states"
SIGNATURES = {
    "react": ("int", f"{AT}, const tdmf_table *tables, real *after, const int *next"),
    "vary_react": ("void", f"{AT}, {VARIED_AT}, const tdmf_table *tables, int seed, real *after"),
    "vary_guard": ("real", f"{AT}, {VARIED_AT}"),
    "answer": ("real", AT),
    "set": ("void", f"{AT}, real given, real *after"),
    "scale": ("void", "const real *parameters, real *of_states, real *of_events"),
}
"""Result and arguments of functions of an instant, by kind."""
for _vary, _given in (("", ""), ("vary_", f", {VARIED_AT}")):
    _point = "const real *at, const real *d_at" if _vary else "const real *at"
    SIGNATURES[f"{_vary}enter"] = "void", f"{AT}{_given}, {_point}, real *after"
LEAVE = "real counted, real *after"
WRITTEN = {"open": "real *constants", "leave": LEAVE, "outputs": "real *outputs", "map": "real *after"}
for _kind, _into in WRITTEN.items():
    SIGNATURES[_kind] = "void", f"{AT}, {_into}"
    SIGNATURES[f"vary_{_kind}"] = "void", f"{AT}, {VARIED_AT}, {_into}"


def c_name(key):
    """The name in C of a mode, in which the value of a word may have any characters."""
    words = "_".join([key[0], *(str(value).replace("-", "minus_") for _, value in key[1])])
    return re.sub(r"\W", lambda at: f"_{ord(at[0]):x}", words, flags=re.ASCII)


class Functions:
    """Functions of C. Each body is written once: modes whose bodies are equal share one function."""

    def __init__(self, page_name):
        self.names, self.texts = {}, []
        self.structs = {a: (v, f"{page_name}_{struct}", const) for a, (v, struct, const) in GIVEN.items()}

    def add(self, name, kind, body, about):
        """The name of the function with this body, which is written if it is new."""
        if (kind, body) not in self.names:
            self.names[kind, body] = name
            result, given = SIGNATURES[kind]
            self.texts.append(function_in_c(result, name, given, body, about, self.structs))
        return self.names[kind, body]

    def add_with_variation(self, name, kind, values, about, of, begin=lambda body: "", into="y->"):
        """Functions that write values and their first variations, by their members in a table.

        `begin` gives the statements with which a body begins.
        """
        vary = InstantVariation()
        varied = {n: vary.of(value) for n, value in values.items()}
        bodies = [assigned(written, into) for written in (values, varied)]
        value, variation = (begin(body) + body for body in bodies)
        own, about = self.add(of, kind, value, about), f"First variation of {of}."
        return {name: own, f"vary_{name}": self.add(f"vary_{of}", f"vary_{kind}", variation, about)}


def merged(tree, leaf_of):
    """A tree of answers with leaves (values, result), in which branches that are equal are one.

    A branch asks for conditions (sign, a, b): for all of one list among several lists.
    """
    if not (isinstance(tree, tuple) and len(tree) == 3):
        return leaf_of(tree)
    condition, yes, no = tree[0], merged(tree[1], leaf_of), merged(tree[2], leaf_of)
    asked = [[(condition.sign, condition.a, condition.b)]]
    if yes == no:
        return yes
    if len(no) == 3 and yes == no[1]:
        return asked + no[0], yes, no[2]
    if len(yes) == 3 and no == yes[2] and len(yes[0]) == 1:
        return [asked[0] + yes[0][0]], yes[1], no
    return asked, yes, no


def sides_of(asked):
    """The expressions that conditions compare."""
    return [side for conditions in asked for _, *sides in conditions for side in sides]


def leaves_in(tree):
    """The leaves of a tree, and the expressions that its conditions compare."""
    if len(tree) == 2:
        return [tree], []
    (yes, of_yes), (no, of_no) = leaves_in(tree[1]), leaves_in(tree[2])
    return yes + no, sides_of(tree[0]) + of_yes + of_no


def roots_in(tree):
    """The expressions that a tree compares, writes and returns."""
    leaves, compared = leaves_in(tree)
    found = [value for values, _ in leaves for value in values.values()]
    return compared + found + [result for _, result in leaves if not isinstance(result, str)]


def tree_in_c(tree, used=None, taken=(), names=(), written=frozenset(), indent="    "):
    """A merged tree as `if`s. Work that both branches share is done before they part."""
    taken, names, roots = dict(taken), set(names), roots_in(tree)
    used = used or Counter(roots) + uses_of(roots)
    all_values = [values.items() for values, _ in leaves_in(tree)[0]]
    common = {
        n: v for n, v in all_values[0] if all((n, v) in items for items in all_values) and n not in written
    }
    asked, *branches = tree if len(tree) == 3 else ([],)
    here = sides_of(asked) if branches else roots
    if branches:
        yes, no = ({*ordered(roots_in(branch), taken)} for branch in branches)
        here += [node for node in ordered(roots, taken) if node in yes and node in no and used[node] > 1]
    lines = statements([*here, *common.values()], taken, names, indent, used)
    lines += lines_of([f"y->{name} = {c_text(value, taken.get)};" for name, value in common.items()], indent)
    if not branches:
        result = tree[1] if isinstance(tree[1], str) else f"return {c_text(tree[1], taken.get)};"
        return lines + lines_of([result], indent)
    tests = [[f"{c_text(a, taken.get)} {sign} {c_text(b, taken.get)}" for sign, a, b in of] for of in asked]
    test = " || ".join(
        f"({' && '.join(of)})" if len(of) > 1 < len(tests) else " && ".join(of) for of in tests
    )
    given = used, taken, names, written | common.keys()
    inner, outer = tree_in_c(branches[0], *given, indent + "    "), tree_in_c(branches[1], *given, indent)
    return f"{lines}{indent}if ({test}) {{\n{inner}{indent}}}\n{outer}"


def answer_in_c(answer):
    """A tree of answers as a function of C that returns a number or a truth value."""
    return tree_in_c(merged(answer, lambda leaf: ({}, lift(int(leaf) if isinstance(leaf, bool) else leaf))))


def decision_in_c(tree, c_names, next_keys, vary):
    """The body of a decision: it writes the states that change, or their variations."""

    def leaf_of(leaf):
        key, changes = leaf
        if vary:
            return {c_names[n]: vary.of(value) for n, value in changes.items()}, "return;"
        result = f"return next[{next_keys.index(key)}]; /* {key[0]} */"
        return {c_names[n]: value for n, value in changes.items()}, result

    return tree_in_c(merged(tree, leaf_of))


def coordinates_in_c(names):
    """Gives the statements that read those coordinates of a point, and their variations, that a body uses."""

    def begin(body):
        read = [(f"{of}_{name}", f"{of}[{i}]") for of in ("at", "d_at") for i, name in enumerate(names)]
        used = [(variable, value) for variable, value in read if re.search(rf"\b{variable}\b", body)]
        return lines_of(f"const real {variable} = {value};" for variable, value in used)

    return begin


class Instants:
    """Functions of an instant in C, and the tables that list them."""

    def __init__(self, page, functions, for_unit=True):
        self.page, self.functions, self.for_unit = page, functions, for_unit

    def guard_row(self, key, event_name):
        """An event as a mode watches it: the row of its table."""
        page, event, of = self.page, self.page.events[event_name], f"{c_name(key)}_{event_name}"
        add, tree = self.functions.add, page.decide(key, event_name)
        next_keys, about = keys_of(tree), f"{event_name}: {event.__doc__ or ''}"
        if len(next_keys) > LIMITS["NEXT"]:
            raise page_error(event, event_name, f"leads to more than {LIMITS['NEXT']} modes")
        row = {"event": f"EVENT_{event_name}"} | ({"is_counted": "true"} if event.counted else {})
        row["react"] = add(f"react_{of}", "react", decision_in_c(tree, page.c_names, next_keys, None), about)
        varied = decision_in_c(tree, page.c_names, next_keys, InstantVariation()).removesuffix(
            "    return;\n"
        )
        about = f"First variation of {event_name}."
        row["vary_react"] = add(f"vary_react_{of}", "vary_react", varied, about)
        watches = page.watches(key, event_name)
        if watches is not True:
            about = f"True if {event_name} is watched."
            row["is_watched"] = add(f"watches_{of}", "answer", answer_in_c(watches), about)
        crosses = event.crossing is not None and page.answer(key, event.crossing, event_name)
        if crosses is not False:
            about = f"True if {event_name} has to cross zero."
            row["is_crossing"] = add(f"crosses_{of}", "answer", answer_in_c(crosses), about)
        if event.closely or all(page.modes[next_key[0]].ends for next_key in next_keys):
            row["looks_again"] = "true"
        forget_expressions()
        d_guard, taken = InstantVariation().of(page.guard(key, event_name)), {}
        body = statements([d_guard], taken, set()) + f"    return {c_text(d_guard, taken.get)};\n"
        about = f"First variation of the guard of {event_name}."
        row["vary_guard"] = add(f"vary_guard_{of}", "vary_guard", body, about)
        row["next"] = f"{{{', '.join(f'MODE_{c_name(next_key)}' for next_key in next_keys)}}}"
        return row

    def changes(self, key, kind, name, changes, about):
        """Functions that write changed states and their variations; nothing where none changes."""
        named = {self.page.c_names[n]: value for n, value in changes.items()}
        of = f"{name}_{c_name(key)}"
        return self.functions.add_with_variation(name, kind, named, about, of) if named else {}

    def leaving(self, key):
        """Held values that every event updates as it leaves a mode."""
        forget_expressions()
        before = self.page.at(key)
        after = self.page.model_after(type(before).leaving, "leaving", before, symbol("counted"))
        return self.changes(key, "leave", "leave", self.page.changes(before, after), before.leaving.__doc__)

    def outputs(self, key):
        """The outputs in a mode."""
        forget_expressions()
        values = {f"[OUTPUT_{n}]": self.page.number(f, key, n, f.unit) for n, f in self.page.outputs.items()}
        for name in self.page.outputs:
            values[f"[OUTPUT_{name}]"].call(name)
        about, of = f"Outputs in {c_name(key)}.", f"outputs_{c_name(key)}"
        return self.functions.add_with_variation("outputs", "outputs", values, about, of, into="outputs")

    def constants(self, motion):
        """Constants of a mode."""
        begin = f"    {motion.name}_constants *c = (void *)constants;\n" if motion.constants else ""
        about, of = f"Constants of {motion.name}.", f"open_{motion.name}"
        return self.functions.add_with_variation(
            "open", "open", motion.constants, about, of, lambda body: begin, "c->"
        )

    def time_scale(self, key):
        """The time scale of the law of a mode."""
        function = self.page.modes[key[0]].time_scale
        answer = function and self.page.answer(key, function, f"time scale of {key[0]}", may_be_none=True)
        if answer is None:
            return {}
        body = answer_in_c(answer)
        return {"time_scale": self.functions.add(f"time_scale_{c_name(key)}", "answer", body, "Time scale.")}

    def world(self, key):
        """Maps from the mode's states to the world's and back, and the world's rates."""
        page, of = self.page, self.page.modes[key[0]].of
        if not page.world_key or of in (None, "world"):
            return {}
        row = {}
        for name, at, to in (("from_world", page.world_key, of), ("to_world", key, "world")):
            forget_expressions()
            before = page.at(at)
            seen = trace(before.in_coordinates, to, name=to)
            seen = {n: lift(value) for n, value in seen.items() if n in page.states}
            values = {n: value for n, value in seen.items() if value is not getattr(before, n)}
            row |= self.changes(key, "map", name, values, f"{name.replace('_', ' ')}, in {key[0]}.")
        if not self.for_unit:
            return row
        moving = page.along_motion(page.rates(key), InstantVariation())
        world = {n: moving.of(value) for n, value in seen.items()}
        about = f"Rates of the world's states in {key[0]}."
        return row | self.changes(key, "map", "world_rates", world, about)

    def setting(self, key, name):
        """The function that changes other states when an importer sets a quantity."""
        forget_expressions()
        function, before = self.page.on_set[name], self.page.at(key)
        quantity = self.page.parameters.get(name) or self.page.states[name]
        changed = self.page.at(key)
        vars(changed)[name] = symbol("given", constant=True, dimension=quantity.dimension)
        after = self.page.model_after(function, name, before, changed)
        named = {self.page.c_names[n]: v for n, v in self.page.changes(before, after).items()}
        if not named:
            return "NULL"
        about = f"{name} is set: {function.__doc__ or ''}"
        return self.functions.add(f"set_{name}_{c_name(key)}", "set", assigned(named, "y->"), about)

    def mode_row(self, key, motion):
        """The tables of a mode, and its row in the table of modes."""
        name, states = motion.name, list(self.page.states)
        if len(motion.watched) > LIMITS["GUARD"]:
            text = f"watches {len(motion.watched)} events; at most {LIMITS['GUARD']} are allowed"
            raise page_error(self.page.events[motion.watched[LIMITS["GUARD"]]], key[0], text)
        if len(motion.observed) > LIMITS["WATCH"]:
            text = f"observes {len(motion.observed)} quantities; at most {LIMITS['WATCH']} are allowed"
            raise page_error(motion.function, key[0], text)
        row = {"motion": f"&tdmf_{self.page.c}_motions[MODE_{name}]"}
        row |= {"ends": "true"} if motion.function.ends else {}
        row |= {"keeps_outputs": "true"} if motion.function.keeps_outputs else {}
        row |= self.constants(motion)
        guards = [row_in_c(self.guard_row(key, event)) for event in motion.watched]
        observed = [(o.part.upper().replace(" ", "_"), o.into) for o in motion.observed.values()]
        watches = [row_in_c({"part": f"TDMF_{part}", "into": states.index(into)}) for part, into in observed]
        tables = rows_in_c("guard", f"guards_{name}", guards, "event")
        tables += rows_in_c("watch", f"watches_{name}", watches, "into")
        row |= {"guard_count": len(guards), "guards": f"guards_{name}"}
        usual = sum(o.is_usual for o in motion.observed.values())
        row |= {"watch_count": len(watches), "usual_count": usual, "watches": f"watches_{name}"}
        row |= self.outputs(key) | self.time_scale(key) | self.leaving(key) | self.world(key)
        return tables, row_in_c(row)

    def sets(self):
        """Tables of the functions of `setting`."""
        page, tables, rows = self.page, "", []
        for name in page.on_set:
            of = page.states if name in page.states else page.parameters
            if name in of:  # not where a subclass has fixed it
                tables += list_in_c("tdmf_set", f"set_{name}", [self.setting(key, name) for key in page.keys])
                row = {"is_state": c_boolean(of is page.states), "index": list(of).index(name)}
                rows.append(row_in_c(row | {"set": f"set_{name}"}))
        return tables, rows

    def section_rows(self):
        """Tables of the sections, and their rows."""
        page, tables, rows = self.page, "", []
        for name, section in page.sections.items():
            forget_expressions()
            names = section.coordinates
            point = {n: symbol(f"at_{n}", dimension=page.states[n].dimension) for n in names}
            changes = page.changes(*page.placed(name, SimpleNamespace(**point)))
            changed = {page.c_names[n]: value for n, value in changes.items()}
            about, of = f"{name}: {section.__doc__ or ''}", f"enter_{name}"
            begin = coordinates_in_c(names)
            row = self.functions.add_with_variation("enter", "enter", changed, about, of, begin)
            tables += list_in_c("int", f"coordinates_{name}", map(list(page.states).index, names))
            row |= {"event": f"EVENT_{section.event}", "count": len(names)}
            rows.append(row_in_c(row | {"coordinates": f"coordinates_{name}"}))
        return tables, rows

    def scales(self):
        """The function that writes the scales of states and guards."""
        forget_expressions()
        page = self.page
        scales = {f"of_states[{i}]": page.scale(q.unit) for i, q in enumerate(page.states.values())}
        scales |= {f"of_events[EVENT_{n}]": page.scale(e.unit) for n, e in page.events.items()}
        about = "Typical size of each state and guard."
        return self.functions.add("scales", "scale", assigned(scales, ""), about)
