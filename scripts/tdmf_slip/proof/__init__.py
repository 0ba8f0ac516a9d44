"""Proofs by interval arithmetic: gaits, their words, eigenvalues and borders, each number enclosed.

They need python-flint, which the extra `proof` of the package brings.
"""

from ..errors import InputError

try:
    import flint  # noqa: F401 # only whether it is there
except ImportError:
    raise InputError(
        "proofs need python-flint (the extra proof), which is missing; "
        "install it by: pip install python-flint"
    ) from None

from . import pickled  # noqa: F401 # registers balls with pickle
