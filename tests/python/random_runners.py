"""Random runners, and their gaits by a search that is far more expensive than that of `find_gait`.

Run as a program, with a number of processes, this writes `random_runners.json`: of each runner every gait
that was found from other drawings of starts, one of them in a wider box, with three times the places from
which Newton's method begins, and more patience. What is stored is apex, word and largest eigenvalue.
"""

import contextlib
import json
import sys
from multiprocessing import Pool
from pathlib import Path

import numpy as np
from tdmf_slip import RunError, Runner
from tdmf_slip.analysis import search
from tdmf_slip.library.fixed_point import settled_gait

STORED = Path(__file__).with_suffix(".json")
SEED, RUNNERS, DRAWINGS = 22, 16, 2
RANGES = {
    "foot.mass": (0.02, 0.3),
    "leg.damping": (0.05, 0.6),
    "gravity": (0.003, 0.03),
    "ground.friction": (0.1, 3.0),
    "hip.stance_torque": (0.03, 0.4),
    "hip.touchdown_angle": (0.35, 1.0),
    "hip.kp": (0.03, 0.4),
    "hip.kd": (0.03, 0.4),
    "hip.liftoff_angle_factor": (0.6, 2.0),
}
"""Drawn evenly in the logarithm."""


def drawn():
    source = np.random.default_rng(SEED)
    for _ in range(RUNNERS):
        values = {n: float(np.exp(source.uniform(np.log(a), np.log(b)))) for n, (a, b) in RANGES.items()}
        retracts, thrusts, rate, thrust = source.uniform(size=4)
        values |= {"hip.retraction_rate": 0.01 * rate} if retracts < 0.5 else {}
        values |= {"leg.thrust": 0.1 * thrust} if thrusts < 0.25 else {}
        yield {name: float(f"{value:.4g}") for name, value in values.items()}


def gaits_of(values):
    runner = Runner(values)
    search.MAX_TRIED, search.PROMISING = 144, 36
    search.ITERATIONS, search.SHORTENINGS, search.GAIN = 24, 8, 0.97
    found = []
    with contextlib.suppress(RunError):
        found.append(settled_gait(runner))
    box = search.SPEEDS, search.ANGLES, search.LENGTHS
    for drawing in range(1, DRAWINGS + 1):
        if drawing == DRAWINGS:
            search.SPEEDS, search.ANGLES, search.LENGTHS = (0.01, 5.0), (-1.5, 2.5), (0.9, 1.1)
        search.starts_of.__defaults__ = (search.SEED + drawing,)
        found += search.search_from_spread(runner, max_gaits=10**6).gaits
    search.SPEEDS, search.ANGLES, search.LENGTHS = box
    apart = []
    for gait in found:
        forward = gait.stride["length"] > 0.0
        if forward and all(np.max(np.abs(gait.apex - o.apex) / runner.scales) > 1e-6 for o in apart):
            apart.append(gait)
    gaits = [{"apex": g.apex.tolist(), "word": g.word, "lambda_max": g.lambda_max} for g in apart]
    print(*((gait["word"], round(gait["lambda_max"], 3)) for gait in gaits), file=sys.stderr)
    return {"runner": values, "gaits": gaits}


if __name__ == "__main__":
    with Pool(int(sys.argv[1])) as pool:
        stored = pool.map(gaits_of, drawn(), chunksize=1)
    STORED.write_text(json.dumps(stored, indent=1) + "\n")
