"""C of a mode's motion: its constants, the series of its states, its guards, and their variations."""

import re

from .c_text import RESERVED, assigned, c_text, name_of, own_name, wrapped_text
from .errors import reading
from .expressions import Variation, forget_expressions, leaves_of, lift, made, ordered, replaced, symbol
from .series import (
    NO_DEGREE,
    Expansion,
    degrees_of,
    kind_of,
    refuse_kinks,
    with_rates_seen,
    with_series_of_functions,
)

EXPAND = """\
/* Adds the terms of coefficient i of one factor and j of the other to the sums of products. */
KERNEL void add_{mode}_sums(const {mode}_series *s, int i, int j, {mode}_sums *sum) {{
{pairs}}}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_{mode}_sums(const {mode}_series *s, int i, {mode}_sums *sum, {mode}_sums *next) {{
{middle}}}

/* From coefficient k of the states to k + 1. */
KERNEL void step_{mode}(const {mode}_constants *c, const {mode}_factors *by, int k, const {mode}_sums *sum,
                        {mode}_series *s) {{
{step}}}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_{mode}(const real *constants, int order, real *series) {{
    const {mode}_constants copy = *(const {mode}_constants *)(const void *)constants, *c = &copy;
    {mode}_series *s = (void *)series;
    static const {mode}_sums none;
    {mode}_sums sum = none, next = none;
{first}    const {mode}_factors factors = {{{factors}}}, *by = &factors;
    step_{mode}(c, by, 0, &sum, s);
    begin_{mode}_sums(s, 0, &sum, &next);
    step_{mode}(c, by, 1, &next, s);
    for (int k = 2; k < order; k += 2) {{
        begin_{mode}_sums(s, k / 2, &sum, &next);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {{
            add_{mode}_sums(s, i, j, &next);
            add_{mode}_sums(s, i - 1, j, &sum);
        }}
        step_{mode}(c, by, k, &sum, s);
        add_{mode}_sums(s, 1, k, &next);
        step_{mode}(c, by, k + 1, &next, s);
    }}
}}
"""
CASTS = {
    "constants": ("c", "constants", "const "),
    "series": ("s", "series", "const "),
    "d_constants": ("d", "constants", "const "),
    "varied": ("t", "series", ""),
}
TURNS = {"sin": "sine", "cos": "cosine"}
INTERVALS = {"+": "interval_sum", "-": "interval_difference", "*": "interval_product"}


def lines_of(lines, indent="    "):
    """Lines of C with an indent."""
    return "".join(f"{indent}{line}\n" for line in lines)


def loop_of(lines):
    """Statements for each coefficient."""
    return f"    for (int k = 0; k < order; ++k) {{\n{lines_of(lines, '        ')}    }}\n"


def unused(names, body):
    """Statements that keep compilers quiet about what a function is given and does not need."""
    return lines_of(f"(void){n};" for n in names.split() if f"{n}->" not in body and f"{n}[" not in body)


def comment(text):
    """A comment of C, of one line or several."""
    return wrapped_text(f"/* {' '.join(text.split())} */") + "\n" if text else ""


class Motion:
    """A mode traced: its constants, its states and the series that they need, its guards."""

    def __init__(self, page, key, name):
        self.page, self.key, self.name, self.function = page, key, name, page.modes[key[0]]
        self.watched = list(page.watched(key))
        self.observed = {n: o for n, o in page.observed.items() if key[0] in o.modes}
        self.moving, drifting = [], []
        for seen in range(
            3
        ):  # first what moves, since all else is constant, then what moves at constant rates
            forget_expressions()
            states = {n: self.symbol_of(n) for n in page.states}
            for n in drifting:
                states[n].drifts = True
            given = page.rates(key, states.get)
            drifting = [
                n for n, rate in given.items() if seen > 0 and rate.is_constant and not rate.is_number(0)
            ]
            moving = [
                n for n in page.states if n in given and not given[n].is_number(0) and n not in drifting
            ]
            self.moving = moving + drifting
        rates = {states[n]: given[n] for n in self.moving}
        self.drifting = [states[n] for n in drifting]
        guards = self.traced_guards(rates, states)
        rates, guards = with_rates_seen(rates, guards)
        self.take_constants(*with_series_of_functions(rates, guards))
        own = {s: rate for s, rate in self.rates.items() if s not in self.drifting}
        self.value = Expansion(own, {}, "s->{}", by_pairs=True)
        arrays = self.value.arrays | {s: s.value for s in self.drifting}
        series = [*self.rates, *(n for n in self.value.made if n in self.value.arrays)]
        self.known = {node: arrays[node] for node in series}
        self.series = [array.removeprefix("s->") for array in self.known.values()]
        degrees = degrees_of(self.rates)
        self.degrees = [degrees[s] for s in self.rates]
        self.judged = [
            i
            for i, (s, rate) in enumerate(self.rates.items())
            if degrees[s] == NO_DEGREE and rate not in self.rates
        ]

    def symbol_of(self, name):
        return self.page.symbol_of(
            name, "s" if name in self.moving else "x", constant=name not in self.moving
        )

    def traced_guards(self, rates, states):
        """Guards of the events that are watched, and quantities that are observed, as expressions."""
        page = self.page
        for root in rates.values():
            with reading(self.function, self.key[0]):
                refuse_kinks(root)
        guards = []
        for n in self.watched:
            guards.append(page.guard(self.key, n, states.get))
            with reading(page.events[n].when, n):
                refuse_kinks(guards[-1])
        for n, function in self.observed.items():
            guards.append(page.number(function, self.key, n, function.unit, states.get))
            with reading(function, n):
                refuse_kinks(guards[-1])
        state_of_rate = {rate: state for state, rate in rates.items()}
        return [
            made("rate", state_of_rate[g]) if g in state_of_rate and not g.is_constant else g for g in guards
        ]

    def take_constants(self, rates, guards, starts):
        """Make constants of the mode of what does not move."""
        self.constants, taken, new = {}, set(), {}
        roots = [*rates.values(), *guards, *starts.values()]
        nodes = ordered(roots)
        asked = {o for node in nodes if not node.is_constant for o in node.operands} | set(roots)
        for node in nodes:
            if node.is_constant and node.operation != "number" and node in asked:
                if node.operands and (not node.name or node.name in taken or node.name in RESERVED):
                    node.name = own_name(node, taken)
                name = name_of(node)
                taken.add(name)
                self.constants[name] = node
                new[node] = symbol(f"c->{name}", constant=True)
        made_new = replaced(roots, new)
        self.rates = dict(zip(rates, made_new, strict=False))
        self.guards = made_new[len(rates) : len(rates) + len(guards)]
        self.starts = dict(zip(starts, made_new[len(rates) + len(guards) :], strict=True))

    def struct(self, what, members, size=""):
        """A struct of reals."""
        lines = lines_of(f"real {m}{size};" for m in members or ["none"])
        return f"typedef struct {{\n{lines}}} {self.name}_{what};\n"

    def function_of(self, name, given, body, about):
        """A function of the motion, with the structs that it reads in place of arrays."""
        casts = ""
        for argument in re.findall(r"(\w+)(?:,|$)", given):
            variable, what, const = CASTS.get(argument, ("", "", ""))
            if variable and f"{variable}->" in body:
                casts += f"    {const}{self.name}_{what} *{variable} = ({const}void *){argument};\n"
            elif not re.search(rf"\b{argument}\b", body):
                casts += f"    (void){argument};\n"
        return f"{comment(about)}static void {name}({given}) {{\n{casts}{body}}}\n"

    def c_of_series(self):
        """The structs of the series and their expansion."""
        value, arrays = self.value, self.value.arrays
        summed = value.summed()
        divisors = list(
            dict.fromkeys(value.series_in(n)[-1] for n in summed if kind_of(n) in ("quotient", "sqrt"))
        )
        self.divisors = [self.series.index(arrays[node].removeprefix("s->")) for node in divisors]
        zero = {node: f"{array}[0]" for node, array in arrays.items()}
        first = [f"{s.value}[1] = {c_text(self.rates[s])};" for s in self.drifting]
        first += [f"{zero[s]} = {c_text(start, zero.get)};" for s, start in self.starts.items()]
        for node in ordered([*divisors, *value.ahead]):
            if node in arrays and node.operands:
                text = c_text(node, lambda n, node=node: zero.get(n) if n is not node else None)
                first.append(f"{zero[node]} = {text};")
        pairs, middle = [], []
        for node in summed:
            a, b = (arrays[series] for series in value.series_in(node))
            is_ahead, half, n = node in value.ahead, "0.5 * " if a == b else "", node.name
            j = "j + 1" if is_ahead else "j"
            pairs += [
                f"sum->{n} += {term};" for term in dict.fromkeys([f"{a}[i] * {b}[{j}]", f"{b}[i] * {a}[{j}]"])
            ]
            both = " + ".join(dict.fromkeys([f"{a}[i] * {b}[i + 1]", f"{b}[i] * {a}[i + 1]"]))
            middle += [
                f"sum->{n} = {both if is_ahead else f'{half}({a}[i] * {b}[i])'};",
                f"next->{n} = {f'{half}({a}[i + 1] * {b}[i + 1])' if is_ahead else 'broadcast(0.0)'};",
            ]
        if not summed:
            pairs, middle = (
                [f"(void){n};" for n in ["s", "i", "j", "sum"]],
                [f"(void){n};" for n in ["s", "i", "sum", "next"]],
            )
        step = value.step()
        yield self.struct("series", self.series, "[TERMS]")
        yield self.struct("sums", [node.name for node in summed])
        yield self.struct("factors", [f"inverse_{name_of(node)}" for node in divisors])
        quiet = unused("c by sum s", " ".join(step)) + ("" if "k" in " ".join(step) else "    (void)k;\n")
        yield EXPAND.format(
            mode=self.name,
            first=lines_of(first),
            pairs=lines_of(pairs),
            middle=lines_of(middle),
            step=quiet + lines_of(step),
            factors=", ".join(f"1.0 / {zero[node]}" for node in divisors) or "broadcast(0.0)",
        )

    def c_of_variation(self):
        """The variation of the series: one more expansion, where the motion's series are known."""
        leaves = leaves_of([*self.rates, *self.rates.values(), *self.starts.values()])
        of = {n: symbol(f"{'d' if n.is_constant else 't'}->{n.value[3:]}", n.is_constant) for n in leaves}
        varies = Variation(of, "d_")
        varied = Expansion({of[s]: varies.of(rate) for s, rate in self.rates.items()}, {}, "{}", self.known)
        zero = {node: f"{array}[0]" for node, array in self.known.items()}
        zero |= {v: f"{v.value}[0]" for v in of.values() if v.value.startswith("t->")}
        first = [f"{zero[of[s]]} = {c_text(varies.of(start), zero.get)};" for s, start in self.starts.items()]
        first += [
            varied.define(n, "0")[-1] for n in varied.ahead if n in varied.arrays and n not in self.known
        ]
        own = [f"real {array}[TERMS];" for array in varied.arrays.values() if "->" not in array]
        body = lines_of(own + first) + loop_of(varied.step())
        given = "const real *constants, const real *series, const real *d_constants, int order, real *varied"
        yield self.function_of(f"vary_{self.name}", given, body, "First variation of the series.")

    def c_of_guards(self):
        """Guards and observed quantities as polynomials in time."""
        given = "const real *constants, const real *series, int order, real *g"
        for name, guard in zip([*self.watched, *self.observed], self.guards, strict=True):
            found = Expansion({}, {"g": guard}, "own_{}", self.known)
            own = [f"real {array}[TERMS];" for node, array in found.arrays.items() if node not in self.known]
            about = self.page.events.get(name) or self.page.observed[name]
            body = lines_of(own) + loop_of(found.step())
            yield self.function_of(f"guard_{self.name}_{name}", given, body, f"{name}: {about.__doc__ or ''}")

    def c_of_bounds(self):
        """What guards are no less than in a step, by intervals; a guard that divides has no bound."""
        self.has_bounds = False
        lines, variables = [], {}
        for i, guard in enumerate(self.guards[: len(self.watched)]):
            bound = self.bound(guard, variables, lines)
            self.has_bounds |= bound is not None
            lines.append(f"low[{i}] = {f'{bound}.low' if bound else 'broadcast(-INFINITY)'};")
        if self.has_bounds:
            given = "const real *constants, const real *series, const real *power, int order, real *low"
            about = "What the guards are no less than in a step."
            yield self.function_of(f"bounds_{self.name}", given, lines_of(lines), about)

    def bound(self, guard, variables, lines):
        """Statements for the interval of a guard; the variable's name, or None."""

        def is_turn(node):
            return node.operation in ("sin", "cos") and not node.is_constant

        stops = {
            *self.known,
            *(node for node in ordered([guard], self.known) if is_turn(node) and node not in self.known),
        }
        nodes, new = ordered([guard], stops), []
        for node in nodes:
            if node in variables:
                continue
            of = [variables.get(o) for o in node.operands]
            if node in self.known:
                text = f"interval_of_series({self.known[node]}, power, order)"
            elif node.is_constant:
                if all(user.is_constant for user in nodes if node in user.operands) and node is not guard:
                    continue
                text = f"interval_at({c_text(node)}, {c_text(node)})"
                text = (
                    text
                    if node.operation != "number"
                    else f"interval_at(broadcast({c_text(node)}), broadcast({c_text(node)}))"
                )
            elif is_turn(node):
                angle = node.operands[0]
                if angle not in self.known:
                    text = "interval_at(broadcast(-1.0), broadcast(1.0))"
                else:
                    array = self.known[angle]
                    text = f"interval_of_{TURNS[node.operation]}({array}, power, order)"
            elif node.operation == "negative":
                text = f"interval_at(-{of[0]}.high, -{of[0]}.low)"
            elif node.operation in INTERVALS:
                text = f"{INTERVALS[node.operation]}({', '.join(of)})"
            else:
                return None
            variables[node] = f"span_{len(variables)}"
            new.append(f"const interval {variables[node]} = {text};")
        lines += new
        return variables[guard]


def constants_in_c(motion, function_of):
    """What is constant in the mode, and its variation."""
    vary = InstantVariation()
    values = motion.constants
    cast = f"    {motion.name}_constants *c = (void *)constants;\n" if values else ""
    yield function_of(
        f"open_{motion.name}", "open", cast + assigned(values, "c->"), f"Constants of {motion.name}."
    )
    varied = {name: vary.of(value) for name, value in values.items()}
    yield function_of(
        f"vary_open_{motion.name}",
        "vary_open",
        cast + assigned(varied, "c->"),
        f"First variation of open_{motion.name}.",
    )


class InstantVariation(Variation):
    """First variations at an instant: parameters vary by dp, states by dx, and nothing else varies."""

    def __init__(self):
        super().__init__({}, "d_")

    def of(self, expression):
        """The variation of an expression."""
        for leaf in leaves_of([expression]):
            varies = leaf.value.startswith(("p->", "x->"))
            self.found.setdefault(leaf, symbol(f"d{leaf.value}") if varies else lift(0))
        return super().of(expression)
