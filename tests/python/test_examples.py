"""The examples do what they say."""

import importlib.util
import pathlib

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


def load(name):
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_runner_crosses_the_ice_and_recovers():
    """On ice the foot never sticks and the runner slows; afterwards it returns to its gait."""
    example = load("ice_patch")
    strides = example.cross(strides=40)
    assert len(strides) == 40
    on_ice = [word for place, word, _ in strides if example.friction_at(place) == example.FRICTION_ON_ICE]
    assert on_ice and all("0" not in word for word in on_ice)
    speeds = [speed for _, _, speed in strides]
    assert min(speeds) < 1.03 < 1.0615 < speeds[-1]
    assert strides[0][1] == strides[-1][1] == "+0-0+"
