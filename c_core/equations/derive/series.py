"""Taylor series of quantities that move: what coefficient k of each is made of.

A quantity is expanded by the recursion of its last operation; what is linear needs none. The first variation
of a motion is one more expansion, of the derivatives of its quantities: they are expressions like any other.
"""

from collections import Counter
from collections.abc import Callable

from .c import c_text
from .expressions import Expression, derivative, leaves, number, ordered, replaced, symbol

# Of n = a * b and the like: the series that coefficient k is made of; how it is made of the inner terms that
# pairs of coefficients have added to; how by a sum of its own, where that is another text.
RECURSIONS = {
    "product": ("ab", "product_of({k}, {inner}, {a}, {b})", "product({a}, {b}, {k})"),
    "square": ("aa", "square_of({k}, {inner}, {a})", "product({a}, {a}, {k})"),
    "quotient": (
        "nb",
        "quotient_of({k}, {inner}, {over}, {n}, {b}, by->{inverse})",
        "({over} - product_so_far({n}, {b}, {k})) / {b}[0]",
    ),
    "sqrt": ("nn", "root_of({k}, {inner}, {over}, {n}, by->{inverse})"),
    "ramp": ("b", "{ramp}_times({k}, {value}, {rate}, {b})"),
    "rate": ("a", "(double)({k} + 1) * {a}[{k} + 1]"),
    "exp": ("an", "exp_of({k}, {a}, {n})"),
}
TURNS = ("sin", "cos")  # are made at once, by the angle's rate
WORDS = {"*": "_times_", "/": "_over_", "+": "_plus_", "-": "_minus_", "negative": "minus_"}


def is_steady(node: Expression) -> bool:
    """Whether it is constant, but for ramps."""
    return all(leaf.is_constant or "ramp" in leaf.marks for leaf in leaves([node]))


def kind_of(node: Expression) -> str:
    """Give the kind of recursion, "linear" for none."""
    if is_steady(node) or node.operation in ("+", "-", "negative"):
        return "linear"
    if not node.operands:
        return node.operation
    a, b = node.operands[0], node.operands[-1]
    if node.operation in ("*", "/") and (a if node.operation == "*" else b).is_constant:
        return "linear"
    if node.operation == "*":
        return "square" if a is b else "ramp" if "ramp" in a.marks else "product"
    return "quotient" if node.operation == "/" else node.operation


def name_of(node: Expression) -> str:
    """Give the page's name, else one made of the operands'."""
    if node.operation == "number":
        return "".join(sign if sign.isalnum() else "_" for sign in f"by_{node.value}")
    word = WORDS.get(node.operation, node.operation + "_of_")
    return node.name or word.join(["", *map(name_of, node.operands)][-2:])


class Expansion:
    """Quantities, and those that they are made of, a coefficient after the other.

    `wanted` are those that are asked for, by the arrays of C that they go to, `rates` of states what their
    integrals are. `known` are series that there are, by their arrays. `place` gives the array of another that
    is needed as a series, by its name. `by_pairs` is whether inner terms of sums are added up outside.
    """

    def __init__(
        self,
        wanted: dict[str, Expression],
        rates: dict[Expression, Expression],
        place: Callable[[str], str] = str,
        known: dict[Expression, str] | None = None,
        by_pairs: bool = False,
    ) -> None:
        self.wanted, self.rates, self.known, self.by_pairs = wanted, rates, known or {}, by_pairs
        roots = [*rates.values(), *wanted.values(), *rates]
        turned = [node.operands[0] for node in ordered(roots, self.known) if node.operation in TURNS]
        self.turned = {angle: (angle.sin(), angle.cos()) for angle in turned}
        roots += [turn for both in self.turned.values() for turn in both]
        self.nodes = [node for node in ordered(roots, self.known) if not is_steady(node)]
        self.made = [node for node in self.nodes if node.operands and node not in self.known]
        self.uses = [operand for node in self.nodes for operand in node.operands] + roots
        self.arrays = {leaf: str(leaf.value) for leaf in self.nodes if not leaf.operands} | self.known
        self.arrays |= {node: array for array, node in wanted.items() if node in self.made}
        self.find_ahead()
        for node in self.made:
            if by_pairs and kind_of(node) != "linear":
                node.name = name_of(node)
            for series in self.series_in(node):
                if series not in self.nodes:
                    raise ValueError(f"{c_text(series)} is needed as a series: let its page give it")
                series.name = name_of(series)
                self.arrays.setdefault(series, place(series.name))
        twice = [array for array, count in Counter(self.arrays.values()).items() if count > 1]
        if twice:
            raise ValueError(f"two series are called {twice[0]}: give one another name in its page")

    def find_ahead(self) -> None:
        """Find what is known a coefficient ahead, and what of that has to be: for a rate."""
        self.early = [state for state, rate in self.rates.items() if rate in self.rates]
        needed = [node.operands[0] for node in self.made if node.operation == "rate"]
        self.ahead = [node for node in ordered(needed, self.known) if node in self.made]
        late = {leaf for leaf in self.rates if leaf not in self.early}
        if late & set(ordered(needed, self.known)) or any(node.operation == "rate" for node in self.ahead):
            raise ValueError("a page asks for the rate of what is not known a coefficient ahead")

    def series_in(self, node: Expression) -> list[Expression]:
        """Give the series that all coefficients are needed of."""
        if node.operation in TURNS:
            return [node.operands[0], self.rate_of(node.operands[0]), node]
        letters = RECURSIONS[kind_of(node)][0] if kind_of(node) in RECURSIONS else ""
        return [{"n": node, "a": node.operands[0], "b": node.operands[-1]}[letter] for letter in letters]

    def rate_of(self, angle: Expression) -> Expression:
        """Give the rate of what is linear in states."""
        return derivative(angle, self.rates)

    def stands(self, node: Expression) -> bool:
        """Whether a quantity has a C variable of its own: it is stored, no sum, or named.

        Of a constant times a sum that is used there alone the constant is multiplied in, once for all.
        """
        if node in self.arrays or node not in self.made:
            return node in self.arrays
        if not self.by_pairs or kind_of(node) != "linear":
            return self.by_pairs or node.name is not None
        users = [user for user in self.nodes if node in user.operands]
        spreads = self.uses.count(node) == 1 and any(user.operands[0].is_constant for user in users)
        return node.name is not None and not spreads

    # ---- C of coefficients --------------------------------------------------------------------------------

    def coefficient(self, node: Expression, k: str) -> str:
        """Write coefficient k: where it stands, else how it is made."""
        if node in self.arrays:
            return f"{self.arrays[node]}[{k}]"
        return str(node.name) if self.stands(node) else self.recursion(node, k)

    def recursion(self, node: Expression, k: str) -> str:
        """Write how coefficient k is made."""
        if kind_of(node) == "linear":
            return self.linear(node, k)
        _, *texts = RECURSIONS[kind_of(node)]
        text = texts[0] if self.by_pairs else texts[-1]
        a, b = node.operands[0], node.operands[-1]
        arrays = {name: self.arrays.get(part) for name, part in (("n", node), ("a", a), ("b", b))}
        names = {"inner": f"sum->{node.name}", "inverse": f"inverse_{self.series_in(node)[-1].name}"}
        if node.operation == "sqrt" and not self.by_pairs:
            raise ValueError(f"{node.name} is a root, which a motion alone can expand: let it have it")
        if "over" in text:
            arrays["over"] = self.coefficient(a, k)
        if kind_of(node) == "ramp":
            arrays |= {"ramp": a.marks["word"], "value": a.value, "rate": a.marks["ramp"].value}
        return text.format(k=k, **names, **arrays)

    def linear(self, node: Expression, k: str) -> str:
        """Write coefficient k of a sum: constants stand in coefficient 0 alone, ramps in 0 and 1."""
        atoms = self.atoms(node)
        held = dict.fromkeys(atoms, number(0))
        moving = number(0)
        for atom in atoms:
            moving = moving + derivative(node, {**held, atom: 1}) * symbol(self.coefficient(atom, k))
        steady = replaced(node, held)
        ramps = {leaf: leaf.marks["ramp"] for leaf in leaves([steady]) if "ramp" in leaf.marks}
        rate = derivative(steady, ramps)
        parts = [c_text(moving)]
        parts += [f"broadcast({c_text(p)})" if p.operation == "number" else c_text(p) for p in (steady, rate)]
        word = min(leaf.marks["word"] for leaf in ramps) if ramps else "constant"
        parts = parts if ramps else parts[:2]
        if moving.is_number(0):
            nothing = steady.is_number(0) and not ramps
            return parts[1] if nothing else f"{word}_of({k}, {', '.join(parts[1:])})"
        return parts[0] if parts[1:] == ["broadcast(0.0)"] else f"with_{word}({k}, {', '.join(parts)})"

    def atoms(self, node: Expression) -> list[Expression]:
        """Give what a sum is made of, of all that moves: what stands, or is no sum."""
        found: dict[Expression, None] = {}
        for part in node.operands:
            is_one = kind_of(part) != "linear" or self.stands(part)
            found |= dict.fromkeys([part] if is_one else self.atoms(part))
        return list(found)

    def define(self, node: Expression, k: str) -> list[str]:
        """Write coefficient k of a quantity into its place, below the page's formula."""
        if not self.stands(node):
            return []
        if node.operation in TURNS:
            angle = node.operands[0]
            parts = [angle, self.rate_of(angle), *self.turned[angle]]
            line = f"turn_by({k}, {', '.join(self.arrays[part] for part in parts)});"
        else:
            place = f"{self.arrays[node]}[{k}]" if node in self.arrays else f"const real {node.name}"
            line = f"{place} = {self.recursion(node, k)};"
        formula = c_text(node, lambda part: part.name if part is not node else None)
        return [f"/* {node.name} = {formula} */", line] if self.by_pairs else [line]

    def own_arrays(self) -> str:
        """Declare the arrays that nobody has asked for."""
        own = [self.arrays[node] for node in self.made if node in self.arrays]
        return "".join(
            f"real {array}[SERIES_TERMS];\n"
            for array in own
            if array.isidentifier() and array not in self.wanted
        )

    def begin(self) -> list[str]:
        """Write coefficient 0 of what is expanded ahead."""
        return [line for node in self.ahead for line in self.define(node, "0")]

    def quantities(self) -> list[str]:
        """Write coefficient k of all but the states, and k + 1 of what is expanded ahead."""
        lines = [line for node in self.ahead for line in self.define(node, "k + 1")]
        lines += [line for node in self.made if node not in self.ahead for line in self.define(node, "k")]
        for array, node in self.wanted.items():
            if self.arrays.get(node) != array:  # it is steady, or another's, too
                lines.append(f"{array}[k] = {self.coefficient(node, 'k')};")
        return list(dict.fromkeys(lines))

    def step(self) -> list[str]:
        """Write coefficient k of all, and k + 1 of the states."""
        late = [state for state in self.rates if state not in self.early]
        return [*map(self.integral, self.early), *self.quantities(), *map(self.integral, late)]

    def integral(self, state: Expression) -> str:
        """Write the next coefficient of a state, by that of its rate."""
        return f"integrate({self.arrays[state]}, k, {self.coefficient(self.rates[state], 'k')});"

    def reads(self) -> list[Expression]:
        """Give what is needed of what was known."""
        parts = [part for node in self.made if kind_of(node) == "linear" for part in self.atoms(node)]
        parts += [series for node in self.made for series in self.series_in(node)]
        return [part for part in dict.fromkeys(parts) if part in self.known]
