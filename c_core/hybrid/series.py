"""Taylor series of moving quantities: the recursion for coefficient k of each.

The last operation of a quantity determines its recursion; sums need none. First variations and guards are
expanded in the same way, and reuse the series of the motion.
"""

import random

from .c_text import c_text, name_of, real_text, take_name
from .errors import PageError
from .expressions import leaves_of, lift, made, ordered, remade, replaced, symbol
from .variations import VARIATIONS, Variation, value_of

# Recursions by kind: the series that one reads (n is the quantity, a and b its operands), the text of
# coefficient k from the inner sums of a motion's loops, and its text with a sum of its own.
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
"""Degree of a quantity that is no polynomial in time."""


def drifts(node):
    """True if a quantity is linear in time, as a ramped input is."""
    if node.operation == "symbol":
        return node.drifts
    return kind_of(node) == "linear" and all(o.is_constant or drifts(o) for o in node.operands)


def kind_of(node):
    """The kind of recursion that an operation needs; "linear" for none."""
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
    """Series of states and of the quantities in their rates, one coefficient after the other.

    `rates` are those of the states, by symbol. `wanted` has further quantities, by the arrays that they go
    to. `known` are existing series. `by_pairs` says that inner sums come from the loops of a motion.
    `of_states` has the rates of all states, if others are expanded here.
    """

    def __init__(self, rates, wanted, into, known=(), by_pairs=False, of_states=None):
        self.rates, self.wanted, self.known, self.by_pairs = rates, wanted, dict(known), by_pairs
        self.of_states = rates if of_states is None else of_states
        roots = [*rates.values(), *wanted.values(), *rates]
        turns = [n for n in ordered(roots, self.known) if kind_of(n) in ("sin", "cos")]
        angles = dict.fromkeys(turn.operands[0] for turn in turns)
        roots += [function for angle in angles for function in (angle.sin(), angle.cos())]
        self.nodes = [node for node in ordered(roots, self.known) if not node.is_constant]
        self.made = [node for node in self.nodes if node.operands and node not in self.known]
        self.arrays = {leaf: str(leaf.value) for leaf in self.nodes if not leaf.operands} | self.known
        self._give_arrays(into)
        needed = [node.operands[0] for node in self.made if node.operation == "rate"]
        self.ahead = [node for node in ordered(needed, self.known) if node in set(self.made)]
        self.early = [s for s, rate in rates.items() if rate in rates or rate.drifts]
        late = {leaf for leaf in ordered(needed, self.known) if not leaf.operands and leaf in rates}
        assert not late - set(self.early), "a rate of a quantity that cannot be expanded one order ahead"

    def _give_arrays(self, into):
        taken = {name_of(node) for node in self.arrays}
        for array, node in self.wanted.items():
            if node in self.made and kind_of(node) != "linear":
                self.arrays[node] = array
        read = [series for node in self.made for series in self.series_in(node)]
        for node in [*(n for n in self.made if kind_of(n) != "linear"), *read]:
            if node not in self.arrays:
                take_name(node, taken)
                self.arrays[node] = into.format(node.name)

    def parts(self, node):
        """The series of a recursion, by their letters in RECURSIONS."""
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
        """Text that computes coefficient k."""
        if kind_of(node) == "linear":
            return self.linear(node, k)
        _, *texts = RECURSIONS[kind_of(node)]
        text, parts = texts[0] if self.by_pairs else texts[-1], self.parts(node)
        given = {letter: self.arrays.get(part) for letter, part in parts.items()}
        rate = self.arrays.get(self.of_states.get(parts["a"])) if "s" in parts else None
        if rate is not None:
            return f"sine_and_cosine_by_rate({k}, {given['a']}, {rate}, {given['s']}, {given['c']})"
        given["inner"] = f"part_of(sum->{node.name}, odd)"
        given["inverse"] = f"inverse_{name_of(self.series_in(node)[-1])}"
        if "{slope}" in text:
            given |= {"value": self.coefficient(parts["a"], 0), "slope": self.coefficient(parts["a"], 1)}
        if "{over}" in text:
            given["over"] = self.coefficient(node.operands[0], k)
        if k == "0" and kind_of(node) == "quotient":
            text = "({over}) / {b}[0]"
        return text.format(k=k, **given)

    def linear(self, node, k):
        """Text of coefficient k of a sum, whose constant terms contribute to coefficient 0 only.

        Terms stay grouped as on the page: 1/m + 1/m_f as one factor would lose 1/m beside a light foot's.
        """
        atoms = self.atoms(node)
        moving = {atom: symbol(self.coefficient(atom, k)) for atom in atoms}
        for part in ordered([node], atoms):
            if part.is_constant:
                moving[part] = lift(0)
            elif part not in moving:
                steady = {"*": 0, "/": 1}.get(part.operation)
                moving[part] = remade(
                    part, [o if i == steady else moving[o] for i, o in enumerate(part.operands)]
                )
        (rest,) = replaced([node], dict.fromkeys(atoms, lift(0)))
        steady = real_text(rest)
        if moving[node].is_number(0):
            return steady if rest.is_number(0) else f"constant_of({k}, {steady})"
        text = c_text(moving[node])
        return text if rest.is_number(0) else f"with_constant({k}, {text}, {steady})"

    def atoms(self, node):
        """The moving terms of a sum that have series of their own."""
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
        """Statements that compute coefficient k of a quantity with a series of its own."""
        if node not in self.arrays:
            return []
        text = self.recursion(node, k)
        if kind_of(node) in ("sin", "cos"):
            return [f"{text};"]
        names = {part: name_of(part) for part in self.arrays if part is not node}
        formula = c_text(node, names.get)
        lines = [f"/* {name_of(node)} = {formula} */"] if self.by_pairs and len(formula) < 300 else []
        return [*lines, f"{self.arrays[node]}[{k}] = {text};"]

    def step(self):
        """Statements from coefficient k of the states to k + 1, first of quantities one order ahead."""
        rates = {s: (self.arrays[s], self.coefficient(rate, "k")) for s, rate in self.rates.items()}
        lines = [f"{a}[k + 1] = {rate} * series_reciprocal[k + 1];" for a, rate in map(rates.get, self.early)]
        ahead, late = set(self.ahead), [s for s in self.rates if s not in self.early]
        lines += [line for node in self.ahead for line in self.define(node, "k + 1")]
        lines += [line for node in self.made if node not in ahead for line in self.define(node, "k")]
        written = {array: node for array, node in self.wanted.items() if self.arrays.get(node) != array}
        lines += [f"{array}[k] = {self.coefficient(node, 'k')};" for array, node in written.items()]
        lines += [f"{a}[k + 1] = series_reciprocal[k + 1] * ({rate});" for a, rate in map(rates.get, late)]
        return list(dict.fromkeys(lines))

    def summed(self):
        """Quantities whose inner sums are accumulated by the loops of a motion."""
        return [n for n in self.made if "{inner}" in "".join(RECURSIONS.get(kind_of(n), ""))]


def degrees_of(rates):
    """Degrees of the states that are polynomials in time; NO_DEGREE for others."""
    degrees = dict.fromkeys(rates, NO_DEGREE)
    for _ in rates:
        found = dict(degrees)
        for node in ordered(rates.values()):
            if node not in found:
                of = [found[o] for o in node.operands]
                degree = sum(of) if node.operation == "*" else NO_DEGREE
                degree = max(of, default=0) if kind_of(node) == "linear" else degree
                found[node] = 0 if node.is_constant else min(NO_DEGREE, degree)
        degrees = {s: min(NO_DEGREE, 1 + found[rate]) for s, rate in rates.items()}
    return degrees


# ---- rewriting of rates and guards ---------------------------------------------------------------


def refuse_kinks(root):
    """Refuse functions without a Taylor series."""
    for node in ordered([root]):
        if node.operation in ("abs", "select") and not node.is_constant:
            text = f"uses `{node.operation}` of what moves: its Taylor series breaks at the kink. "
            raise PageError(f"{text}Hold the case in a state, and let an event change it")


def with_recursions(rates, guards):
    """Rewrite functions without a recursion; atan2 becomes a state, with a start and a rate.

    A division by a constant becomes a product, so that no coefficient is divided.
    """
    starts, given = {}, list(rates)

    def change(node, operands):
        if not node.is_constant and node.operation == "/" and operands[1].is_constant:
            return operands[0] * (1 / operands[1])
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
    """Replace quantities that are the rate of another one: (x vx + y vy)/r is that of r = sqrt(x^2 + y^2).

    Functions of positions are expanded one order ahead, so their rates are cheap. Two expressions count as
    equal if they have equal values at two random points.
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
