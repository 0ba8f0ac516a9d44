"""The published gaits by both readings, run through FMPy's CVODE from the default start until settled.

The slowest of them; with --release all. Validation runs all, from the gaits on.
"""

import numpy as np
import pytest
from conftest import apex_start, name_of_gait, reference_gaits, runner_of_gait, some_of
from tdmf_slip import find_gait

SCALARS = ("period", "length", "speed", "work", "cost_of_transport")
APEX = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
LEFT = 1e-9
"""Of the distance from a gait, where a run has settled: the slowest, at friction 0.2, takes 218 strides."""


@pytest.mark.parametrize("reference", some_of(reference_gaits()[::-1], 1), ids=name_of_gait)
def test_the_unit_settles_on_the_published_gait(reference, run):
    """A long run, then one stride from its last apex.

    A gait shrinks a distance by its largest eigenvalue a stride, so it piles up the solver's error of one
    stride 1/(1 - 0.91) = 11 times at friction 0.2: the long run is the more exact one.
    """
    given = runner_of_gait(reference)
    strides = np.ceil(np.log(LEFT) / np.log(find_gait(given).lambda_max))
    _, instance = run((strides + 0.5) * reference["period"], given, tolerance=1e-10, output_interval=2.0)
    apex = instance.real(*(f"apex.{name}" for name in APEX))
    assert apex == pytest.approx(reference["apex"], abs=1e-5)
    counts = ("stride.count", "event.count")
    rows, instance = run(2.1 * reference["period"], apex_start(apex) | given, tolerance=1e-9, output=counts)
    assert instance.text("stride.word") == reference["word"]
    assert instance.real("hip.liftoff_angle")[0] == pytest.approx(reference["liftoff_angle"], abs=1e-6)
    for name in SCALARS:
        assert instance.real(f"stride.{name}")[0] == pytest.approx(reference[name], rel=1e-6), name
    # Every event of the reference is one that the importer was led into, at the same time after the apex.
    times, counts = np.unique(rows["time"], return_counts=True)
    for name, time in reference["events"]:
        assert np.min(np.abs(times[counts > 1] - time)) <= 1e-6 * time, name
    # The clamp's release is a kink of the torque and no event.
    listed = [name for name, _ in reference["events"] if name != "retract_clamp_release"]
    assert rows["event.count"][rows["stride.count"] == 1][0] == len(listed)
