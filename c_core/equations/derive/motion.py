"""C of a motion: its structs, its series for `real` of any width, and the variation of these.

Products of series are convolutions. Those of one coefficient are summed in one loop, two coefficients at a
time, from the middle outwards: of the terms of both most share a factor that is loaded once, and the newest
coefficients, which have just been found, are needed last.
"""

from types import SimpleNamespace as Record
from typing import Any

from ..in_c import InC
from ..motions import Family
from .c import c_text, comment, struct
from .expressions import (
    Expression,
    begin_anew,
    derivative,
    leaves,
    lift,
    ordered,
    parameters,
    replaced,
    symbol,
    trace,
)
from .series import RECURSIONS, Expansion, kind_of
from .values import Function, members

FACTORS = "What is divided by."
SUMS = "Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half."
SERIES = """\
{factors}
{sums}
/* Adds the terms with coefficient i of one factor and j of the other; of what is known ahead, of j + 1. */
KERNEL void add_{case}_sums(const {family}_series *s, int i, int j, {case}_sums *sum) {{
{pairs}}}

/* Sets the sums of coefficients 2 i and 2 i + 1 to the terms in the middle. */
KERNEL void begin_{case}_sums(const {family}_series *s, int i, {case}_sums *sum, {case}_sums *next) {{
{middle}}}

{what}KERNEL void expand_{case}_on(const {family}_coefficients *c, const {case}_factors *by, int k,
                           const {case}_sums *sum, {family}_series *s) {{
{step}}}

/* From coefficient 0 of the states up to `order`; an odd order gets one coefficient more. */
KERNEL void expand_{case}(const {family}_coefficients *given, int order, {family}_series *s) {{
    const {family}_coefficients copy = *given, *c = &copy;
    static const {case}_sums none = {{0}};
    {case}_sums sum = none, next = none;
{first}    const {case}_factors factors = {{
{products}    }};
    const {case}_factors *by = &factors;
    expand_{case}_on(c, by, 0, &sum, s);
    begin_{case}_sums(s, 0, &sum, &next);
    expand_{case}_on(c, by, 1, &next, s);
    for (int k = 2; k < order; k += 2) {{
        begin_{case}_sums(s, k / 2, &sum, &next);
        for (int i = k / 2, j = i + 1; i > 1; --i, ++j) {{
            add_{case}_sums(s, i, j, &next);
            add_{case}_sums(s, i - 1, j, &sum);
        }}
        expand_{case}_on(c, by, k, &sum, s);
        add_{case}_sums(s, 1, k, &next);
        expand_{case}_on(c, by, k + 1, &next, s);
    }}
}}
"""
VARIATION = """\
/* The same differentiated, from coefficient 0 of the states of t; coefficients vary by d. */
static inline void vary_{case}(const {family}_coefficients *c, const {family}_series *s,
                               const {family}_coefficients *d, int order, {family}_variation *t) {{
{local}{begin}for (int k = 0; k < order; ++k) {{
{step}}}
}}
"""


class Motion:
    """One case of a family, traced alone: its expansion, and that of its variation."""

    def __init__(self, family: Family, case: str) -> None:
        begin_anew()
        self.family, self.case = family, case
        options = {"stored": "", "ramp": True} | family.cases[case]
        names = f"{family.stored} {options.pop('stored')}".split()
        arguments = {name: symbol(f"c->{name}", constant=True) for name in constants(family)}
        for name, word in family.ramps.items():
            rate = symbol(f"c->{name}_rate", constant=True)
            marks = {"ramp": rate, "word": word} if options["ramp"] or word == "drift" else {"constant": True}
            arguments[name] = symbol(f"c->{name}", **marks)
        del options["ramp"]
        states = {name: symbol(f"s->{name}") for name in states_of(family)}
        found = vars(trace(family.page.motion, Record(**arguments), Record(**states), **options))
        rates = {states[name]: lift(rate) for name, rate in vars(found.pop("rates")).items()}
        found = {name: lift(value) for name, value in found.items()}
        for name in [*found, *names]:
            found[name].name = name if found[name].operands else found[name].name
        # Rates of quantities stand for what the page makes these of.
        new: dict[Expression, Any] = {}
        for name, of in family.rates.items():
            new[found[name]] = Expression("rate", replaced(found[of], new))
            new[found[name]].name = name
        found = {name: replaced(value, new) for name, value in found.items()}
        rates = {state: replaced(rate, new) for state, rate in rates.items()}
        self.value = Expansion({f"s->{n}": found[n] for n in names}, rates, "s->{}".format, by_pairs=True)
        self.vary({name: found[name] for name in family.varied.split()}, rates)

    def vary(self, varied: dict[str, Expression], rates: dict[Expression, Expression]) -> None:
        """Differentiate: the variation is an expansion, of which the motion's series are known."""
        variations = {
            leaf: variation_of(leaf) for leaf in leaves([*rates, *rates.values(), *varied.values()])
        }
        stored = {n: f"s->{n.name}" for n in self.value.nodes if kind_of(n) != "linear"} | self.value.arrays
        self.varied = Expansion(
            {f"t->{name}": derivative(value, variations, "d_") for name, value in varied.items()},
            {variations[state]: derivative(rate, variations, "d_") for state, rate in rates.items()},
            lambda name: f"t->{name.removeprefix('d_')}" if name.startswith("d_") else name,
            stored,
        )
        self.value.arrays |= {node: stored[node] for node in self.varied.reads()}

    def source(self) -> str:
        """Write the functions of the case, the last of which expands the series."""
        value, arrays, step = self.value, self.value.arrays, self.value.step()
        summed = [node for node in value.made if "{inner}" in "".join(RECURSIONS.get(kind_of(node), ""))]
        divisors = [value.series_in(node)[-1] for node in summed if kind_of(node) in ("quotient", "sqrt")]
        made = {f"inverse_{node.name}": f"1.0 / {arrays[node]}[0]" for node in divisors}
        zero = {node: f"{array}[0]" for node, array in arrays.items()}
        lines = [
            f"{zero[node]} = {c_text(node, {n: t for n, t in zero.items() if n is not node}.get, 'real_')};\n"
            for node in ordered(divisors)
            if node in arrays and node.operands
        ]
        return SERIES.format(
            family=self.family.name,
            case=self.case,
            what=comment(self.family.page.motion.__doc__, " From coefficient k of the states to the next."),
            factors=struct(FACTORS, f"{self.case}_factors", made, "real"),
            sums=struct(SUMS, f"{self.case}_sums", [str(node.name) for node in summed], "real"),
            pairs="".join(map(self.pairs, summed)),
            middle="".join(map(self.middle, summed)) + ("" if value.ahead else "(void)next;\n"),
            step="\n".join(step),
            first="".join(lines),
            products="".join(f".{name} = {text},\n" for name, text in made.items()),
        )

    def pairs(self, node: Expression) -> str:
        """Add the terms of a sum with coefficients i and j of its factors."""
        a, b = (self.value.arrays[series] for series in self.value.series_in(node))
        j = "j + 1" if node in self.value.ahead else "j"
        terms = dict.fromkeys([f"{a}[i] * {b}[{j}]", f"{b}[i] * {a}[{j}]"])
        return "".join(f"sum->{node.name} += {term};\n" for term in terms)

    def middle(self, node: Expression) -> str:
        """Begin a sum with its terms in the middle."""
        a, b = (self.value.arrays[series] for series in self.value.series_in(node))
        half = "0.5 * " if a == b else ""
        if node not in self.value.ahead:
            return f"sum->{node.name} = {half}({a}[i] * {b}[i]);\nnext->{node.name} = broadcast(0.0);\n"
        both = " + ".join(dict.fromkeys([f"{a}[i] * {b}[i + 1]", f"{b}[i] * {a}[i + 1]"]))
        return f"sum->{node.name} = {both};\nnext->{node.name} = {half}({a}[i + 1] * {b}[i + 1]);\n"

    def variation(self) -> str:
        """Write the first variation of the series."""
        begin = [line for node in self.varied.ahead for line in self.varied.define(node, "0")]
        return VARIATION.format(
            family=self.family.name,
            case=self.case,
            local=self.varied.own_arrays(),
            begin="".join(f"{line}\n" for line in begin),
            step="\n".join(self.varied.step()),
        )


def variation_of(leaf: Expression) -> Expression:
    """Give the variation of a state, or of what is given."""
    if leaf.value.startswith("s->"):
        return symbol("t" + leaf.value[1:], f"d_{leaf.name}")
    marks = dict(leaf.marks)
    if "ramp" in marks:
        marks["ramp"] = variation_of(marks["ramp"])
    return symbol("d" + leaf.value[1:], f"d_{leaf.name}", **marks)


# ---- what the cases of a family share ---------------------------------------------------------------------


def constants(family: Family) -> list[str]:
    """Name what does not change in time."""
    return [c for c in members(family.constants) if c.removesuffix("_rate") not in family.ramps]


def states_of(family: Family) -> list[str]:
    """Name the states, by what a motion starts with."""
    return list(vars(family.page.start(Record(**dict.fromkeys(family.start.split(), 1.0)))))


def series_of(family: Family) -> set[str]:
    """Name the states, and what is stored in one case or another."""
    stored = " ".join(case.get("stored", "") for case in family.cases.values())
    return {*states_of(family), *family.stored.split(), *stored.split()}


def structs(family: Family) -> str:
    """Write the structs, and the states by what a motion starts with."""
    name, motions = family.name, [Motion(family, case) for case in family.cases]
    given = [*constants(family), *family.ramps, *(f"{ramp}_rate" for ramp in family.ramps)]

    def stored(expansions: list[Expansion], of: str) -> list[str]:
        arrays = [array for found in expansions for array in [*found.wanted, *found.arrays.values()]]
        return [array.removeprefix(of) for array in arrays if array.startswith(of)]

    what = "Series of the states and of what is made of them, up to the order or one less."
    size = "[SERIES_TERMS]"
    series = stored([motion.value for motion in motions], "s->")
    varied = stored([motion.varied for motion in motions], "t->")
    depends = "What the motions depend on, and its rates where it changes in time."
    types = {"start": f"const {name}_start *", "written": f"{name}_series *"}
    return "\n".join(
        [
            struct(depends, f"{name}_coefficients", given, "real"),
            struct(what, f"{name}_series", series, "real", size),
            struct("The first variations of some.", f"{name}_variation", varied, "real", size),
            struct("What a motion starts with.", f"{name}_start", family.start.split(), "real"),
            Function(InC(f"void begin_{name}", family.page.start, lambda start: (start,)), types, "real").c(),
        ]
    )


def end(family: Family) -> str:
    """Write where a motion leads in some time, and the change of that."""
    name, cases = family.name, parameters(family.page.end)[1:]

    def at_time(s: Any, elapsed: Expression, order: Expression, *case: Any) -> Any:
        """Give the states then."""
        states = {n: Expression("value_at", getattr(s, n), elapsed, order) for n in states_of(family)}
        return Record(**{n: value.named(n) for n, value in states.items()}), *case

    types = {"s": f"const {name}_series *", "elapsed": "const elapsed_time *", "order": "int"}
    types |= dict.fromkeys(cases, "bool")
    row = InC(f"{name}_start end_{name}", family.page.end, at_time)
    return Function(row, types, "real").c()
