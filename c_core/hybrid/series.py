"""Taylor series of quantities that move: what coefficient k of each is made of.

A quantity is expanded by the recursion of its last operation; sums need none. First variations and guards are
expansions, too: of expressions some parts of which are series that are there already.
"""

import random

from .c_text import RESERVED, c_text, name_of, own_name
from .errors import PageError
from .expressions import (
    VARIATIONS,
    Variation,
    leaves_of,
    lift,
    made,
    ordered,
    remade,
    replaced,
    symbol,
    value_of,
)

# For each kind: the series that its recursion reads (n is the quantity, a and b its operands); how
# coefficient k follows from inner sums that the loops of a motion add up for two coefficients at once; and
# by a sum of its own.
RECURSIONS = {
    "product": ("ab", "product_of({k}, {inner}, {a}, {b})", "product({a}, {b}, {k})"),
    "square": ("aa", "square_of({k}, {inner}, {a})", "product({a}, {a}, {k})"),
    "quotient": (
        "nb",
        "quotient_of({k}, {inner}, {over}, {n}, {b}, by->{inverse})",
        "({over} - product_so_far({n}, {b}, {k})) / {b}[0]",
    ),
    "sqrt": ("nn", "root_of({k}, {inner}, {over}, {n}, by->{inverse})", "own_root_of({k}, {over}, {n})"),
    "drift": ("b", "drift_times({k}, {value}, {slope}, {b})"),
    "rate": ("a", "(double)({k} + 1) * {a}[{k} + 1]"),
    "exp": ("an", "exp_of({k}, {a}, {n})"),
    "log": ("an", "log_of({k}, {a}, {n})"),
    "sin": ("asc", "sine_and_cosine_of({k}, {a}, {s}, {c})"),
    "cos": ("asc", "sine_and_cosine_of({k}, {a}, {s}, {c})"),
}
NO_DEGREE = 99
"""The degree of what is no polynomial in time."""


def drifts(node):
    """Whether a quantity grows at a constant rate, as a ramped input does: coefficient 1 is its last."""
    if node.operation == "symbol":
        return node.drifts
    return kind_of(node) == "linear" and all(o.is_constant or drifts(o) for o in node.operands)


def kind_of(node):
    """The kind of recursion, "linear" for none."""
    if node.is_constant or node.operation in ("+", "-", "negative"):
        return "linear"
    if node.operation not in ("*", "/"):
        return node.operation
    a, b = node.operands
    if (a if node.operation == "*" else b).is_constant:
        return "linear"
    if node.operation == "*" and (drifts(a) or drifts(b)):
        return "drift"
    return "quotient" if node.operation == "/" else "square" if a is b else "product"


class Expansion:
    """Series of states and of what their rates are made of, one coefficient after the other.

    `rates` are those of the states, by symbol. `wanted` has further quantities, by the arrays that they go
    to. `known` are series that are there. `by_pairs` says that inner sums come from the loops of a motion.
    """

    def __init__(self, rates, wanted, into, known=(), by_pairs=False):
        self.rates, self.wanted, self.known, self.by_pairs = rates, wanted, dict(known), by_pairs
        roots = [*rates.values(), *wanted.values(), *rates]
        angles = dict.fromkeys(
            n.operands[0] for n in ordered(roots, self.known) if kind_of(n) in ("sin", "cos")
        )
        roots += [function for angle in angles for function in (angle.sin(), angle.cos())]
        self.nodes = [node for node in ordered(roots, self.known) if not node.is_constant]
        self.made = [node for node in self.nodes if node.operands and node not in self.known]
        self.arrays = {leaf: str(leaf.value) for leaf in self.nodes if not leaf.operands} | self.known
        self._give_arrays(into)
        needed = [node.operands[0] for node in self.made if node.operation == "rate"]
        self.ahead = [node for node in ordered(needed, self.known) if node in set(self.made)]
        self.early = [s for s, rate in rates.items() if rate in rates or rate.drifts]
        late = {leaf for leaf in ordered(needed, self.known) if not leaf.operands and leaf in rates}
        assert not late - set(self.early), "the rate of what is not known a coefficient ahead"

    def _give_arrays(self, into):
        taken = {name_of(node) for node in self.arrays}
        for node in self.made:
            if kind_of(node) != "linear":
                if node.name is None or node.name in taken or node.name in RESERVED:
                    node.name = own_name(node, taken)
                taken.add(node.name)
                self.arrays[node] = into.format(node.name)
        for node in self.made:
            for series in self.series_in(node):
                if series not in self.arrays:
                    if series.name is None or series.name in taken or series.name in RESERVED:
                        series.name = own_name(series, taken)
                    taken.add(series.name)
                    self.arrays[series] = into.format(series.name)

    def parts(self, node):
        """The series that a recursion reads, by their letters."""
        a, b = node.operands[0], node.operands[-1]
        if kind_of(node) == "drift":
            return {"a": a, "b": b} if drifts(a) else {"a": b, "b": a}
        if kind_of(node) in ("sin", "cos"):
            return {"a": a, "s": a.sin(), "c": a.cos()}
        return {"n": node, "a": a, "b": b}

    def series_in(self, node):
        """Quantities whose series a recursion reads."""
        letters, *_ = RECURSIONS.get(kind_of(node), ("",))
        return [self.parts(node)[letter] for letter in letters]

    def coefficient(self, node, k):
        """Text of coefficient k."""
        return f"{self.arrays[node]}[{k}]" if node in self.arrays else self.recursion(node, k)

    def recursion(self, node, k):
        """Text of how coefficient k is computed."""
        if kind_of(node) == "linear":
            return self.linear(node, k)
        _, *texts = RECURSIONS[kind_of(node)]
        text, parts = texts[0] if self.by_pairs else texts[-1], self.parts(node)
        given = {letter: self.arrays.get(part) for letter, part in parts.items()}
        given |= {"inner": f"sum->{node.name}", "inverse": f"inverse_{name_of(self.series_in(node)[-1])}"}
        if "{slope}" in text:
            given |= {"value": self.coefficient(parts["a"], 0), "slope": self.coefficient(parts["a"], 1)}
        if "{over}" in text:
            given["over"] = self.coefficient(node.operands[0], k)
        return text.format(k=k, **given)

    def linear(self, node, k):
        """Text of coefficient k of a sum: what is constant stands in coefficient 0 alone."""
        atoms = self.atoms(node)
        zeros = dict.fromkeys(atoms, lift(0))
        moving = lift(0)
        for atom, factor in linear_factors(node, atoms).items():
            moving = moving + factor * symbol(self.coefficient(atom, k))
        (rest,) = replaced([node], zeros)
        steady = c_text(rest)
        if moving.is_number(0):
            steady = f"broadcast({steady})" if rest.operation == "number" else steady
            return steady if rest.is_number(0) else f"constant_of({k}, {steady})"
        return c_text(moving) if rest.is_number(0) else f"with_constant({k}, {c_text(moving)}, {steady})"

    def atoms(self, node):
        """What a sum is made of, of all that moves: quantities with series of their own."""
        if node in self.arrays and (node in self.known or not node.operands):
            return [node]
        found, todo, seen = {}, list(reversed([o for o in node.operands if not o.is_constant])), set()
        while todo:
            part = todo.pop()
            if part in seen:
                continue
            seen.add(part)
            if kind_of(part) != "linear" or part in self.arrays:
                found[part] = None
            else:
                todo += reversed([o for o in part.operands if not o.is_constant])
        return list(found)

    def define(self, node, k):
        """Statements that give coefficient k of a quantity with a series of its own."""
        if node not in self.arrays:
            return []
        text = self.recursion(node, k)
        if kind_of(node) in ("sin", "cos"):
            return [f"{text};"]
        formula = c_text(
            node, lambda part: name_of(part) if part is not node and part in self.arrays else None
        )
        lines = [f"/* {name_of(node)} = {formula} */"] if self.by_pairs and len(formula) < 300 else []
        return [*lines, f"{self.arrays[node]}[{k}] = {text};"]

    def step(self):
        """Statements from coefficient k of the states to k + 1; what is known ahead goes first."""
        lines = [
            f"{self.arrays[s]}[k + 1] = {self.coefficient(self.rates[s], 'k')} * series_reciprocal[k + 1];"
            for s in self.early
        ]
        ahead, late = set(self.ahead), [s for s in self.rates if s not in self.early]
        lines += [line for node in self.ahead for line in self.define(node, "k + 1")]
        lines += [line for node in self.made if node not in ahead for line in self.define(node, "k")]
        lines += [f"{array}[k] = {self.coefficient(node, 'k')};" for array, node in self.wanted.items()]
        lines += [
            f"{self.arrays[s]}[k + 1] = series_reciprocal[k + 1] * ({self.coefficient(self.rates[s], 'k')});"
            for s in late
        ]
        return list(dict.fromkeys(lines))

    def summed(self):
        """Quantities whose inner sums the loops of a motion add up."""
        return [n for n in self.made if "{inner}" in "".join(RECURSIONS.get(kind_of(n), ""))]


def linear_factors(node, atoms):
    """The constant factor of each atom in a sum."""
    factors, known = dict.fromkeys(atoms, lift(0)), set(atoms)
    if node in known and not node.operands:
        return {node: lift(1)}
    share = {node: lift(1)}
    for part in reversed(ordered([node], known - {node})):
        factor = share.get(part)
        if factor is None or part.is_constant:
            continue
        if part in known:
            factors[part] = factors[part] + factor
            continue
        a, b = part.operands[0], part.operands[-1]
        of = {
            "+": [(a, factor), (b, factor)],
            "-": [(a, factor), (b, -factor)],
            "negative": [(a, -factor)],
            "*": [(b, a * factor)],
            "/": [(a, factor / b)],
        }[part.operation]
        for operand, more in of:
            if not operand.is_constant:
                share[operand] = share[operand] + more if operand in share else more
    return factors


def degrees_of(rates):
    """Degrees of the states that are polynomials in time; NO_DEGREE for others."""
    degrees = dict.fromkeys(rates, NO_DEGREE)
    for _ in rates:
        found = dict(degrees)
        for node in ordered(rates.values()):
            if node not in found:
                of = [found[o] for o in node.operands]
                degree = (
                    max(of, default=0)
                    if kind_of(node) == "linear"
                    else sum(of)
                    if node.operation == "*"
                    else NO_DEGREE
                )
                found[node] = 0 if node.is_constant else min(NO_DEGREE, degree)
        degrees = {s: min(NO_DEGREE, 1 + found[rate]) for s, rate in rates.items()}
    return degrees


# ---- what the page need not say ------------------------------------------------------------------


def refuse_kinks(root):
    """Refuse what has no Taylor series."""
    for node in ordered([root]):
        if node.operation in ("abs", "select") and not node.is_constant:
            raise PageError(
                f"uses `{node.operation}` of what moves: its Taylor series breaks at the kink. Hold the case "
                "in a state, and let an event change it"
            )


def with_series_of_functions(rates, guards):
    """Rewrite functions that have no recursion: atan2 becomes a state by its rate, with a start."""
    starts, given = {}, list(rates)

    def change(node, operands):
        if node.is_constant or node.operation not in ("atan2", "expm1", "log1p"):
            return remade(node, operands)
        if node.operation == "expm1":
            return operands[0].exp() - 1
        if node.operation == "log1p":
            return (1 + operands[0]).log()
        own = symbol(f"s->seen_{node.name or 'angle'}{'_' * len(starts)}")
        starts[own] = node
        moving = Variation({s: rates[s] for s in given})
        rates[own] = VARIATIONS["atan2"](node, *operands, *(moving.of(o) for o in operands))
        return own

    rates, new = dict(rates), {}
    for state in given:
        (rates[state],) = replaced([rates[state]], new, change)
    guards = replaced(guards, new, change)
    return rates, guards, starts


def with_rates_seen(rates, guards):
    """Replace what is the rate of another quantity, as (x vx + y vy)/r is of r = sqrt(x^2 + y^2).

    Rates of positions are known a coefficient ahead, which is cheaper. Whether two expressions are equal is
    asked at two random points.
    """
    early = {state: rate for state, rate in rates.items() if rate in rates}
    roots = [*rates.values(), *guards]
    nodes = [node for node in ordered(roots) if not node.is_constant]
    of_positions = {}
    for node in nodes:
        parts = (of_positions.get(o, o.is_constant) for o in node.operands)
        of_positions[node] = all(parts) if node.operands else node in early
    draws = [random.Random(seed) for seed in (1, 2)]
    leaves = leaves_of([*roots, *rates])
    points = [{leaf: draw.uniform(0.5, 2) for leaf in leaves} for draw in draws]

    def fingerprint(node):
        try:
            return tuple(f"{value_of([node], point)[0]:.10e}" for point in points)
        except (ArithmeticError, ValueError):
            return None

    moving, by_value = Variation(early), {}
    for node in nodes:
        if of_positions[node] and kind_of(node) in ("sqrt", "quotient", "square"):
            by_value.setdefault(fingerprint(moving.of(node)), made("rate", node))
    by_value.pop(None, None)
    new = {}
    for node in nodes:
        if kind_of(node) in ("quotient", "product") and fingerprint(node) in by_value:
            new[node] = by_value[fingerprint(node)]
            new[node].name = node.name
    made_new = replaced(roots, new)
    return dict(zip(rates, made_new, strict=False)), made_new[len(rates) :]
