"""Balls can be pickled, exactly: python-flint's own cannot."""

import copyreg
from typing import Any

from flint import acb, arb

RADIUS_BITS = 30
"""Bits of a radius, which is rounded up."""
Part = tuple[int, int] | str


def _part(number: arb) -> Part:
    """A number without radius: mantissa and exponent of two, or what it is if it is not finite."""
    if not number.is_finite():
        return str(number)
    mantissa, exponent = number.man_exp()
    return int(mantissa), int(exponent)


def ball_of_parts(middle: Part, radius: Part) -> arb:
    """A ball again."""
    asked = arb(radius)
    if isinstance(radius, str) or asked.is_zero():
        return arb(middle, asked)
    bits = RADIUS_BITS - radius[0].bit_length()
    just_below = arb((2 * (radius[0] << bits) - 1, radius[1] - bits - 1))
    found = arb(middle, just_below)
    return found if found.rad() >= asked else arb(middle, asked)


def _reduced(ball: arb) -> tuple[Any, tuple[Part, Part]]:
    return ball_of_parts, (_part(ball.mid()), _part(ball.rad()))


def _reduced_complex(ball: acb) -> tuple[Any, tuple[arb, arb]]:
    return acb, (ball.real, ball.imag)


copyreg.pickle(arb, _reduced)
copyreg.pickle(acb, _reduced_complex)
