"""Runners side by side: strides with exact derivatives, runs over many strides, and stepping in place.

::

    batch = Batch({"ground.friction": [0.4, 0.6]}, apex)
    batch.stride(jacobian=True).jacobian, batch.run(100).fate
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked_whole
from ..errors import InputError
from ..given import row_of
from ..variables.table import by_full_name
from . import c_structs, page_strides
from .batch_given import TOLERANCE as TOLERANCE
from .batch_given import Given
from .batch_tables import ends_table, recorded_table, strides_table
from .engine import LAST_STRIDE, Engine
from .page_model import PageModel
from .return_map import Along, checked_direction
from .returns import RunnerStrides
from .tables import Table

ACCURACY = 1e-8
"""Largest error of a stride at `TOLERANCE`, of its apex over the scales of the section, and of its time,
distance and energies over sqrt(m/k), l0 and k l0^2. It holds for starts anywhere in
`analysis.attraction.BOX`, and for runners whose parameters are at most a factor of e off the default ones."""
NEAR = 1e-2
"""Distance from a gait's apex, over the scales, at which a runner counts as settled."""


class Batch(Given):
    """Runners side by side in the C engine, which one object asks for strides of any kind.

    Parameters
    ----------
    runners : Runner, Gait, mapping, Series, str, Path, or sequence of these, optional
        One runner for all, one for each, or start values by name of which some are arrays with a value for
        each runner.
    apices : array_like of float, shape (n,) or (runners, n), optional
        First apices, in the order of `library.section.COORDINATES`: m, m/s, m, rad, m/s, rad/s; for the
        reduced map the first two. By default each gait's apex, or where each runner starts.
    ground : RoughGround, optional
        Uneven ground, for `run` and `step`.
    law : callable or AffineLaw, optional
        Law that sets values at each apex, for `run` and `step`: `law(apices, stride_number)` returns arrays
        by name. The engine itself follows an `AffineLaw`.
    vary : mapping of str to array_like, shape (runners,), optional
        Parameters and inputs by name in which the runners differ from the one given.
    inputs : mapping of str to array_like, optional
        Settings by name, for `run`: a number, one for each stride, shape (strides,), or one for each runner
        and stride, shape (runners, strides). Further strides have the last ones.
    model : as in `find_gait`
    foot_x : array_like of float, optional
        Positions of the feet at the start, m, by default 0; the ground may have a patch.
    first_number : int, default 0
        Number of the first runner; ground and noise are drawn by the numbers of runners and strides.
    tolerance : float, default 2e-10
        Relative tolerance of a step in `run` and `step`; `stride` has the runner's own.
    step_limit : int, optional
        Largest number of steps of a runner's first stride; each further one has those left over and a
        fortieth of them more. By default the library's `TDMF_STEP_LIMIT`. A runner that needs more is
        unsolved.
    threads : int, optional
        Threads of the engine, by default one for each processor, and one within a block of work. Results do
        not depend on it.
    instructions : str, optional
        One of `instruction_sets()`, which all give the same results, bit for bit. By default the fastest,
        but for apices of shape (n,), a single runner, `one by one`.

    Raises
    ------
    InputError
        A value is not allowed, or shapes do not go together.

    Examples
    --------
    >>> import tdmf_slip
    >>> gait = tdmf_slip.find_gait(friction=0.6)
    >>> batch = tdmf_slip.Batch(gait.runner, [gait.apex, gait.apex * [1, 1.1, 1, 1, 1, 1]])
    >>> run = batch.run(20)
    >>> print(run.strides, run.apex[:, 1].round(3))
    [20 20] [1.063 1.068]
    """

    _stepping: Engine | None = None

    def __getstate__(self) -> dict[str, Any]:
        """State without strides under way, whose memory belongs to this object."""
        return {**super().__getstate__(), "_stepping": None}

    # ---- one stride -----------------------------------------------------------------------------------

    def stride(self, jacobian: bool = False, along: Sequence[Along] = ()) -> Table:
        """One stride of each runner on the level, by the native solver, with exact derivatives.

        Parameters
        ----------
        jacobian : bool, default False
            Differentiate by the coordinates of the apex.
        along : sequence of str or mapping of str to float, optional
            Differentiate by these parameters and inputs, or along directions of several, too.

        Returns
        -------
        Table
            Over `runner`, unless there is one with a single apex: `outcome`, 0 where the stride closed,
            `word`, `why_not` it did not close, `apex`, `next_apex`, and quantities by their names. With
            derivatives also `jacobian`, shape (..., n, n), `next_apex_by`, shape (..., n, by), and for
            quantities such as `speed` the derivatives as `speed_by`, shape (..., by): by the n coordinates,
            then along the directions. All are NaN where a stride has not closed.

        Raises
        ------
        InputError
            A name is no parameter or input.
        """
        self.refuse_patches()
        along = [
            checked_direction(one, self.runner.model)
            for one in row_of(along, "along", "names or mappings in a list")
        ]
        is_differentiated = jacobian or len(along) > 0
        most = page_strides.SEEDS if self.model.is_page else c_structs.SEEDS
        parts = [
            self._exact_strides(is_differentiated, along[first : first + most])
            for first in range(0, max(len(along), 1), most)
        ]
        return strides_table(self, parts, along, is_differentiated=is_differentiated)

    def _exact_strides(self, is_differentiated: bool, along: Sequence[Along]) -> page_strides.Strides:
        starts = self.starts[:, : self.size].copy()
        if isinstance(self.model, PageModel):
            return page_strides.strides_of(
                self.model,
                self.models,
                self.held,
                starts,
                tolerance=self.runner.tolerance,
                seeds=page_strides.seeds_of(self.model, along) if is_differentiated else None,
                step_limit=self.step_limit or 0,
                threads=self.threads or 1,
            )

        def made(measured: bool) -> NDArray[Any]:
            return c_structs.exact_strides(
                self.runner.solver(),
                self.models,
                self.held,
                self.starts,
                reduced=self.runner.reduced,
                derivatives=is_differentiated,
                along=along,
                measured=measured,
            )

        return RunnerStrides(
            made(is_differentiated),
            starts,
            self.value_of,
            self.runner.reduced,
            along=along if is_differentiated else None,
            measured=None if is_differentiated else lambda: made(True),
        )

    # ---- many strides ---------------------------------------------------------------------------------

    def run(
        self,
        strides: int,
        until: Any = None,
        *,
        near: float = NEAR,
        balls: ArrayLike | None = None,
        record: bool = False,
    ) -> Table:
        """Strides of each runner until it settles, falls, or has made all of them.

        Parameters
        ----------
        strides : int
            A runner that has closed as many is undecided, as is one whose stride takes longer than
            1e4 sqrt(m/k).
        until : Gait or array_like of float, optional
            Apices of gaits that runners may settle on: shape (n,), (gaits, n), or (runners, gaits, n).
        near : float, default 1e-2
            Distance from a gait's apex, over the scales, at which a runner counts as settled.
        balls : array_like of float, shape (gaits, n, n), optional
            A runner has also settled where `|ball (apex - gait)| <= 1`.
        record : bool, default False
            Keep every stride: the table's `recorded` then has their apices, quantities and settings over
            `runner` and `stride`.

        Returns
        -------
        Table
            Over `runner`: `fate`, a number of `FATES`, `gait` (-1 for none), `strides`, `word_code`, and of
            the strides that closed the last `apex`, `foot_x` (m), `time` (s), `distance` (m), `work` (of hip
            and leg), `hip_work`, `leg_work`, `external_work`, `damper_loss`, `friction_loss` and
            `impact_loss` (J). The attribute `work_done` counts strides, events and steps of the solver.

        Raises
        ------
        InputError
            A value is not allowed.
        StoppedError
            An interrupt from the keyboard came: a `KeyboardInterrupt` with the ends of the first runners, all
            that had begun; those that are not complete have the fate `stopped`.
        """
        strides = checked_whole("strides", strides, 1, LAST_STRIDE)
        engine = Engine(self)
        if until is None and balls is not None:
            raise InputError("balls without gaits; allowed: with until")
        if until is not None:
            engine.settle(until, near, balls)
        if record:
            engine.record(strides)
        work = engine.make(strides)
        recorded = recorded_table(self, engine, engine.settings_made(strides)) if record else None
        return ends_table(self, engine, work, recorded)

    def step(self, settings: Mapping[str, ArrayLike] | None = None) -> NDArray[np.int32]:
        """One more stride of each runner that still runs, in place and without checks.

        Parameters
        ----------
        settings : mapping of str to array_like, optional
            What is set for this stride, by the names that the first call had: a number each, or one for each
            runner. The engine refuses numbers out of range.

        Returns
        -------
        ndarray of int, shape (runners,)
            Fates by `FATES`; a runner that has made its strides is `undecided`. The array is the batch's own,
            as are `apices` and `last`.
        """
        engine = self._stepping
        if engine is None:
            engine = self._stepping = Engine(self)
            engine.keep_checkpoints()
            engine.record(1)
        engine.step(by_full_name(settings, "settings", "numbers or arrays by name", self.model.aliases))
        return engine.fates

    @property
    def apices(self) -> NDArray[np.float64]:
        """Apices that `step` has reached, shape (runners, n); the starts before its first call."""
        apices = self.starts if self._stepping is None else self._stepping.ends["apex"]
        return apices[:, : self.size]

    @property
    def last(self) -> NDArray[Any]:
        """Last strides of `step`, shape (runners,), in the fields of the library's `tdmf_ensemble_stride`."""
        recorded = self._under_way().recorded
        assert recorded is not None
        strides: NDArray[Any] = recorded[:, 0]
        return strides

    def save(self) -> NDArray[Any]:
        """States of all runners after `step`, shape (runners,): a structured array that can be indexed."""
        return self._under_way().save()

    def _under_way(self) -> Engine:
        if self._stepping is None:
            raise InputError("the batch has made no stride; allowed: after step or resume")
        return self._stepping

    def resume(self, states: NDArray[Any], stride: int) -> None:
        """Replace the runners by saved ones, which begin the stride of this number; of any number of states.

        All have the parameters of the first runner.
        """
        self.starts = np.repeat(self.starts[:1], len(states), axis=0)
        self.models, self.held, self.foot_x = self.models[:1], self.held[:1], None
        self.inputs = {name: row[:1] for name, row in self.inputs.items()}
        engine = self._stepping = Engine(self)
        engine.resume(states, stride)
        engine.record(1)
