"""Numbers as people and programs give them: durations, masked values, decimal commas, marks of editors."""

import datetime
import io

import numpy as np
import pandas
import pytest
from tdmf_slip import InputError
from tdmf_slip.fitting.measurements import measurements_of
from tdmf_slip.fmu.inputs import read_tables
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.library.ground import read_heights
from tdmf_slip.variables.parameters import read_parameters

FRICTION = "ground.friction"
SECONDS = pandas.to_timedelta([0.0, 5.0], unit="s")


def friction_at_the_end(inputs):
    return run_unit({}, inputs=inputs, stop_time=6.0, output_interval=1.0).final[FRICTION]


@pytest.mark.parametrize(
    "times",
    [
        SECONDS,
        SECONDS.to_numpy().astype("m8[ns]"),
        np.array([0, 5000], "m8[ms]"),
        [datetime.timedelta(0), datetime.timedelta(seconds=5)],
        [np.timedelta64(0, "s"), 5.0],
    ],
    ids=range(5),
)
def test_durations_are_seconds(times):
    """Friction halves within 5 s; durations read as nanoseconds would leave it almost unchanged."""
    assert friction_at_the_end({FRICTION: (times, [0.6, 0.3])}) == 0.3


def test_durations_over_an_index_are_seconds_too():
    index = SECONDS.rename("time")
    assert friction_at_the_end(pandas.Series([0.6, 0.3], index=index, name=FRICTION)) == 0.3
    assert friction_at_the_end(pandas.DataFrame({FRICTION: [0.6, 0.3]}, index=index)) == 0.3


@pytest.mark.parametrize("second", [1.0, np.timedelta64(1000, "ms"), datetime.timedelta(seconds=1)])
def test_a_duration_is_a_stop_time_and_an_interval(second):
    run = run_unit({}, stop_time=second, output_interval=second / 2)
    assert run.table["time"][-1] == 1.0 and len(run.table["time"]) >= 3


def test_a_stance_may_last_a_duration():
    data = pandas.DataFrame(
        {"stance_time [s]": pandas.to_timedelta([250], unit="ms"), "stance_time_error [s]": [0.01]}
    )
    assert measurements_of(data).rows[0]["stance_time"].value == 0.25


# ---- texts ----


def written(folder, name, text, mark=""):
    path = folder / name
    path.write_bytes((mark + text).encode())
    return path


@pytest.mark.parametrize(
    "text", ["0,01", "0.1,0.2 0.3", "1,650 12.5", "1,2,3", "0,01\n0,02\n", "1_05", "0.1, 2_0"]
)
def test_heights_that_may_be_others_are_refused(tmp_path, text):
    with pytest.raises(InputError, match=r"line 1: .*allowed: "):
        read_heights(str(written(tmp_path, "heights.txt", text)))


@pytest.mark.parametrize(
    ("text", "heights"),
    [
        ("0, 0.1", (0.0, 0.1)),
        ("0.5,0.25,-1\n2", (0.5, 0.25, -1.0, 2.0)),
        ("1, 2, 3", (1.0, 2.0, 3.0)),
        ("1e-3 .5", (1e-3, 0.5)),
    ],
)
def test_heights_are_what_they_say(tmp_path, text, heights):
    assert read_heights(str(written(tmp_path, "heights.txt", text))) == heights


TITLES = "speed [m/s]{0}speed_error [m/s]{0}peak_force [N]{0}peak_force_error [N]\n"


@pytest.mark.parametrize("separator", [";", "\t"])
@pytest.mark.parametrize(
    "row", ["1.5|0.01|1,650|12.5", "1,5|0,01|1650.0|12", "2|0,1|1.650|12", "1,5|1e-3|.5|1"]
)
def test_a_comma_is_no_decimal_sign_beside_points(tmp_path, separator, row):
    text = TITLES.format(separator) + row.replace("|", separator)
    with pytest.raises(InputError, match=r"line 2: .* in a table that has "):
        measurements_of(written(tmp_path, "data.csv", text))


def test_what_has_no_number_was_not_measured(tmp_path):
    """Tables on file and in memory agree."""
    columns = {"speed [m/s]": [1.0, 1.1], "speed_error [m/s]": 0.01}
    for nothing in (np.nan, None):
        table = pandas.DataFrame(
            columns | {"peak_force [N]": [nothing, 2.0], "peak_force_error [N]": [nothing, 0.1]}
        )
        for text in ("", "nan", "NaN", "NA"):
            path = tmp_path / "data.csv"
            table.to_csv(path, index=False, na_rep=text)
            rows = measurements_of(path).rows
            assert [list(row) for row in rows] == [["speed"], ["speed", "peak_force"]]
            assert rows == measurements_of(table).rows == measurements_of(table.convert_dtypes()).rows


MARK = "\ufeff"


def test_a_byte_order_mark_is_no_part_of_a_text(tmp_path, fmu, command, monkeypatch):
    toml = written(tmp_path, "runner.toml", "[ground]\nfriction = 0.5\n", MARK)
    json = written(tmp_path, "runner.json", '{"ground.friction": 0.5}', MARK)
    assert read_parameters(toml) == read_parameters(json) == {FRICTION: 0.5}
    assert read_heights(str(written(tmp_path, "heights.txt", "0.5 1", MARK))) == (0.5, 1.0)
    table = written(tmp_path, "inputs.csv", f"time,{FRICTION}\n0,1\n", MARK)
    assert list(read_tables(table, fmu)) == [FRICTION]
    data = written(tmp_path, "data.csv", "speed [m/s],speed_error [m/s]\n1,0.1\n", MARK)
    assert measurements_of(data).rows[0]["speed"].value == 1.0
    printed = command("gait", "--json")[1]
    gait = written(tmp_path, "gait.json", printed, MARK)
    told = command("simulate", "--from-gait", gait, "--strides", "1", "--json")
    assert told[0] == 0
    monkeypatch.setattr("sys.stdin", io.StringIO(gait.read_text(encoding="utf-8")))
    assert command("simulate", "--from-gait", "-", "--strides", "1", "--json") == told
