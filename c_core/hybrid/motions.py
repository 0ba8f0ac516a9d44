"""C of the motion in a mode: constants, series of the states, guards, and their variations."""

import re

from .c_text import c_text, declared_in_c, function_in_c, lines_of, name_of, real_text, take_name
from .errors import reading
from .expressions import forget_expressions, leaves_of, lift, made, ordered, replaced, symbol
from .series import NO_DEGREE, Expansion, degrees_of, kind_of, refuse_kinks, with_rates_seen, with_recursions
from .variations import Variation

EXPAND = """\
/* Adds the terms of coefficients i - 1 and i of one factor and j of the other to the sums of products. */
KERNEL void add_{mode}_sums(const {mode}_series *s, int i, int j, {mode}_sums *sum) {{
{pairs}}}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1. */
KERNEL void begin_{mode}_sums(const {mode}_series *s, int i, {mode}_sums *sum) {{
{middle}}}

/* Computes coefficient k + 1 of the states from coefficient k; `odd` selects the sum of coefficient k. */
KERNEL void step_{mode}(const {mode}_constants *c, const {mode}_factors *by, int k, const {mode}_sums *sum, \
int odd, {mode}_series *s) {{
{step}}}

/* All coefficients up to `order`, which is even: the sums of two coefficients are added up in one loop. */
static void expand_{mode}(const real *constants, int order, real *series) {{
    const {mode}_constants copy = *(const {mode}_constants *)(const void *)constants, *c = &copy;
    {mode}_series *s = (void *)series;
    static const {mode}_sums none;
    {mode}_sums sum = none;
{first}    const {mode}_factors factors = {{{factors}}}, *by = &factors;
    step_{mode}(c, by, 0, &sum, 0, s);
    begin_{mode}_sums(s, 0, &sum);
    step_{mode}(c, by, 1, &sum, 1, s);
    for (int k = 2; k < order; k += 2) {{
        begin_{mode}_sums(s, k / 2, &sum);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {{
            add_{mode}_sums(s, i, j, &sum);
        }}
        step_{mode}(c, by, k, &sum, 0, s);
        add_{mode}_sums(s, 1, k, &sum);
        step_{mode}(c, by, k + 1, &sum, 1, s);
    }}
}}
"""
CASTS = {
    "constants": ("c", "constants", "const "),
    "series": ("s", "series", "const "),
    "expanded": ("s", "series", ""),
    "d_constants": ("d", "constants", "const "),
    "varied": ("t", "series", ""),
    "d_series": ("t", "series", "const "),
}
LEAST_ORDER = 4
"""Orders of series are at least this."""
TURNS = {"sin": "true", "cos": "false"}
INTERVALS = {"+": "interval_sum", "-": "interval_difference", "*": "interval_product"}


def loop_in_c(found):
    """A loop over the coefficients of the series that an expansion adds, if it adds any."""
    step = lines_of(found.step(), "        ")
    return f"    for (int k = 0; k < order; ++k) {{\n{step}    }}\n" if step else ""


def expansion_in_c(found, first=()):
    """The series that an expansion adds, and a loop over their coefficients."""
    own = [array for array in found.arrays.values() if "->" not in array and array not in found.wanted]
    own = [declared_in_c("real", own, "[TERMS]")] if own else []
    new = [n for n in found.ahead if n in found.arrays and n not in found.known]
    lines = own + list(first) + [found.define(n, "0")[-1] for n in new]
    return lines_of(lines) + loop_in_c(found)


def divides_by_square(node):
    """True if a quantity is divided by the square of another."""
    return kind_of(node) == "quotient" and kind_of(node.operands[1]) == "square"


class Motion:
    """The expressions of a mode: its constants, the series of its states, its guards."""

    def __init__(self, page, key, name):
        self.page, self.key, self.name, self.function = page, key, name, page.modes[key[0]]
        self.watched = list(page.watched(key))
        observed = [(n, o) for n, o in page.observed.items() if key[0] in o.modes]
        self.observed = dict(sorted(observed, key=lambda of: not of[1].is_usual))
        self.moving, drifting = [], []
        for seen in range(3):  # first finds what moves, then what moves at a constant rate
            forget_expressions()
            states = {n: self.symbol_of(n) for n in page.states}
            for n in drifting:
                states[n].drifts = True
            given = page.rates(key, states.get)
            moving = [n for n in page.states if n in given and not given[n].is_number(0)]
            drifting = [n for n in given if n in moving and seen > 0 and given[n].is_constant]
            self.moving = [n for n in moving if n not in drifting] + drifting
        rates = {states[n]: given[n] for n in self.moving}
        self.drifting = [states[n] for n in drifting]
        guards = self.traced_guards(rates, states)
        rates, guards = with_rates_seen(rates, guards)
        self.take_constants(*with_recursions(rates, guards))
        own = {s: rate for s, rate in self.rates.items() if s not in self.drifting}
        self.value = Expansion(own, {}, "s->{}", by_pairs=True)
        arrays = self.value.arrays | {s: s.value for s in self.drifting}
        series = [*self.rates, *(n for n in self.value.made if n in self.value.arrays)]
        self.known = {node: arrays[node] for node in series}
        self.series = [array.removeprefix("s->") for array in self.known.values()]
        degrees = degrees_of(self.rates)
        self.degrees = [degrees[s] for s in self.rates]
        observed, places = self.guards[len(self.watched) :], {s: i for i, s in enumerate(self.rates)}
        self.integrals = [places.get(n.operands[0], -1) if n.operation == "rate" else -1 for n in observed]
        self.factors = [number for quantity in observed for number in self.factors_of(quantity)]
        steers = [degrees[s] == NO_DEGREE and rate not in self.rates for s, rate in self.rates.items()]
        self.judged = [i for i, is_judged in enumerate(steers) if is_judged]
        squares = {n.operands[0]: n.operands[1].operands[0] for n in self.value.made if divides_by_square(n)}
        divided = [squares.get(list(self.rates)[i]) for i in self.judged]
        self.divided = [places.get(s, -1) for s in divided]

    def factors_of(self, quantity):
        """Numbers of two series whose signs decide that of an observed rate of a state; -1 for none."""
        node, known = quantity, list(self.known)
        if node.operation == "rate":
            node = self.rates.get(node.operands[0], node)
        while node.operation == "negative" or (node.operation == "*" and node.operands[0].is_constant):
            node = node.operands[-1]
        factors = node.operands if kind_of(node) == "product" and node not in self.rates else (node,)
        if quantity.operation != "rate" or not all(factor in self.known for factor in factors):
            return -1, -1
        return *map(known.index, factors), *[-1] * (2 - len(factors))

    def symbol_of(self, name):
        is_moving = name in self.moving
        return self.page.symbol_of(name, "s" if is_moving else "x", constant=not is_moving)

    def traced_guards(self, rates, states):
        """Guards of watched events, then observed quantities, as expressions."""
        page = self.page
        traced = [(self.function, self.key[0], rate) for rate in rates.values()]
        traced += [(page.events[n].when, n, page.guard(self.key, n, states.get)) for n in self.watched]
        for n, function in self.observed.items():
            traced.append((function, n, page.number(function, self.key, n, function.unit, states.get)))
        for function, name, expression in traced:
            with reading(function, name):
                refuse_kinks(expression)
        of_rate = {rate: made("rate", state) for state, rate in rates.items() if not rate.is_constant}
        return [of_rate.get(guard, guard) for _, _, guard in traced[len(rates) :]]

    def take_constants(self, rates, guards, starts):
        """Replace the constant parts of rates, guards and starts by constants of the mode."""
        self.constants, taken, new = {}, set(), {}
        roots = [*rates.values(), *guards, *starts.values()]
        nodes = ordered(roots)
        asked = {o for node in nodes if not node.is_constant for o in node.operands} | set(roots)
        for node in nodes:
            if node.is_constant and node.operation != "number" and node in asked:
                if node.operands:
                    take_name(node, taken)
                name = name_of(node)
                taken.add(name)
                self.constants[name] = node
                new[node] = symbol(f"c->{name}", constant=True)
        made_new = replaced(roots, new)
        self.rates = dict(zip(rates, made_new, strict=False))
        self.guards = made_new[len(rates) : len(rates) + len(guards)]
        self.starts = dict(zip(starts, made_new[len(rates) + len(guards) :], strict=True))

    def struct(self, what, members, size="", of="real"):
        """A struct of reals, or pairs of reals."""
        declared = declared_in_c(of, members or ["none"], size)
        return f"typedef struct {{\n    {declared}\n}} {self.name}_{what};\n"

    def function_of(self, name, given, body, about):
        """A function of the motion, which reads its arrays as structs."""
        structs = {a: (v, f"{self.name}_{struct}", const) for a, (v, struct, const) in CASTS.items()}
        return function_in_c("void", name, given, body, about, structs)

    def in_c(self):
        """The motion's structs and functions."""
        parts = (self.c_of_series(), self.c_of_variation(), self.c_of_guards(), self.c_of_bounds())
        return "\n".join(text for part in parts for text in part)

    def c_of_series(self):
        """The structs of the series and their expansion."""
        value, arrays = self.value, self.value.arrays
        summed = value.summed()
        divided = [n for n in summed if kind_of(n) in ("quotient", "sqrt")]
        divisors = list(dict.fromkeys(value.series_in(n)[-1] for n in divided))
        self.divisors = [self.series.index(arrays[node].removeprefix("s->")) for node in divisors]
        zero = {node: f"{array}[0]" for node, array in arrays.items()}
        first = [f"{s.value}[1] = {real_text(self.rates[s])};" for s in self.drifting]
        first += [f"{zero[s]} = {real_text(start, zero.get)};" for s, start in self.starts.items()]
        for node in ordered([*divisors, *value.ahead]):
            if node in arrays and node.operands:
                text = c_text(node, lambda n, node=node: zero.get(n) if n is not node else None)
                first.append(f"{zero[node]} = {text};")
        pairs, middle = [], []
        for node in summed:
            a, b = (arrays[series] for series in value.series_in(node))
            j, ahead = ("j + 1", "next_") if node in value.ahead else ("j", "")
            if a == b:
                pairs.append(f"add_products(&sum->{node.name}, {a} + i - 1, {a}[{j}]);")
                middle.append(f"sum->{node.name} = {ahead}middle_of_square({a}, i);")
            else:
                pairs.append(f"add_both_products(&sum->{node.name}, {a}, {b}, i, {j});")
                middle.append(f"sum->{node.name} = {ahead}middle_of_product({a}, {b}, i);")
        step = lines_of(value.step())
        yield self.struct("series", self.series, "[TERMS]")
        if not summed:
            given, body = (
                "const real *constants, int order, real *expanded",
                lines_of(first) + loop_in_c(value),
            )
            yield self.function_of(f"expand_{self.name}", given, body, "All coefficients.")
            return
        quiet = [f"(void){n};" for n in ("c", "by", "sum", "s") if not re.search(rf"\b{n}(->|\[)", step)]
        quiet += [f"(void){n};" for n in ("k", "odd") if not re.search(rf"\b{n}\b", step)]
        yield self.struct("sums", [node.name for node in summed], of="pair")
        yield self.struct("factors", [f"inverse_{name_of(node)}" for node in divisors])
        yield EXPAND.format(
            mode=self.name,
            first=lines_of(first),
            pairs=lines_of(pairs),
            middle=lines_of(middle),
            step=lines_of(quiet) + step,
            factors=", ".join(f"1.0 / {zero[node]}" for node in divisors) or "broadcast(0.0)",
        )

    def c_of_variation(self):
        """First variations of the series and of observed quantities, expansions that reuse the series."""
        observed = dict(zip(self.observed, self.guards[len(self.watched) :], strict=True))
        leaves = leaves_of([*self.rates, *self.rates.values(), *self.starts.values(), *observed.values()])
        of = {n: symbol(f"{'d' if n.is_constant else 't'}->{n.value[3:]}", n.is_constant) for n in leaves}
        varies = Variation(of, "d_")
        varied = Expansion({of[s]: varies.of(rate) for s, rate in self.rates.items()}, {}, "{}", self.known)
        zero = {node: f"{array}[0]" for node, array in self.known.items()}
        zero |= {v: f"{v.value}[0]" for v in of.values() if v.value.startswith("t->")}
        starts = {zero[of[s]]: varies.of(start) for s, start in self.starts.items()}
        first = [f"{own} = {real_text(start, zero.get)};" for own, start in starts.items()]
        given = "const real *constants, const real *series, const real *d_constants, "
        about, body = "First variation of the series.", expansion_in_c(varied, first)
        yield self.function_of(f"vary_{self.name}", f"{given}int order, real *varied", body, about)
        for name, quantity in observed.items():
            found = self.expansion("dg", varies.of(quantity))
            arguments, about = (
                f"{given}const real *d_series, int order, real *dg",
                f"First variation of {name}.",
            )
            yield self.function_of(f"d_observed_{self.name}_{name}", arguments, expansion_in_c(found), about)

    def expansion(self, array, quantity):
        """The expansion of a quantity into an array, by the series of the motion."""
        return Expansion({}, {array: quantity}, "own_{}", self.known, of_states=self.rates)

    def c_of_guards(self):
        """Guards and observed quantities as polynomials in time."""
        given = "const real *constants, const real *series, int order, real *g"
        for name, guard in zip([*self.watched, *self.observed], self.guards, strict=True):
            body = expansion_in_c(self.expansion("g", guard))
            about = self.page.events.get(name) or self.page.observed[name]
            yield self.function_of(f"guard_{self.name}_{name}", given, body, f"{name}: {about.__doc__ or ''}")

    def c_of_bounds(self):
        """Bounds of guards and observed quantities in a step, by interval arithmetic; a quotient has none.

        The sign of an observed quantity with factors follows from these.
        """
        lines, variables = [], {}
        always = [n for n in self.watched if self.page.watches(self.key, n) is True]
        places = {n: i for i, n in enumerate([*self.watched, *self.observed])}
        by_factors = [n for i, n in enumerate(self.observed) if self.factors[2 * i] >= 0]
        for name in [*always, *(n for n in places if n not in [*always, *by_factors])]:
            i = places[name]
            bound, new, found = self.bound(self.guards[i], variables)
            new.append(f"bounds[{i}] = {bound or 'unbounded()'};")
            if name not in always and bound:
                lines += [f"if (watched >> {i} & 1) {{", *(f"    {line}" for line in new), "}"]
            else:
                lines, variables = lines + new, found
        self.has_bounds = "span_" in "".join(lines)
        if self.has_bounds:
            given = "const real *constants, const real *series, const real *power, int order"
            given += ", uint64_t watched, interval *bounds"
            about = "Bounds of guards and observed quantities; `watched` has a bit for each of them."
            yield self.function_of(f"bounds_{self.name}", given, lines_of(lines), about)

    def terms(self, node, more=0):
        """Number of terms of a series: few if it is a polynomial of a low degree."""
        degree = dict(zip(self.rates, self.degrees, strict=True)).get(node, NO_DEGREE) + more
        return degree + 1 if degree < LEAST_ORDER else "order"

    def bound(self, guard, variables):
        """The variable of a guard's interval, statements that compute it, and all variables by expression.

        The variable is None where the guard has no bound.
        """
        turns = [n for n in ordered([guard], self.known) if n.operation in TURNS and not n.is_constant]
        rates = [n for n in ordered([guard]) if n.operation == "rate" and n.operands[0] in self.known]
        angles = [n.operands[0] for n in turns if n not in self.known and n.operands[0] in self.known]
        nodes = [*angles, *ordered([guard], {*self.known, *turns, *rates})]
        new, found = [], dict(variables)
        for node in nodes:
            if node in found:
                continue
            of = [found.get(o) for o in node.operands]
            if node in self.known:
                text = f"interval_of_series({self.known[node]}, power, {self.terms(node)})"
            elif node in rates:
                of_rate = node.operands[0]
                text = f"interval_of_rate({self.known[of_rate]}, power, {self.terms(of_rate, -1)})"
            elif node.is_constant:
                if all(user.is_constant for user in nodes if node in user.operands) and node is not guard:
                    continue
                value = real_text(node)
                text = f"interval_at({value}, {value})"
            elif node in turns and node.operands[0] in self.known:
                angle = node.operands[0]
                text = f"interval_of_turn({self.known[angle]}[0], {found[angle]}, {TURNS[node.operation]})"
            elif node in turns:
                text = "interval_at(broadcast(-1.0), broadcast(1.0))"
            elif node.operation == "negative":
                text = f"interval_at(-{of[0]}.high, -{of[0]}.low)"
            elif node.operation == "*" and node.operands[0] is node.operands[1]:
                text = f"interval_square({of[0]})"
            elif node.operation in INTERVALS:
                text = f"{INTERVALS[node.operation]}({', '.join(of)})"
            else:
                return None, [], variables
            found[node] = f"span_{len(found)}"
            new.append(f"const interval {found[node]} = {text};")
        return found[guard], new, found


class InstantVariation(Variation):
    """First variations at an instant, along variations dp of the parameters and dx of the states."""

    def __init__(self):
        super().__init__({}, "d_")

    def of(self, expression):
        """The variation of an expression."""
        for leaf in leaves_of([expression]):
            kind = leaf.value[:3]
            varies = symbol(f"{'d' if kind in ('p->', 'x->') else 'd_'}{leaf.value}")
            self.found.setdefault(leaf, varies if kind in ("p->", "x->", "at_") else lift(0))
        return super().of(expression)
