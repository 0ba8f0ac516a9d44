"""Runners side by side: strides with exact derivatives, runs over many strides, and stepping in place.

::

    batch = Batch({"ground.friction": [0.4, 0.6]}, apex)
    batch.stride(jacobian=True).jacobian, batch.run(100).fate
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..checks import checked_between, checked_whole
from ..errors import InputError
from ..given import numbers_by, numbers_of, row_of
from ..uninterrupted import in_block
from ..variables.table import by_full_name
from . import c_structs, own_runs
from .batch_given import TOLERANCE as TOLERANCE
from .batch_given import Given
from .batch_tables import ends_table, recorded_table, strides_table
from .c_structs import WIDTH
from .engine import LAST_STRIDE, Engine
from .laws import AffineLaw, CheckedLaw
from .own_model import OwnModel
from .return_map import Along, checked_direction
from .returns import RunnerStrides
from .settings import setting_number
from .tables import Table

LARGEST_BALL = 1e100
"""Largest number in a ball's matrix."""
WORK = ("strides", "events", "steps", "lane_steps", "evaluations", "layer_steps")
"""Counters of the engine: strides closed, events taken and steps of all runners; lanes stepped, occupied or
not; coefficients of series; steps shortened by a friction that falls with speed."""


class Session:
    """A request to the engine for a batch, which goes on, and what is set in each stride."""

    def __init__(self, batch: Given) -> None:
        self.batch = batch
        law, single = batch.law, batch.is_single
        threads = batch.threads or (1 if single or in_block() else os.cpu_count() or 1)
        self.engine = Engine(batch, threads)
        self.function: CheckedLaw | None = None
        if isinstance(law, AffineLaw):
            self.engine.obey(law.settings)
        elif law is not None:
            self.function = CheckedLaw(
                law, batch.runner, batch.ground, tuple(batch.varied), tuple(batch.inputs)
            )
            self.engine.keep_checkpoints()
        self.names: tuple[str, ...] = ()
        self.values = np.empty((len(batch), 1, 0))
        self.made: list[NDArray[np.float64]] = []
        if batch.inputs and self.function is None:
            width = max(rows.shape[1] for rows in batch.inputs.values())
            self._set_by(tuple(batch.inputs), width)
            for number, rows in enumerate(batch.inputs.values()):
                self.values[..., number] = np.pad(rows, ((0, 0), (0, width - rows.shape[1])), "edge")

    def _set_by(self, names: tuple[str, ...], width: int) -> None:
        self.names = names
        self.values = np.empty((len(self.batch), width, len(names)))
        self.engine.set_by(
            [setting_number(name, "settings", self.batch.model) for name in names], self.values
        )

    def settle(self, until: Any, near: float, balls: ArrayLike | None) -> None:
        """Have runs end on gaits."""
        batch, size = self.batch, self.batch.size
        if batch.ground.segment_length:
            raise InputError(
                f"gaits on a terrain (segment_length = {batch.ground.segment_length:g} m), where no apex "
                "comes back; allowed: one of the two"
            )
        batch.refuse_patches()
        gaits = numbers_by("until", getattr(until, "apex", until), batch.runner.coordinates)
        gaits = gaits.reshape(*[1] * (3 - gaits.ndim), *gaits.shape)
        if gaits.ndim != 3 or gaits.shape[2] != size or gaits.shape[0] not in (1, len(batch)):
            raise InputError(
                f"until of shape {gaits.shape}; allowed: rows of {', '.join(batch.runner.coordinates)}"
            )
        if not np.isfinite(gaits).all():
            raise InputError(f"until: {gaits.tolist()}: allowed: finite numbers")
        wide = np.zeros((*gaits.shape[:2], WIDTH))
        wide[..., :size] = gaits
        matrices = None if balls is None else numbers_of("balls", balls)
        if matrices is not None:
            fits = matrices.shape == (gaits.shape[1], size, size)
            if not fits or not np.all(np.abs(matrices) <= LARGEST_BALL):
                raise InputError(
                    f"balls: of shape {matrices.shape}; allowed: one for each gait, {size} by {size}, up to "
                    f"{LARGEST_BALL:g}"
                )
        self.engine.settle_on(wide, checked_between("near", near, 0.0, np.inf), matrices)

    def make(self, strides: int) -> dict[str, int]:
        """Make strides, all at once or, by a function, one after the other."""
        if self.function is None:
            work = self.engine.advance(strides)
            return {name: getattr(work, name) for name in WORK}
        done = dict.fromkeys(WORK, 0)
        for _ in range(strides):
            self._set(self._asked(self.function))
            self.made.append(self.values[:, 0].copy())
            work = self.engine.advance(1)
            done = {name: count + getattr(work, name) for name, count in done.items()}
            if not self.engine.keep_checkpoints()["stands"].any():
                break
        return done

    def _asked(self, function: CheckedLaw) -> dict[str, NDArray[np.float64]]:
        """Settings of the next stride, from the inputs and from the function."""
        engine, batch, stride = self.engine, self.batch, self.engine.made
        if stride == 0:
            apices, runs = batch.starts[:, : batch.size].copy(), np.full(len(batch), True)
        else:
            runs = engine.keep_checkpoints()["stands"]
            apices = np.where(runs[:, None], engine.ends["apex"][:, : batch.size], np.nan)
        given = {name: rows[:, min(stride, rows.shape[1] - 1)] for name, rows in batch.inputs.items()}
        return given | function(apices, stride, runs)

    def _set(self, settings: Mapping[str, ArrayLike]) -> None:
        """Set the next stride, by names that the first call decides."""
        if not self.names:
            self._set_by(tuple(settings), 1)
        elif set(settings) != set(self.names):
            raise InputError(
                f"settings: {', '.join(map(str, settings))}; allowed: {', '.join(self.names)}, as in the "
                "first call"
            )
        values = self.values[:, 0]
        for number, name in enumerate(self.names):
            values[:, number] = settings[name]
        self.engine.set_from(self.engine.made)

    def step(self, settings: Mapping[str, ArrayLike] | None) -> None:
        """One stride, without checks."""
        if self.function is not None:
            settings = {**self._asked(self.function), **(settings or {})}
        if settings:
            self._set(settings)
        self.engine.record_next()
        self.engine.advance(1)

    def settings_made(self, strides: int) -> dict[str, NDArray[np.float64]]:
        """Settings of each stride, by name, shape (runners, strides)."""
        if not self.names:
            return {}
        values = np.stack(self.made, axis=1) if self.made else self.values
        values = np.pad(values, ((0, 0), (0, max(0, strides - values.shape[1])), (0, 0)), "edge")
        return {name: values[:, :strides, number] for number, name in enumerate(self.names)}


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

    _stepping: Session | None = None

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
        most = own_runs.SEEDS if self.model.is_own else c_structs.SEEDS
        parts = [
            self._exact_strides(is_differentiated, along[first : first + most])
            for first in range(0, max(len(along), 1), most)
        ]
        return strides_table(self, parts, along, is_differentiated=is_differentiated)

    def _exact_strides(self, is_differentiated: bool, along: Sequence[Along]) -> own_runs.Strides:
        starts = self.starts[:, : self.size].copy()
        if isinstance(self.model, OwnModel):
            return own_runs.strides_of(
                self.model,
                self.models,
                self.held,
                starts,
                tolerance=self.runner.tolerance,
                seeds=own_runs.seeds_of(self.model, along) if is_differentiated else None,
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
        session = Session(self)
        if until is None and balls is not None:
            raise InputError("balls without gaits; allowed: with until")
        if until is not None:
            session.settle(until, near, balls)
        if record:
            session.engine.record(strides)
        work = session.make(strides)
        engine = session.engine
        recorded = recorded_table(self, engine, session.settings_made(strides)) if record else None
        return ends_table(self, engine, work, recorded)

    def step(self, settings: Mapping[str, ArrayLike] | None = None) -> NDArray[np.int32]:
        """One more stride of each runner that still runs, in place and without checks.

        Parameters
        ----------
        settings : mapping of str to array_like, optional
            What is set for this stride, by the names that the first call had: a number each, or one for each
            runner. The engine refuses numbers out of range with a `MemoryError`.

        Returns
        -------
        ndarray of int, shape (runners,)
            Fates by `FATES`; a runner that has made its strides is `undecided`. The array is the batch's own,
            as are `apices` and `last`.
        """
        session = self._stepping
        if session is None:
            session = self._stepping = Session(self)
            session.engine.keep_checkpoints()
            session.engine.record(1)
        session.step(by_full_name(settings, "settings", "numbers or arrays by name", self.model.aliases))
        fates: NDArray[np.int32] = session.engine.fates
        return fates

    @property
    def apices(self) -> NDArray[np.float64]:
        """Apices that `step` has reached, shape (runners, n); the starts before its first call."""
        apices = self.starts if self._stepping is None else self._stepping.engine.ends["apex"]
        return apices[:, : self.size]

    @property
    def last(self) -> NDArray[Any]:
        """Last strides of `step`, shape (runners,), in the fields of the library's `tdmf_ensemble_stride`."""
        recorded = self._under_way().engine.recorded
        assert recorded is not None
        strides: NDArray[Any] = recorded[:, 0]
        return strides

    def save(self) -> NDArray[Any]:
        """States of all runners after `step`, shape (runners,): a structured array that can be indexed."""
        states: NDArray[Any] = self._under_way().engine.save()
        return states

    def _under_way(self) -> Session:
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
        session = self._stepping = Session(self)
        session.engine.resume(states, stride)
        session.engine.record(1)
