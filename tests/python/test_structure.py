"""Dependencies declared in the model structure, and directional derivatives, against perturbations."""

import math
import random

import numpy as np
import pytest

INPUTS = (
    "ground.friction",
    "hip.external_torque",
    "ground.height",
    "ground.slope",
    "leg.extension",
    "body.external_fx",
    "body.external_fy",
    "control.touchdown_angle",
    "control.stance_torque",
    "control.thrust",
)
ALL_MODES = {1, 2, 3, 4, 5}


def random_start(draw):
    """A posture near the ground; on it, in contact or grazing, three times out of four."""
    on_ground = draw.random() < 0.75
    x, height, slope = draw.uniform(-1, 1), draw.uniform(-0.5, 0.5), draw.uniform(-0.2, 0.2)
    speed = draw.choice([0.0, draw.uniform(-1, 1)])
    return {
        "foot.x": x,
        "foot.y": height + x * math.tan(slope) + (0.0 if on_ground else draw.uniform(0.1, 1)),
        "leg.length": draw.uniform(0.7, 1.2),
        "leg.angle": draw.uniform(-0.9, 0.9),
        "foot.vx": speed,
        "foot.vy": speed * math.tan(slope) if on_ground else draw.uniform(-1, 1),
        "leg.length_rate": draw.uniform(-1, 1),
        "leg.angle_rate": draw.uniform(-1, 1),
        "ground.friction": draw.uniform(0.1, 1),
        "ground.height": height,
        "ground.slope": slope,
        "leg.extension": draw.uniform(-0.02, 0.02),
        "leg.thrust": draw.uniform(0.01, 0.05),
        "body.external_fx": draw.uniform(-0.01, 0.01),
        "body.external_fy": draw.uniform(-0.01, 0.01),
        "hip.external_torque": draw.uniform(-0.1, 0.1),
        "hip.retraction_rate": draw.uniform(-0.5, 0.5),
        "ground.static_friction_ratio": draw.uniform(1, 1.5),
    }


@pytest.fixture(scope="module")
def declared(description):
    """Unknown -> the knowns that it may depend on; those without a declaration are left out."""
    unknowns = [*description.outputs, *description.derivatives]
    return {
        unknown.variable.name: {known.name for known in unknown.dependencies}
        for unknown in unknowns
        if unknown.variable.variability == "continuous"
    }


def moved(unknowns, before, after):
    return {name for name, a, b in zip(unknowns, before, after, strict=True) if a != b}


def changed_by_input(instance, unknowns, known):
    """Names of the unknowns that move when an input does, in event mode."""
    before = instance.real(*unknowns)
    value = instance.real(known)[0]
    instance.set_values({known: value + 1e-3})
    after = instance.real(*unknowns)
    instance.set_values({known: value})
    return moved(unknowns, before, after)


def changed_by_state(instance, unknowns, known):
    """Names of the unknowns that move when a state does, in continuous-time mode."""
    before = instance.real(*unknowns)
    states = instance.continuous_states()
    instance.set_continuous_states(states + 1e-3 * (np.array(instance.states) == known))
    after = instance.real(*unknowns)
    instance.set_continuous_states(states)
    return moved(unknowns, before, after)


def test_declared_dependencies_are_those_observed(new_instance, declared):
    draw = random.Random(2016)
    unknowns = sorted(declared)
    observed = {name: set() for name in unknowns}
    modes = set()
    for _ in range(200):
        instance = new_instance()
        instance.set_values(random_start(draw))
        instance.start()
        modes.add(instance.integer("contact.mode"))
        for known in INPUTS:
            for name in changed_by_input(instance, unknowns, known):
                observed[name].add(known)
        instance.model.enterContinuousTimeMode()
        for known in instance.states:
            for name in changed_by_state(instance, unknowns, known):
                observed[name].add(known)
    assert modes == ALL_MODES
    assert observed == declared


def difference(instance, unknowns, known):
    """Central differences of the unknowns by an input, in event mode, or by a state, in continuous time."""
    step, sides = 1e-5, []
    if known in INPUTS:
        value = instance.real(known)[0]
        for sign in (-1, 1):
            instance.set_values({known: value + sign * step})
            sides.append(instance.real(*unknowns))
        instance.set_values({known: value})
    else:
        states = instance.continuous_states()
        for sign in (-1, 1):
            instance.set_continuous_states(states + sign * step * (np.array(instance.states) == known))
            sides.append(instance.real(*unknowns))
        instance.set_continuous_states(states)
    return (np.array(sides[1]) - np.array(sides[0])) / (2 * step)


def derivative(instance, unknowns, known):
    references = [instance.references[name] for name in unknowns]
    return np.array(instance.model.getDirectionalDerivative(references, [instance.references[known]], [1.0]))


def test_directional_derivatives_in_a_run_are_differences(new_instance, declared):
    """Of every continuous output and state derivative, by every input and every state."""
    draw = random.Random(14)
    unknowns = sorted(set(declared) - {"der(hip.positive_work)"})  # has a kink where the power is zero
    compared, modes = 0, set()
    for _ in range(60):
        start = random_start(draw)
        instance = new_instance()
        instance.set_values(start)
        instance.start()
        if abs(start["leg.angle"]) < 0.2:
            continue  # in graze the torque is steep near upright
        modes.add(instance.integer("contact.mode"))
        for knowns in (INPUTS, instance.states):
            for known in knowns:
                exact = derivative(instance, unknowns, known)
                size = 1e-6 * (1.0 + np.max(np.abs(exact)))
                assert difference(instance, unknowns, known) == pytest.approx(exact, abs=size), known
                compared += 1
            if knowns is INPUTS:
                instance.model.enterContinuousTimeMode()
    assert modes == ALL_MODES and compared > 40 * 25
