"""How long a runner stays up on rough ground that it hardly ever falls on: by multilevel splitting.

Walkers are runners at their apices. The score that they are split by is learned where falls are common: on
rougher ground, how likely a runner at an apex is to fall within the next strides. The estimate does not
depend on it, only its interval does.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..checks import checked_whole
from ..drawable import Drawable
from ..errors import InputError
from ..library.gait import Gait, check_is_gait
from ..library.ground import LAST_SEED, RoughGround
from ..library.laws import Law, check_law
from ..library.runner import Runner
from ..terminal.progress import progress_bar
from ..variables.parameters import RunnerLike
from .search import periodic_gait
from .splitting import CONFIDENCE, REPLICAS, RareEvent, levels_of, rare_event
from .walkers import Walkers

LEVELS = 16
MAX_WALKERS, MAX_STEPS = 10_000, 100_000
SMOOTHEST = 1e-9
"""Roughness, m."""


@dataclass(frozen=True, eq=False, repr=False)
class RareFalls(Drawable):
    """Strides until a rare fall, estimated by splitting."""

    runner: Runner
    """The runner that falls."""
    word: str
    """Of the gait on level ground that the runners start from."""
    roughness: float
    """Standard deviation of a step, m."""
    found: RareEvent
    """Rates of independent runs, falls and strides."""

    @property
    def mean_strides(self) -> float:
        """Until the fall; infinite where none was seen."""
        return self.found.mean

    @property
    def interval(self) -> tuple[float, float]:
        """Confidence interval of the mean; above it may be open."""
        return self.found.interval

    @property
    def falls(self) -> int:
        """Of walkers, each with its weight."""
        return self.found.events

    @property
    def strides(self) -> int:
        """Made by all walkers."""
        return self.found.steps

    def __repr__(self) -> str:
        """In a line: the mean with its interval."""
        low, high = self.interval
        roughness = f"{self.roughness:.4g} {self.runner.label('m')}"
        return (
            f"<RareFalls of {self.word} on steps of {roughness}: "
            f"{self.mean_strides:.4g} strides, {low:.4g} to {high:.4g}>"
        )

    def as_json(self) -> dict[str, object]:
        """The estimate as a plain object."""
        return {
            **self.runner.record(),
            "word": self.word,
            "roughness": self.roughness,
            "mean_strides": self.mean_strides,
            "interval": list(self.interval),
            "confidence": CONFIDENCE,
            "falls": self.falls,
            "strides": self.strides,
            "runs": len(self.found.rates),
        }


def rare_falls(
    runner: RunnerLike,
    roughness: float | RoughGround,
    *,
    walkers: int = 64,
    strides: int = 160,
    seed: int = 0,
    gait: Gait | None = None,
    law: Law | None = None,
    progress: bool = False,
) -> RareFalls:
    """The mean number of strides until a fall that hardly ever comes, by multilevel splitting.

    Ground, start and fall are those of `strides_to_fall`, which waits for falls and serves where they come.
    Here `REPLICAS` independent runs keep so many walkers at each of `LEVELS` levels of danger.

    Parameters
    ----------
    runner : Runner, Gait, mapping of str to float, Series, str or Path
        Who runs: a runner, or start values by the unit's names and in its units, over the unit's own.
    roughness : float or RoughGround
        Standard deviation of a step, m; or ground whose steps hang together, trip, or come with a friction of
        their own for each stride. Its seed is of no account here.
    walkers : int, default 64
        Kept at each level.
    strides : int, default 160
        Of each walker in each run, of which the first quarter is forgotten.
    seed : int, default 0
        Of everything that is drawn.
    gait : Gait, optional
        What they start from; by default the gait that `find_gait` finds.
    law : callable or AffineLaw, optional
        What is set at each apex, as in `strides_to_fall`.
    progress : bool, default False
        A bar on stderr.

    Returns
    -------
    RareFalls
        The mean with its confidence interval.

    Raises
    ------
    InputError
        A value is not allowed, the runner goes by the reduced map, or the law does not fit it.
    RunError
        There is no gait to start from, or no fall was seen on much rougher ground either.

    Examples
    --------
    >>> import tdmf_slip
    >>> rare = tdmf_slip.rare_falls({"ground.friction": 0.6}, 0.4, walkers=8, strides=16)
    >>> low, high = rare.interval
    >>> low < rare.mean_strides < high
    True
    """
    runner = Runner(runner)
    if runner.reduced:
        raise InputError(
            "runner by the reduced map is not allowed on rough ground; allowed: by the full model"
        )
    check_law(law, runner)
    ground = roughness if isinstance(roughness, RoughGround) else RoughGround(roughness)
    _check_is_rough(ground)
    walkers = checked_whole("walkers", walkers, 8, MAX_WALKERS)
    strides = checked_whole("strides", strides, 8, MAX_STEPS)
    seed = checked_whole("seed", seed, 0, LAST_SEED)
    if gait is not None:
        check_is_gait(gait, "gait")
    start = periodic_gait(runner) if gait is None else gait
    chain = Walkers(start, ground, law)
    with progress_bar("rare falls", REPLICAS + 1, "runs", progress) as bar:
        scores, highest = chain.learn(seed % 2**32)
        bar.update()
        levels = levels_of(scores, highest, LEVELS)
        found = rare_event(chain, levels, keep=walkers, steps=strides, seed=seed, done=bar.update)
    return RareFalls(start.runner, start.word, ground.roughness, found)


def _check_is_rough(ground: RoughGround) -> None:
    """Refuse ground without steps, a terrain, and friction that hangs together."""
    if ground.roughness < SMOOTHEST:
        raise InputError(f"roughness = {ground.roughness:g} is not allowed; allowed: {SMOOTHEST:g} m or more")
    if ground.segment_length:
        raise InputError(
            f"segment_length = {ground.segment_length:g} m: rare_falls copies walkers from apex to apex, and "
            "copies would have the same segments ahead; allowed: ground by stride (segment_length of 0), or "
            "strides_to_fall"
        )
    if ground.friction_weights:
        raise InputError(
            "friction_weights: friction that hangs together has a past, which rare_falls would have to copy "
            "with each walker and copies of steps alone; allowed: a friction of its own for each stride "
            "(friction_spread), or strides_to_fall"
        )
