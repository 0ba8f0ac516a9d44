"""Runners fitted to measured gaits: derivatives, confidence, what cannot be identified, and tables."""

import json
import math
import re
from pathlib import Path

import numpy as np
import pandas
import pytest
from tdmf_slip import InputError, Runner, find_gait, fit
from tdmf_slip.fitting import problem as problem_module
from tdmf_slip.fitting.measurements import Measured, Measurements, measurements_of, shipped
from tdmf_slip.fitting.problem import Prior, Problem, Request
from tdmf_slip.fitting.result import identified
from tdmf_slip.fitting.search import Across
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.quantities import quantities_of, unit_of
from tdmf_slip.variables.parameters import read_parameters

FAST_HUMAN = Path(__file__).with_name("fast_human.toml")
TABLE = "speed [m/s],speed_error [m/s],frequency [Hz],frequency_error [Hz]\n"
FAST = {
    "speed": Measured(3.4, 0.03),
    "frequency": Measured(2.82, 0.03),
    "peak_force": Measured(2068.0, 20.0),
}
EACH = ["hip.touchdown_angle", "hip.stance_torque"]


MEASURED = ("speed", "frequency", "stance_time", "duty_factor", "slip_distance", "peak_force")


def measured(gait, names=MEASURED, error=0.005):
    """Quantities of a gait as exact data; the error of a slip of zero is a thousandth of a stride."""
    quantities = quantities_of(gait, names)
    smallest = {"slip_distance": 1e-3 * gait.stride["length"]}
    return {
        name: Measured(value, error * max(abs(value), smallest.get(name, 0.0)))
        for name, value in quantities.items()
    }


def test_the_gait_is_found_from_elsewhere():
    true = find_gait({"ground.friction": 0.6, "hip.stance_torque": 0.24, "leg.stiffness": 1.1})
    free = ["hip.stance_torque", "leg.stiffness"]
    found = fit(
        {"ground.friction": 0.43}, Measurements((measured(true),), "a gait"), [*free, "ground.friction"]
    )
    assert found.chi_square < 1e-12
    assert "the word of row 1 changed on the way: +0-, +0-0+" in found.notes
    for name in free:
        assert found.parameters[name].value == pytest.approx(true.runner[name], rel=1e-7)
    assert found.words == (true.word,) and found.gaits[0].stride["speed"] == pytest.approx(
        true.stride["speed"]
    )


def test_gaits_that_are_lost_on_the_way_are_reported():
    """A precise speed that no gait over this parameter has: chi square is above 1e8."""
    found = fit(None, Measurements(({"speed": Measured(4.0, 1e-4)},), "too fast"), ["hip.touchdown_angle"])
    notes = " ".join(found.notes)
    assert "has no gait" in notes and "the data are not met" in notes and "mean nothing" in notes
    assert found.residuals[0].fitted < 2.0
    assert found.chi_square > 1e8 and not found.converged
    assert not any(estimate.is_profiled for estimate in found.estimates)


@pytest.mark.parametrize(
    ("runner", "model", "row", "free"),
    [
        ({}, "full", {"speed": Measured(0.3, 0.01)}, ["hip.stance_torque"]),
        (read_parameters(FAST_HUMAN), "reduced", FAST, ["leg.stiffness", *EACH]),
    ],
)
def test_the_search_goes_on_across_folds(runner, model, row, free):
    """The measured gaits are beyond the fold at which the branch of the first gait ends."""
    found = fit(runner, Measurements((row,), "beyond a fold"), free, model=model)
    assert found.chi_square < 1e-9 and found.converged
    assert "the search went on across a fold, where gaits turn back" in found.notes
    again = gait_near(found.runners[0], found.apexes[0])
    for name, of in row.items():
        assert quantities_of(again, [name])[name] == pytest.approx(of.value, rel=1e-6)


def test_the_search_across_folds_has_exact_derivatives():
    row = measured(find_gait({"ground.friction": 0.6}))
    prior = Prior(1.0, 0.1, "leg.stiffness")
    shared, each = ("leg.stiffness",), ("leg.damping",)
    request = Request(Measurements((row, row), "a gait"), shared, each, (prior,), False, False, (), 1)
    problem = Problem(request, find_gait({"ground.friction": 0.55}))
    across = Across(problem, np.zeros(3))
    at = across.begin + 1e-3
    exact, step = across.jacobian(at), 1e-6
    for k in range(len(at)):
        aside = step * (np.arange(len(at)) == k)
        difference = (across.residuals(at + aside) - across.residuals(at - aside)) / (2.0 * step)
        assert exact[:, k] == pytest.approx(difference, abs=1e-5 * np.max(np.abs(exact)))


def test_two_measurements_of_one_speed_are_met_in_their_middle():
    """Both data are one error off: chi square is 2, with probability erfc(1) at one degree of freedom."""
    rows = tuple({"speed": Measured(speed, 0.01)} for speed in (1.0, 1.02))
    found = fit(None, Measurements(rows, "twice"), ["hip.stance_torque"])
    assert [residual.fitted for residual in found.residuals] == pytest.approx([1.01, 1.01], abs=1e-6)
    assert found.chi_square == pytest.approx(2.0, rel=1e-6) and found.degrees_of_freedom == 1
    assert found.probability == pytest.approx(math.erfc(1.0), rel=1e-6)
    assert "chi square 2 with 1 degree of freedom, probability 0.16" in found.as_text()


def test_a_fit_ends_after_so_many_strides_and_says_so(monkeypatch):
    """Speeds in km/h under the unit m/s are an example of such data."""
    monkeypatch.setattr(problem_module, "MAX_STRIDES", 60)
    row = {"speed": Measured(3.6, 0.01), "frequency": Measured(0.04, 0.001)}
    found = fit(None, Measurements((row,), "too fast"), ["hip.stance_torque", "leg.stiffness"])
    assert not found.converged
    ended = next(note for note in found.notes if "the search was ended after" in note)
    strides = int(re.search(r"after (\d+) strides", ended)[1])
    assert 60 <= strides < 60 + 100
    assert "units that their titles say" in ended and np.isfinite(found.chi_square)


def test_rows_share_what_is_shared_and_have_their_own():
    base, torques = {"ground.friction": 0.6, "leg.stiffness": 1.05}, (0.19, 0.21, 0.23)
    true = [find_gait({**base, "hip.stance_torque": torque}) for torque in torques]
    data = Measurements(tuple(measured(gait, ("speed", "frequency")) for gait in true), "three gaits")
    found = fit(None, data, ["leg.stiffness"], vary_each=["hip.stance_torque"])
    assert list(found.parameters) == ["leg.stiffness", *(f"hip.stance_torque[{row}]" for row in (1, 2, 3))]
    assert found.parameters["leg.stiffness"].value == pytest.approx(1.05, rel=1e-7)
    for row, torque in enumerate(torques, start=1):
        assert found.parameters[f"hip.stance_torque[{row}]"].value == pytest.approx(torque, rel=1e-7)


def test_what_acts_as_a_sum_is_one_combination():
    gait = find_gait({"ground.friction": 0.6})
    found = fit(
        None,
        Measurements((measured(gait),), "a gait"),
        ["leg.stiffness", "hip.stance_torque", "control.stance_torque", "leg.min_length"],
    )
    combination, alone = sorted(found.unidentified, key=lambda of: -len(of.members))
    assert dict(alone.members) == {"leg.min_length": 1.0}
    assert "leg.min_length cannot be identified" in found.as_text()
    assert set(combination.members) == {"hip.stance_torque", "control.stance_torque"}
    changes = combination.changes
    assert changes["hip.stance_torque"] == pytest.approx(-changes["control.stance_torque"], rel=1e-6)
    assert np.isinf(found.parameters["hip.stance_torque"].high)
    assert np.isfinite(found.parameters["leg.stiffness"].high)
    assert "cannot be identified: " in found.as_text()


def test_what_acts_as_a_product_is_one_combination():
    """Times and places identify only the ratios of masses, stiffness, damping and torques."""
    scaled = ["body.mass", "foot.mass", "leg.stiffness", "leg.damping"]
    scaled += ["hip.stance_torque", "hip.kp", "hip.kd"]
    names = ("speed", "frequency", "stance_time", "slip_distance")
    true = [find_gait({"ground.friction": friction}) for friction in (0.6, 0.45, 1.3)]
    data = Measurements(tuple(measured(gait, names, 1e-4) for gait in true), "three gaits")
    found = fit(None, data, scaled, vary_each=["ground.friction"])
    (combination,) = found.unidentified
    assert dict(combination.members) == pytest.approx(dict.fromkeys(scaled, 1.0), abs=1e-5)
    for row, gait in enumerate(true, start=1):
        estimate = found.parameters[f"ground.friction[{row}]"]
        assert estimate.value == pytest.approx(gait.friction, rel=1e-6) and np.isfinite(estimate.high)


def test_a_combination_is_poorly_identified_where_its_interval_is_as_wide_as_itself():
    """The interval is 1.96 errors wide on each side; the relative error is the inverse singular value."""
    for size, count in ((1.2, 1), (1.9, 1), (2.0, 0), (2.5, 0)):
        known = identified(np.array([[size]]), ["leg.damping"], np.array([0.2]), 1.95996)
        assert [of.standard_error for of in known.unidentified] == pytest.approx([1.0 / size] * count)


def test_a_parameter_at_the_end_of_its_range_is_reported():
    gait = find_gait({"ground.friction": 0.6})
    row = {"peak_force": Measured(0.98 * gait.stride["peak_force"], 0.01), "speed": Measured(1.0, 10.0)}
    found = fit({"leg.thrust": 0.01}, Measurements((row,), "a gait"), ["leg.thrust"])
    assert "lower end of its range" in " ".join(found.notes)
    assert found.parameters["leg.thrust"].value == pytest.approx(0.0, abs=1e-6)


def written(tmp_path, text):
    path = tmp_path / "data.csv"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_table_has_comments_and_empty_cells(tmp_path):
    table = written(tmp_path, f"# from a paper, table 1\n{TABLE}1.0,0.01,,\n1.1,0.01,0.04,0.001\n")
    first, second = measurements_of(table).rows
    assert first == {"speed": Measured(1.0, 0.01)}
    assert second == {"speed": Measured(1.1, 0.01), "frequency": Measured(0.04, 0.001)}


@pytest.mark.parametrize("row", ["1.0;0.01;0.04;0.001", "1,0;,01;0,04;1,0e-3", '1,0;"0,01"; 0,04 ;0,001'])
@pytest.mark.parametrize("separator", [";", "\t"])
def test_semicolons_and_tabulators_may_be_between_cells(tmp_path, separator, row):
    """Spreadsheets write such files in countries with a decimal comma."""
    lines = f"{TABLE.replace(',', separator)}{row.replace(';', separator)}\n"
    table = written(tmp_path, f"# made\n{lines}")
    (found,) = measurements_of(table).rows
    assert found == {"speed": Measured(1.0, 0.01), "frequency": Measured(0.04, 0.001)}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "the header and the rows are missing"),
        (TABLE, "the rows are missing"),
        ("speed,speed_error [m/s]\n1,0.1\n", "has no unit; allowed: speed [m/s]"),
        ("speed [kg],speed_error [m/s]\n1,0.1\n", "'kg' is no unit of speed; allowed: speed [m/s]"),
        ("sped [m/s],speed_error [m/s]\n1,0.1\n", "near matches: speed"),
        ("speed [m/s]\n1\n", "column speed without speed_error"),
        ("speed [m/s],speed [m/s],speed_error [m/s]\n1,1,1\n", "there twice"),
        (f"{TABLE}1.0,0,0.04,0.001\n", "row 1: speed_error = 0 is not allowed"),
        (f"{TABLE}1.0,0.1,0.04,nan\n", "frequency_error = nan is not allowed"),
        (f"{TABLE}1.0,0.1,0.04,0.001\nnan,0.1,0.04,0.001\n", "row 2: speed = nan is not allowed"),
        (f"{TABLE}1.0,,0.04,0.001\n", "speed_error = nothing is not allowed"),
        (f"{TABLE},,,\n", "nothing is measured"),
        (f"{TABLE}fast,0.1,0.04,0.001\n", "speed = fast is not allowed"),
        (f"{TABLE}1.0,0.1\n", "2 cells under 4 columns"),
        ("duty_factor [1],duty_factor_error [1]\n1.2,0.1\n", "a number 0 to 1"),
        (f"{TABLE}1e300,0.1,0.04,0.001\n", "speed = 1e300 is not allowed; allowed: a number 0 to 1e+09"),
        (f"{TABLE}1.0,5e-324,0.04,0.001\n", "row 1: speed_error = 5e-324 is not allowed"),
        (f"{TABLE}1.0,0.1,0.04,0.001\n100,0.9e-10,0.04,0.001\n", "row 2: speed_error = 0.9e-10 is not"),
        (f"{TABLE}1.0,0.1,{'4' * 140000},0.001\n", "line 2, column 3: a cell of 140,000 characters"),
        (f"{'x' * 140000}\n1\n", "line 1, column 1: a cell of 140,000 characters; allowed: 100"),
        (f'{TABLE}1.0,0.1,"0.04,0.001\n', "line 2"),
    ],
)
def test_a_bad_table_gets_one_sentence(tmp_path, command, text, words):
    table = written(tmp_path, text)
    assert words in command.refusal("fit", str(table), "--vary", "leg.stiffness")


def test_no_more_is_fitted_than_is_measured(tmp_path, command):
    table = written(tmp_path, f"{TABLE}1.0,0.1,0.04,0.001\n")
    said = command.refusal("fit", str(table), "--vary", "leg.stiffness,leg.damping,hip.kp")
    assert "has 2 measured; allowed: no more" in said


def test_the_command_prints_writes_and_draws(tmp_path, command):
    gait = find_gait({"ground.friction": 0.6})
    row = measured(gait)
    header = ",".join(f"{name} [{unit_of(name)}],{name}_error [{unit_of(name)}]" for name in row)
    cells = ",".join(f"{of.value!r},{of.error!r}" for of in row.values())
    table = written(tmp_path, f"# made\n{header}\n{cells}\n")
    page, picture = tmp_path / "report.html", tmp_path / "fit.svg"
    arguments = ["fit", str(table), "--vary", "leg.stiffness", "--report", str(page), "--plot", str(picture)]
    status, out, said = command(*arguments, "--json")
    printed = json.loads(out)
    assert (status, said) == (0, "")
    estimate = printed["parameters"]["leg.stiffness"]
    assert estimate["low"] < estimate["value"] < estimate["high"]
    assert estimate["value"] == pytest.approx(Runner()["leg.stiffness"], rel=1e-8)
    assert len(printed["residuals"]) == len(MEASURED) and printed["unidentified"] == []
    text = page.read_text(encoding="utf-8")
    assert "leg.stiffness" in text and "data:image/png;base64," in text and "<script" not in text
    assert "Intervals are by the profile likelihood." in text
    assert picture.read_text(encoding="utf-8").startswith("<?xml")
    status, out, _ = command(*arguments[:4])
    assert status == 0 and "leg.stiffness" in out and "degrees of freedom" in out


def published(name, columns):
    """Numbers of the table in the comments of a file."""
    lines = shipped(name).read_text(encoding="utf-8").splitlines()
    rows = [line.lstrip("# ").split() for line in lines if line.startswith("#")]
    numbers = [
        [float(cell) for cell in row] for row in rows if len(row) == columns and all(map(is_number, row))
    ]
    return np.array(numbers)


def is_number(text):
    return text.replace(".", "", 1).isdigit()


def test_the_numbers_of_a_runner_at_eight_speeds_are_made_of_those_published():
    weight, rows = 84.0 * 9.81, measurements_of(shipped("human_running.csv")).rows
    speed, peak, impulse = published("human_running.csv", 3).T
    assert len(rows) == len(speed) == 8
    made = {"speed": speed, "frequency": 1.0 / impulse, "peak_force": peak * weight}
    for name, values in made.items():
        assert [row[name].value for row in rows] == pytest.approx(values, rel=1e-5)
    for name, scale in (("frequency", 1.0), ("peak_force", weight)):
        off = made[name] - np.polyval(np.polyfit(speed, made[name], 1), speed)
        assert rows[0][name].error == pytest.approx(np.sqrt(off @ off / 6), rel=5e-3), scale


def test_the_numbers_of_fast_runners_are_made_of_those_published():
    text = shipped("human_fast_running.csv").read_text(encoding="utf-8")
    pairs = re.findall(
        r"^# (\w[\w ]*) \([^)]*\) +([\d.]+) \(([\d.]+)\) +([\d.]+) \(([\d.]+)\)$", text, re.MULTILINE
    )
    printed = {name: np.array(numbers, float).reshape(2, 2) for name, *numbers in pairs}
    made = {
        "speed": printed["velocity"] / 3.6,
        "stance_time": printed["contact time"],
        "frequency": printed["step frequency"],
        "peak_force": printed["peak vertical force"] * 84.0 * 9.81,
    }
    for number, row in enumerate(measurements_of(shipped("human_fast_running.csv")).rows):
        for name, (mean, deviation) in ((name, of[number]) for name, of in made.items()):
            assert row[name].value == pytest.approx(mean, rel=1e-4)
            assert row[name].error == pytest.approx(deviation / np.sqrt((11, 9)[number]), rel=2e-3)


@pytest.mark.parametrize("data", [3, "missing.csv"])
def test_what_is_no_data_is_refused(data):
    with pytest.raises(InputError, match=r"data|missing\.csv"):
        fit(None, data, ["leg.stiffness"])
    with pytest.raises(InputError, match="human_running"):
        shipped("horse.csv")


UNITS, ERRORS = {"speed": "km/h", "stance_time": "ms"}, {"speed": "1 %", "stance_time": [100.0, 200.0]}
COLUMNS = {"speed": [3.6, 3.96], "stance_time": [3500.0, 3400.0]}


@pytest.mark.parametrize("kind", ["mapping", "table", "file", "titles"])
def test_units_and_errors_may_be_given_beside_the_data(kind, tmp_path):
    data = {
        "mapping": lambda: COLUMNS,
        "table": lambda: pandas.DataFrame(COLUMNS),
        "file": lambda: written(tmp_path, "speed,stance_time\n3.6,3500\n3.96,3400\n"),
        "titles": lambda: written(tmp_path, "speed [km/h],stance_time [ms]\n3.6,3500\n3.96,3400\n"),
    }[kind]()
    units = {} if kind == "titles" else UNITS
    rows = measurements_of(data, units, ERRORS).rows
    assert [row["speed"].value for row in rows] == pytest.approx([1.0, 1.1], rel=1e-12)
    assert [row["speed"].error for row in rows] == pytest.approx([0.01, 0.011], rel=1e-12)
    assert [row["stance_time"].value for row in rows] == pytest.approx([3.5, 3.4], rel=1e-12)
    assert [row["stance_time"].error for row in rows] == pytest.approx([0.1, 0.2], rel=1e-12)


@pytest.mark.parametrize(
    ("data", "units", "errors", "words"),
    [
        (COLUMNS, {"speed": "kg"}, ERRORS, "'kg' is no unit of speed"),
        (COLUMNS, {"speed": 3}, ERRORS, "no unit of speed"),
        (COLUMNS, {"sped": "m/s"}, ERRORS, "units: 'sped' is not allowed.*speed"),
        (COLUMNS, {}, {"speed": "1 %"}, "stance_time without stance_time_error.*errors="),
        (COLUMNS, {}, ERRORS | {"speed": "1 m/s"}, "errors: speed = '1 m/s' is not allowed"),
        (COLUMNS, {}, ERRORS | {"speed": [0.1]}, "errors: speed"),
        (COLUMNS, {}, ERRORS | {"frequency": 0.1}, "errors: frequency has no column"),
        (COLUMNS | {"speed_error": [1.0, 1.0]}, {}, ERRORS, "errors: speed has a column of errors"),
        ({"speed": [1.0], "stance_time": [1.0, 2.0]}, {}, ERRORS, "columns of different lengths"),
        ({}, {}, {}, "columns of different lengths, or none"),
    ],
)
def test_units_and_errors_that_do_not_fit_are_refused(data, units, errors, words):
    with pytest.raises(InputError, match=words):
        measurements_of(data, units, errors)
