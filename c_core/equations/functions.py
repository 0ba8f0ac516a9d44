"""What a law may use beside + - * /: elementary functions of any number type, and records.

A number that has a method of the function's name is asked for it; for any other the module that serves its
type is, which is `math` unless `serve` has named another.
"""

import math
from types import SimpleNamespace as Record

__all__ = [
    "Record",
    "atan2",
    "cos",
    "exp",
    "expm1",
    "larger",
    "log1p",
    "serve",
    "sin",
    "sqrt",
    "where",
]

_modules = {}


def serve(number_type, module):
    """From now on numbers of a type are served by a module, or any object, with functions of these names."""
    _modules[number_type] = module


def _function(name):
    def of_numbers(x, *more):
        method = getattr(x, name, None)
        return method(*more) if method is not None else getattr(_modules.get(type(x), math), name)(x, *more)

    of_numbers.__name__ = of_numbers.__qualname__ = name
    of_numbers.__doc__ = f"{name}, of numbers of any type."
    return of_numbers


sqrt = _function("sqrt")
sin = _function("sin")
cos = _function("cos")
atan2 = _function("atan2")
exp = _function("exp")
expm1 = _function("expm1")
log1p = _function("log1p")


def where(word, is_, then, other):
    """One number where a word or flag of a mode is this, else another; C asks where it takes the number."""
    if hasattr(word, "where"):
        return word.where(is_, then, other)
    return then if word == is_ else other


def larger(x, y):
    """The larger of two numbers; where they are equal its changes are those of x."""
    if hasattr(x, "larger"):
        return x.larger(y)
    if hasattr(y, "larger"):
        return (0 * y + x).larger(y)
    return x if x >= y else y
