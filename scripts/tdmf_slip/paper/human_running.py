"""Human running, published beside computed: the preset of human size, and a fit at eight speeds.

The sources stand in `variables/presets/human.toml` and `fitting/data/human_running.csv`.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cache

import numpy as np

from ..analysis.search import periodic_gait
from ..errors import GaitNotFoundError
from ..fitting.fitted import fit
from ..fitting.result import Fit
from ..library.gait import Gait
from ..library.quantities import weight_of
from ..variables.parameters import read_parameters
from ..variables.variable import Given
from .claims import CLAMP, FREE, Claim, Finding, both_readings

STIFFNESS, EACH = "leg.stiffness", ("hip.stance_torque", "hip.touchdown_angle")
JOG, FIT = "human jog", "human at 2.6 to 4.0 m/s"
SCATTER = 2.0
"""Standard deviations between people within which a gait agrees."""


def peak_force(gait: Gait) -> float:
    """Largest normal force of the stride, body weights."""
    return float(gait.stride["peak_force"] / weight_of(gait.runner))


TUNED: Mapping[str, Mapping[str, Given]] = {
    FREE: {},
    CLAMP: {"hip.stance_torque": 336.0, "hip.liftoff_angle_factor": 0.63, "hip.swing_clamp": True},
}
"""Values over the preset's that tune it to the measured speed and step frequency, by reading."""
MEASURED: Sequence[tuple[str, float, float, str, str, Callable[[Gait], float]]] = (
    ("steps per second, tuned", 2.62, 0.16, "Hz", "Karamanidis 2005", lambda gait: 1.0 / gait.period),
    ("contact", 271, 23, "ms", "Karamanidis 2005", lambda gait: 1000.0 * gait.stride["stance_time"]),
    ("peak force", 2.36, 0.19, "body weights", "Front. Physiol. 2022", peak_force),
)
"""Quantities of people at 2.5 to 3.1 m/s, as the preset cites them.

Each has a name, its mean, the standard deviation between the people, unit and paper, and how it is computed.
"""

GROUPS = ((15.0, 1.7), (16.6, 3.1))
"""Mean leg stiffness of two groups at 20 km/h with its standard deviation, kN/m, by another method."""


RUNNER = "human_running"
"""Parameters of the person's runner."""


def _fit(runner: str | Mapping[str, Given], data: str, vary: Sequence[str], each: Sequence[str]) -> Fit:
    """A fit by the reduced map."""
    found: Fit = fit(runner, data, vary, vary_each=each, model="reduced", profile=False)
    return found


@cache
def fitted() -> Fit:
    """One stiffness at eight speeds, torque and touchdown angle at each."""
    return _fit(RUNNER, "human_running", [STIFFNESS], EACH)


def claims() -> list[Claim]:
    """Published numbers of human running beside those computed."""
    preset = read_parameters("human")
    jogs = {reading: periodic_gait({**preset, **values}) for reading, values in TUNED.items()}
    found = []
    for what, mean, deviation, unit, source, quantity in MEASURED:
        values = {reading: quantity(gait) for reading, gait in jogs.items()}
        findings = {
            reading: Finding(
                f"{value:.{0 if mean > 100.0 else 2}f}", abs(value - mean) <= SCATTER * deviation
            )
            for reading, value in values.items()
        }
        published = f"{mean:g} ± {deviation:g} {unit}"
        found.append(Claim(f"{JOG}: {what}", published, findings, source=source))
    return [*found, *_of_fit(fitted()), _fast()]


def _fast() -> Claim:
    """Leg stiffness of two groups at 20 km/h."""
    found = _fit(RUNNER, "human_fast_running", [], [STIFFNESS, *EACH])
    values = [found.parameters[f"{STIFFNESS}[{row}]"].value / 1000.0 for row in (1, 2)]
    agrees = all(abs(value - of[0]) <= of[1] for value, of in zip(values, GROUPS, strict=True))
    published = ", ".join(f"{mean} ± {deviation}" for mean, deviation in GROUPS)
    return Claim(
        "human at 20 km/h: leg stiffness of two groups",
        f"{published} kN/m",
        both_readings(f"{values[0]:.1f}, {values[1]:.1f} kN/m", agrees),
        source="Girard 2017",
    )


def _of_fit(found: Fit) -> list[Claim]:
    """Claims about the runner of Matijevich and others; the reduced map has no swing."""
    source = "Matijevich 2019"
    stiffness, gait = found.parameters[STIFFNESS].value, found.gaits[0]
    relative = stiffness * gait.runner["leg.free_length"] / weight_of(gait.runner)
    values = [one.lambda_max for one in found.gaits]
    expected = found.degrees_of_freedom + SCATTER * np.sqrt(2.0 * found.degrees_of_freedom)
    chi_square = f"chi2 {found.chi_square:.1f} of {found.degrees_of_freedom}"
    fits = both_readings(
        f"one stiffness, {relative:.1f} weights per leg length; {chi_square}",
        bool(found.chi_square <= expected),
    )
    unstable = "all unstable, " if min(values) > 1.0 else ""
    steady = both_readings(f"{unstable}eigenvalues {min(values):.2f} to {max(values):.2f}", max(values) < 1.0)
    return [
        Claim(f"{FIT}: frequency and peak force", "eight of each", fits, source=source),
        Claim(f"{FIT}: gait", "steady", steady, source=source),
    ]


ASSUMED: Mapping[str, tuple[float, float]] = {
    "leg.free_length": (0.9, 1.03),
    "foot.mass": (3.0, 5.0),
    "leg.damping": (40.0, 100.0),
    "ground.friction": (0.4, 1.0),
}
"""Constants that the fit assumes, with the ends between which they are varied: m, kg, N s/m, 1."""
MASSES = (71.4, 84.0, 92.4)
"""Masses of the runner, which is not published, kg; forces are published in body weights."""
COMMAND = (
    f"tdmf-slip fit human_running --parameters human_running --vary {STIFFNESS} "
    f"--vary-each {','.join(EACH)} --model reduced"
)
OF_GAITS = (
    'python -c "from tdmf_slip.paper.human_running import fitted; '
    "print([(gait.lambda_max, gait.stride['slip_distance']) for gait in fitted().gaits])\""
)


def fit_rows() -> list[dict[str, str]]:
    """Claims about the fit of one stiffness at eight speeds: claim, value, control and command."""
    found = fitted()
    stiffness, gait = found.parameters[STIFFNESS], found.gaits[0]
    length, mass = gait.runner["leg.free_length"], weight_of(gait.runner) / gait.runner["gravity"]
    relative = length / weight_of(gait.runner)
    low, high = (relative * end for end in (stiffness.low, stiffness.high))
    by_mass = [f"{stiffness.value * one / mass / 1000.0:.1f} at {one:g} kg" for one in MASSES]
    refitted = [_refitted(name, end) for name, ends in ASSUMED.items() for end in ends]
    changes = [100.0 * (one / stiffness.value - 1.0) for one in refitted]
    values = [one.lambda_max for one in found.gaits]
    slips = [100.0 * one.stride["slip_distance"] for one in found.gaits]
    rows = [
        (
            "One leg stiffness fits a human runner at eight speeds, 2.6 to 4.0 m/s; weights per leg length.",
            f"{relative * stiffness.value:.1f} ({low:.1f} to {high:.1f}); chi square "
            f"{found.chi_square:.1f} with {found.degrees_of_freedom} degrees of freedom",
            f"leg length, foot mass, damping or friction changed: {min(changes):+.1f} % to "
            f"{max(changes):+.1f} %",
            COMMAND,
        ),
        (
            "In kN/m it is proportional to the runner's mass, which is assumed.",
            ", ".join(by_mass),
            "",
            COMMAND,
        ),
        (
            "All eight fitted gaits are unstable in the reduced map: largest eigenvalues.",
            f"{min(values):.2f} to {max(values):.2f}",
            f"by the full model: {_full_gaits(found)} of 8 runners have a gait with the free swing, "
            f"{_full_gaits(found, clamp=True)} with the clamp",
            OF_GAITS,
        ),
        (
            "The fitted runner slips in every step, cm; slip of the person was not measured.",
            f"{min(slips):.1f} to {max(slips):.1f}",
            "at the assumed friction of 0.6",
            OF_GAITS,
        ),
    ]
    return [dict(zip(("claim", "value", "control", "command"), row, strict=True)) for row in rows]


def _refitted(name: str, value: float) -> float:
    """The stiffness with one assumed constant changed."""
    values = read_parameters(RUNNER)
    changed = {name: value}
    if name == "leg.free_length":  # the start is an apex, with a leg of this length above the ground
        changed |= {"leg.length": value, "foot.y": float(values["foot.y"]) * value + 0.02}
    found = _fit({**values, **changed}, "human_running", [STIFFNESS], EACH)
    return float(found.parameters[STIFFNESS].value)


def _full_gaits(found: Fit, clamp: bool = False) -> int:
    """Number of the fitted runners that have a gait in the full model."""
    count = 0
    for gait in found.gaits:
        try:
            periodic_gait(gait.runner.replace({"hip.swing_clamp": clamp}, model="full"))
        except GaitNotFoundError:
            continue
        count += 1
    return count
