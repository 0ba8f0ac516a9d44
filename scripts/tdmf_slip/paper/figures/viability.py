"""Size of the viable sets against friction, for runners of equal speed and apex height."""

import pandas
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...analysis.sweeps import gaits_in
from ...library.runner import Runner
from ...pictures import style
from ...variables.table import FRICTION
from ...viable_sets.viability import viability
from ..matched import IN_TWO, match_gaits
from ..statements.regions import CHOSEN, VIABLE_PLANE
from .data import Results, table_of
from .over_friction import friction_axis

FRICTIONS = (0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.43, 0.6, 0.85, 1.2, 2.5, 5.0, 10.0)
REFERENCE = 0.6
"""Friction of the gait to which runners are matched."""
HOLD, VARY = IN_TWO
CELLS = 64
BAND, COLOUR = "between the inner and the outer set", "#1f5fa8"


def table(results: Results) -> pandas.DataFrame:
    """Viable sets of matched runners by the reduced map, at each friction; takes minutes."""
    small = Runner(results.runner, model="reduced")
    unmatched = [small.replace({FRICTION: friction}) for friction in (REFERENCE, *FRICTIONS)]
    runners = [gait.runner for gait in gaits_in(match_gaits(unmatched, HOLD, VARY))]
    sets = [viability(one, axes=VIABLE_PLANE, vary=CHOSEN, n=CELLS, progress=True) for one in runners]
    settings = pandas.DataFrame({of: [one[of] for one in runners] for of in (FRICTION, *VARY)})
    sizes = table_of(
        sets,
        "inner_share",
        "outer_share",
        inner_robustness=lambda found: float(found["inner_robustness"].mean()),
        outer_robustness=lambda found: float(found["outer_robustness"].mean()),
    )
    return settings.rename(columns={FRICTION: "friction"}).join(sizes)


def draw(results: Results) -> Figure:
    """Draw both shares against friction, as bands between the inner and the outer set."""
    data = results.table("viability")
    figure, axes = style.subplots(2, 1, figsize=(7.6, 6.6), sharex=True)
    _band(axes[0], data, "share")
    axes[0].set_title("(a) viable share of the plane of apex heights and speeds")
    _band(axes[1], data, "robustness")
    axes[1].set_ylim(bottom=0.0)
    axes[1].set_title("(b) viable share of the touchdown angles, averaged over the plane")
    axes[0].legend(loc="upper left")
    friction_axis(axes[1], FRICTIONS)
    return figure


def _band(axes: Axes, data: pandas.DataFrame, what: str) -> None:
    friction, inner, outer = (data[name] for name in ("friction", f"inner_{what}", f"outer_{what}"))
    axes.fill_between(friction, inner, outer, color=COLOUR, alpha=0.3, linewidth=0, label=BAND)
    for ends in (inner, outer):
        axes.plot(friction, ends, ".-", color=COLOUR, linewidth=0.9, markersize=4)
