"""The directive `law`: an equation of the model, rendered from the text that its C is derived from."""

from collections.abc import Callable
from types import SimpleNamespace as Record

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from tdmf_slip.equations import coordinates, ground_force, leg
from tdmf_slip.equations.derive.expressions import Expression, begin_anew, symbol

STATE = {
    "foot_x": "x",
    "foot_y": "y",
    "leg_length": "r",
    "leg_angle": r"\theta",
    "foot_vx": r"\dot x",
    "foot_vy": r"\dot y",
    "leg_length_rate": r"\dot r",
    "leg_angle_rate": r"\dot\theta",
}


def _body() -> dict[str, Expression]:
    state = Record(**{name: symbol(text) for name, text in STATE.items()})
    body = coordinates.body(state, leg.direction(state.leg_angle))
    return {"x_m": body.x, "y_m": body.y}


def _axial_force() -> dict[str, Expression]:
    return {"F_s": leg.axial_force(*map(symbol, ("k", "c", "l_0", "r", r"\dot r")))}


def _ground_force(angle: str, slope: str | None) -> Record:
    across, weight = symbol(r"\tau") / symbol("r"), symbol("m_f g")
    along = weight * symbol(slope).sin() if slope else 0
    off = weight * symbol(slope).cos() if slope else weight
    direction = leg.direction(symbol(angle))
    return ground_force.holding_force(symbol("F_s"), across, -direction.sine, direction.cosine, along, off)


def _normal_force() -> dict[str, Expression]:
    return {"f_y": _ground_force(r"\theta", None).normal}


def _force_on_slope() -> dict[str, Expression]:
    force = _ground_force(r"\theta'", r"\sigma")
    return {"f_n": force.normal, r"\text{stick:}\quad f_t": force.tangential}


EQUATIONS: dict[str, Callable[[], dict[str, Expression]]] = {
    "body": _body,
    "axial_force": _axial_force,
    "normal_force": _normal_force,
    "force_on_slope": _force_on_slope,
}


def latex(node: Expression, smallest: int = 0) -> str:
    """Write an expression as it is printed: products without a sign, quotients as fractions."""
    if node.operation in ("symbol", "number"):
        return str(node.value)
    if node.operation in ("sin", "cos"):
        return rf"\{node.operation} {latex(node.operands[0], 2)}"
    if node.operation == "/":
        above, below = (latex(operand) for operand in node.operands)
        return rf"\frac{{{above}}}{{{below}}}"
    if node.operation in ("negative", "*"):
        is_negative, factors = _factors(node)
        product = r"\,".join(latex(factor, 1) for factor in factors)
        strength, text = (0, f"-{product}") if is_negative else (1, product)
    elif node.operation in ("+", "-"):
        left, right = node.operands
        is_negative, factors = _factors(right)
        sign = "-" if is_negative != (node.operation == "-") else "+"
        strength, text = 0, rf"{latex(left)} {sign} " + r"\,".join(latex(factor, 1) for factor in factors)
    else:
        raise ValueError(f"no law in print has the operation {node.operation}")
    return rf"\left({text}\right)" if strength < smallest else text


def _factors(node: Expression) -> tuple[bool, list[Expression]]:
    """Whether a product is negative, and its factors without signs, sines and cosines last."""
    if node.operation == "negative":
        is_negative, factors = _factors(node.operands[0])
        return not is_negative, factors
    if node.operation != "*":
        return False, [node]
    (one, left), (other, right) = map(_factors, node.operands)
    return one != other, sorted(left + right, key=lambda factor: factor.operation in ("sin", "cos"))


def written(name: str) -> str:
    """Write a law's equations, one beside the other."""
    begin_anew()
    return r", \qquad ".join(f"{left} = {latex(right)}" for left, right in EQUATIONS[name]().items())


class Law(SphinxDirective):
    """An equation by its name here, and the number that it has in the paper."""

    required_arguments = 1
    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The formula, set apart."""
        number = rf" \qquad {self.arguments[1]}" if len(self.arguments) > 1 else ""
        text = written(self.arguments[0]) + number
        block = nodes.math_block(text, text, nowrap=False, number=None, label=None, docname=self.env.docname)
        self.set_source_info(block)
        return [block]


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx of the directive."""
    app.add_directive("law", Law)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
