"""The driver of pages: runs in many calls, guards that begin at zero, observed quantities."""

import numpy as np
import pytest
from page_runs import BEHIND, KERNEL, CompiledPage, run_batch, widths_of
from scipy.optimize import brentq

from c_core.hybrid import Model, cos, event, mode, observe, output, parameter, sin, state

# ---- runs that are stopped and go on ------------------------------------------------------------------


class Hopper(Model):
    """A mass that a decision puts a rounding error below the ground, from where it rises."""

    start = "flight", {}
    height, speed, hops = state(1), state(0), state(0)
    second, depth = parameter(1, "s"), parameter(1e-12)

    @mode()
    def flight(b):
        return {"height": b.speed / b.second, "speed": -2 / b.second}

    @event("flight", when=lambda b: b.height)
    def hop(b):
        return b.replace(height=-b.depth, speed=-b.speed, hops=b.hops + 1)


@pytest.mark.parametrize("depth", [0, 5e-13, 1e-12, 3e-12, 1e-11])
def test_an_event_that_was_just_taken_is_not_due_again_by_rounding_or_after_a_stop(depth):
    run = CompiledPage(Hopper).start(depth=depth)
    assert [run.to(stop="hop").time for _ in range(3)] == pytest.approx([1, 3, 5], abs=1e-8)
    assert run.outcome == "stopped"
    assert run.to(6.5).hops == 3
    assert run.height == pytest.approx(2 * 1.5 - 1.5**2, abs=1e-8)


class Turns(Model):
    """An angle that turns steadily; its sine crosses zero, and its cosine is kept."""

    start = "turns", {}
    angle, rate, crossings, falls = state(0.5), state(1, "1/s"), state(0), state(0)
    push = parameter(0, "1/s2")

    @mode()
    def turns(s):
        """The rate grows by the push."""
        return {"angle": s.rate, "rate": s.push}

    @event("turns", when=lambda s: sin(s.angle), crossing=lambda s: True)
    def crosses(s):
        """The sine falls through zero, however often a run is stopped."""
        return s.replace(crossings=s.crossings + 1)

    @event("turns", when=lambda s: 1 + s.falls - s.angle / np.pi)
    def passes(s):
        """The angle passes a multiple of pi, and is set a little back."""
        return s.replace(falls=s.falls + 1)


def test_a_guard_that_would_have_risen_has_not_crossed_zero():
    """An importer reverses the rate at the instant at which the sine is zero and rises."""
    run = CompiledPage(Turns).start(angle=0.0).to(0.0)
    assert run.set(rate=-1.0).to(3.0).crossings == 0
    assert run.set(rate=1.0).to(9.4).crossings == 1


class Decays(Model):
    """A leg that shortens towards its least length, and would fall below it."""

    start = "decays", {}
    excess, rate = state(1), parameter(1, "1/s")

    @mode()
    def decays(s):
        """The excess over the least length decays."""
        return {"excess": -s.rate * s.excess}

    @mode(ends=True)
    def fallen(s):
        """The run ends."""
        return {}

    @event("decays", when=lambda s: s.excess)
    def falls(s):
        """The excess is gone."""
        return s.to("fallen")


@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-4])
def test_a_guard_that_decays_towards_zero_does_not_reach_it(tolerance):
    """A rough tolerance gives its polynomial roots by error alone; a fall there would be false."""
    run = CompiledPage(Decays).start(tolerance=tolerance).to(18.0)
    assert (run.outcome, run.log) == ("arrived", [])


class TwoMasses(Model):
    """A pull on a heavy and a very light mass, which an equal drag on the light one cancels."""

    start = "pulled", {}
    speed, pull, drag = state(0, "m/s"), state(1, "N"), state(-1, "N")
    heavy, light, growth = parameter(1, "kg"), parameter(1e-17, "kg"), parameter(1, "1/s")

    @mode()
    def pulled(s):
        """Both forces grow alike."""
        rate = s.pull / s.heavy + (s.pull + s.drag) / s.light
        return {"speed": rate, "pull": s.growth * s.pull, "drag": s.growth * s.drag}


def test_a_large_constant_does_not_absorb_a_small_one_that_has_the_same_factor():
    """Collected into one factor, 1/heavy would be lost beside 1/light."""
    run = CompiledPage(TwoMasses).start().to(1.0)
    assert run.speed == pytest.approx(np.expm1(1), rel=1e-12)


@pytest.mark.parametrize("push", [0, 0.03])
def test_a_run_in_many_calls_is_the_run_in_one(push):
    """Calls end anywhere, at an event, or a rounding error before or after it. Two events coincide."""
    page, end = CompiledPage(Turns), 40.0
    whole = page.start(push=push, seeds=["angle", "push"], tolerance=1e-13).to(end)
    events = [time for time, *_ in whole.log]
    random = np.random.default_rng(3)
    near = np.outer(events, 1 + 1e-16 * np.array([-20, -2, 0, 2, 20, 1e3, -1e3, 1e5, -1e5])).ravel()
    for cuts in (random.uniform(0, end, 300), events, near):
        run = page.start(push=push, seeds=["angle", "push"], tolerance=1e-13)
        for time in sorted(cuts):
            run.to(time)
            assert run.time == time
        run.to(end)
        for name in page.events:  # two events at one instant may come in any order
            mine, theirs = ([time for time, of, *_ in r.log if of == name] for r in (run, whole))
            assert mine == pytest.approx(theirs, abs=1e-12), name
        assert run.x == pytest.approx(whole.x, abs=1e-12)
        assert run.dx == pytest.approx(whole.dx, abs=1e-9)


class Bounces(Model):
    """A ball that bounces, with what a sampled run reports."""

    start = "falls", {}
    height, speed, bounces, fastest = state(1, "m"), state(0, "m/s"), state(0), state(0, "m/s")
    gravity, restitution = parameter(10, "m/s2"), parameter(0.8)

    @mode()
    def falls(b):
        """The ball falls."""
        return {"height": b.speed, "speed": -b.gravity}

    @event("falls", when=lambda b: b.height, unit="m")
    def bounce(b):
        """The ground reverses the velocity."""
        return b.replace(speed=-b.restitution * b.speed, bounces=b.bounces + 1)

    @observe("falls", "largest", into="fastest", unit="m/s")
    def speed_downward(b):
        """Downward velocity."""
        return -b.speed

    @output("m2/s2")
    def energy(b):
        """Energy per mass."""
        return b.gravity * b.height + b.speed**2 / 2

    place = output("m", "Height", of=lambda b: b.height)
    most = output("m/s", "Largest downward velocity so far", of=lambda b: b.fastest)
    count = output("1", "Bounces", of=lambda b: b.bounces)


def test_outputs_are_sampled_along_a_run_with_their_derivatives():
    page, seeds = CompiledPage(Bounces), ["restitution", "gravity"]
    lands = np.sqrt(0.2)
    times = np.array([0, 0, 0.1, 0.2, lands - 1e-9, lands + 1e-9, 0.6, 1.0, 1.0 + 1e-12, 2.5])
    values, varied = page.start(seeds=seeds).sample(times)
    stepwise = page.start(seeds=seeds)
    for i, time in enumerate(times):
        stepwise.to(time)
        assert values[i] == pytest.approx(list(stepwise.outputs.values()), abs=1e-12), time
    assert values[2] == pytest.approx([10, 0.95, 1, 0], abs=1e-13)
    assert values[:, 3].tolist() == [0, 0, 0, 0, 0, 1, 1, 1, 1, 4]
    for i, seed in enumerate(seeds):
        base = getattr(page.start(), seed)
        ends = [page.start(**{seed: base + sign * 1e-6}).sample(times)[0] for sign in (1, -1)]
        differences = (ends[0] - ends[1]) / 2e-6
        smooth = [0, 2, 3, 6, 7, 8, 9]  # without those at the bounce
        vary = [0, 1, 2, 3]
        assert varied[smooth, i][:, vary] == pytest.approx(differences[smooth][:, vary], abs=1e-7)


def test_samples_stop_with_the_run_and_come_after_a_stop():
    run = CompiledPage(Bounces).start()
    values, _ = run.sample([0.1, 0.3, 0.5])
    again = CompiledPage(Bounces).start().to(stop="bounce")
    assert again.sample([0.5])[0][0] == pytest.approx(values[2], abs=1e-13)


# ---- memory and refusals ---------------------------------------------------------------------------------


def test_a_run_allocates_nothing_and_stays_within_its_memory():
    allocates = {f.name for folder in KERNEL for f in folder.glob("*.c") if "alloc(" in f.read_text()}
    assert allocates == {"batch.c", "batch_lanes.c", "threads.c"}
    for page, seeds in ((CompiledPage(Bounces), ["gravity"]), (CompiledPage(Hopper), [])):
        run = page.start(seeds=seeds).to(3.0)
        assert np.isnan(run.memory[-BEHIND:]).all()


@pytest.mark.parametrize("order", [-2, 0, 2, 3, 27, 29, 30, 1000])
def test_an_order_that_is_not_allowed_is_refused_where_a_run_begins(order):
    run = CompiledPage(Bounces).start()
    run.run.order = order
    assert run.to(1.0).outcome == "bad-order"
    assert run.message == f"The order of the series is {order}; it has to be even, from 4 to 28"
    assert (run.time, run.run.steps) == (0, 0)


# ---- guards that are zero where a mode begins ------------------------------------------------------------


class Lifts(Model):
    """A guard that begins at zero, and whose derivatives are zero up to one of them."""

    start = "rests", {}
    g0, g1, g2, g3, g4 = state(0), state(0), state(0), state(0), state(0)
    second, taken = parameter(1, "s"), state(0)

    @mode()
    def rests(s):
        """A chain of integrators."""
        return {f"g{k}": getattr(s, f"g{k + 1}") / s.second for k in range(4)} | {"g4": -1 / s.second}

    @mode()
    def gone(s):
        """Afterwards."""
        return {}

    @event("rests", when=lambda s: s.g0)
    def leaves(s):
        """The guard falls below zero."""
        return s.to("gone", taken=1)


@pytest.fixture(scope="module")
def lifts():
    return CompiledPage(Lifts)


@pytest.mark.parametrize("noise", [0, 1e-17, -1e-17, 1e-16, -1e-16])
@pytest.mark.parametrize("order", range(1, 5))
def test_the_first_derivative_that_is_not_zero_decides(lifts, order, noise):
    """g = c t^n/n! - t^5/5!: with c < 0 the event is due at once, with c > 0 at (120 c/n!)^(1/(5 - n))."""
    falls = lifts.start(**{"g0": noise, f"g{order}": -1e-3}).to(9.0)
    assert [time for time, *_ in falls.log] == [0.0]
    factorial = np.prod(np.arange(1, order + 1))
    for slope in (1e-3, 1e-7, 1e-10):
        rises = lifts.start(**{"g0": noise, f"g{order}": slope}).to(9.0)
        due = (120 * slope / factorial) ** (1 / (5 - order))
        assert [time for time, *_ in rises.log] == pytest.approx([due], rel=1e-9)


class Slides(Model):
    """A block is dropped and slides from the impact on until friction has stopped it."""

    start = "falls", {}
    height, speed, sliding = state(1, "m"), state(0, "m/s"), state(0, "s")
    after, descent, friction = parameter(0, "m/s"), parameter(1, "m/s"), parameter(2, "m/s2")

    @mode()
    def falls(s):
        """The body falls at a steady speed."""
        return {"height": -s.descent}

    @mode()
    def slides(s):
        """Friction slows it down."""
        return {"speed": -s.friction, "sliding": 1}

    @mode()
    def lies(s):
        """The body is at rest."""
        return {}

    @event("falls", when=lambda s: s.height, unit="m")
    def lands(s):
        """The impact leaves a speed, which may be 0."""
        return s.to("slides", speed=s.after)

    @event("slides", when=lambda s: s.speed, unit="m/s")
    def stops(s):
        """The body's speed has fallen to 0."""
        return s.to("lies", speed=0)


@pytest.mark.parametrize("width", [1, 2, 4, 8])
def test_an_event_in_zero_time_has_a_time_that_varies_where_its_guard_falls_from_zero(width):
    """The block slides for after/friction, of which nothing is left at 0 but the derivative."""
    page = CompiledPage(Slides, in_lanes=True)
    if width not in widths_of(page):
        pytest.skip("this machine has no such lanes")
    runs = [page.start(seeds=["after", "height"], after=after) for after in (0.0, 1e-6, 0.3, 0.0)]
    run_batch(runs, 3.0, width=width)
    for run in runs:
        assert run.mode == "lies" and run.sliding == pytest.approx(run.after / 2, abs=1e-14)
        assert run.d("sliding") == pytest.approx([0.5, 0.0], abs=1e-12)


# ---- observed quantities ---------------------------------------------------------------------------------


class Wave(Model):
    """Sines of an angle that turns steadily: states of few terms, with a sine in what is observed."""

    start = "turns", {}
    angle, phase, count = state(0.3), state(0), state(0)
    rate = parameter(1, "1/s")
    most, positive, twice = state(-9), state(0), state(0)

    @mode()
    def turns(s):
        """The angle turns steadily."""
        return {"angle": s.rate, "phase": 0 * s.rate}

    @event("turns", when=lambda s: 1.5 - s.count + 0.2 * cos(s.angle) - s.angle / 7, crossing=lambda s: True)
    def passes(s):
        """A guard with a cosine."""
        return s.replace(count=s.count + 0.25)

    @observe("turns", "largest", into="most")
    def wave(s):
        """A sine, and its third harmonic."""
        return sin(s.angle) + 0.3 * sin(3 * s.angle)

    @observe("turns", "positive integral", into="positive", unit="1/s")
    def half_wave(s):
        """A sine."""
        return s.rate * sin(s.angle)

    @observe("turns", "positive integral", into="twice", unit="1/s")
    def touching(s):
        """A sine that touches zero from below."""
        return s.rate * (sin(s.angle) - 1)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-12])
def test_observed_quantities_of_a_steady_turn_are_those_of_closed_forms(tolerance):
    """No state of a steady turn limits a step."""
    page = CompiledPage(Wave)
    turn = np.arccos(np.sqrt(1.7 / 3.6))  # cos a + 0.9 cos 3a = 0 there and where cos a = 0
    critical = np.add.outer([turn, -turn, np.pi - turn, np.pi + turn, np.pi / 2, -np.pi / 2],
                            2 * np.pi * np.arange(15)).ravel()  # fmt: skip
    for end in (0.7, 2.0, 11.0, 80.0):
        run = page.start(tolerance=tolerance).to(end)
        seen = np.array([*critical[(critical > 0.3) & (critical < 0.3 + end)], 0.3, 0.3 + end])
        assert run.most == pytest.approx(np.max(np.sin(seen) + 0.3 * np.sin(3 * seen)), abs=30 * tolerance)
        turns, left = divmod(0.3 + end, 2 * np.pi)
        positive = 2 * turns + (1 - np.cos(min(left, np.pi))) - (1 - np.cos(0.3))
        assert run.positive == pytest.approx(positive, abs=30 * tolerance * (1 + end))
        assert run.twice == pytest.approx(0, abs=30 * tolerance * (1 + end))


# ---- steady turns ----------------------------------------------------------------------------------------


class SpinningLeg(Model):
    """A mass that falls while its leg turns steadily: its states are polynomials, its guards are not."""

    start = "fall", {}
    turn, gravity = parameter(1, "rad/s"), parameter(0.009, "m/s2")
    length, height, speed = parameter(1, "m"), state(1, "m"), state(0, "m/s")
    angle, first = state(1.15, "rad"), state(0)

    @mode()
    def fall(s):
        return {"height": s.speed, "speed": -s.gravity, "angle": -s.turn}

    @mode(ends=True)
    def done(s):
        return {}

    @event("fall", when=lambda s: s.height + 0.15 * s.length * cos(s.angle), unit="m")
    def body_lands(s):
        return s.to("done", first=1)

    @event("fall", when=lambda s: s.height - 0.85 * s.length * cos(s.angle), unit="m")
    def foot_lands(s):
        return s.to("done", first=2)


@pytest.mark.parametrize("turn", [0.0004, 0.01, 1.0, 30.0])
@pytest.mark.parametrize("until", [1e2, 1e6, 1e30])
def test_a_leg_that_spins_steadily_meets_its_first_event_however_far_a_run_goes(turn, until):
    def above(time):
        return 1 - 0.0045 * time**2 - 0.85 * np.cos(1.15 - turn * time)

    times = np.linspace(0, 15, 200001)
    at = np.argmax(above(times) < 0)
    run = CompiledPage(SpinningLeg).start(turn=turn, tolerance=1e-13).to(until)
    assert (run.outcome, run.first) == ("ended", 2)
    assert run.time == pytest.approx(brentq(above, *times[at - 1 : at + 1], xtol=1e-14), abs=1e-11)
    assert run.run.steps < 200
