"""A gait under a law from apex to settings: whether it still is one, and stable."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..library.affine_law import AffineLaw, check_law
from ..library.gait import Gait, check_is_gait
from ..library.return_map import stride_from
from ..library.runner import Runner
from ..variables.variable import Given
from .search import periodic_gait

SAME = 1e-6
"""What a setting may be off the gait's at its apex, over the larger of it and 1."""


def jacobian_under(gait: Gait, law: AffineLaw) -> NDArray[np.float64]:
    """The Jacobian of a gait's return map under a law that sets at each apex, away from its limits.

    That of the map as it is, plus for each setting the next apex's change by it times its gain.
    """
    check_law(law, gait.runner)
    jacobian = gait.jacobian.copy()
    for name, gain in zip(law.inputs, np.asarray(law.gain), strict=True):
        jacobian += np.outer(stride_from(gait.runner, gait.apex, name)[2], gain)
    return jacobian


def check_attracts(gait: Gait, law: AffineLaw | None) -> None:
    """Refuse a law under which a gait is none, or unstable, so that it attracts nothing."""
    check_is_gait(gait, "gait")
    check_law(law, gait.runner)
    if law is None:
        return
    if gait.strides > 1:
        raise InputError(f"law: for a gait of {gait.strides} strides; allowed: of one")
    for name, value in replace(law, noise=None).inputs_at(gait.apex).items():
        usual = gait.runner[name]
        if abs(value - usual) > SAME * max(1.0, abs(usual)):
            raise InputError(
                f"law: {name} = {value:g} at the gait's apex, where the runner has {usual:g}; "
                "allowed: the same"
            )
    largest = float(np.max(np.abs(np.linalg.eigvals(jacobian_under(gait, law)))))
    if not largest < 1.0:
        raise InputError(
            f"law: under it the gait at friction {gait.friction:g} is unstable, with a largest eigenvalue of "
            f"{largest:.6g}: it attracts nothing; allowed: below 1"
        )


def stable_gait(runner: Runner | Mapping[str, Given], law: AffineLaw | None = None) -> Gait:
    """The gait of a runner, or under a law the one near its apex, if it attracts anything."""
    if law is None:
        gait = periodic_gait(runner)
        if not gait.stable:
            raise InputError(f"the gait at friction {gait.friction:g} is unstable: it attracts nothing")
        return gait
    runner = Runner(runner)
    check_law(law, runner)
    gait = periodic_gait(runner, guess=law.apex)
    check_attracts(gait, law)
    return gait
