"""The fit to a human runner at eight speeds, against the stored results."""

import csv
from pathlib import Path

import pytest
import tdmf_slip
from tdmf_slip.fitting.measurements import shipped
from tdmf_slip.paper import human_running, results_page
from tdmf_slip.paper.claims import CLAMP, FREE
from tdmf_slip.variables.parameters import read_parameters

DOCUMENTATION = Path(__file__).parents[2] / "documentation"
PAGE = (DOCUMENTATION / "results.md").read_text(encoding="utf-8")
STORED = results_page.read(DOCUMENTATION / "data/results", results_page.PAPERS)
OF_MASS = ("body.mass", "foot.mass", "leg.stiffness", "leg.damping", "hip.stance_torque", "hip.kp", "hip.kd")
"""Parameters that are in proportion to the mass if the motion stays the same."""


@pytest.fixture(scope="module")
def claims():
    return {claim.what: claim for claim in human_running.claims()}


def test_the_stiffness_is_in_proportion_to_the_assumed_mass(tmp_path):
    """Forces are published in body weights: 15 % less mass gives 15 % less force and 15 % less stiffness."""
    lines = [line for line in shipped("human_running.csv").read_text().splitlines() if line[0] != "#"]
    rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]
    light = [
        {name: 0.85 * value if "force" in name else value for name, value in row.items()} for row in rows
    ]
    with (tmp_path / "light.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, light[0])
        writer.writeheader()
        writer.writerows(light)
    values = read_parameters("human_running")
    found = tdmf_slip.fit(
        {**values, **{name: 0.85 * values[name] for name in OF_MASS}},
        tmp_path / "light.csv",
        ["leg.stiffness"],
        vary_each=["hip.stance_torque", "hip.touchdown_angle"],
        model="reduced",
        profile=False,
    )
    known = human_running.fitted().parameters["leg.stiffness"].value
    assert found.parameters["leg.stiffness"].value == pytest.approx(0.85 * known, rel=1e-6)


def test_an_interval_goes_on_across_the_fold_of_a_row():
    """The gaits of row 7 turn back at a damping of 329 N s/m; other fits show gaits beyond the fold."""
    free = {"vary_each": ["hip.stance_torque", "hip.touchdown_angle"], "model": "reduced"}
    varied = ["leg.stiffness", "leg.damping"]
    found = tdmf_slip.fit("human_running", "human_running", varied, profile=["leg.damping"], **free)
    runner = found.runners[0].replace({"leg.damping": 340.0})
    held = tdmf_slip.fit(runner, "human_running", ["leg.stiffness"], profile=False, **free)
    assert held.converged and held.chi_square < found.chi_square + 3.84
    assert found.parameters["leg.damping"].high > 340.0


def test_the_stored_rows_of_human_running_are_what_is_computed(claims):
    stored = {row["what"]: row for row in STORED["others"] if row["what"] in claims}
    assert stored.keys() == claims.keys()
    for what, claim in claims.items():
        assert stored[what] == claim.as_json()
    unstable = human_running.fitted().gaits
    assert all(gait.lambda_max > 1.0 for gait in unstable)
    low, high = (choose(gait.lambda_max for gait in unstable) for choose in (min, max))
    assert f"{low:.2f} to {high:.2f}" in PAGE


def test_the_jog_is_tuned_to_the_measured_speed_and_frequency_in_both_readings():
    preset = read_parameters("human")
    for reading in (FREE, CLAMP):
        gait = tdmf_slip.find_gait({**preset, **human_running.TUNED[reading]})
        assert gait.stable and gait.speed == pytest.approx(2.7, abs=0.01)
        assert 1.0 / gait.period == pytest.approx(2.62, abs=0.01)
