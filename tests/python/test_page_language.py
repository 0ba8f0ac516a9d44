"""The language of pages: the examples of its guide, closed forms, and hard cases."""

import importlib
import re
import sys
from pathlib import Path

import numpy as np
import page_runs
import pytest
from page_runs import ROOT, CompiledPage
from scipy.integrate import solve_ivp

from c_core import hybrid
from c_core.hybrid import Model, coordinates, event, mode, output, parameter, sin, state
from c_core.hybrid.unit_files import build_units
from c_core.pages.runner import PlainRunner


@pytest.fixture(scope="module")
def guide():
    """The examples of the guide of the language."""
    return page_runs.guide()


def test_the_language_needs_the_standard_library_alone_and_knows_no_page():
    for file in (ROOT / "c_core/hybrid").glob("*.py"):
        for line in file.read_text(encoding="utf-8").splitlines():
            if found := re.match(r"(?:from|import) ([\w.]+)", line):
                assert found[1].startswith(".") or found[1].split(".")[0] in sys.stdlib_module_names, line
                assert "pages" not in found[1]


def test_a_page_is_compiled_from_the_installed_package_alone(guide):
    assert importlib.import_module("tdmf_slip.hybrid").__all__ == hybrid.__all__
    installed = Path(importlib.import_module("tdmf_slip").__file__).parent
    page = CompiledPage(guide.Ball, "-O0", (installed / "hybrid" / "kernel", installed / "kernel"))
    assert page.start().to(3.0).bounces == 6


def test_every_word_of_the_language_is_in_an_example():
    words = set(re.findall(r"\w+", page_runs.code_of_guide()))
    assert set(hybrid.__all__) - words == {"PageError"}


def test_the_ball_of_the_guide_falls_down_its_own_stair_and_a_given_one(guide):
    page = CompiledPage(guide.Stair)
    own = page.start(seeds=["gravity"], tolerance=1e-13)
    own.to(stop="lands")
    fallen = np.sqrt(2 * 0.2 / 9.81)
    assert (own.time, own.page().x) == pytest.approx((0.3 + fallen, 0.3 + fallen), abs=1e-12)
    assert own.d("x")[0] == pytest.approx(-fallen / 2 / 9.81, abs=1e-12)
    stair, varied = [[0, 0], [-0.1, 0], [-1, 2]], np.array([[0, 0], [1, 0], [1, 1]], dtype=float)
    given = page.start(seeds=["gravity"], tables={"steps": stair}, tolerance=1e-13)
    given.vary_table(0, varied)  # a stair that is higher from the second step on
    given.dp[0] = 0
    given.to(0.3 + np.sqrt(0.2 / 9.81) + 1e-3)
    assert (given.vx, given.y, given.step) == (0, pytest.approx(-0.1, abs=1e-14), 1)
    assert given.d("y")[0] == 1
    assert page.start(vx=3.0, tables={"steps": stair}).to(stop="lands").vx == 2


def test_the_damped_ball_of_the_guide_falls_as_scipy_integrates(guide):
    page = CompiledPage(guide.DampedBall)
    assert "restitution" not in page.parameters
    run = page.start(tolerance=1e-13).to(0.4)

    def rates(_, y):
        return [y[1], -9.81 - 0.1 * y[1] * (np.log1p(y[1] ** 2) + np.log(2))]

    found = solve_ivp(rates, (0, 0.4), [1, 0], "DOP853", rtol=1e-13, atol=1e-13).y[:, -1]
    assert [run.height, run.speed] == pytest.approx(found, abs=1e-11)


def test_the_block_of_the_guide_sticks_and_slips(guide):
    """The block slips when the spring reaches the grip, then moves as SciPy integrates fading friction."""
    run = CompiledPage(guide.Block).start(tolerance=1e-13).to(30.0)

    def rates(_, y):
        return [y[1], -y[0] + np.exp((y[1] - 0.1) / 0.5)]

    def passes_middle(_, y):
        return y[0]

    def comes_to_rest(_, y):
        return y[1] - 0.1

    comes_to_rest.direction, comes_to_rest.terminal = 1, True
    events, given = [passes_middle, comes_to_rest], {"method": "DOP853", "rtol": 1e-13, "atol": 1e-13}
    found = solve_ivp(rates, (10, 30), [1, 0.1 - 1e-12], events=events, **given)
    assert [name for _, name, *_ in run.log] == ["slips_back", "passes_middle", "comes_to_rest"]
    times = [10.0, found.t_events[0][0], found.t_events[1][-1]]
    assert [time for time, *_ in run.log] == pytest.approx(times, abs=1e-9)
    before = run.work
    run.set(pull=0.5)
    assert run.work == pytest.approx(before + 0.5 * run.page().x, abs=1e-14)


def test_the_yoyo_of_the_guide_flies_as_a_parabola_and_keeps_its_energy_on_the_string(guide):
    run = CompiledPage(guide.Yoyo).start(turn=1.0, tolerance=1e-13)
    first = run.world()
    flown = run.to(0.5).world()
    assert flown["x"] == pytest.approx(first["x"] + 0.5 * first["vx"], abs=1e-13)
    assert flown["y"] == pytest.approx(first["y"] + 0.5 * first["vy"] - 9.81 / 8, abs=1e-13)

    def energy(world):
        return (world["vx"] ** 2 + world["vy"] ** 2) / 2 + 9.81 * world["y"]

    taut = energy(run.to(0.7).world())
    assert [name for _, name, *_ in run.log] == ["goes_slack", "goes_taut"]
    assert energy(run.to(1.5).world()) == pytest.approx(taut, abs=1e-11)
    assert run.mode == "swing"


class Awkward(Model):
    """Names that C and the generator use themselves, powers, and a thousand terms."""

    start = "x", {}
    register, double, near = state(0.5), state(-0.3), parameter(2)
    minus_k, d_k, p, INFINITY = state(0.1), parameter(1), parameter(3), state(0)
    tau, DBL_MAX = parameter(1, "s"), state(0)
    real_p, own_real_p = parameter(0), parameter(0)  # the kernel's names begin with `real_`

    @mode()
    def x(s):
        """Powers of all kinds."""
        powers = s.register**2 + s.register**-2 + s.double**3 + s.register**0.5 + s.near ** (0.1 * s.double)
        terms = sum((s.minus_k * (0.001 * i) for i in range(1000)), start=s.d_k * 0)
        return {
            "register": powers / 10 / s.tau,
            "double": 0.1 / s.tau,
            "minus_k": -(terms / 500 - s.p) / s.tau,
            "INFINITY": 1 / s.tau,
            "DBL_MAX": (s.real_p + s.own_real_p) / s.tau,
        }

    @output()
    def long(s):
        return s.register


def test_awkward_names_powers_and_a_thousand_terms_work():
    page = CompiledPage(Awkward)
    run = page.start(tolerance=1e-13).to(1.0)
    slope = sum(0.001 * i for i in range(1000)) / 500

    def rates(t, y):
        r, d, m = y
        return [(r**2 + r**-2 + d**3 + r**0.5 + 2 ** (0.1 * d)) / 10, 0.1, -(slope * m - 3)]

    found = solve_ivp(rates, (0, 1), [0.5, -0.3, 0.1], "DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    assert [run.register, run.double, run.minus_k] == pytest.approx(found, abs=1e-10)
    assert max(len(line) for text in page.files.values() for line in text.split("\n")) <= 110


TAKEN = """
from c_core.hybrid import *

class {page}(Model):
    start = "falls", {{}}
    height, speed, gravity = state(1, "m"), state(0, "m/s"), parameter(2, "m/s2")

    @mode("register")
    def falls(b):
        return dict(height=b.speed, speed=-b.gravity)

    @mode("lands", ends=True)
    def double(b):
        return {{}}

    @event("falls", when=lambda b: b.height, unit="m")
    def main(b):
        return b.to("double", lands={lands!r})
"""


@pytest.mark.parametrize(
    ("page", "lands"),
    [("Driver", "a b"), ("Math", "*/"), ("UnitPage", 0.5), ("Unit", -1), ("FixedPoint", "+")],
)
def test_pages_may_be_called_as_c_files_are_and_words_may_have_any_characters(tmp_path, page, lands):
    """Header files of the standard and of the driver, and of the units."""
    names = {"__name__": "<locals>"}
    exec(TAKEN.format(page=page, lands=lands).replace('"falls", {}', '"falls", {"register": "int"}'), names)
    names[page].__qualname__ = f"<locals>.{page}"
    assert CompiledPage(names[page]).start(tolerance=1e-13).to(2.0).time == pytest.approx(1)
    assert len(build_units(names[page], tmp_path, compiler=page_runs.compiler(), flags=["-O0"])) == 2


def counter(level, guard):
    """A page that counts how often a guard falls through 0."""

    class Counter(Model):
        start = "runs", {}
        angle, count = state(0), state(0)
        rate = parameter(1, "1/s")

        @mode()
        def runs(s):
            return {"angle": s.rate}

        @event("runs", when=lambda s: guard(s, level), crossing=lambda s: True)
        def falls(s):
            return s.replace(count=s.count + 1)

    return CompiledPage(Counter).start().to(6 * np.pi)


@pytest.mark.parametrize(("level", "events"), [(1.000001, 0), (0.999999, 3)])
def test_a_guard_that_touches_zero_is_distinguished_from_one_that_crosses(level, events):
    assert counter(level, lambda s, level: level + sin(s.angle)).count == events


def test_three_roots_in_one_step_are_three_events():
    run = counter(
        0,
        lambda s, level: (
            (s.angle - 1) * (s.angle - 1.1) * (1.2 - s.angle) * (s.angle - 1.3) * (s.angle - 1.4)
        ),
    )
    assert [time for time, *_ in run.log] == pytest.approx([1.0, 1.2, 1.4], abs=1e-11)


class Stiff(Model):
    """A decay so fast that the higher coefficients of its series overflow."""

    start = "decays", {}
    x = state(1)
    rate = parameter(1e25, "1/s")

    @mode()
    def decays(b):
        return {"x": -b.rate * b.x}


def test_a_series_whose_coefficients_overflow_has_fewer_terms():
    assert CompiledPage(Stiff).start().to(1e-24).x == pytest.approx(np.exp(-10), rel=1e-9)


def test_laws_run_on_numbers_arrays_and_symbols_alike():
    lengths = np.linspace(0.8, 1.2, 5)
    many = PlainRunner.at("flight", length=lengths, angle=np.full(5, 0.3)).spring()
    one = [PlainRunner.at("flight", length=float(x), angle=0.3).spring() for x in lengths]
    assert many == pytest.approx(one, abs=0)


def test_a_guard_without_a_bound_shares_terms_with_one_that_has_a_bound():
    class Pair(Model):
        start = "go", {}
        x, y, far, turn = state(1), state(2), state(0), parameter(1, "1/s")

        @mode()
        def go(s):
            return {"x": s.turn * s.y, "y": -s.turn * s.x}

        @event("go", when=lambda s: s.x * s.y / (6 + s.x * s.y) + 0.5, crossing=lambda s: True)
        def divided(s):
            return s.replace(far=s.far + 1)

        @event("go", when=lambda s: s.x * s.y + 2.4, crossing=lambda s: True)
        def near(s):
            return s.replace(far=s.far + 100)

    run = CompiledPage(Pair).start(tolerance=1e-12).to(np.pi)  # x y = 2.5 sin(2 t + a) takes 2.4 twice
    amplitude, phase = 2.5, np.arcsin(0.8)
    first = [time for time, name, *_ in run.log if name == "near"]
    assert first == pytest.approx([(np.pi + np.arcsin(2.4 / amplitude) - phase) / 2], abs=1e-11)
    divided = [time for time, name, *_ in run.log if name == "divided"]
    assert divided == pytest.approx([(np.pi + np.arcsin(2 / amplitude) - phase) / 2], abs=1e-11)


class FixedCoordinate(Model):
    """A page whose subclass fixes one of its coordinates."""

    start = "turns", {}
    angle = state(0.5, "rad", of="polar")
    x, y = state(0, of="world"), state(0, of="world")

    @coordinates("world")
    def in_world(m):
        return {"x": sin(m.angle), "y": 5 * sin(m.angle)}

    @mode(of="polar")
    def turns(m):
        return {}

    @mode(of="world")
    def flies(m):
        return {}


def test_a_coordinate_that_a_subclass_fixes_stays_fixed():
    class Level(FixedCoordinate):
        y = 3

    assert FixedCoordinate.at("turns").to("flies").y == pytest.approx(5 * np.sin(0.5))
    assert Level.at("turns").to("flies").y == 3
