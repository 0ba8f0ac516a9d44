"""The whole runner's page: ground, control, actuation, falling friction and patches beside the references."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from page_runs import COMPILER, CompiledPage
from test_page_runner import SECTION, jacobian, section, word, world_of

from c_core.pages.runner import Runner

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
FOLDER = Path(__file__).parent
GAITS = json.loads((FOLDER / "further_gaits.json").read_text(encoding="utf-8"))["gaits"]
PATCHES = json.loads((FOLDER / "patch_runs.json").read_text(encoding="utf-8"))["runs"]


@pytest.fixture(scope="module")
def whole():
    return CompiledPage(Runner)


def given(page, values):
    """Values by the page's names, angles in degrees as numbers; the references have the clamp of (12)."""
    names = {page.model.public(n): n for n in [*page.states, *page.parameters]}

    def number(value):
        return math.radians(float(value.split()[0])) if isinstance(value, str) else value

    return {"swing_clamp": 1.0} | {names[name]: number(value) for name, value in values.items()}


@pytest.mark.parametrize("gait", GAITS, ids=[str(g["start_values"]) for g in GAITS])
def test_gaits_beyond_the_paper_are_those_of_the_references(whole, gait):
    values = given(whole, gait["start_values"])
    run = whole.start(tolerance=1e-13, **values, **world_of(gait["apex"]))
    energy = run.to(0.0).told["energy"]
    run.to(stop="apex")
    assert word(run) == gait["word"]
    assert section(run) == pytest.approx(gait["apex"], abs=1e-10)
    mine = {
        "period": run.period, "length": run.distance, "rise": run.rise_of_stride, "speed": run.speed,
        "hip_work": run.hip_work, "leg_work": run.leg_work_of_stride, "external_work": run.external_work,
        "damper_loss": run.damper_loss, "friction_loss": run.friction_loss, "impact_loss": run.impact_loss,
        "cost_of_transport": run.cost_of_transport, "slip_distance": run.slip_distance,
    }  # fmt: skip
    assert mine == pytest.approx({n: gait.get(n, value) for n, value in mine.items()}, abs=2e-10)
    lost = run.damper_loss + run.friction_loss + run.impact_loss
    done = run.work + run.leg_work + run.external_work
    assert run.told["energy"] - energy == pytest.approx(done - lost, abs=1e-12)
    if "jacobian" in gait:
        found = jacobian(whole, gait["apex"], tolerance=1e-13, **values)
        assert found == pytest.approx(np.array(gait["jacobian"]), abs=1e-8)


@pytest.mark.parametrize("case", PATCHES, ids=[case["name"] for case in PATCHES])
def test_runs_over_a_patch_are_those_of_the_references(whole, case):
    values, start = given(whole, case["start_values"]), world_of(case["apex"])
    com_x = -start["seen_x"]  # the foot begins at x = 0, and heights are above the ground below the centre
    start |= {"seen_x": 0.0, "seen_y": start["seen_y"] + com_x * math.tan(values.get("ground_slope", 0.0))}
    run = whole.start(tolerance=1e-13, **values, **start)
    words = [word(run.to(stop="apex")) for _ in range(len(case["words"]))]
    assert words == case["words"]
    assert section(run) == pytest.approx(
        case["end"]["apex"] if "apex" in case["end"] else case["end"], abs=1e-9
    )


def test_the_whole_page_has_few_modes(whole):
    assert len(whole.modes) <= 20
    assert len(SECTION) == 6
