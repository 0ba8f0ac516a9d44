"""The runner whose gait has the least, or the most, of a quantity: over parameters, within bounds."""

from __future__ import annotations

from collections.abc import Mapping

from ..analysis.search import periodic_gait
from ..checks import checked_whole
from ..library.runner import Runner
from ..library.shared_steps import shares_steps
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from ..variables.table import Model
from ..variables.values import model_of
from ..variables.variable import Given
from .optimizer import Optimizer
from .optimum import Optimum
from .problem import Goal, check_action, checked_objective, checked_radius, checked_space, checked_values

STARTS, MAX_STARTS = 6, 100


@shares_steps
def optimize(
    runner: RunnerLike,
    vary: Mapping[str, tuple[Given, Given]],
    *,
    minimize: str | None = None,
    maximize: str | None = None,
    target: Mapping[str, float] | None = None,
    stable: bool | float = False,
    starts: int = STARTS,
    model: str | Model | None = None,
    progress: bool = False,
) -> Optimum:
    """The best runner: parameters within bounds whose gait has the least or the most of a quantity.

    By sequential quadratic programming (SLSQP), with gradients that are exact through the gait. These change
    smoothly only while the gait word and the events of the stride stay, so that each run of SLSQP is on one
    region. Where an iterate is on another, the border between the two is located. If the objective gets
    better away from the border on one side, the search goes on there; if on neither, the best point on the
    border is found by SLSQP along it. The gradients of both sides then show whether
    it is an optimum, see `Optimum.remaining_improvement`. Where an iterate has no gait, because of a fold or
    a fall, the search backs off. Near a fold it stops where the leading eigenvalue is about 0.99, and
    `limits` reports `fold`.

    Each search is local. The first one begins with the runner given, the others where gaits promise most of a
    thousand or so that the ensemble engine settles all over the bounds, and that have no better one near them
    (multi-level single linkage). How many different optima they end at is told, in `basins`. A better gait
    that none of them leads to may exist, also on a branch of unstable ones: the result is called local,
    unless no gait can have less.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path
        Who is to become better: a runner, or start values by the unit's names and in its units, over the
        unit's own. The search begins with its gait.
    vary : mapping of str to pairs of float
        Parameters and inputs that are varied, with their lower and upper bounds; also texts like `40 deg`.
    minimize, maximize : str, optional
        One of the two: the quantity, by a name of `library.quantities.QUANTITIES`, among them
        `cost_of_transport`, `speed`, `slip_distance`.
    target : mapping of str to float, optional
        Quantities that are prescribed, by the same names, in SI units.
    stable : bool or float, default False
        Only gaits whose spectral radius is at most this; True stands for 0.99. The radius is constrained by
        the leading eigenvalues one by one, which are smooth where the radius itself is not.
    starts : int, default 6
        How many searches are made at the most; the best counts. With one, only the runner's own gait is begun
        with.
    model : str, optional
        `full` or `reduced`, as in `find_gait`.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    Optimum
        The parameters, the gait, which bounds are active, and whether it was shown to be an optimum.

    Raises
    ------
    InputError
        An unknown quantity, bounds that are none, a parameter without effect, or a value that is refused.
    TargetNotMetError
        No gait within the bounds has what is prescribed, or is stable: `nearest` is the nearest that was
        found.
    RunError
        There is no gait to begin with, or none within the bounds.

    Examples
    --------
    >>> import tdmf_slip
    >>> angles = {"hip.touchdown_angle": (0.5, 0.75)}
    >>> best = tdmf_slip.optimize({}, angles, minimize="cost_of_transport", starts=1)
    >>> best.active_bounds
    {'hip.touchdown_angle': 'upper'}
    """
    objective, sign = checked_objective(minimize, maximize)
    space = checked_space(vary, model_of(runner, model))
    prescribed = checked_values(target, (objective,), space)
    goal = Goal(objective, sign, prescribed, radius=checked_radius(stable))
    count = checked_whole("starts", starts, 1, MAX_STARTS)
    before = periodic_gait(Runner(runner, model=model))
    optimizer = Optimizer(before, space, count)
    check_action(optimizer.candidate(goal), space)
    with progress_bar("optimize", count, "starts", progress) as bar:
        found = optimizer.best(goal, bar)
    return optimizer.optimum(goal, found)
