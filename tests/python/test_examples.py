"""The examples do what they say."""

import numpy as np
import pytest
import tdmf_slip
from conftest import ROOT, release
from own_pages import loaded
from tdmf_slip.fitting.measurements import measurements_of
from tdmf_slip.fmu.simulation import run_unit


def test_the_runner_crosses_the_ice_and_recovers(load_example):
    """The foot never sticks on ice, and the runner slows; afterwards it returns to its gait."""
    example = load_example("ice_patch")
    strides = example.cross(strides=40)
    assert len(strides) == 40
    on_ice = [
        word for position, word, _ in strides if example.friction_at(position) == example.FRICTION_ON_ICE
    ]
    assert on_ice and all("0" not in word for word in on_ice)
    speeds = [speed for _, _, speed in strides]
    assert min(speeds) < 1.03 < 1.0606 < speeds[-1]
    assert strides[0][1] == strides[-1][1] == "+0-0+"


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_runner_of_either_version_takes_start_values(load_example, fmi):
    given = {"ground.friction": 0.43, "leg.damping": 0.21, "status.terminate_on_fall": False}
    wanted = run_unit(given, strides=2).stride
    with load_example("runner").Runner(0.5, given, fmi) as runner:
        while runner["stride.count"] < 2:
            runner.advance()
        assert runner["stride.word"] == wanted["word"] and runner["contact.mode"] == 1
        assert runner["stride.speed"] == pytest.approx(wanted["speed"], rel=1e-6)
        assert not runner["status.terminate_on_fall"]


def test_a_controller_at_the_hip_holds_the_speed(load_example):
    """Alone, the runner settles on a slower gait on the slippery ground; the controller drives it up."""
    example = load_example("hip_controller")
    target = example.speed_before()
    alone, _ = example.run()
    held, ledger = example.run(example.SpeedHolder(target))
    assert alone[-1][1] < 0.95 * target
    assert held[-1][1] == pytest.approx(target, rel=0.01)
    # The work of the external torque is in the books of the hip.
    assert abs(ledger) < 1e-8


def test_a_batch_over_a_table(load_example, monkeypatch, capsys, tmp_path):
    example = load_example("batch")
    monkeypatch.setattr(example, "DAMPINGS", (0.2,))
    monkeypatch.setattr(example, "FRICTIONS", (0.6, 1.2))
    monkeypatch.setattr("sys.argv", ["batch.py", "--output", str(tmp_path / "runs.nc")])
    example.main()
    assert [line.split()[2] for line in capsys.readouterr().out.splitlines()[1:]] == ["+0-0+", "+0+"]
    assert (tmp_path / "runs.nc").exists()


def test_the_runner_crosses_rough_ground(load_example, tmp_path):
    example = load_example("rough_ground")
    rows = example.run()
    assert rows.attrs["stride.count"] == example.STRIDES and not rows.fallen
    loaded = rows["contact.normal"] > 0
    heights = rows["foot.y"][loaded]
    assert heights.max() > 0.9 and heights[0] == pytest.approx(0.0, abs=1e-12)
    example.draw(tmp_path / "run.png", example.ground(), rows)
    assert (tmp_path / "run.png").stat().st_size > 10_000


def test_forces_of_a_treadmill_become_a_table_that_gives_back_the_runner(
    load_example, monkeypatch, capsys, tmp_path
):
    """Forces of our own runner, in the layout that is read: step frequency, contact time and peak return."""
    example = load_example("treadmill_forces")
    values = "human_running"
    gait = tdmf_slip.find_gait(values, model="reduced")
    stride = gait.stride
    period, stance = stride["period"], stride["stance_time"]
    time = np.arange(0, 30.0, 1.0 / example.RATE)
    within = np.mod(time, period)
    force = np.where(within < stance, stride["peak_force"] * np.sin(np.pi * within / stance), 0.0)
    path = tmp_path / "RBDS001runT35forces.txt"
    rows = "".join(f"{k}\t0\t{f:.3f}\t0\n" for k, f in enumerate(force))
    path.write_text("Time\tFx\tFy\tFz\n" + rows, encoding="utf-8")
    monkeypatch.setattr("sys.argv", ["treadmill_forces.py", str(path)])
    example.main()
    table = tmp_path / "run.csv"
    table.write_text(capsys.readouterr().out, encoding="utf-8")
    (row,) = measurements_of(table).rows
    assert row["speed"].value == 3.5
    assert row["frequency"].value == pytest.approx(1.0 / period, rel=1e-3)
    assert row["stance_time"].value == pytest.approx(stance, abs=3.0 / example.RATE)
    assert row["peak_force"].value == pytest.approx(stride["peak_force"], rel=1e-3)


def written(folder, force, title="Fy", mark="", point="."):
    """A recording of forces, with an empty cell for each NaN."""
    path = folder / "RBDS001runT35forces.txt"
    cells = ["" if np.isnan(f) else f"{f:.3f}".replace(".", point) for f in force]
    text = f"Time\t{title}\n" + "".join(f"{k}\t{cell}\n" for k, cell in enumerate(cells))
    path.write_text(mark + text, encoding="utf-8")
    return path


STEPS = np.r_[np.tile(np.r_[np.zeros(50), np.full(60, 900.0)], 12), np.zeros(50)]
"""Eleven steps of 110 rows each, and a last contact."""


@pytest.mark.parametrize(
    ("gap", "left_out"),
    [
        (slice(0, 0), 0),
        (slice(400, 401), 1),  # in a stance
        (slice(435, 436), 1),  # in a flight
        (slice(379, 380), 2),  # before a foot comes down, where one step ends and another begins
        (slice(700, 850), 3),  # half a second
        (slice(100, 180), 2),  # over the end of a contact and the beginning of the next
        (slice(0, 120), 0),  # before all steps
    ],
)
def test_steps_that_touch_a_gap_are_left_out_and_counted(load_example, tmp_path, capsys, gap, left_out):
    example = load_example("treadmill_forces")
    force = STEPS.copy()
    force[gap] = np.nan
    row = [float(cell) for cell in example.row_of(written(tmp_path, force))]
    assert row[2:8:2] == pytest.approx([300.0 / 110.0, 60.0 / 300.0, 900.0], rel=1e-5)
    said = capsys.readouterr().err
    assert (f": {left_out} steps touch a gap" in said) == bool(left_out)


@pytest.mark.parametrize("layout", [{"title": "fy"}, {"title": " FY "}, {"mark": "\ufeff"}, {"point": ","}])
def test_forces_are_read_in_the_layouts_that_spreadsheets_write(load_example, tmp_path, layout):
    example = load_example("treadmill_forces")
    assert example.row_of(written(tmp_path, STEPS, **layout)) == example.row_of(written(tmp_path, STEPS))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Time\tFz\n0\t1\n", "the columns time, fz; allowed: with the force in Fy"),
        ("Time\tFy\n0\t1,650\n1\t12.5\n", "decimal commas and points"),
        ("Time\tFy\n0\tmuch\n", "'much'"),
        ("Time\tFy\n" + "0\t0.0\n" * 900, "0 steps; allowed: 3 or more"),
        ("", "cannot be read"),
        (b"Time\tFy\n0\t\xff\n", "cannot be read"),
    ],
    ids=range(6),
)
def test_what_are_no_forces_gets_one_sentence(load_example, tmp_path, text, said):
    example, path = load_example("treadmill_forces"), tmp_path / "RBDS001runT35forces.txt"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(SystemExit, match=said):
        example.row_of(path)
    with pytest.raises(SystemExit, match="cannot be read"):
        example.row_of(tmp_path / "none")
    with pytest.raises(SystemExit, match="no speed in its name"):
        example.speed_of("forces.txt")


@release
def test_the_tables_of_compliant_ground_on_the_results_page_are_what_the_example_prints(load_example):
    example = load_example("compliant_ground")
    page = (ROOT / "documentation" / "results.md").read_text(encoding="utf-8")
    for table in example.tables(*example.computed(loaded(example.PAGE))):
        assert example.in_markdown(table) in page


def test_a_bounce_of_the_force_is_no_step(load_example):
    """A dip of a few rows within a contact, and a knock within a flight."""
    example = load_example("treadmill_forces")
    step = np.r_[np.zeros(60), np.full(70, 900.0)]
    force = np.r_[np.tile(step, 6), np.zeros(60)]
    force[100:104], force[290:293] = 0.0, 200.0
    down, up = example.contacts(force)
    assert len(down) == 6 and np.all(up - down == 70)
