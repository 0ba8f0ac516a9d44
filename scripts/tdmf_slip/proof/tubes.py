"""The tube that all starts of a set stay in along a stride, to look at."""

from dataclasses import dataclass
from fractions import Fraction

from flint import arb, ctx

from .given import Radius, RunnerLike, ball_of, gait_of, radius_of
from .parameters import Parameters
from .starts import Fineness, Starts
from .travelling_set import SetTraveller

BITS = 80


@dataclass(frozen=True)
class Section:
    """A tube at the end of a step or an event."""

    time: float
    """Since the apex, s."""
    contact: str
    """Mode of the foot: flight, stick, slip or graze."""
    middle: dict[str, float]
    """Centres of the motion's numbers: the leg's, and by mode those of the centre of mass or of the foot."""
    radius: dict[str, float]
    """How far a start of the set may be from the middle."""


def tube_along(gait: RunnerLike = None, radius: Radius = Fraction(1, 10**8)) -> list[Section]:
    """The tube of all starts around a gait's apex, along a stride."""
    found, values = gait_of(gait)
    fine, size = Fineness(BITS), radius_of(radius)
    with ctx.workprec(BITS):
        radii = [ball_of(size) * float(scale) for scale in found.runner.scales]
        starts = Starts([arb(float(x)) for x in found.apex], [r.upper().mid() for r in radii])
    traveller = SetTraveller(Parameters(values), starts, fine, fine)
    sections = [_section(traveller)]
    while not traveller.step():
        sections.append(_section(traveller))
    return [*sections, _section(traveller)]


def _section(traveller: SetTraveller) -> Section:
    return Section(
        float(traveller.time.mid()),
        traveller.mode.contact,
        {name: float(ball.mid()) for name, ball in traveller.set.items()},
        {name: float(ball.rad()) for name, ball in traveller.set.items()},
    )
