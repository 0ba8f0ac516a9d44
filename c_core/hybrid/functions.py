"""Functions that a page's laws use: on numbers, arrays, intervals and expressions alike."""

import math
import sys

from .expressions import Condition, Expression, lift, selected

radians = math.radians


def _function(name):
    def of(*numbers):
        numpy = sys.modules.get("numpy")
        if any(isinstance(x, Expression) for x in numbers):
            numbers = [lift(x) for x in numbers]
        elif numpy and any(isinstance(x, numpy.ndarray) for x in numbers):
            return getattr(numpy, {"atan2": "arctan2"}.get(name, name))(*numbers)
        first, *others = numbers
        return getattr(first, name)(*others) if hasattr(first, name) else getattr(math, name)(*numbers)

    of.__name__, of.__doc__ = name, f"`{name}` of a number, an array, an interval or an expression."
    return of


sqrt, sin, cos, exp, log, expm1, log1p, atan2 = map(
    _function, ("sqrt", "sin", "cos", "exp", "log", "expm1", "log1p", "atan2")
)


def select(condition, if_true, if_false):
    """One of two numbers, by a condition. To choose a mode or a word, use `if` instead."""
    if isinstance(condition, Condition):
        return selected(condition.sign, condition.a, condition.b, lift(if_true), lift(if_false))
    if hasattr(condition, "shape") and condition.shape:
        return sys.modules["numpy"].where(condition, if_true, if_false)
    return if_true if condition else if_false
