"""Models of users' own: from a page to a library, and what the package's analyses say of them."""

import dataclasses
import json
import pickle
import re
import shutil
import warnings

import numpy as np
import pytest
import tdmf_slip
from conftest import ROOT
from scipy_strides import Stride, torque_of_gains
from tdmf_slip import Batch, InputError, Runner, find_gait, gait_at, load_model, stride_map
from tdmf_slip.building.build import derived, new_folder
from tdmf_slip.building.sources import page_in
from tdmf_slip.builds import TABLE
from tdmf_slip.errors import Note
from tdmf_slip.library.engine import FATES
from tdmf_slip.variables.table import BUILDS, OWN_MODELS

GAINS = {"stance_kp": 0.02, "stance_kd": 0.03}


def ball_gait(gravity, restitution, push):
    """Height, period, and derivatives of the next height by height, gravity, restitution and push."""
    speed = push / (1 - restitution)
    height = speed**2 / 2 / gravity
    by_all = [restitution, -height * (1 - restitution) / gravity, speed * speed / gravity, speed / gravity]
    return height, 2 * speed / gravity, by_all


@pytest.mark.parametrize("values", [(9.81, 0.8, 1.0), (1.62, 0.5, 2.0), (9.81, 0.0, 3.0)])
def test_the_gait_of_a_ball_is_that_of_the_closed_form(ball, values):
    given = dict(zip(("gravity", "restitution", "push"), values, strict=True))
    height, period, by_all = ball_gait(*values)
    gait = find_gait(ball, **given)
    assert gait.apex == pytest.approx([height], rel=1e-12)
    assert gait.period == pytest.approx(period, rel=1e-12)
    assert gait.impact_speed == pytest.approx(given["push"] / (1 - given["restitution"]), rel=1e-12)
    stride = Batch(gait, gait.apex).stride(along=list(given))
    assert stride.next_apex_by[0] == pytest.approx(by_all, abs=1e-11)
    assert gait.word == "lands-apex" and gait.stable


def test_strides_of_many_balls_are_those_of_the_closed_form(ball):
    heights = np.linspace(0.1, 3, 40)
    found = stride_map(ball, heights[:, None], strides=4, derivatives=["push"])
    speeds = np.sqrt(2 * 9.81 * heights)
    for stride in range(4):
        speeds = 1 + 0.8 * speeds
        assert found["next_apex"][:, stride, 0].values == pytest.approx(speeds**2 / 2 / 9.81, rel=1e-9)
    assert found["next_apex_by"][:, 3, 0, 1].values == pytest.approx(speeds / 9.81, rel=1e-9)
    assert found["fate"].values.max() == 0


def test_the_gait_under_a_law_of_one_s_own_closes_in_scipy_and_its_jacobian_is_differences(my_runner):
    gait = find_gait(my_runner, friction=0.6, **GAINS)
    again = Stride(0.6, torque=torque_of_gains(**GAINS, stance_target=0.0)).run(gait.apex)
    assert again["apex"] == pytest.approx(gait.apex, abs=1e-9)
    names = ["hip.stance_kp", "stance_kd", "friction", "hip.stance_torque"]
    exact = Batch(gait, gait.apex).stride(along=names)
    step = 1e-6 * gait.runner.scales
    for k in range(6):
        ends = gait.apex + np.outer([1, -1], np.eye(6)[k] * step)
        ahead, behind = Batch(gait, ends).stride().next_apex
        assert (ahead - behind) / 2 / step[k] == pytest.approx(gait.jacobian[:, k], abs=1e-7)
    for k, name in enumerate(names):
        changed = [gait.runner.replace({name: gait.runner[name] + way * 1e-6}) for way in (1, -1)]
        ahead, behind = Batch(changed, gait.apex).stride().next_apex
        assert (ahead - behind) / 2e-6 == pytest.approx(exact.next_apex_by[:, 6 + k], abs=1e-7)


def test_without_gains_it_is_the_built_in_runner_with_all_its_quantities(my_runner):
    none = dict.fromkeys(GAINS, 0.0)
    mine, own = find_gait(my_runner, friction=0.43, **none), find_gait(friction=0.43)
    assert mine.apex == pytest.approx(own.apex, abs=1e-10) and mine.word == own.word
    shared = set(mine.stride) & set(own.stride)
    assert len(shared) >= 18
    for name in shared:
        assert mine.stride[name] == pytest.approx(own.stride[name], abs=1e-9), name
    assert np.sort(np.abs(mine.eigenvalues)) == pytest.approx(np.sort(np.abs(own.eigenvalues)), abs=1e-7)


def test_a_runner_that_stands_still_comes_to_no_apex_soon(my_runner):
    """A run used to last until its numbers ended, which took as long as ten thousand strides."""
    draw = np.random.default_rng(0).uniform
    starts = np.tile(find_gait(my_runner).apex, (150, 1))
    starts[:, 0], starts[:, 1] = draw(1, 2, 150), draw(0.6, 1.6, 150)
    vary = {"hip.touchdown_angle": draw(0.3, 1.1, 150), "hip.stance_torque": draw(0.05, 0.4, 150)}
    strides = Batch(my_runner, starts, vary=vary).stride()
    said = {strides.why_not[k] for k in np.flatnonzero(strides.outcome)}
    assert said == {"the run has not reached `apex` and is in the mode `stick` after 10000 s"}


def test_what_new_writes_works_as_it_stands(tmp_path, ball):
    """The folder gets a build of the same page that is there already."""
    folder = tdmf_slip.new(tmp_path / "my_ball", start="scratch")
    shutil.copytree(ball.folder, folder / "build")
    program = (folder / "test_my_ball.py").read_text(encoding="utf-8")
    names = {"__file__": str(folder / "test_my_ball.py")}
    exec(program, names)
    names["test_the_gait_is_that_of_the_closed_form"]()


def test_a_model_is_one_object_and_survives_pickling(ball):
    assert load_model(ball.folder) is ball
    runner = Runner(ball, push=2)
    again = pickle.loads(pickle.dumps(runner))
    assert again == runner and again.model is ball and again["push"] == 2.0


def test_a_result_finds_its_model_by_the_build_though_another_has_the_name(ball, monkeypatch):
    gaits = tdmf_slip.sweep(ball, {"push": [1.0, 2.0]}).gaits
    other = dataclasses.replace(ball, table={**ball.table, "id": "another"})
    monkeypatch.setitem(OWN_MODELS, ball.name, other)
    assert gait_at(gaits, push=2.0).runner.model is ball
    monkeypatch.setitem(OWN_MODELS, ball.name, ball)
    with pytest.warns(Note, match=f"my_ball: the result is from build gone, loaded is {ball.build}; load"):
        gait_at(gaits.assign_attrs(build="gone"), push=2.0)


def test_a_library_of_another_version_or_built_anew_is_refused(ball, tmp_path, monkeypatch):
    monkeypatch.setitem(OWN_MODELS, ball.name, ball)  # the tests' model stays the one of its name
    monkeypatch.setitem(BUILDS, ball.build, ball)
    folder = tmp_path / "build"
    shutil.copytree(ball.folder, folder)
    model = load_model(folder)
    table = json.loads((folder / "model.json").read_text(encoding="utf-8"))
    (folder / "model.json").write_text(json.dumps(table | {"id": "another"}), encoding="utf-8")
    with pytest.raises(InputError, match="was built anew while it was loaded; load it again"):
        Runner(model, push=3)
    with pytest.raises(InputError, match=r"is build .*, not another as model.json says; build it anew"):
        load_model(folder)
    (folder / "model.json").write_text(json.dumps(table | {"version": "0.0.9"}), encoding="utf-8")
    with pytest.raises(InputError, match=r"was built by tdmf-slip 0\.0\.9, this is .*; build it anew"):
        load_model(folder)
    (tmp_path / "other").mkdir()
    text = json.dumps(table | {"libraries": {"z80-cpm": "x"}})
    (tmp_path / "other" / "model.json").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match="was built for z80-cpm, this is"):
        load_model(tmp_path / "other")
    with pytest.raises(InputError, match="has no build in it; first make one: tdmf-slip build"):
        load_model(tmp_path / "other" / "nothing")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("def (", r"page.py:1: invalid syntax"),
        ("import nothing_of_the_kind", r"page.py:1: ModuleNotFoundError: .*nothing_of_the_kind"),
        ("x = 1", r"page.py: declares as models: none; allowed: one subclass of Model"),
        (
            "from tdmf_slip.hybrid import *\nclass A(Model):\n    start = 'f', {}\n    h = state(1, 'metre')",
            r"page.py:4: `h` has the unit `metre`, in which `metre` is no unit",
        ),
        (
            "from tdmf_slip.hybrid import *\nclass A(Model):\n    start = 'fall', {}\n    h = state(1, 'm')\n"
            "    @mode()\n    def fall(b):\n        return dict(h=b.speed)",
            r"page.py:7: `fall` reads `speed`, which it does not have here",
        ),
    ],
)
def test_an_error_on_a_page_is_one_message_and_nothing_is_left(tmp_path, text, message):
    (tmp_path / "page.py").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=message) as problem:
        tdmf_slip.build(tmp_path)
    assert "\n" not in str(problem.value)
    assert [path.name for path in tmp_path.iterdir()] == ["page.py"]


def test_a_build_replaces_files_and_never_writes_into_them(tmp_path):
    """A library that is written into while another process loads it ends that process by a bus error."""
    for text in ("first", "second"):
        with new_folder(tmp_path / "build") as made:
            (made / TABLE).write_text("{}", encoding="utf-8")
            (made / "model.so").write_text(text, encoding="utf-8")
        if text == "first":
            loaded_before = (tmp_path / "build" / "model.so").open(encoding="utf-8")
    with loaded_before:
        assert loaded_before.read() == "first"
    assert (tmp_path / "build" / "model.so").read_text(encoding="utf-8") == "second"
    assert [path.name for path in tmp_path.iterdir()] == ["build"]


def test_a_failing_or_missing_compiler_leaves_nothing_and_says_what_to_install(tmp_path, monkeypatch):
    folder = tdmf_slip.new(tmp_path / "my_ball", start="scratch")
    before = sorted(path.name for path in folder.iterdir())
    monkeypatch.setenv("CC", "false")
    with pytest.raises(tdmf_slip.RunError, match="the C compiler failed: false"):
        tdmf_slip.build(folder)
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(InputError, match=r"no-such-compiler: cannot be run: .*pip install 'ziglang"):
        tdmf_slip.build(folder)
    monkeypatch.delenv("CC")
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(InputError, match=r"no C compiler was found .*pip install 'ziglang"):
        tdmf_slip.build(folder)
    with pytest.raises(InputError, match="platform 'mars-linux' is not allowed; allowed: x86_64-linux"):
        tdmf_slip.build(folder, platform="mars-linux")
    assert sorted(path.name for path in folder.iterdir()) == before


@pytest.mark.parametrize(
    ("added", "said"),
    [
        ("    @mode()\n    def rest(b):\n        return {}\n", "`rest` is a mode to which no event leads"),
        ("    def rebound(b):\n        return 0\n", "nothing on the page calls `rebound`"),
        (
            "    def rebound(b):\n        return super().rebound()\n",
            "nothing on the page calls `rebound`",
        ),
    ],
)
def test_what_has_no_effect_on_a_page_is_noted(tmp_path, added, said):
    """A mode that no run reaches; a function that no other calls, as one that overrides a misspelt name."""
    page = tdmf_slip.new(tmp_path / "my_ball", start="scratch") / "page.py"
    text = page.read_text(encoding="utf-8")
    page.write_text(f"{text}\n{added}", encoding="utf-8")
    line = len(text.splitlines()) + 2
    with pytest.warns(Note, match=rf"page\.py:{line}: {re.escape(said)}"):
        derived(page_in(page))


def test_a_page_on_which_all_has_an_effect_gets_no_note():
    with warnings.catch_warnings(action="error"):
        derived(page_in(ROOT / "examples" / "pages" / "compliant_runner.py"))


@pytest.mark.parametrize("given", [[-0.1], [np.nextafter(0, -1)]])
def test_a_point_that_breaks_a_requirement_of_the_page_is_refused_with_its_words(ball, given):
    words = rf"height = {given[0]:.9g} at the start; it must be on the floor or above it"
    stride = Batch(ball, given).stride(jacobian=True)
    assert stride.outcome != 0 and re.search(words, str(stride.why_not)) and np.isnan(stride.next_apex).all()
    assert Batch(ball, given).run(3).fate == FATES.index("no_start")
    with pytest.raises(InputError, match=words):
        tdmf_slip.trajectory(ball, given, times=[0.1])
    with pytest.raises(InputError, match=words):
        tdmf_slip.trajectory(Runner(ball, height=given[0]), times=[0.1])
    with pytest.raises(InputError, match=words):
        find_gait(Runner(ball, height=given[0]))
    many = Batch(ball, [[1.0], given, [2.0]]).stride()
    assert list(many.outcome == 0) == [True, False, True]
    alone = Batch(ball, [[1.0], [2.0]]).stride()
    assert (many.next_apex[[0, 2]] == alone.next_apex).all()


def test_a_point_on_the_border_of_a_requirement_is_accepted(ball):
    assert Batch(ball, [0.0]).stride().next_apex == pytest.approx(1 / 2 / 9.81)


@pytest.mark.parametrize("name", ["My_Ball", "my-ball", "9balls", "class"])
def test_a_name_that_cannot_be_a_model_s_is_refused(tmp_path, name):
    with pytest.raises(InputError, match=f"new '{name}' is not allowed"):
        tdmf_slip.new(tmp_path / name)
    assert not any(tmp_path.iterdir())
