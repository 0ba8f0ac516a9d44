"""Convergence of a runner on compliant ground to the runner on rigid ground.

    python examples/compliant_ground.py [picture]

Builds the page examples/pages/compliant_runner.py, follows its gaits from stiff to soft ground, and compares
them with the gaits of the built-in runner. Ground of stiffness k_g has the damping c_g = 2 sqrt(k_g), with
which no foot bounces. Stiffness is relative to that of the leg. The Results page has tables and picture.
"""

import sys
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize_scalar
from tdmf_slip import build, find_gait, load_model

PAGE = Path(__file__).parent / "pages" / "compliant_runner.py"
FRICTIONS = {10.0: "#22303c", 1.2: "#4c78a8", 0.6: "#0b7a75", 0.43: "#b279a2", 0.2: "#e07b00"}
"""Frictions whose gaits on rigid ground have different words, and their colours."""
STIFFNESSES = np.geomspace(1e5, 10, 33)
OPTIMA = {20.0: "#e07b00", 100.0: "#b279a2", 1000.0: "#0b7a75", np.inf: "#22303c"}
"""Stiffnesses at which speed is compared over friction, and their colours; the last one is rigid ground."""
SWEPT = np.geomspace(10, 0.1, 41)
GOOD = 0.01
"""Relative difference up to which the rigid law counts as good; for eigenvalues the difference itself."""


def on_ground(model, stiffness, friction, clamp, guess, damping=2.0):
    """The gait on ground of a stiffness; rigid ground is infinitely stiff."""
    given = {"friction": friction, "hip.swing_clamp": clamp}
    if np.isinf(stiffness):
        return find_gait(given)
    ground = {"ground.stiffness": stiffness, "ground.dissipation": damping * np.sqrt(stiffness)}
    return find_gait(model, guess=guess, **given, **ground)


def branch(model, clamp, friction):
    """The gait on rigid ground, and the gaits from stiff to soft ground."""
    gaits = [on_ground(model, np.inf, friction, clamp, None)]
    for stiffness in STIFFNESSES:
        gaits.append(on_ground(model, stiffness, friction, clamp, gaits[-1].apex))
    return gaits


def differences(gaits):
    """Differences of speed, cost and largest eigenvalue from rigid ground, a row for each stiffness."""
    values = np.array([[g.stride["speed"], g.stride["cost_of_transport"], g.lambda_max] for g in gaits])
    return (values[1:] - values[0]) / [values[0, 0], values[0, 1], 1]


def good_from(differences):
    """The least stiffness from which on the rigid law is good, between points on straight lines."""
    size = np.log(np.abs(differences)) - np.log(GOOD)
    at = int(np.argmax(size > 0))  # the first that is not good, coming from stiff ground
    if size[at] <= 0:
        return STIFFNESSES[-1]
    share = size[at] / (size[at] - size[at - 1])
    return STIFFNESSES[at] ** (1 - share) * STIFFNESSES[at - 1] ** share


def fastest(model, stiffness, clamp):
    """Friction of the fastest gait, and its speed over that on friction 10."""
    guess = on_ground(model, np.inf, 0.5, clamp, None).apex

    def slowness(friction):
        return -on_ground(model, stiffness, friction, clamp, guess).stride["speed"]

    found = minimize_scalar(slowness, bounds=(0.44, 0.54), method="bounded", options={"xatol": 1e-5})
    sticks = on_ground(model, stiffness, 10.0, clamp, on_ground(model, np.inf, 10.0, clamp, None).apex)
    return found.x, -found.fun / sticks.stride["speed"] - 1


def computed(model):
    """Branches by clamp and friction, and fastest gaits by clamp and stiffness."""
    cases = [(clamp, friction) for clamp in (False, True) for friction in FRICTIONS]
    branches = {case: branch(model, *case) for case in cases}
    return branches, {(c, k): fastest(model, k, c) for c in (False, True) for k in OPTIMA}


def pair(values, digits):
    """A value by default and with the clamp."""
    return " / ".join(f"{value:.{digits}f}" for value in values)


def tables(branches, optima):
    """The two tables of the Results page: lists of cells."""
    rows = [["stiffness from which on ... differs by less than 1 %", *(f"friction {f:g}" for f in FRICTIONS)]]
    for i, name in enumerate(("speed", "cost of transport")):
        good = [[good_from(differences(branches[c, f])[:, i]) for c in (False, True)] for f in FRICTIONS]
        rows.append([name, *(pair(values, 0) for values in good)])
    words = [[branches[False, f][at].word for at in (0, -1)] for f in FRICTIONS]
    rows.append(["gait word on rigid ground, and on stiffness 10", *(f"`{a}`, `{b}`" for a, b in words)])
    found = [[optima[clamp, stiffness] for clamp in (False, True)] for stiffness in OPTIMA]
    names = ["rigid" if np.isinf(stiffness) else f"stiffness {stiffness:g}" for stiffness in OPTIMA]
    fastest = ["friction of the fastest gait", *(pair([one[0] for one in of], 3) for of in found)]
    gained = [
        "faster than on friction 10, per cent",
        *(pair([100 * one[1] for one in of], 1) for of in found),
    ]
    return rows, [["fastest gait", *names], fastest, gained]


def in_markdown(rows):
    """A table as text."""
    head, *others = [f"| {' | '.join(row)} |" for row in rows]
    return "\n".join([head, "|" + " --- |" * len(rows[0]), *others])


def speeds(model, stiffness):
    """Speeds over friction, from high to low."""
    gaits = [on_ground(model, np.inf, SWEPT[0], False, None)]
    for friction in SWEPT:
        gaits.append(on_ground(model, stiffness, friction, False, gaits[-1].apex))
    return [gait.stride["speed"] for gait in gaits[1:]]


def draw(path, branches, over_friction):
    """Draw differences from rigid ground against the stiffness, and speed against friction."""
    names = "speed", "cost of transport", "largest eigenvalue"
    figure, panels = plt.subplots(2, 2, figsize=(8.6, 7.2), layout="constrained")
    for (clamp, friction), gaits in branches.items():
        line = {"color": FRICTIONS[friction], "linestyle": ":" if clamp else "-"}
        label = None if clamp else f"friction {friction:g}"
        for axes, values in zip(panels.flat, np.abs(differences(gaits)).T, strict=False):
            axes.loglog(STIFFNESSES, values, **line, label=label)
    for number, (axes, name) in enumerate(zip(panels.flat, names, strict=False)):
        axes.axhline(GOOD, color="black", linestyle="--", linewidth=0.9)
        axes.set(ylim=(3e-7, 0.2), xlabel="stiffness of the ground (leg stiffnesses)")
        axes.set_title(f"({'abc'[number]}) difference from rigid ground: {name}", fontsize=10)
    panels[0, 0].legend(loc="lower left", title="dotted: with the clamp")
    for stiffness, values in over_friction.items():
        label = "rigid" if np.isinf(stiffness) else f"stiffness {stiffness:g}"
        panels[1, 1].semilogx(SWEPT, values, color=OPTIMA[stiffness], label=label)
    panels[1, 1].set_title("(d) average speed (l₀√(k/m))", fontsize=10)
    panels[1, 1].set(xlabel="friction")
    panels[1, 1].legend(loc="lower center")
    figure.savefig(path, dpi=150)


def main():
    """Build the page, print the tables and draw the picture."""
    with tempfile.TemporaryDirectory() as folder:
        model = load_model(build(PAGE, folder, unit=False))
        branches, optima = computed(model)
        print("\n\n".join(map(in_markdown, tables(branches, optima))))
        over_friction = {stiffness: speeds(model, stiffness) for stiffness in OPTIMA}
        draw(sys.argv[1] if len(sys.argv) > 1 else "compliant_ground.png", branches, over_friction)


if __name__ == "__main__":
    main()
