"""C of a motion's Taylor series and of their first variation, for `real` of any width.

Products of series are convolutions. Those of one coefficient are summed in one loop, two coefficients at a
time, from the middle outwards: of the terms of both most share a factor that is loaded once, and the newest
coefficients, which have just been found, are needed last. What is linear needs no sum.
"""

from collections.abc import Callable, Iterable
from types import SimpleNamespace as Record
from typing import Any

from .expressions import Expression, c_text, derivative, forget, lift, number, ordered, symbol, trace

# Coefficient k of what is no sum: n, made of a and b, by inner terms; `over` is of a root or quotient.
VALUE = {
    "square": "square_of({k}, {inner}, {s_a})",
    "product": "product_of({k}, {inner}, {s_a}, {s_b})",
    "quotient": "quotient_of({k}, {inner}, {over}, s->{n}, {s_b}, by->inverse_{b})",
    "sqrt": "root_of({k}, {inner}, {over}, s->{n}, by->inverse_{n})",
    "ramp": "ramp_times({k}, {ramp}, {s_b})",
    "drift": "drift_times({k}, {ramp}, {s_b})",
    "rate": "(double)({k} + 1) * {s_a}[{k} + 1]",
    "sin": "sin_of({k}, {s_a}, s->{other})",
    "cos": "cos_of({k}, {s_a}, s->{other})",
    "exp": "exp_of({k}, {s_a}, s->{n})",
}
VARIATION = {
    "square": "2.0 * product({s_a}, t->{a}, {k})",
    "product": "vary_product({s_a}, t->{a}, {s_b}, t->{b}, {k})",
    "quotient": "vary_quotient(s->{n}, t->{n}, {s_b}, t->{b}, {over}, {k})",
    "sqrt": "vary_root(s->{n}, t->{n}, {over}, {k})",
    "ramp": "vary_ramp_times({k}, {ramp}, {d_ramp}, {s_b}, t->{b})",
    "drift": "vary_drift_times({k}, {ramp}, {d_ramp}, {s_b}, t->{b})",
    "rate": "(double)({k} + 1) * t->{a}[{k} + 1]",
    "sin": "product(s->{other}, t->{a}, {k})",
    "cos": "-product(s->{other}, t->{a}, {k})",
    "exp": "product(s->{n}, t->{a}, {k})",
}
SUMS = {"position": "_position_sums", "sum": "_sums"}  # of what is known a coefficient ahead, and of the rest
WHOLE = {  # the same of what is no motion, in arrays
    "square": "product({s_a}, {s_a}, {k})",
    "product": "product({s_a}, {s_b}, {k})",
    "drift": "drift_times({k}, {ramp}, {s_b})",
    "quotient": "({over} - product_so_far({n}, {s_b}, {k})) * inverse_{b}",
    "sin": "sin_of({k}, {s_a}, {other})",
    "cos": "cos_of({k}, {s_a}, {other})",
}
OTHER = {"sin": "cos", "cos": "sin"}
ONLY = {"sqrt", "sin", "cos", "exp", "rate"}  # operations that are kinds of their own
Terms = tuple[Expression, Expression, Expression]  # what moves, what is constant, what a ramp adds by time


def summary(function: Callable[..., Any]) -> str:
    """Give the docstring of a page's function in one line."""
    return " ".join((function.__doc__ or "").split())


def struct(name: str, members: Iterable[str], size: str = "") -> list[str]:
    """Write a struct of reals."""
    return [
        "typedef struct {",
        *(f"real {member}{size};" for member in dict.fromkeys(members)),
        f"}} {name};",
    ]


def header(name: str, page: str, include: str, lines: list[str]) -> str:
    """Write a header, with what it is derived from on top."""
    guard = f"TDMF_DERIVED_{name.upper()}_H"
    spaced = [
        part
        for line in lines
        for part in (["", line] if line.startswith("/*") and " = " not in line else [line])
    ]
    top = [f"/* Derived from c_core/equations/{page}.py by equations/derive: edit that. */"]
    top += [f"#ifndef {guard}", f"#define {guard}", "", f'#include "{include}"']
    return "\n".join([*top, *spaced, "", "#endif", ""])


def rebuilt(expression: Expression, new: dict[Expression, Expression]) -> Expression:
    """Give an expression with some of its parts replaced; names stay."""
    for node in ordered([expression]):
        if node not in new:
            operands = [new[operand] for operand in node.operands]
            new[node] = node if operands == list(node.operands) else Expression(node.operation, *operands)
            new[node].name = new[node].name or node.name
    return new[expression]


def scaled(by: Expression, node: Expression) -> Expression:
    """Give a constant times a quantity, with the sign of one without a name in front."""
    return -(by * node.operands[0]) if node.operation == "negative" and node.name is None else by * node


def spread(by: Expression, node: Expression) -> Expression:
    """Give a constant times a sum, term by term."""
    if node.operation in ("+", "-"):
        a, b = (spread(by, operand) for operand in node.operands)
        return a + b if node.operation == "+" else a - b
    if node.operation == "negative":
        return -spread(by, node.operands[0])
    return scaled(by * node.operands[0], node.operands[1]) if has_factor(node) else by * node


def has_factor(node: Expression) -> bool:
    """Whether a quantity is a product with a constant."""
    return node.operation == "*" and node.operands[0].is_constant


def is_steady(node: Expression) -> bool:
    """Whether it is constant, but for ramps."""
    leaves = [leaf for leaf in ordered([node]) if not leaf.operands]
    return all(leaf.is_constant or leaf.marks.get("ramp") is not None for leaf in leaves)


def takes_factor(node: Expression) -> bool:
    """Whether each term of a sum has a constant factor, so that another costs nothing."""
    if node.operation in ("+", "-", "negative"):
        return all(takes_factor(operand) or is_steady(operand) for operand in node.operands)
    return has_factor(node)


def changes_of_constants(
    expression: Expression, known: Iterable[Expression] = ()
) -> dict[Expression, Expression]:
    """Give d->name for each constant c->name that an expression has outside of what is known."""
    leaves = [leaf for leaf in ordered([expression], known) if str(leaf.value).startswith("c->")]
    return {leaf: symbol("d" + leaf.value[1:], constant=True) for leaf in leaves if leaf not in known}


def constant_name(node: Expression) -> str:
    """Name what is made of constants alone by these, unless a page has named it."""
    words = {"*": "_", "/": "_over_", "+": "_plus_", "-": "_minus_", "negative": "minus_"}
    if node.is_number():
        return "".join(sign if sign.isalnum() else "_" for sign in str(node.value))
    if node.name is None:
        word = words.get(node.operation, node.operation + "_of_")
        name = word.join(["", *map(constant_name, node.operands)][-2:])
        node.name = f"by_{name}" if name[0].isdigit() else name
    return "d_" + node.name if str(node.value).startswith("d->") else node.name


def divided(rate: str) -> str:
    """Write a state's next coefficient, by that of its rate."""
    one = " " not in rate or rate.startswith(("with_", "ramp_of", "constant_of"))
    return rate if rate == "real_of(0.0)" else f"{rate if one else f'({rate})'} * divide"


class Family:
    """Motions that share the structs of their series; `cases` has what the page is told of each.

    `constants` are all that is given, `ramps` of them what changes in time, in any width where True, else
    where inputs ramp; `rates` are quantities that are rates of others; of `varied` the variation is asked
    for, besides that of the states.
    """

    def __init__(self, name: str, page: Any, **given: Any) -> None:
        self.name, self.page = name, page
        self.noted, self.varied = given["noted"].split(), given["varied"].split()
        self.ramps, self.rates, self.cases = given["ramps"], given["rates"], given["cases"]
        self.constants = [c for c in given["constants"] if c.removesuffix("_rate") not in self.ramps]

    def motion(self, case: str) -> "Motion":
        """Trace one case, alone."""
        forget()
        return Motion(self, case, **self.cases[case])

    def structs(self) -> list[str]:
        """Write coefficients, series, variation, what a motion starts with, and the states made of that."""
        motions, name, code = [self.motion(case) for case in self.cases], self.name, self.page.start.__code__
        forget()
        given = {start: symbol("start->" + start) for start in code.co_varnames[: code.co_argcount]}
        states = vars(trace(self.page.start, **given))
        changes = {leaf: symbol("d->" + start) for start, leaf in given.items()}
        varied = {state: derivative(value, changes) for state, value in states.items()}
        rates = [ramp + "_rate" for ramp in self.ramps]
        return [
            "/* What the motions depend on, and its rates where it changes in time. */",
            *struct(f"{name}_coefficients", [*self.constants, *self.ramps, *rates]),
            "/* Series of the states and of what is made of them, up to the order or one less. */",
            *struct(f"{name}_series", (m for motion in motions for m in motion.members), "[SERIES_TERMS]"),
            "/* The first variations of some. */",
            *struct(
                f"{name}_variation",
                (m for motion in motions for m in motion.varied_members),
                "[SERIES_TERMS]",
            ),
            "/* What a motion starts with. */",
            *struct(f"{name}_start", given),
            f"/* {summary(self.page.start)} */",
            f"static inline void begin_{name}(const {name}_start *start, {name}_series *s) {{",
            *(f"s->{state}[0] = {c_text(value)};" for state, value in states.items()),
            "}",
            "/* Their variation, where what it starts with varies by d. */",
            f"static inline void begin_{name}_variation(const {name}_start *start, const {name}_start *d, "
            f"{name}_variation *t) {{",
            *(["(void)start;"] if not set(given.values()) & set(ordered(varied.values())) else []),
            *(f"t->{state}[0] = {c_text(value)};" for state, value in varied.items()),
            "}",
        ]


class Motion:
    """One case of a family, traced: which quantities are kept as series, and C of all of them."""

    values = VALUE

    def __init__(self, family: Family, case: str, noted: str = "", ramp: bool = True, **told: Any) -> None:
        self.family, self.case, start = family, case, family.page.start
        held = {name: symbol(f"c->{name}", constant=True) for name in family.constants}
        for name, always in family.ramps.items():
            rate = symbol(f"c->{name}_rate", constant=True) if ramp or always else None
            held[name] = symbol(f"c->{name}", constant=rate is None, ramp=rate, always=always)
        states = [symbol(f"s->{name}") for name in vars(start(*[1.0] * start.__code__.co_argcount))]
        traced = trace(family.page.motion, Record(**held), Record(**{str(s.name): s for s in states}), **told)
        found = {name: lift(value) for name, value in vars(traced).items() if name != "rates"}
        for name, value in found.items():
            value.name = value.name if value.operation in ("symbol", "number") else name
        new: dict[Expression, Expression] = {}
        for name, of in family.rates.items():
            new[found[name]] = Expression("rate", rebuilt(found[of], new))
            new[found[name]].name = name
        found = {name: rebuilt(value, new) for name, value in found.items()}
        self.varied = {name: found[name] for name in family.varied}
        roots = [rebuilt(lift(getattr(traced.rates, str(state.name))), new) for state in states]
        names = [*family.noted, *noted.split()]
        roots = self.with_factors_spread([*roots, *(found[name] for name in names)])
        self.rates = dict(zip(states, roots, strict=False))
        self.noted = dict(zip(names, roots[len(states) :], strict=True))
        self.kind: dict[Expression, str] = {}
        self.other: dict[Expression, Expression] = {}
        self.nodes = self.moving(roots)
        self.varied_nodes = self.moving([*self.rates.values(), *self.varied.values()])
        self.find_ahead()
        self.find_kept()

    # ---- what is what -------------------------------------------------------------------------------------

    def with_factors_spread(self, roots: list[Expression]) -> list[Expression]:
        """Multiply constants into sums whose terms have one: that saves a product for each coefficient."""
        nodes = ordered(roots)
        new: dict[Expression, Expression] = {}
        for node in nodes:
            uses = [other.operands.count(node.operands[-1]) for other in nodes if node.operands]
            made = rebuilt(node, new)
            if (
                has_factor(node)
                and sum(uses) + roots.count(node.operands[1]) == 1
                and takes_factor(made.operands[1])
            ):
                made = spread(*made.operands)
                made.name = made.name or node.name
            new[node] = made
        return [new[root] for root in roots]

    def moving(self, roots: Iterable[Expression]) -> list[Expression]:
        """Give what moves of all that the roots are made of, operands first, and note kinds and names."""
        nodes = [node for node in ordered(roots) if not is_steady(node)]
        for node in ordered(roots):
            if node.is_constant and node.operands:
                constant_name(node)
        others = [
            getattr(node.operands[0], OTHER[node.operation])() for node in nodes if node.operation in OTHER
        ]
        if not set(others) <= set(nodes):  # sine and cosine come in pairs
            return self.moving([*others, *roots])
        self.other |= dict(zip((node for node in nodes if node.operation in OTHER), others, strict=True))
        for node in nodes:
            steady = [is_steady(operand) for operand in node.operands]
            kind = node.operation if node.operation in ONLY else "linear" if node.operands else "state"
            if node.operation == "*" and any(steady) and not any(o.is_constant for o in node.operands):
                kind = "drift" if any(operand.marks.get("always") for operand in node.operands) else "ramp"
            elif node.operation == "*" and not any(steady):
                kind = "square" if node.operands[0] is node.operands[1] else "product"
            self.kind[node] = "quotient" if node.operation == "/" and not steady[1] else kind
            if node.name is None and self.kind[node] != "linear":
                word = {"*": "_times_", "/": "_over_"}.get(node.operation, node.operation + "_of_")
                node.name = word.join(["", *(operand.name or "sum" for operand in node.operands)][-2:])
        return nodes

    def factors(self, node: Expression) -> tuple[Expression, ...]:
        """Give the two series whose inner terms a quantity sums, if any."""
        own = {"quotient": (node, node.operands[-1] if node.operands else node), "sqrt": (node, node)}
        return node.operands if self.kind[node] in ("square", "product") else own.get(self.kind[node], ())

    def convolved(self, node: Expression) -> set[Expression]:
        """Give the series that all coefficients are needed of."""
        given = set(node.operands) if self.kind[node] in ("ramp", "drift", "rate", "exp", *OTHER) else set()
        own = {node} if self.kind[node] in ("exp", *OTHER) else set()
        return {series for series in given | own | set(self.factors(node)) if not is_steady(series)}

    def find_ahead(self) -> None:
        """Find what is known to one coefficient more, and what of that has to be: for a rate."""
        self.early = [state for state, rate in self.rates.items() if rate in self.rates]
        ahead = set(self.early)
        for node in self.nodes:
            if (
                node.operands
                and self.kind[node] != "rate"
                and all(is_steady(o) or o in ahead for o in node.operands)
            ):
                ahead.add(node)
        needed = [node.operands[0] for node in self.nodes if self.kind[node] == "rate"]
        if not set(needed) <= ahead:
            raise ValueError(f"{self.case}: a rate of what is not known a coefficient ahead")
        self.ahead = [node for node in ordered(needed) if node.operands]

    def find_kept(self) -> None:
        """Find what is stored: what is noted or convolved, and what the variation of a constant meets."""
        self.kept = {*self.rates, *self.noted.values()}.union(*map(self.convolved, self.nodes))
        met: set[Expression] = set()
        for node in self.varied_nodes:
            if self.kind[node] == "linear":
                moving, atoms = self.terms(node)[0], self.atoms(node)
                changes = {**dict.fromkeys(atoms, number(0)), **changes_of_constants(moving, atoms)}
                met.update(part for part in ordered([derivative(moving, changes)], atoms) if part in atoms)
        self.kept |= met
        for node in self.kept:
            if node.name is None and not is_steady(node):
                raise ValueError(
                    f"{self.case}: {c_text(node)} is needed as a series: give it a variable in its page"
                )
        needed = set[Expression]().union(*map(self.convolved, self.varied_nodes))
        self.varied_kept = {*self.rates, *self.varied.values()} | needed
        self.arrays = [node for node in self.varied.values() if node in needed - self.kept]
        self.members = [
            *self.noted,
            *(str(node.name) for node in [*self.rates, *self.nodes] if node in self.kept),
        ]
        stored = [str(node.name) for node in [*self.rates, *self.varied_nodes] if node in self.varied_kept]
        self.varied_members = [*self.varied, *stored]

    # ---- sums ---------------------------------------------------------------------------------------------

    def stands(self, node: Expression) -> bool:
        """Whether a quantity has a C variable of its own: it is stored, no sum, or named."""
        if is_steady(node):
            return False
        return (
            self.kind[node] != "linear" or node in self.kept or (node.name is not None and node in self.nodes)
        )

    def terms(self, node: Expression) -> Terms:
        """Give what of a sum moves, made of what stands, its constant, and what a ramp adds by time."""

        def look_into(part: Expression) -> tuple[Expression, ...]:
            if is_steady(part) and (part.is_constant or not part.operands):
                return (
                    number(0),
                    part,
                    part.marks.get("ramp", number(0)) if not part.is_constant else number(0),
                )
            if part is not node and self.stands(part):
                return part, number(0), number(0)
            if part.operation in ("+", "-"):
                pairs = zip(*map(look_into, part.operands), strict=True)
                return tuple(a + b if part.operation == "+" else a - b for a, b in pairs)
            if part.operation == "/":
                return tuple(a / part.operands[1] for a in look_into(part.operands[0]))
            inner = look_into(part.operands[-1])
            return tuple(-a if part.operation == "negative" else scaled(part.operands[0], a) for a in inner)

        moving, constant, rate = look_into(node)
        return moving, constant, rate

    def atoms(self, node: Expression) -> list[Expression]:
        """Give what stands of all that a sum is made of."""

        def look_into(part: Expression) -> list[Expression]:
            if part is not node and (is_steady(part) or self.stands(part)):
                return [] if is_steady(part) else [part]
            return [atom for operand in part.operands for atom in look_into(operand)]

        return look_into(node)

    def text_of(
        self, k: str, factors: dict[Expression, str], prefix: str
    ) -> Callable[[Expression], str | None]:
        """Say how coefficient k of what stands is written; products of constants join the factors."""

        def text(node: Expression) -> str | None:
            if node.is_constant and node.operands:
                name = factors.setdefault(node, constant_name(node))
                if list(factors.values()).count(name) > 1:
                    raise ValueError(f"two constants are called {name}: give them variables in their page")
                return prefix + name
            if node.is_constant or node not in self.kind:
                return None
            if node in self.arrays:
                return f"{node.name}[{k}]"
            return f"s->{node.name}[{k}]" if node in self.kept else node.name if self.stands(node) else None

        return text

    def sum_text(self, node: Expression, k: str, factors: dict[Expression, str], varied: bool) -> str:
        """Write coefficient k of a sum, or of its variation."""
        terms, drifts = self.terms(node), any(leaf.marks.get("always") for leaf in ordered([node]))
        text_of = self.text_of(k, factors, "" if varied or node in self.arrays else "by->")
        if varied:
            atoms = self.atoms(node)
            changes = {
                **changes_of_constants(terms[0], atoms),
                **{atom: self.change(atom, k) for atom in atoms},
            }
            steady = [derivative(part, changes_of_constants(part)) for part in terms[1:]]
            terms = derivative(terms[0], changes), steady[0], steady[1]
        moving = c_text(terms[0], lambda part: None if part is node else text_of(part))
        constant, rate = (f"real_of({c_text(t)})" if t.is_number() else c_text(t) for t in terms[1:])
        if terms[0].is_number(0):
            alone = (
                f"ramp_of({k}, {constant}, {rate})"
                if not terms[2].is_number(0)
                else f"constant_of({k}, {constant})"
            )
            return "real_of(0.0)" if terms[1].is_number(0) and terms[2].is_number(0) else alone
        if not terms[2].is_number(0):
            return f"with_{'drift' if drifts else 'ramp'}({k}, {moving}, {constant}, {rate})"
        return moving if terms[1].is_number(0) else f"with_constant({k}, {moving}, {constant})"

    def operand(self, node: Expression, k: str, factors: dict[Expression, str], varied: bool = False) -> str:
        """Write coefficient k of an operand, which may be a sum without a name, or of its variation."""
        if varied and (self.stands(node) or node in self.varied_kept) and not is_steady(node):
            return str(self.change(node, k).value)
        text = self.text_of(k, factors, "by->")(node) if self.stands(node) and not varied else None
        return text or self.sum_text(node, k, factors, varied)

    def change(self, node: Expression, k: str) -> Expression:
        """Give a symbol for the variation of coefficient k of what stands."""
        return symbol(f"t->{node.name}[{k}]" if node in self.varied_kept else f"d_{node.name}")

    # ---- C ------------------------------------------------------------------------------------------------

    def coefficient(
        self, node: Expression, k: str, factors: dict[Expression, str], varied: bool = False
    ) -> str:
        """Write coefficient k of a quantity, or of its variation."""
        kind = self.kind[node]
        if kind == "linear":
            return self.sum_text(node, k, factors, varied)
        if kind in ("ramp", "drift") and not is_steady(node.operands[0]):
            node = Record(name=node.name, operands=node.operands[::-1], operation="*")  # type: ignore[assignment]
        a, b = node.operands[0], node.operands[-1]
        series = [str(part.name) if part in self.arrays else f"s->{part.name}" for part in (a, b)]
        sums = "position" if node in self.ahead else "sum"
        ramp = f"{a.value}, {a.marks['ramp'].value}" if kind in ("ramp", "drift") else ""
        over = self.operand(a, k, factors, varied) if kind in ("quotient", "sqrt") else ""
        names = {"n": node.name, "a": a.name, "b": b.name, "s_a": series[0], "s_b": series[1]}
        names |= {"ramp": ramp, "d_ramp": ramp.replace("c->", "d->"), "inner": f"{sums}->{node.name}"}
        other = self.other[node].name if kind in OTHER else ""
        return (VARIATION if varied else self.values)[kind].format(k=k, over=over, other=other, **names)

    def turn(self, node: Expression, k: str) -> str | None:
        """Write sine and cosine at once, where the angle's rate is a series."""
        leaves = [leaf for leaf in ordered(node.operands) if not leaf.operands and not is_steady(leaf)]
        if self.kind[node] not in OTHER or not all(leaf in self.rates for leaf in leaves):
            return None
        rate = derivative(node.operands[0], {leaf: self.rates[leaf] for leaf in leaves})
        pair = sorted([node, self.other[node]], key=lambda part: part.operation, reverse=True)
        series = [node.operands[0], rate, *pair]  # sine before cosine
        if not all(part in self.kept or part in self.arrays for part in series):
            return None
        names = [str(part.name) if part in self.arrays else f"s->{part.name}" for part in series]
        return f"turn_by({k}, {', '.join(names)});"

    def define(self, node: Expression, k: str, factors: dict[Expression, str]) -> list[str]:
        """Write coefficient k of a quantity into its place, below the page's formula."""

        def name_of(part: Expression) -> str | None:
            own = f"rate of {part.operands[0].name}" if part.operation == "rate" else None
            return part.name if part is not node and part.name else own

        if not node.operands or not self.stands(node):
            return []
        place = f"s->{node.name}[{k}]" if node in self.kept else f"const real {node.name}"
        formula = f"/* {node.name} = {c_text(node, name_of)} */"
        turn = self.turn(node, k)
        if turn is not None and self.nodes.index(self.other[node]) < self.nodes.index(node):
            return [formula]
        return [formula, turn or f"{place} = {self.coefficient(node, k, factors)};"]

    def source(self) -> list[str]:
        """Write the functions of the case, the last of which expands the series."""
        factors: dict[Expression, str] = {}
        case, series = self.case, f"{self.family.name}_series *s"
        lines = [f"s->{state.name}[k + 1] = s->{self.rates[state].name}[k] * divide;" for state in self.early]
        for node in [*self.ahead, *(node for node in self.nodes if node not in self.ahead)]:
            lines += self.define(node, "k + 1" if node in self.ahead else "k", factors)
        for name, value in self.noted.items():
            lines += (
                [f"s->{name}[k] = {self.sum_text(value, 'k', factors, False)};"] if is_steady(value) else []
            )
        for state, rate in self.rates.items():
            if state not in self.early:
                lines.append(f"s->{state.name}[k + 1] = {divided(self.operand(rate, 'k', factors))};")
        summed = [node for node in self.nodes if self.factors(node)]
        groups = {
            "position": [n for n in summed if n in self.ahead],
            "sum": [n for n in summed if n not in self.ahead],
        }
        groups = {name: nodes for name, nodes in groups.items() if nodes}
        inverses = [n for n in self.nodes if self.kind[n] == "sqrt"]
        inverses = list(
            dict.fromkeys([n.operands[1] for n in self.nodes if self.kind[n] == "quotient"] + inverses)
        )
        sums = ", ".join(f"const {case + SUMS[name]} *{name}" for name in groups)
        first = f"const {self.family.name}_coefficients *c, const {case}_factors *by, int k"
        return [
            "/* Factors that all coefficients have, and what is divided by. */",
            *struct(f"{case}_factors", [*(f"inverse_{node.name}" for node in inverses), *factors.values()]),
            *(line for name, nodes in groups.items() for line in self.sums(name, nodes, series)),
            f"/* {summary(self.family.page.motion)} From coefficient k of the states to the next. */",
            f"KERNEL void expand_{case}_on({first}, {sums}, {series}) {{",
            "const double divide = series_reciprocal[k + 1];",
            *lines,
            "}",
            *self.by_two(groups, f"{first}, {series}"),
            *self.whole(groups, inverses, factors, series),
        ]

    def sums(self, name: str, nodes: list[Expression], series: str) -> list[str]:
        """Write the struct of inner terms and how pairs of coefficients add to it."""
        full, pairs, squares = self.case + SUMS[name], list[str](), list[str]()
        for node in nodes:
            a, b = (f"s->{factor.name}" for factor in self.factors(node))
            pairs.append(f"sum->{node.name} += {a}[i] * {b}[j];")
            pairs += [] if a == b else [f"sum->{node.name} += {a}[j] * {b}[i];"]
            squares.append(
                f"sum->{node.name} = " + (f"0.5 * ({a}[i] * {a}[i]);" if a == b else f"{a}[i] * {b}[i];")
            )
        return [
            "/* Inner terms of a coefficient: all without coefficient 0 of a factor, of squares half. */",
            *struct(full, (str(node.name) for node in nodes)),
            "/* Adds the terms with coefficient i of one factor and j of the other. */",
            f"KERNEL void add_{full}(const {series}, int i, int j, {full} *sum) {{",
            *pairs,
            "}",
            "/* Sets them to the terms with coefficient i of both factors. */",
            f"KERNEL void begin_{full}(const {series}, int i, {full} *sum) {{",
            *squares,
            "}",
        ]

    def by_two(self, groups: dict[str, Any], parameters: str) -> list[str]:
        """Write the steps from an even coefficient two further."""
        begin, loops, last = [], [], []
        for name in groups:
            full = self.case + SUMS[name]
            begin += [
                f"static const {full} no_{name} = {{0}};",
                f"{full} {name} = no_{name}, next_{name} = no_{name};",
            ]
            if name == "position":  # a coefficient ahead
                loops.append(f"begin_{full}(s, middle + 1, &next_{name});")
                loops.append(f"add_{full}(s, middle, middle + 1, &{name});")
            else:
                loops.append(f"begin_{full}(s, middle, &{name});")
            loops += [
                f"for (int i = middle, j = middle + {2 if name == 'position' else 1}; i > 1; --i, ++j) {{",
                f"add_{full}(s, i, j, &next_{name});",
                f"add_{full}(s, i - 1, j, &{name});",
                "}",
            ]
            last.append(f"add_{full}(s, 1, {'k + 1' if name == 'position' else 'k'}, &next_{name});")
        return [
            "/* From coefficient k, even, two further. */",
            f"KERNEL void expand_{self.case}_by_two({parameters}) {{",
            "const int middle = k / 2;",
            *begin,
            *loops,
            f"expand_{self.case}_on(c, by, k, {', '.join('&' + name for name in groups)}, s);",
            *last,
            f"expand_{self.case}_on(c, by, k + 1, {', '.join('&next_' + name for name in groups)}, s);",
            "}",
        ]

    def whole(
        self, groups: dict[str, Any], inverses: list[Expression], factors: dict[Expression, str], series: str
    ) -> list[str]:
        """Write the whole expansion."""
        family, case, first = self.family.name, self.case, []
        for node in ordered(inverses):
            if node in self.kept and node.operands:
                known = [part for part in ordered([node]) if part in self.kept and part is not node]
                value = c_text(
                    node, lambda part, known=known: f"s->{part.name}[0]" if part in known else None, "real_"
                )  # type: ignore[misc]
                first.append(f"s->{node.name}[0] = {value};")
        sums = ", ".join("&" + name for name in groups)
        position = [f"begin_{case}_position_sums(s, 1, &position);"] if "position" in groups else []
        return [
            "/* From coefficient 0 of the states up to `order`; an odd order gets one coefficient more. */",
            f"KERNEL void expand_{case}(const {family}_coefficients *given, int order, {series}) {{",
            f"const {family}_coefficients copy = *given, *c = &copy;",
            *(f"static const {case + SUMS[name]} no_{name} = {{0}};" for name in groups),
            *(f"{case + SUMS[name]} {name} = no_{name};" for name in groups),
            *first,
            f"const {case}_factors factors = {{",
            *(f".inverse_{node.name} = 1.0 / s->{node.name}[0]," for node in inverses),
            *(f".{name} = {c_text(node)}," for node, name in factors.items()),
            "};",
            f"const {case}_factors *by = &factors;",
            f"expand_{case}_on(c, by, 0, {sums}, s);",
            *position,
            f"expand_{case}_on(c, by, 1, {sums}, s);",
            "for (int k = 2; k < order; k += 2) {",
            f"expand_{case}_by_two(c, by, k, s);",
            "}",
            "}",
        ]

    def variation(self) -> list[str]:
        """Write the first variation of the series."""
        family, factors = self.family.name, dict[Expression, str]()

        def define(node: Expression, k: str) -> list[str]:
            if not node.operands or not (node in self.varied_kept or self.stands(node)):
                return []
            place = str(self.change(node, k).value)
            value = self.coefficient(node, k, factors, varied=True)
            return [f"{place if '->' in place else 'const real ' + place} = {value};"]

        lines = [f"t->{state.name}[k + 1] = t->{self.rates[state].name}[k] * divide;" for state in self.early]
        lines += [line for node in self.ahead for line in define(node, "k + 1")]
        for node in self.varied_nodes:
            if node in self.arrays:
                lines.append(f"{node.name}[k] = {self.sum_text(node, 'k', factors, False)};")
            lines += define(node, "k") if node not in self.ahead else []
        for name, value in self.varied.items():
            lines += (
                [f"t->{name}[k] = {self.sum_text(value, 'k', factors, True)};"] if is_steady(value) else []
            )
        for state, rate in self.rates.items():
            if state not in self.early:
                lines.append(f"t->{state.name}[k + 1] = {divided(self.operand(rate, 'k', factors, True))};")
        return [
            "/* The same differentiated, from coefficient 0 of the states of t; coefficients vary by d. */",
            f"static inline void vary_{self.case}(const {family}_coefficients *c, const {family}_series *s, "
            f"const {family}_coefficients *d, int order, {family}_variation *t) {{",
            *(f"real {node.name}[SERIES_TERMS];" for node in self.arrays),
            *(f"const real {name} = {c_text(node)};" for node, name in factors.items()),
            *(line for node in self.ahead for line in define(node, "0")),
            "for (int k = 0; k < order; ++k) {",
            "const double divide = series_reciprocal[k + 1];",
            *lines,
            "}",
            "}",
        ]


class Expansion(Motion):
    """A law of quantities whose series there are: a guard, or what one is made of."""

    values = WHOLE

    def __init__(self, name: str, law: Callable[..., Any], rates: dict[str, str], **given: Any) -> None:
        """Trace a law; `given` has None for a series, the text of a constant, two of one that drifts."""
        forget()
        self.name, self.law, self.case = name, law, name
        self.parameters = list(dict.fromkeys(parameters({**given, **dict.fromkeys(rates.values())})))
        self.rates = {symbol(of): symbol(rate) for of, rate in rates.items()}
        self.kind, self.other, self.kept, self.ahead = {}, {}, set[Expression](), []
        result = trace(law, **{key: symbols(key, value) for key, value in given.items()})
        result.name = name
        self.nodes = self.moving([result])
        needed = {result}.union(*map(self.convolved, self.nodes))
        self.arrays = [node for node in self.nodes if not node.operands or node in needed]
        self.arrays += self.rates.values()

    def source(self) -> list[str]:
        """Write a function that expands the law."""
        factors, lines = dict[Expression, str](), list[str]()
        for node in self.nodes:
            if node.operands and self.stands(node):
                place = f"{node.name}[k]" if node in self.arrays else f"const real {node.name}"
                turn = self.turn(node, "k")
                lines.append(turn or f"{place} = {self.coefficient(node, 'k', factors)};")
        lines = list(dict.fromkeys(lines))
        local = [node for node in self.arrays if node.operands and node.name != self.name]
        divisors = dict.fromkeys(
            node.operands[1].name for node in self.nodes if self.kind[node] == "quotient"
        )
        return [
            f"/* {summary(self.law)} */",
            f"static inline void expand_{self.name}({', '.join(self.parameters)}, int order, "
            f"real {self.name}[SERIES_TERMS]) {{",
            *(f"real {node.name}[SERIES_TERMS];" for node in local),
            *(f"const real inverse_{name} = 1.0 / {name}[0];" for name in divisors),
            *(f"const real {name} = {c_text(node)};" for node, name in factors.items()),
            "int k = 0;",
            "do {",
            *lines,
            "} while (++k <= order);",
            "}",
        ]


def parameters(given: dict[str, Any]) -> Iterable[str]:
    """Name the C parameters that hand in what a law is told; a servo is a struct."""
    for name, text in given.items():
        if isinstance(text, dict):
            yield from parameters(text)
        elif text is None:
            yield f"const real *{name}"
        else:
            for part in text if isinstance(text, tuple) else (text,):
                yield f"const hip_law *{part.split('->')[0]}" if "->" in part else f"real {part}"


def symbols(name: str, given: Any) -> Any:
    """Give what a law is told: records, series, constants and drifts."""
    if isinstance(given, dict):
        return Record(**{key: symbols(key, value) for key, value in given.items()})
    if isinstance(given, tuple):
        return symbol(given[0], ramp=symbol(given[1], constant=True), always=True)
    return symbol(name) if given is None else symbol(given, constant=True)
