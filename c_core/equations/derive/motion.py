"""C of a motion: its structs, its series for `real` of any width, and the variation of these.

Products of series are convolutions. Those of one coefficient are summed in one loop, two coefficients at a
time, from the middle outwards: of the terms of both most share a factor that is loaded once, and the newest
coefficients, which have just been found, are needed last.
"""

from types import SimpleNamespace as Record
from typing import Any

from .c import c_text, comment, struct
from .expressions import (
    Changes,
    Expression,
    derivative,
    forget,
    leaves,
    lift,
    ordered,
    parameters,
    replaced,
    symbol,
    trace,
)
from .series import RECURSIONS, Expansion, kind_of
from .values import Function

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
{first}
    const {case}_factors factors = {{
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


class Family:
    """Motions that share the structs of their series; `cases` has what the page is told of each.

    `constants` are all that is given, `ramps` of them what changes in time, with the word "drift" in any
    width, with "ramp" where inputs ramp; `rates` are quantities that are rates of others; of `varied` the
    variation is asked for, besides that of the states.
    """

    def __init__(self, name: str, page: Any, **given: Any) -> None:
        self.name, self.page = name, page
        self.noted, self.varied = given["noted"].split(), given["varied"].split()
        self.ramps, self.rates, self.cases = given["ramps"], given["rates"], given["cases"]
        self.constants = [c for c in given["constants"] if c.removesuffix("_rate") not in self.ramps]
        asked = Record(**dict.fromkeys(given["start"].split(), 1.0))
        self.start, self.states = list(vars(asked)), list(vars(page.start(asked)))

    def motion(self, case: str) -> "Motion":
        """Trace one case, alone."""
        forget()
        return Motion(self, case, **self.cases[case])

    def structs(self) -> str:
        """Write the structs, and the states by what a motion starts with."""
        motions = [self.motion(case) for case in self.cases]
        given = [*self.constants, *self.ramps, *(ramp + "_rate" for ramp in self.ramps)]
        series, varied = ([m for motion in motions for m in motion.members(of)] for of in ("s->", "t->"))
        types = {"start": f"const {self.name}_start *", "written": f"{self.name}_series *"}
        begin = Function("void", f"begin_{self.name}", types, self.page.start, number="real")
        structs = [
            ("What the motions depend on, and its rates where it changes in time.", "coefficients", given),
            (
                "Series of the states and of what is made of them, up to the order or one less.",
                *("series", series, "[SERIES_TERMS]"),
            ),
            ("The first variations of some.", "variation", varied, "[SERIES_TERMS]"),
            ("What a motion starts with.", "start", self.start),
        ]
        written = [
            struct(what, f"{self.name}_{name}", members, "real", *size)
            for what, name, members, *size in structs
        ]
        return "\n".join([*written, begin.c()])

    def end(self) -> str:
        """Write where a motion leads in some time, and the change of that."""

        def handed(s: Any, elapsed: Expression, order: Expression, *case: Any) -> Any:
            """Give the states then."""
            states = {name: Expression("value_at", getattr(s, name), elapsed, order) for name in self.states}
            return Record(**{name: value.named(name) for name, value in states.items()}), *case

        types = {"s": f"const {self.name}_series *", "elapsed": "const elapsed_time *", "order": "int"}
        types |= dict.fromkeys(parameters(self.page.end)[1:], "bool")
        return Function(
            f"{self.name}_start", f"end_{self.name}", types, self.page.end, handed, number="real"
        ).c()


class Motion:
    """One case of a family, traced: its expansion, and that of its variation."""

    def __init__(self, family: Family, case: str, noted: str = "", ramp: bool = True, **told: Any) -> None:
        self.family, self.case = family, case
        held = {name: symbol(f"c->{name}", constant=True) for name in family.constants}
        for name, word in family.ramps.items():
            rate = symbol(f"c->{name}_rate", constant=True)
            marks = {"ramp": rate, "word": word} if ramp or word == "drift" else {"constant": True}
            held[name] = symbol(f"c->{name}", **marks)
        states = {name: symbol(f"s->{name}") for name in family.states}
        traced = vars(trace(family.page.motion, Record(**held), Record(**states), **told))
        rates = {states[name]: lift(rate) for name, rate in vars(traced.pop("rates")).items()}
        names = [*family.noted, *noted.split()]
        found, rates = self.with_rates({name: lift(value) for name, value in traced.items()}, rates, names)
        self.value = Expansion({f"s->{n}": found[n] for n in names}, rates, "s->{}".format, by_pairs=True)
        self.vary({name: found[name] for name in family.varied}, rates)

    def with_rates(
        self, found: dict[str, Expression], rates: Changes, noted: list[str]
    ) -> tuple[dict[str, Expression], Changes]:
        """Name what a page gives, and put rates of quantities for what the page makes these of."""
        for name in [*found, *noted]:
            found[name].name = name if found[name].operands else found[name].name
        new: Changes = {}
        for name, of in self.family.rates.items():
            new[found[name]] = Expression("rate", replaced(found[of], new))
            new[found[name]].name = name
        return (
            {name: replaced(value, new) for name, value in found.items()},
            {state: replaced(rate, new) for state, rate in rates.items()},
        )

    def vary(self, varied: dict[str, Expression], rates: Changes) -> None:
        """Differentiate: the variation is an expansion, of which the motion's series are known."""
        changes = {leaf: change_of(leaf) for leaf in leaves([*rates, *rates.values(), *varied.values()])}
        stored = {node: self.value.arrays.get(node, f"s->{node.name}") for node in self.value.nodes}
        known = {node: array for node, array in stored.items() if self.value.stands(node)}
        self.varied = Expansion(
            {f"t->{name}": derivative(value, changes, "d_") for name, value in varied.items()},
            {changes[state]: derivative(rate, changes, "d_") for state, rate in rates.items()},
            lambda name: f"t->{name.removeprefix('d_')}" if name.startswith("d_") else name,
            known,
        )
        self.value.arrays |= {node: known[node] for node in self.varied.reads()}

    def members(self, of: str) -> list[str]:
        """Name the series that are stored in a struct."""
        expansion = self.value if of == "s->" else self.varied
        arrays = [*expansion.wanted, *expansion.arrays.values()]
        return [array.removeprefix(of) for array in arrays if array.startswith(of)]

    def source(self) -> str:
        """Write the functions of the case, the last of which expands the series."""
        value, arrays, step = self.value, self.value.arrays, self.value.step()
        summed = [node for node in value.made if "{inner}" in "".join(RECURSIONS.get(kind_of(node), ""))]
        divisors = [value.series_in(node)[-1] for node in summed if kind_of(node) in ("quotient", "sqrt")]
        made = {f"inverse_{node.name}": f"1.0 / {arrays[node]}[0]" for node in divisors}
        first = [node for node in ordered(divisors) if node in arrays and node.operands]
        zero = {node: f"{array}[0]" for node, array in arrays.items()}
        lines = [
            f"{zero[node]} = {c_text(node, {n: t for n, t in zero.items() if n is not node}.get, 'real_')};"
            for node in first
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
            first="\n".join(lines),
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
        begin, step = self.varied.begin(), self.varied.step()
        return VARIATION.format(
            family=self.family.name,
            case=self.case,
            local=self.varied.own_arrays(),
            begin="".join(f"{line}\n" for line in begin),
            step="\n".join(step),
        )


def change_of(leaf: Expression) -> Expression:
    """Give the variation of a state, or of what is given."""
    if leaf.value.startswith("s->"):
        return symbol("t" + leaf.value[1:], f"d_{leaf.name}")
    marks = dict(leaf.marks)
    if "ramp" in marks:
        marks["ramp"] = change_of(marks["ramp"])
    return symbol("d" + leaf.value[1:], f"d_{leaf.name}", **marks)
