"""The pages in examples/pages, beside closed forms, published values and independent integrations."""

import sys

import numpy as np
import pytest
from page_runs import COMPILER, ROOT, CompiledPage

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
TIGHT = {"tolerance": 1e-13}
PAGES = ROOT / "examples" / "pages"
sys.path.append(str(PAGES))


def test_every_page_has_less_than_120_lines():
    pages = sorted(PAGES.glob("*.py"))
    assert len(pages) == 2
    for page in pages:
        assert len(page.read_text(encoding="utf-8").splitlines()) < 120, page.name


# ---- the bouncing ball ---------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def ball():
    from bouncing_ball import BouncingBall

    return CompiledPage(BouncingBall, "-O1")


@pytest.mark.parametrize(
    ("height", "restitution", "gravity"), [(1, 0.8, 9.81), (3, 0.5, 1.62), (0.2, 0.99, 9.81)]
)
def test_the_ball_bounces_by_its_closed_form_until_it_rests(ball, height, restitution, gravity):
    """Bounce n comes after sqrt(2 h/g) (1 + 2 e (1 - e^(n - 1))/(1 - e)), and leaves e^n sqrt(2 g h)."""
    slowest = 0.05 * np.sqrt(2 * gravity * height)
    given = {"height": height, "restitution": restitution, "gravity": gravity, "slowest": slowest}
    run = ball.start(**given, **TIGHT).to(1e3)
    count = int(np.ceil(np.log(0.05) / np.log(restitution)))
    n = np.arange(1, count + 1)
    falls = np.sqrt(2 * height / gravity)
    times = falls * (1 + 2 * restitution * (1 - restitution ** (n - 1)) / (1 - restitution))
    assert [time for time, *_ in run.log] == pytest.approx(times, abs=1e-11)
    assert (run.mode, run.bounces, run.height, run.speed) == ("rest", count, 0, 0)
    assert run.speed_up == pytest.approx(restitution**count * np.sqrt(2 * gravity * height), abs=1e-11)


def test_the_ball_loses_the_share_of_its_energy_that_the_restitution_says(ball):
    run = ball.start(**TIGHT)
    energies = [run.to(time).outputs["energy"] for time in (0.1, 0.9, 1.6)]
    assert energies == pytest.approx(9.81 * 0.8 ** (2 * np.arange(3)), abs=1e-11)


def test_the_return_map_of_the_ball_and_its_derivatives(ball):
    section = ball.section("after_bounce", seeds=["restitution", "gravity"], **TIGHT).after(
        [2.0], varies=True
    )
    assert section.next == pytest.approx([1.6], abs=1e-13)
    assert np.hstack([section.jacobian, section.by_seeds]) == pytest.approx(
        np.array([[0.8, 2, 0]]), abs=1e-13
    )
    assert section.crossing.time == pytest.approx(4 / 9.81, abs=1e-13)


# ---- the rimless wheel ---------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def wheel():
    from rimless_wheel import RimlessWheel

    return CompiledPage(RimlessWheel, "-O1")


WHEELS = [
    {},
    {"slope": 0.15, "half_angle": 0.4, "length": 0.7},
    {"slope": 0.03, "half_angle": 0.1, "gravity": 1.62},
]


@pytest.mark.parametrize("given", WHEELS)
def test_the_wheel_rolls_by_its_closed_form_map(wheel, given):
    rate, seeds = 1.3, ["slope", "half_angle"]
    at = wheel.section("at_landing", seeds=seeds, **given, **TIGHT)
    slope, half, length, gravity = (
        getattr(at.given, name) for name in ("slope", "half_angle", "length", "gravity")
    )

    def after(rate, slope, half):
        gained = 4 * gravity / length * np.sin(slope) * np.sin(half)
        return np.cos(2 * half) * np.sqrt(rate**2 + gained)

    at.after([rate], varies=True)
    assert at.next == pytest.approx([after(rate, slope, half)], abs=1e-12)
    shifts = 1e-20j * np.eye(3)  # complex steps are exact
    slopes = [after(*(np.array([rate, slope, half]) + shift)).imag / 1e-20 for shift in shifts]
    assert np.hstack([at.jacobian, at.by_seeds])[0] == pytest.approx(slopes, abs=1e-12)
    share = np.cos(2 * half) ** 2
    rolling = np.sqrt(share / (1 - share) * 4 * gravity / length * np.sin(slope) * np.sin(half))
    assert at.fixed_point([rate]) == pytest.approx([rolling], abs=1e-12)
    assert at.jacobian == pytest.approx(np.array([[share]]), abs=1e-12)


def test_the_wheel_keeps_its_energy_in_a_vault(wheel):
    run = wheel.start(angle=-0.1, rate=0.9, **TIGHT)
    energies = [run.to(time).outputs["energy"] for time in (0, 0.1, 0.2)]
    assert run.steps == 0
    assert energies == pytest.approx([energies[0]] * 3, abs=1e-12)


@pytest.mark.parametrize("share", [0.999999, 1.000001])
def test_a_wheel_that_is_too_slow_rocks_until_it_stands(wheel, share):
    """It comes over the top if thetadot^2 > 2 g/l (1 - cos(s - a)) where the vault begins."""
    slope, half = 0.01, np.radians(15)
    enough = np.sqrt(2 * 9.81 * (1 - np.cos(slope - half)))
    run = wheel.start(slope=slope, angle=slope - half, rate=share * enough, **TIGHT).to(60.0)
    assert (run.log[0][1], run.mode) == ("lands_uphill" if share < 1 else "lands_downhill", "stands")
    assert run.rate == 0
    rocking = [name for _, name, *_ in run.log]
    assert rocking[-6:] == rocking[-2:] * 3 and rocking[-1] != rocking[-2]
