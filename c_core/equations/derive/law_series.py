"""C that expands a law of quantities whose series there are: a guard, or what one is made of."""

from collections.abc import Callable
from types import SimpleNamespace as Record
from typing import Any

from ..motions import STRUCTS
from .c import comment
from .expressions import forget, lift, parameters, symbol, trace
from .series import Expansion

LAW = """\
{what}static inline void expand_{name}({parameters}, int order, real {name}[SERIES_TERMS]) {{
{local}int k = 0;
do {{
{step}
}} while (++k <= order);
}}
"""


def law_series(law: Callable[..., Any], given: dict[str, Any], rates: dict[str, str] | None = None) -> str:
    """Write a function that expands a law of series, by the names of its parameters.

    Of those that are none, `given` has the text of a constant, two texts of one that drifts, or a dict of
    that for a record; `rates` are those of series that it turns by.
    """
    rates = rates or {}
    forget()
    name, names = law.__name__, parameters(law)
    told = [handed(parameter, given.get(parameter)) for parameter in names]
    told += [handed(rate, None) for rate in rates.values()]
    quantity = lift(trace(law, *(value for value, _ in told[: len(names)])))
    expansion = Expansion({name: quantity}, {symbol(of): symbol(rate) for of, rate in rates.items()})
    step = expansion.quantities()
    return LAW.format(
        what=comment(law.__doc__),
        name=name,
        parameters=", ".join(dict.fromkeys(text for _, declared in told for text in declared)),
        local=expansion.own_arrays(),
        step="\n".join(step),
    )


def handed(name: str, given: Any) -> tuple[Any, list[str]]:
    """Give what a law is handed as a parameter, and the C parameters that hand it in; a servo is a struct."""
    if given is None:
        return symbol(name), [f"const real *{name}"]
    if isinstance(given, dict):
        members = {member: handed(member, value) for member, value in given.items()}
        record = Record(**{member: value for member, (value, _) in members.items()})
        return record, [text for _, declared in members.values() for text in declared]
    value, *rate = texts = given if isinstance(given, tuple) else (given,)
    marks = {"ramp": symbol(rate[0], constant=True), "word": "drift"} if rate else {"constant": True}
    declared = [f"real {text}" for text in texts]
    pointer = value.split("->")[0]
    if pointer != value:
        declared = [f"const {STRUCTS[pointer][0]} *{pointer}"]
    return symbol(value, **marks), declared
