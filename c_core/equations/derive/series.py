"""Taylor series of quantities that move: what coefficient k of each is made of.

A quantity is expanded by the recursion of its last operation; what is linear needs none. The first variation
of a motion is one more expansion, of the derivatives of its quantities: they are expressions like any other.
"""

from collections import Counter
from collections.abc import Callable

from .c import c_text
from .expressions import Expression, derivative, leaves, lift, ordered, replaced, symbol

# Of n = a * b and the like: the series that coefficient k is made of, r being the rate of the angle a, s and
# c its sine and cosine; how it is made of the inner terms that pairs of coefficients have added to; how by a
# sum of its own, where that is another text.
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
    "sin": ("arsc", "sine_and_cosine_term({k}, {a}, {r}, {s}, {c})"),
    "cos": ("arsc", "sine_and_cosine_term({k}, {a}, {r}, {s}, {c})"),
}
WORDS = {"*": "_times_", "/": "_over_", "+": "_plus_", "-": "_minus_", "negative": "minus_"}


def is_steady(node: Expression) -> bool:
    """Whether it is constant, but for ramps."""
    return all(leaf.is_constant or "ramp" in leaf.marks for leaf in leaves([node]))


def kind_of(node: Expression) -> str:
    """Give the kind of recursion, "linear" for none."""
    if is_steady(node) or node.operation in ("+", "-", "negative"):
        return "linear"
    if node.operation not in ("*", "/"):
        return node.operation
    a, b = node.operands
    if (a if node.operation == "*" else b).is_constant:
        return "linear"
    if node.operation == "/":
        return "quotient"
    return "square" if a is b else "ramp" if "ramp" in a.marks else "product"


def name_of(node: Expression) -> str:
    """Give the page's name, else one made of the operands'."""
    if node.operation == "number":
        return "".join(sign if sign.isalnum() else "_" for sign in f"by_{node.value}")
    word = WORDS.get(node.operation, node.operation + "_of_")
    return node.name or word.join(["", *map(name_of, node.operands)][-2:])


class Expansion:
    """Quantities, and those that they are made of, a coefficient after the other.

    `wanted` are those that are asked for, by the arrays of C that they go to, `rates` of states what their
    integrals are. `known` are series that there are, by their arrays. `array_of` gives that of another that
    is needed as a series, by its name. `by_pairs` is whether inner terms of sums are added up outside.
    """

    def __init__(
        self,
        wanted: dict[str, Expression],
        rates: dict[Expression, Expression],
        array_of: Callable[[str], str] = str,
        known: dict[Expression, str] | None = None,
        by_pairs: bool = False,
    ) -> None:
        self.wanted, self.rates, self.known, self.by_pairs = wanted, rates, known or {}, by_pairs
        roots = [*rates.values(), *wanted.values(), *rates]
        turns = [node for node in ordered(roots, self.known) if kind_of(node) in ("sin", "cos")]
        self.turns = {
            angle: {"a": angle, "r": derivative(angle, rates), "s": angle.sin(), "c": angle.cos()}
            for angle in (node.operands[0] for node in turns)
        }
        roots += [parts[letter] for parts in self.turns.values() for letter in "sc"]
        self.nodes = [node for node in ordered(roots, self.known) if not is_steady(node)]
        self.made = [node for node in self.nodes if node.operands and node not in self.known]
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
                self.arrays.setdefault(series, array_of(series.name))
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

    def parts(self, node: Expression) -> dict[str, Expression]:
        """Give what a recursion may ask for; the rate is that of an angle that is linear in states."""
        a, b = node.operands[0], node.operands[-1]
        return self.turns[a] if kind_of(node) in ("sin", "cos") else {"n": node, "a": a, "b": b}

    def series_in(self, node: Expression) -> list[Expression]:
        """Give the series that all coefficients are needed of."""
        letters, *_ = RECURSIONS.get(kind_of(node), ("",))
        return [self.parts(node)[letter] for letter in letters]

    def stands(self, node: Expression) -> bool:
        """Whether a quantity has a C variable of its own: it is stored, or named."""
        return node in self.arrays or (node in self.made and node.name is not None)

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
        if node.operation == "sqrt" and not self.by_pairs:
            raise ValueError(f"{node.name} is a root, which a motion alone can expand: let it have it")
        a, text = node.operands[0], texts[0] if self.by_pairs else texts[-1]
        parts = {letter: self.arrays.get(part) for letter, part in self.parts(node).items()}
        parts |= {"inner": f"sum->{node.name}", "inverse": f"inverse_{self.series_in(node)[-1].name}"}
        if "{over}" in text:
            parts["over"] = self.coefficient(a, k)
        if kind_of(node) == "ramp":
            parts |= {"ramp": a.marks["word"], "value": a.value, "rate": a.marks["ramp"].value}
        return text.format(k=k, **parts)

    def linear(self, node: Expression, k: str) -> str:
        """Write coefficient k of a sum: constants stand in coefficient 0 alone, ramps in 0 and 1."""
        atoms = self.atoms(node)
        zeros = dict.fromkeys(atoms, lift(0))
        moving = lift(0)
        for atom in atoms:
            moving = moving + derivative(node, {**zeros, atom: 1}) * symbol(self.coefficient(atom, k))
        steady = replaced(node, zeros)
        ramps = {leaf: leaf.marks["ramp"] for leaf in leaves([steady]) if "ramp" in leaf.marks}
        word = min(leaf.marks["word"] for leaf in ramps) if ramps else "constant"
        parts = [steady, derivative(steady, ramps)] if ramps else [steady]
        texts = [f"broadcast({c_text(p)})" if p.operation == "number" else c_text(p) for p in parts]
        if steady.is_number(0) and not ramps:
            return texts[0] if moving.is_number(0) else c_text(moving)
        if moving.is_number(0):
            return f"{word}_of({k}, {', '.join(texts)})"
        return f"with_{word}({k}, {', '.join([c_text(moving), *texts])})"

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
        array = f"{self.arrays[node]}[{k}]" if node in self.arrays else f"const real {node.name}"
        line = f"{self.recursion(node, k)};"
        line = line if line.startswith("sine_and_cosine_term") else f"{array} = {line}"
        formula = c_text(node, lambda part: part.name if part is not node else None)
        return [f"/* {node.name} = {formula} */", line] if self.by_pairs else [line]

    def own_arrays(self) -> str:
        """Declare the arrays that nobody has asked for."""
        own = [self.arrays[node] for node in self.made if node in self.arrays]
        own = [array for array in own if array.isidentifier() and array not in self.wanted]
        return "".join(f"real {array}[SERIES_TERMS];\n" for array in own)

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

        def integrals(are_early: bool) -> list[str]:
            states = [state for state in self.rates if (state in self.early) == are_early]
            rates = [self.coefficient(self.rates[state], "k") for state in states]
            return [f"integrate({self.arrays[s]}, k, {r});" for s, r in zip(states, rates, strict=True)]

        return [*integrals(True), *self.quantities(), *integrals(False)]

    def reads(self) -> list[Expression]:
        """Give what is needed of what was known."""
        parts = [part for node in self.made if kind_of(node) == "linear" for part in self.atoms(node)]
        parts += [series for node in self.made for series in self.series_in(node)]
        return [part for part in dict.fromkeys(parts) if part in self.known]
