"""Falls of guinea fowl on slippery ground, published beside computed.

Clark and Higham (2011): `guinea_fowl.toml` has their words, and the runner that stands for a bird.

A runner on its gait reaches an apex with the patch before it. For this landing the leg is placed at a
prescribed contact angle, and the friction of the stride is that of the patch; afterwards both return to their
former values. The reduced map is used, because its leg comes down exactly at the prescribed angle.
"""

import math
import tomllib
from collections.abc import Mapping, Sequence
from functools import cache
from importlib import resources
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..analysis.targeted import find_gait
from ..errors import RunError
from ..library.batch import Batch
from ..library.batch_tables import CLOSED
from ..library.fixed_point import gait_near
from ..library.gait import Gait
from ..library.runner import Runner
from ..variables.table import FRICTION
from .claims import Claim, both_readings
from .evidence import touchdown_angle
from .statements.claim import ANGLE, RATE, TORQUE

if TYPE_CHECKING:
    import xarray

AFTER = 30
"""Strides after the patch: a runner that has made them is up."""
STEEPEST = math.pi / 2.0
"""Bound of the angle at which a leg may be placed, rad from the vertical."""


def contact_angle_of(gait: Gait) -> float:
    """The angle of the leg from the ground at touchdown, on a gait."""
    return 90.0 - math.degrees(touchdown_angle(gait))


def landing_at(gait: Gait, contact_angle: float) -> Runner | None:
    """The runner of a gait whose leg is placed so that it comes down at an angle, from the gait's apex."""
    values, at = gait.runner, math.radians(90.0 - contact_angle)
    share = values["body.mass"] / (values["body.mass"] + values["foot.mass"])
    drop = float(gait.apex[0]) - share * values["leg.free_length"] * math.cos(at)
    if drop <= 0.0:
        return None
    touchdown_angle = at + values[RATE] * math.sqrt(2.0 * drop / values["gravity"])
    return gait.runner.replace({ANGLE: touchdown_angle}) if touchdown_angle < STEEPEST else None


def meet_patch(
    gaits: Sequence[Gait], contact_angles: Sequence[float], frictions: Sequence[float]
) -> "xarray.Dataset":
    """Falls and slip of runners on gaits that meet a patch, one stride long.

    `fell` is 1 or 0, and NaN if the leg cannot be placed at the angle. `slip_distance`, m, is that of the
    first stride on the patch, and NaN where this stride does not close. `own_angle` is the contact angle of
    a gait.
    """
    import xarray  # slow to load

    landings = {
        (number, row, column): runner.replace({FRICTION: friction})
        for number, friction in enumerate(frictions)
        for row, gait in enumerate(gaits)
        for column, angle in enumerate(contact_angles)
        if (runner := landing_at(gait, angle)) is not None
    }
    cells, before = tuple(np.transpose([*landings])), [gaits[row] for _, row, _ in landings]
    inputs = {
        name: [
            [patch[name], *[gait.runner[name]] * AFTER]
            for patch, gait in zip(landings.values(), before, strict=True)
        ]
        for name in (FRICTION, ANGLE)
    }
    batch = Batch([gait.runner for gait in before], [gait.apex for gait in before], inputs=inputs)
    made = batch.run(1 + AFTER, record=True).recorded
    assert made is not None
    fell = np.full((len(frictions), len(gaits), len(contact_angles)), np.nan)
    slips = fell.copy()
    fell[cells], slips[cells] = made["fate"][:, -1] != CLOSED, made["slip_distance"][:, 0]
    over = ("friction", "speed", "contact_angle")
    axes = dict(zip(over, (frictions, [gait.stride["speed"] for gait in gaits], contact_angles), strict=True))
    own = "speed", [contact_angle_of(gait) for gait in gaits]
    return xarray.Dataset({"fell": (over, fell), "slip_distance": (over, slips), "own_angle": own}, axes)


FRICTIONS = (0.05, 0.1, 0.2)
"""Friction coefficients of the patch, because that of polypropylene is not known."""
SOURCE = "Clark and Higham 2011"
"""Authors who measured guinea fowl on a slippery patch."""
STEP = 0.1
"""Step between speeds, m/s."""
ANGLES = np.arange(50.0, 76.0, 1.0)
"""Contact angles, degrees from the ground."""
NEAR = 5.0
"""Largest difference, degrees, of a border that agrees with the published one, as its friction is unknown."""
GRAVITY = 9.81
"""Gravitational acceleration, m/s2."""
MAXIMUM = 0.9
"""Share that counts as nearly all."""


@cache
def published() -> Mapping[str, Mapping[str, float]]:
    """The numbers of `guinea_fowl.toml`, by table."""
    text = resources.files(__package__).joinpath("guinea_fowl.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def borders(found: "xarray.Dataset", friction: float) -> NDArray[np.float64]:
    """Contact angles down to which gaits stay up, degrees; begun at the one nearest to their own."""
    angles, up = found["contact_angle"].values, found["fell"].sel(friction=friction).values == 0.0
    border = np.full(len(up), np.nan)
    for row, own in enumerate(found["own_angle"].values):
        if up[row].any():
            column = int(np.argmin(np.where(up[row], np.abs(angles - own), np.inf)))
            falls_below = np.flatnonzero(~up[row, :column])
            border[row] = angles[falls_below[-1] + 1 if len(falls_below) else 0]
    return border


def runner_of(leg_length: float | None = None) -> Runner:
    """The runner that stands for a bird, by the reduced map, at the speed where the others begin."""
    its = published()["runner"]
    length = leg_length or its["leg_length"]
    stiffness = its["stiffness"] * its["mass"] * GRAVITY / length
    values = {
        "body.mass": its["mass"] / (1.0 + its["foot_share"]),
        "foot.mass": its["mass"] * its["foot_share"] / (1.0 + its["foot_share"]),
        "leg.stiffness": stiffness,
        "leg.damping": 2.0 * its["damping_ratio"] * math.sqrt(its["mass"] * stiffness),
        "leg.free_length": length,
        "leg.min_length": 0.05 * length,
        "gravity": GRAVITY,
        TORQUE: its["start_torque"] * stiffness * length**2,
        ANGLE: math.radians(its["touchdown_angle"]),
        RATE: its["start_speed"] / length,
        FRICTION: its["high_friction"],
    }
    return Runner(values, model="reduced")


@cache
def gaits(leg_length: float | None = None) -> tuple[Gait, ...]:
    """Gaits over the published speeds, as far as there are any, each from its neighbour."""
    its = published()["runner"]
    runner = runner_of(leg_length)
    length, begin = runner["leg.free_length"], its["start_speed"]
    first = gait_near(runner, [its["start_height"] * length, begin])
    low, high = published()["published"]["slowest"], published()["published"]["fastest"]
    count = round((high - low) / STEP)
    speeds = [low + STEP * k for k in range(count + 1)]
    up = _continued(first, [speed for speed in speeds if speed >= begin])
    down = _continued(first, [speed for speed in reversed(speeds) if speed < begin])
    return (*reversed(down), *up)


def _continued(gait: Gait, speeds: Sequence[float]) -> list[Gait]:
    """Gaits at speeds in turn, to the last that there is."""
    found: list[Gait] = []
    for speed in speeds:
        runner = gait.runner.replace({RATE: speed / gait.runner["leg.free_length"]})
        try:
            gait = find_gait(runner, target={"speed": speed}, vary=[TORQUE], guess=gait.apex)
        except RunError:
            break
        found.append(gait)
    return found


@cache
def fall_map(leg_length: float | None = None) -> "xarray.Dataset":
    """Falls on a patch over its friction, speed and contact angle; the last friction is the ground's."""
    return meet_patch(
        gaits(leg_length), ANGLES.tolist(), [*FRICTIONS, published()["runner"]["high_friction"]]
    )


def claims(found: "xarray.Dataset") -> list[Claim]:
    """Numbers of Clark and Higham beside the map on the most slippery patch; the reduced map has no swing."""
    said, friction, speeds = published()["published"], FRICTIONS[0], found["speed"].values
    border, slow = borders(found, friction), speeds <= said["fast"]
    patch = f"guinea fowl, mu = {friction:g}"
    fallen = found["fell"].isel(contact_angle=said["contact_angle"] < ANGLES).sum(["speed", "contact_angle"])
    steep, *_, anyway = fallen.values
    fell, slips = (found[name].sel(friction=friction).values for name in ("fell", "slip_distance"))
    up, down = slips[fell == 0.0], slips[fell == 1.0]
    short = float(np.mean(up < said["slip_distance"]))
    known = down[np.isfinite(down)]
    long = float(np.mean(known >= said["slip_distance"]))
    of_slow, of_fast, fast = np.nanmax(border[slow]), np.nanmax(border[~slow]), f"{said['fast']:g} m/s"
    begins, ends = speeds[0] < said["slowest"] + 0.5 * STEP, speeds[-1] > said["fastest"] - 0.5 * STEP
    near = abs(of_slow - said["contact_angle"]) <= NEAR
    slips_up = f"for {100 * short:.0f} %, the largest {100 * np.max(up):.0f} cm"
    said_and_found = [
        ("speeds", "1.3 to 3.6 m/s", f"{speeds[0]:.1f} to {speeds[-1]:.1f} m/s", begins and ends),
        ("contact angle to stay up", "> 70°", f"> {of_slow - 1:.0f}° up to {fast}", near),
        (
            "falls above 70°",
            "avoided",
            f"{steep:.0f}, and {anyway:.0f} where it is not slippery",
            steep == 0.0,
        ),
        (f"less above {fast}", "tolerated", f"> {of_fast - 1:.0f}°", of_fast < of_slow),
        ("slips of those up", "below 10 cm", slips_up, short >= MAXIMUM),
        (
            "slips of those that fall",
            "10 cm or more",
            f"{100 * long:.0f} % of those that fall after it",
            long >= MAXIMUM,
        ),
    ]
    return [
        Claim(f"{patch}: {what}", published, both_readings(computed, bool(agrees)), source=SOURCE)
        for what, published, computed, agrees in said_and_found
    ]
