"""C that expands a law of quantities whose series there are: a guard, or what one is made of."""

from collections.abc import Callable, Iterable
from types import SimpleNamespace as Record
from typing import Any

from .c import c_text, comment
from .expressions import forget, lift, symbol, trace
from .series import Expansion

LAW = """\
{what}static inline void expand_{name}({parameters}, int order, real {name}[SERIES_TERMS]) {{
{local}int k = 0;
do {{
{step}
}} while (++k <= order);
}}
"""


def law_series(name: str, law: Callable[..., Any], rates: dict[str, str], **given: Any) -> str:
    """Write a function that expands a law.

    It is given None for a series, the text of a constant, two texts of one that drifts, a dict of all that
    for a record; `rates` are those of series that it turns by.
    """
    forget()
    quantity = lift(trace(law, **{key: symbols(key, value) for key, value in given.items()}))
    expansion = Expansion({name: quantity}, {symbol(of): symbol(rate) for of, rate in rates.items()})
    step = expansion.quantities()
    names = dict.fromkeys(parameters({**given, **dict.fromkeys(rates.values())}))
    local = [
        f"real {expansion.arrays[node]}[SERIES_TERMS];\n"
        for node in expansion.made
        if node in expansion.arrays
    ]
    constants = [f"const real {factor} = {c_text(node)};\n" for node, factor in expansion.factors.items()]
    return LAW.format(
        what=comment(law.__doc__),
        name=name,
        parameters=", ".join(names),
        local="".join([line for line in [*local, *constants] if f" {name}[" not in line]),
        step="\n".join(step),
    )


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
        return symbol(given[0], ramp=symbol(given[1], constant=True), word="drift")
    return symbol(name) if given is None else symbol(given, constant=True)
