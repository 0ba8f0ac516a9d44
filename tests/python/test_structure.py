"""Dependencies declared in the model structure, against those that perturbations show in every mode."""

import random

import numpy as np
import pytest

INPUTS = ("ground.friction", "hip.external_torque")
ALL_MODES = {1, 2, 3, 4, 5}


def random_start(draw):
    """A posture near the ground; on it, in contact or grazing, three times out of four."""
    on_ground = draw.random() < 0.75
    return {
        "foot.x": draw.uniform(-1, 1),
        "foot.y": 0.0 if on_ground else draw.uniform(0.1, 1),
        "leg.length": draw.uniform(0.7, 1.2),
        "leg.angle": draw.uniform(-0.9, 0.9),
        "foot.vx": draw.choice([0.0, draw.uniform(-1, 1)]),
        "foot.vy": 0.0 if on_ground else draw.uniform(-1, 1),
        "leg.length_rate": draw.uniform(-1, 1),
        "leg.angle_rate": draw.uniform(-1, 1),
        "ground.friction": draw.uniform(0.1, 1),
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


def changed_by(instance, unknowns, known):
    """Names of the unknowns that move when a state or an input does."""
    before = instance.real(*unknowns)
    if known in INPUTS:
        value = instance.real(known)[0]
        instance.set_values({known: value + 1e-3})
        after = instance.real(*unknowns)
        instance.set_values({known: value})
    else:
        states = instance.continuous_states()
        instance.set_continuous_states(states + 1e-3 * (np.array(instance.states) == known))
        after = instance.real(*unknowns)
        instance.set_continuous_states(states)
    return {name for name, a, b in zip(unknowns, before, after, strict=True) if a != b}


def test_declared_dependencies_are_those_observed(new_instance, declared):
    draw = random.Random(2016)
    unknowns = sorted(declared)
    observed = {name: set() for name in unknowns}
    modes = set()
    for _ in range(150):
        instance = new_instance()
        instance.set_values(random_start(draw))
        instance.start()
        instance.model.enterContinuousTimeMode()
        modes.add(instance.integer("contact.mode"))
        for known in (*instance.states, *INPUTS):
            for name in changed_by(instance, unknowns, known):
                observed[name].add(known)
    assert modes == ALL_MODES
    assert observed == declared
