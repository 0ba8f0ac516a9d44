"""The continuous states of a unit, in the world's coordinates, and what values depend on."""

import math
import operator
import random

from .expressions import forget_expressions, leaves_of, lift, ordered
from .tracing import trace
from .variations import Variation

OPERATIONS = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "negative": operator.neg,
    "sin": math.sin, "cos": math.cos, "atan2": math.atan2, "abs": abs, "expm1": math.sin, "exp": math.cos,
    "sqrt": lambda x: math.sqrt(abs(x)), "log": lambda x: math.sqrt(abs(x)), "log1p": lambda x: x * x,
}  # fmt: skip
"""Operations that are defined for any number. Replacements serve as well, because only dependence matters."""


class World:
    """The continuous states of a unit, and the names that values depend on."""

    def __init__(self, page):
        self.page, moving = page, set()
        sets = {f.gives_coordinates for f in page.model.marked("gives_coordinates").values()}
        start = page.modes[page.keys[0][0]]
        self.key = page.world_key
        if sets and ("world" not in sets or self.key is None):
            page.refuse("has coordinates, and no mode in those called `world`, which a unit shows")
        self.start_of = start.of if start.of != "world" else None
        for key in page.keys:
            forget_expressions()
            moving |= {n for n, rate in page.rates(key).items() if not rate.is_number(0)}
        self.integrals = {
            n: o for n, o in page.observed.items() if o.part == "positive integral" and o.is_usual
        }
        moving |= {o.into for o in self.integrals.values()}
        left_out = {f"{n}_rate" for n in page.inputs}
        left_out |= {o.into for o in page.observed.values() if not o.is_usual}
        own = {n: q for n, q in page.states.items() if q.role == "state" and n not in left_out}
        self.states = [n for n, q in own.items() if (q.of and "world" in q.of) or (not q.of and n in moving)]
        self.held = [n for n, q in own.items() if not q.of and n not in self.states]
        self.starts = [n for n, q in own.items() if q.of and self.start_of in q.of and "world" not in q.of]
        self.moving = moving | set(self.states)
        self.names = {page.c_names[n]: n for n in (*page.parameters, *page.states)}
        settings = [n for n, q in page.parameters.items() if q.role == "setting"]
        self.knowns = dict.fromkeys([*self.states, *page.inputs, *settings])

    def in_mode(self, key):
        """The states of a mode with coordinates of its own, as expressions of the world's."""
        of = self.page.modes[key[0]].of
        if self.key is None or of in (None, "world"):
            return {}
        seen = trace(self.page.at(self.key).in_coordinates, of, name=of)
        return {n: lift(value) for n, value in seen.items()}

    def rates(self, key):
        """Rates of the continuous states in a mode."""
        page, of = self.page, self.page.modes[key[0]].of
        rates = page.rates(key)
        found = {n: rates.get(n, lift(0)) for n in self.states}
        if self.key is not None and of not in (None, "world"):
            moving = page.along_motion(rates, Variation({}))
            seen = trace(page.at(key).in_coordinates, "world", name="world")
            found |= {n: moving.of(lift(value)) for n, value in seen.items() if n in self.states}
        for name, observed in self.integrals.items():
            if key[0] in observed.modes:
                found[observed.into] = found[observed.into] + page.number(observed, key, name)
        return found

    def outputs(self, key):
        """The outputs in a mode."""
        return {n: self.page.number(f, key, n) for n, f in self.page.outputs.items()}

    def indicators(self, key):
        """The guards that a mode watches, and the rates of quantities whose largest values it observes."""
        page, observed = self.page, self.page.observed.items()
        moving = page.along_motion(page.rates(key), Variation({}))
        peaks = {n: o for n, o in observed if o.part == "largest" and o.is_usual and key[0] in o.modes}
        found = {n: moving.of(lift(page.number(o, key, n))) for n, o in peaks.items()}
        return found | {n: page.guard(key, n) for n in page.watched(key)}

    def dependencies(self, values_in):
        """Names of states, inputs and settings that values depend on in any mode, by the values' names.

        Also returns the names of the values that depend on something that moves.
        """
        found, moves = {}, set()
        for key in self.page.keys:
            forget_expressions()
            own, values = self.in_mode(key), values_in(key)
            candidates = {}
            for name, value in values.items():
                names = {self.name_of(leaf) for leaf in leaves_of([value])}
                moves |= {name} if names & self.moving else set()
                for other in names & own.keys():
                    names |= {self.name_of(leaf) for leaf in leaves_of([own[other]])}
                candidates[name] = names & self.knowns.keys()
            for name, known in self.influences(own, values, candidates):
                found.setdefault(name, set()).update(known)
        return found, moves

    def name_of(self, leaf):
        """The name of the parameter or state that a symbol stands for."""
        return self.names[leaf.value[3:]]

    def influences(self, own, values, candidates):
        """Each value's name with the candidates along which it changes: in some, all terms cancel.

        The values are compared at random points, with coordinates `own` of the mode as the world's have them.
        Inputs are at rest, as in Model Exchange.
        """
        draw, found = random.Random(0), {name: set() for name in values}
        of_own, of_values = ordered(own.values()), ordered(values.values())
        names = {self.name_of(leaf) for leaf in leaves_of([*own.values(), *values.values()])}
        for _ in range(2):
            point = {name: draw.uniform(0.5, 1.5) for name in sorted(names)}
            point |= {f"{name}_rate": 0.0 for name in self.page.inputs}
            weights = [draw.random() for _ in range(2 * max(len(of_own), len(of_values)))]

            def at(changes, point=point, weights=weights):
                seen = self.evaluated(of_own, point | changes, weights)
                mode = {name: seen[value] for name, value in own.items()}
                numbers = self.evaluated(of_values, point | changes | mode, weights)
                return {name: numbers[value] for name, value in values.items()}

            before = at({})
            for known in sorted(set().union(*candidates.values())):
                after = at({known: point[known] + 0.1})
                for name in values:
                    if not math.isclose(before[name], after[name], rel_tol=1e-10, abs_tol=1e-10):
                        found[name] |= {known} & candidates[name]
        return found.items()

    def evaluated(self, nodes, numbers, weights):
        """Numbers of expressions. A selection is a mixture, which depends on all that decides it.

        Very large and very small constants are replaced by ones of ordinary size, so that rounding hides no
        change.
        """
        found = {}
        for i, node in enumerate(nodes):
            of = [found[operand] for operand in node.operands]
            if node.operation == "number":
                is_ordinary = node.value == 0 or 1e-3 <= abs(node.value) <= 1e3
                found[node] = float(node.value) if is_ordinary else math.copysign(1 + weights[i], node.value)
            elif node.operation == "symbol":
                found[node] = numbers[self.name_of(node)]
            elif node.operation in OPERATIONS:
                found[node] = OPERATIONS[node.operation](*of)
            else:
                first, second = of[0] - of[1] if len(of) > 2 else of[0], of[-2:]
                share = weights[2 * i] + weights[2 * i + 1] * first
                found[node] = share * second[0] + (1 - share) * second[-1]
        return found
