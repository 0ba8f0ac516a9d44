"""fmi-sim, an importer written in Rust, runs the FMI 3.0 unit; scripts/test --release builds it."""

import csv
import pathlib
import subprocess

import pytest
import tdmf_slip
from conftest import HANGS, unit_reference
from own_pages import loaded

FMI_SIM = pathlib.Path(__file__).resolve().parents[2] / "build/importers/bin/fmi-sim"
QUANTITIES = ("period", "length", "speed", "work", "cost_of_transport")
REFERENCE = unit_reference()

pytestmark = pytest.mark.skipif(
    not FMI_SIM.is_file(),
    reason=f"NOT TESTED: fmi-sim is missing ({FMI_SIM}); ./scripts/test --release builds it",
)


def rows_of(folder, fmi, interface, stop_time, *options, unit=None):
    output = folder / f"fmi{fmi}.csv"
    unit = unit or tdmf_slip.fmu_path(fmi)
    command = [FMI_SIM, "--quiet", "--model", unit, "--output-file", output, interface]
    done = subprocess.run(
        [*map(str, command), "-f", str(stop_time), *options], capture_output=True, text=True, timeout=HANGS
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    with output.open(newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.parametrize(
    "options",
    [(), ("--event-mode-used",), ("--event-mode-used", "--early-return-allowed")],
    ids=["plain", "event mode", "early return"],
)
def test_co_simulation(tmp_path, options):
    rows = rows_of(tmp_path, 3, "co-simulation", 251.0, *options)
    last = rows[-1]
    assert last["stride.count"] == "10" and last["stride.word"] == REFERENCE["word"]
    for name in QUANTITIES:
        assert float(last[f"stride.{name}"]) == pytest.approx(REFERENCE[name], rel=1e-8), name
    # Only with early return is there a row more for each event.
    assert (len(rows) > 2550) == ("--early-return-allowed" in options)


def test_a_unit_of_one_s_own_gives_what_the_engine_gives(tmp_path):
    model = loaded(tdmf_slip.new(tmp_path / "my_runner") / "page.py", unit=True)
    unit = model.unit.with_name("MyRunner_FMI3.fmu")
    last = rows_of(tmp_path, 3, "co-simulation", 251.0, unit=unit)[-1]
    end = tdmf_slip.trajectory(model, times=[251.0]).isel(time=0)
    assert int(last["stride.count"]) == end["stride.count"] >= 8
    for name in QUANTITIES:
        assert float(last[f"stride.{name}"]) == pytest.approx(float(end[f"stride.{name}"]), rel=1e-8), name
    rows = rows_of(tmp_path, 3, "model-exchange", 25.0, "--output-interval", "0.001", unit=unit)
    at = tdmf_slip.trajectory(model, times=[float(rows[-1]["time"])]).isel(time=0)
    assert float(rows[-1]["com.x"]) == pytest.approx(float(at["com.x"]), rel=5e-3)


def test_model_exchange(tmp_path):
    """It has forward Euler only: good to some thousandths, and the same rows from both versions."""
    two, three = (
        rows_of(tmp_path, fmi, "model-exchange", 25.1, "--output-interval", "0.001") for fmi in (2, 3)
    )
    assert three[-1]["stride.count"] == "1" and three[-1]["stride.word"] == REFERENCE["word"]
    for name in QUANTITIES:
        assert float(three[-1][f"stride.{name}"]) == pytest.approx(REFERENCE[name], rel=5e-3), name
    assert [row["foot.x"] for row in two] == [row["foot.x"] for row in three]
