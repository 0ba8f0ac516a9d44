"""The guide to a law of one's own: its commands and its code run as printed."""

import re
import shutil

import fmpy
import own_pages
import pytest
import tdmf_slip
from conftest import ROOT
from fmpy.validation import validate_fmu
from page_runs import compiler

GUIDE = (ROOT / "documentation" / "guides" / "own_law.md").read_text(encoding="utf-8")
CODE = re.findall(r"^```python\n(.*?)^```", GUIDE, re.MULTILINE | re.DOTALL)
COMMANDS = re.findall(r"^tdmf-slip (.*)$", GUIDE, re.MULTILINE)


def test_the_guide_s_commands_are_those_that_there_are(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert COMMANDS == ["new my_runner", "build my_runner"]
    status, out, err = command(*COMMANDS[0].split())
    assert status == 0 and not err
    names = ("README.md", "page.py", "parameters.toml", "test_my_runner.py")
    assert out.split() == [str(tmp_path.joinpath("my_runner", name).relative_to(tmp_path)) for name in names]
    assert "exists already" in command.refusal(*COMMANDS[0].split())


def test_the_guide_s_code_and_the_folder_s_test_run(tmp_path, monkeypatch):
    """All tests share one build of this page."""
    monkeypatch.chdir(tmp_path)
    folder = tdmf_slip.new("my_runner")
    shutil.copytree(own_pages.my_runner().folder, folder / "build")
    names = {}
    assert len(CODE) == 2
    for code in CODE:
        exec(code, names)
    assert names["gait"].stable and names["gait"].runner["hip.stance_kp"] == 0.01
    assert names["run"].attrs["stride.count"] == 2 and "hip.torque" in names["run"]
    assert names["run"].attrs["stride.period"] == pytest.approx(names["gait"].period, rel=1e-6)
    assert names["found"].converged and names["viable"].inner_share > 0.1
    assert names["film"].stat().st_size > 10_000
    program = folder / "test_my_runner.py"
    own = {"__file__": str(program.resolve())}
    exec(program.read_text(encoding="utf-8"), own)
    tests = [value for name, value in own.items() if name.startswith("test_")]
    assert len(tests) == 2
    for test in tests:
        test()


def test_build_makes_a_library_and_units_that_fmpy_validates_and_runs(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("CC", " ".join(compiler()))
    assert command("new", "my_ball", "--from", "scratch")[0] == 0
    made = command.json("build", "my_ball")
    folder = tmp_path / "my_ball" / "build"
    assert {path.name for path in folder.iterdir()} == {path.split("/")[-1] for path in made["files"]}
    assert len(made["files"]) == 5 and sorted(p.name for p in tmp_path.iterdir()) == ["my_ball"]
    for unit in ("MyBall.fmu", "MyBall_FMI3.fmu"):
        assert validate_fmu(str(folder / unit)) == []
        for interface in ("ModelExchange", "CoSimulation"):
            options = {"fmi_type": interface, "relative_tolerance": 1e-9, "output": ["height"]}
            rows = fmpy.simulate_fmu(str(folder / unit), stop_time=0.4, **options)
            assert rows["height"][-1] == pytest.approx(1 - 9.81 / 2 * 0.4**2, abs=1e-6)
