"""The examples do what they say."""

import importlib
import pathlib

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


@pytest.fixture
def load(monkeypatch):
    monkeypatch.syspath_prepend(EXAMPLES)
    return importlib.import_module


def test_the_runner_crosses_the_ice_and_recovers(load):
    """On ice the foot never sticks and the runner slows; afterwards it returns to its gait."""
    example = load("ice_patch")
    strides = example.cross(strides=40)
    assert len(strides) == 40
    on_ice = [word for place, word, _ in strides if example.friction_at(place) == example.FRICTION_ON_ICE]
    assert on_ice and all("0" not in word for word in on_ice)
    speeds = [speed for _, _, speed in strides]
    assert min(speeds) < 1.03 < 1.0615 < speeds[-1]
    assert strides[0][1] == strides[-1][1] == "+0-0+"


def test_a_controller_at_the_hip_holds_the_speed(load):
    """Alone, the runner settles on a slower gait on the slippery ground; the controller drives it up."""
    example = load("hip_controller")
    target = example.speed_before()
    alone, _ = example.run()
    held, ledger = example.run(example.SpeedHolder(target))
    assert alone[-1][1] < 0.95 * target
    assert held[-1][1] == pytest.approx(target, rel=0.01)
    # The work of the external torque is in the books of the hip.
    assert abs(ledger) < 1e-8


def test_a_batch_over_a_table(load, monkeypatch, capsys, tmp_path):
    example = load("batch")
    monkeypatch.setattr(example, "DAMPINGS", (0.2,))
    monkeypatch.setattr(example, "FRICTIONS", (0.6, 1.2))
    monkeypatch.setattr("sys.argv", ["batch.py", "--output", str(tmp_path / "runs.nc")])
    example.main()
    assert [line.split()[2] for line in capsys.readouterr().out.splitlines()[1:]] == ["+0-0+", "+0+"]
    assert (tmp_path / "runs.nc").exists()


def test_the_runner_crosses_rough_ground(load, tmp_path):
    example = load("rough_ground")
    rows = example.run()
    assert rows["stride.count"][-1] == example.STRIDES and not rows["status.fallen"][-1]
    loaded = rows["contact.normal"] > 0
    heights = rows["foot.y"][loaded]
    assert heights.max() > 0.9 and heights[0] == pytest.approx(0.0, abs=1e-12)
    example.draw(tmp_path / "run.png", example.ground(), rows)
    assert (tmp_path / "run.png").stat().st_size > 10_000
