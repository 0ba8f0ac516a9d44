"""Accuracy of the solvers: gaits against their proved enclosures."""

from collections.abc import Mapping, Sequence

import numpy as np
from flint import arb

from ..analysis.stride_map import stride_map
from ..errors import InputError
from ..fmu.simulation import run_unit
from ..library.engine import instruction_sets
from ..library.gait import Gait
from ..library.runner import Runner
from ..library.section import COORDINATES
from ..library.strides import strides_from
from .proof import Proof

QUANTITIES = ("period", "speed", "cost_of_transport", "slip_distance")
FINEST = 1e-12
"""Tolerance of the solvers, but of the native one, which has its own default."""
LANES = 8
"""Runners side by side, so that every lane has one."""
PAST = 1.0005
"""Periods after which a run of the unit has closed a stride."""
UNITS: Mapping[str, tuple[str, Mapping[str, str]]] = {
    "unit, Co-Simulation": ("cs", {}),
    "unit, Co-Simulation by CVODE": ("cs", {"solver.method": "cvode"}),
    "unit, Model Exchange by CVODE": ("me", {}),
}
"""Interfaces and settings of runs of the unit."""
Numbers = dict[str, float]


def solver_errors(proof: Proof) -> dict[str, Numbers]:
    """Upper bounds of the errors of each solver's stride from the proved apex."""
    if not proof.proved:
        raise InputError("proof: undecided; allowed: a gait that is proved")
    runner = Runner({name: float(value.ball()) for name, value in proof.values.items()})
    native = strides_from(runner, np.array([float(x.mid()) for x in proof.apex]))
    after = dict(zip(COORDINATES, native.apex + native.residual, strict=True))
    found: dict[str, Numbers] = {"native": {**native.stride, **after}}
    found |= {f"lanes, {name}": _by_lanes(runner, native, name) for name in instruction_sets()}
    found |= {name: _by_unit(runner, native, *how) for name, how in UNITS.items()}
    return {name: _errors(proof, runner, numbers) for name, numbers in found.items()}


def _errors(proof: Proof, runner: Runner, found: Mapping[str, float]) -> Numbers:
    errors = {name: distance(found[name], proof.quantities[name]) for name in QUANTITIES}
    rows = zip(COORDINATES, proof.apex, runner.scales, strict=True)
    errors["apex"] = max(distance(found[name], ball) / float(scale) for name, ball, scale in rows)
    return errors


def distance(value: float, ball: arb) -> float:
    """Distance from a number to the farthest point of a ball."""
    return float(abs(ball - arb(value)).upper())


def _by_lanes(runner: Runner, native: Gait, instructions: str) -> Numbers:
    apices = np.tile(native.apex, (LANES, 1))
    run = stride_map(runner, apices, tolerance=FINEST, instructions=instructions)
    after = dict(zip(COORDINATES, run["next_apex"].values[0, 0], strict=True))
    return {**{name: float(run[name][0, 0]) for name in QUANTITIES}, **after}


def _by_unit(runner: Runner, native: Gait, interface: str, settings: Mapping[str, str]) -> Numbers:
    run = run_unit(
        {**runner.start_values(native.apex), **settings},
        stop_time=PAST * native.period,
        tolerance=FINEST,
        output_interval=native.period / 100,
        variables=(),
        interface=interface,
    )
    return {**{name: float(run.stride[name]) for name in QUANTITIES}, **run.apex}


def error_table(errors: Sequence[Mapping[str, Numbers]]) -> list[list[str]]:
    """The largest error of each solver over some gaits, under a heading."""
    heading = ["solver", *QUANTITIES, "apex"]
    rows = [
        [solver, *(f"{max(of[solver][name] for of in errors):.1e}" for name in heading[1:])]
        for solver in errors[0]
    ]
    return [heading, *rows]
