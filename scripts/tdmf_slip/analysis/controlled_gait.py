"""A gait under a law from apex to settings: whether it still is one, and stable."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..library.batch import Batch
from ..library.gait import Gait, check_is_gait
from ..library.laws import AffineLaw, Law, check_law, numbers_up_to
from ..library.return_map import stride_from
from ..library.runner import Runner
from ..library.settings import setting_number
from ..variables.parameters import RunnerLike
from ..variables.table import by_full_name
from .search import periodic_gait

SAME = 1e-6
"""Largest difference of a setting from the gait's at its apex, over the larger of the setting and 1."""
DIFFERENCE = 1e-5
"""Step of differences, over the scales."""
ROUNDS = 20
"""Gaits that are tried, each with the settings that the law gives at the one before."""


def jacobian_under(gait: Gait, law: Law) -> NDArray[np.float64]:
    """The Jacobian of a gait's return map under a law that sets at each apex.

    That of an affine law within its limits is exact: the map's own, plus for each setting the next apex's
    change by it times its gain. That of a function is by central differences.
    """
    check_law(law, gait.runner)
    if isinstance(law, AffineLaw):
        jacobian = gait.jacobian.copy()
        for name, gain in zip(law.inputs, np.asarray(law.gain), strict=True):
            jacobian += np.outer(stride_from(gait.runner, gait.apex, name)[2], gain)
        return jacobian
    steps = DIFFERENCE * np.diag(gait.runner.scales)
    starts = gait.apex + np.concatenate([steps, -steps])
    run = Batch(gait.runner, starts, law=law, tolerance=gait.runner.tolerance).run(1)
    if (run.strides != 1).any():
        raise InputError("law: under it strides from beside the gait's apex do not close; allowed: they do")
    up, down = np.split(run.apex, 2)
    differences: NDArray[np.float64] = ((up - down) / (2.0 * DIFFERENCE * gait.runner.scales)[:, None]).T
    return differences


def check_attracts(gait: Gait, law: Law | None) -> None:
    """Refuse a law under which a gait is none, or unstable, so that it attracts nothing."""
    check_is_gait(gait, "gait")
    check_law(law, gait.runner)
    if law is None:
        return
    if gait.strides > 1:
        raise InputError(f"law: for a gait of {gait.strides} strides; allowed: of one")
    for name, value in _changed(gait, law).items():
        raise InputError(
            f"law: {name} = {value:g} at the gait's apex, where the runner has {gait.runner[name]:g}; "
            "allowed: the same"
        )
    largest = float(np.max(np.abs(np.linalg.eigvals(jacobian_under(gait, law)))))
    if not largest < 1.0:
        raise InputError(
            f"law: under it the gait at friction {gait.friction:g} is unstable, with a largest eigenvalue of "
            f"{largest:.6g}: it attracts nothing; allowed: below 1"
        )


def _changed(gait: Gait, law: Law) -> dict[str, float]:
    """Settings of a law at a gait's apex that differ from those of the gait's runner."""
    quiet = replace(law, noise=None) if isinstance(law, AffineLaw) else law
    given = by_full_name(quiet(gait.apex[None], 0), "law: what it gives", "numbers or arrays by name")
    changed = {}
    for name, values in given.items():
        setting_number(name, "law")
        value, usual = float(numbers_up_to(f"law: {name}", values, 1).ravel()[0]), gait.runner[name]
        if not abs(value - usual) <= SAME * max(1.0, abs(usual)):
            changed[name] = value
    return changed


def stable_gait(runner: RunnerLike, law: Law | None = None) -> Gait:
    """The gait of a runner that attracts, or the one that a law keeps as it is.

    Near the apex of an affine law the runner has this gait. Under a function the runner has at the gait the
    settings that the function gives there; a gait with them is searched for in rounds.
    """
    runner = Runner(runner)
    check_law(law, runner)
    gait = periodic_gait(runner, guess=law.apex if isinstance(law, AffineLaw) else None)
    if law is None:
        if not gait.stable:
            raise InputError(f"the gait at friction {gait.friction:g} is unstable: it attracts nothing")
        return gait
    if not isinstance(law, AffineLaw):
        for _ in range(ROUNDS):
            changed = _changed(gait, law)
            if not changed:
                break
            for name, value in changed.items():
                runner = runner.replace({name: value})
            gait = periodic_gait(runner, guess=gait.apex)
    check_attracts(gait, law)
    return gait
