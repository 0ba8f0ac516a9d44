"""Accuracy of the solvers: gaits against their proved enclosures."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from flint import arb
from numpy.typing import NDArray

from ..analysis.stride_map import stride_map
from ..errors import InputError
from ..fmu.simulation import run_unit
from ..library.engine import instruction_sets
from ..library.runner import Runner
from ..library.strides import strides_from
from .proof import Proof
from .starts import COORDINATES

QUANTITIES = ("period", "speed", "cost_of_transport", "slip_distance")
FINEST = 1e-12
"""Tolerance of the solvers, but of the native one, which has its own default."""
LANES = 8
"""Runners side by side, so that every lane has one."""
PAST = 1.0005
"""Periods after which a run of the unit has closed a stride."""
Numbers = dict[str, float]


def solver_errors(proof: Proof) -> dict[str, Numbers]:
    """How far each solver's stride, from the proved apex, may be from the gait at the most."""
    if not proof.proved:
        raise InputError("proof: undecided; allowed: a gait that is proved")
    runner = Runner({name: float(value.ball()) for name, value in proof.values.items()})
    apex = np.array([float(x.mid()) for x in proof.apex])
    solvers = {**_of_library(), **_of_fmu()}
    return {name: _errors(proof, runner, solve(runner, apex)) for name, solve in solvers.items()}


def _errors(proof: Proof, runner: Runner, found: Mapping[str, float]) -> Numbers:
    errors = {name: distance(found[name], proof.quantities[name]) for name in QUANTITIES}
    rows = zip(COORDINATES, proof.apex, runner.scales, strict=True)
    errors["apex"] = max(distance(found[name], ball) / float(scale) for name, ball, scale in rows)
    return errors


def distance(value: float, ball: arb) -> float:
    """From a number to the farthest of a ball."""
    return float(abs(ball - arb(value)).upper())


Solve = Callable[[Runner, NDArray[np.float64]], Numbers]


def _of_library() -> dict[str, Solve]:
    return {"native": _native, **{f"lanes, {name}": _lanes(name) for name in instruction_sets()}}


def _of_fmu() -> dict[str, Solve]:
    return {
        "unit, Co-Simulation": _fmu("cs"),
        "unit, Co-Simulation by CVODE": _fmu("cs", {"solver.method": "cvode"}),
        "unit, Model Exchange by CVODE": _fmu("me"),
    }


def _native(runner: Runner, apex: NDArray[np.float64]) -> Numbers:
    stride = strides_from(runner, apex)
    after = dict(zip(COORDINATES, stride.apex + stride.residual, strict=True))
    return {**{name: stride.stride[name] for name in QUANTITIES}, **after}


def _lanes(instructions: str) -> Solve:
    def solve(runner: Runner, apex: NDArray[np.float64]) -> Numbers:
        run = stride_map(runner, np.tile(apex, (LANES, 1)), tolerance=FINEST, instructions=instructions)
        after = dict(zip(COORDINATES, run["next_apex"].values[0, 0], strict=True))
        return {**{name: float(run[name][0, 0]) for name in QUANTITIES}, **after}

    return solve


def _fmu(interface: str, settings: Mapping[str, str] | None = None) -> Solve:
    def solve(runner: Runner, apex: NDArray[np.float64]) -> Numbers:
        period = strides_from(runner, apex).period
        run = run_unit(
            {**runner.start_values(apex), **(settings or {})},
            stop_time=PAST * period,
            tolerance=FINEST,
            output_interval=period / 100,
            variables=(),
            interface=interface,
        )
        of_stride = {name: float(run.stride[name]) for name in QUANTITIES}
        return {**of_stride, **{name: run.apex[name] for name in COORDINATES}}

    return solve


def error_table(proofs: Sequence[Proof]) -> list[list[str]]:
    """Errors of all solvers over some gaits, the largest of each."""
    of_all = [solver_errors(proof) for proof in proofs]
    heading = ["solver", *QUANTITIES, "apex"]
    rows = [
        [solver, *(f"{max(errors[solver][name] for errors in of_all):.1e}" for name in heading[1:])]
        for solver in of_all[0]
    ]
    return [heading, *rows]
