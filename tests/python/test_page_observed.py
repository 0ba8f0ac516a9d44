"""First variations of observed quantities: the integral of a positive part, and the largest value."""

import numpy as np
import pytest
from conftest import some_of
from page_runs import CompiledPage, run_batch, widths_of
from runner_pages import drawn

from c_core.hybrid import Model, event, mode, observe, parameter, sin, state


class Pulse(Model):
    """Two quantities that are observed while an angle turns; an event is in between."""

    start = "turns", {}
    angle, rate, jump, passed = state(0.1), parameter(1, "1/s"), parameter(0, "1"), state(0)
    due, height, slope, end = parameter(1), parameter(1), parameter(0.2), parameter(5)
    most, positive, read_most, read_positive = state(0), state(0), state(0), state(0)

    @mode()
    def turns(s):
        """The angle turns."""
        return {"angle": s.rate + s.slope * s.rate * sin(s.angle)}

    @mode(ends=True)
    def over(s):
        """Afterwards."""
        return {}

    @event("turns", when=lambda s: s.due + s.passed * 99 - s.angle)
    def passes(s):
        """The observed quantities jump, and are read and reset."""
        return s.replace(passed=s.passed + 1, read_most=s.most, read_positive=s.positive, most=0, positive=0)

    @event("turns", when=lambda s: s.end - s.angle)
    def stops(s):
        """The run ends."""
        return s.to("over")

    @observe("turns", "largest", into="most")
    def wave(s):
        """A wave that jumps at the event."""
        return s.height * sin(s.angle) + s.jump * s.passed

    @observe("turns", "largest", into="most")
    def lower_wave(s):
        """Another quantity whose largest value goes into the same state."""
        return -s.height * sin(s.angle) / 2

    @observe("turns", "positive integral", into="positive", unit="1/s")
    def half_wave(s):
        """The rate of a wave that jumps at the event."""
        return s.rate * (s.height * sin(s.angle) + s.jump * s.passed)


PULSE = ("angle", "rate", "jump", "due", "height", "slope", "end")


@pytest.fixture(scope="module")
def pulse():
    return CompiledPage(Pulse, "-O1", in_lanes=True)


@pytest.mark.parametrize("due", [0.7, 1.4, 2.0, 3.0, 4.0, 4.6])
@pytest.mark.parametrize("jump", [-1.2, -0.4, 0.0, 0.3, 1.5])
def test_variations_of_what_is_observed_are_those_of_differences(pulse, due, jump):
    """The largest value is met within a step, at either side of the event, at the end of the run."""
    for until in (0.9, 2.5, 100.0):
        given = {"due": due, "jump": jump, "tolerance": 1e-13}
        run = pulse.start(seeds=PULSE, **given).to(until)
        for i, seed in enumerate(PULSE):
            value = getattr(pulse.start(**given), seed)
            ends = [pulse.start(**given | {seed: value + sign * 1e-5}).to(until).x for sign in (1, -1)]
            assert run.dx[i] == pytest.approx((ends[0] - ends[1]) / 2e-5, abs=1e-8), seed


def test_they_are_the_same_in_lanes_in_many_calls_and_sampled(pulse):
    def runs():
        random = np.random.default_rng(8)
        draw = [{"due": random.uniform(0.3, 5.5), "jump": random.uniform(-1, 1)} for _ in range(40)]
        return [pulse.start(seeds=PULSE, tolerance=1e-12, **given) for given in draw]

    ends = np.linspace(0, 7, 40)
    wanted = [run.to(end) for run, end in zip(runs(), ends, strict=True)]
    for width in widths_of(pulse):
        mine = runs()
        run_batch(mine, ends, width=width)
        assert [run.dx.tobytes() for run in mine] == [run.dx.tobytes() for run in wanted]
    for run, whole, end in zip(runs(), wanted, ends, strict=True):
        for time in (*np.linspace(0, end, 23), *(time for time, *_ in whole.log)):
            run.to(time) if time >= run.time else None
        run.to(end)
        assert run.dx == pytest.approx(whole.dx, abs=1e-9)


# ---- the runner ------------------------------------------------------------------------------------------


OBSERVE_ALL = 2


def test_only_usual_quantities_are_observed_unless_a_run_asks_for_all(whole):
    given = {"seen_vy": -0.01, "friction": 0.6}
    usual, asked = whole.start(**given), whole.start(**given)
    asked.run.observes = OBSERVE_ALL
    assert usual.to(30.0).x[:1] == asked.to(30.0).x[:1]
    measures = ("squared_torque", "greatest_foot_height", "greatest_slip_velocity")
    assert all(getattr(asked, name) > 0 for name in measures)
    assert all(getattr(usual, name) == 0 for name in measures)
    assert usual.positive_work_so_far == pytest.approx(asked.positive_work_so_far, abs=1e-10)


def differences(start, seed, step, until, events):
    """Central differences of a run's states by a seed, with two steps; None if other events are taken."""
    value, found = getattr(start(), seed), []
    for size in (step, step / 2):
        runs = [start(**{seed: value + sign * size}).to(until) for sign in (1, -1)]
        found.append((runs[0].x - runs[1].x) / (2 * size))
        if any(run.outcome != "arrived" or events_of(run) != events for run in runs):
            return None
    return found


def rounding_of_differences(start, seed, step, until):
    """Standard deviation of central differences whose steps differ by up to 1 %.

    Their truncation errors are equal, their rounding errors are not.
    """
    value, found = getattr(start(), seed), []
    for size in step * np.linspace(0.99, 1.01, 16):
        after, before = (start(**{seed: value + sign * size}).to(until).x for sign in (1, -1))
        found.append((after - before) / (2 * size))
    return np.std(found, axis=0, ddof=1)


def events_of(run):
    """The events that a run has taken, in their order."""
    return [name for _, name, *_ in run.log]


def test_random_runners_of_any_stiffness_vary_as_differences_do(whole):
    checked = 0
    observed = [whole.states.index(o.into) for o in whole.model.marked("is_observed").values()]
    lost_slip = 1866  # the step before the slip ends at its guard's zero, and rounding leaves the guard below
    for number in {*some_of(range(3000), 60), lost_slip}:
        parameters, inputs, world, segments, (length, rate, _) = drawn(number)
        values = whole.names(parameters | inputs) | world
        values |= {"swing_clamp": number % 2, "tolerance": 1e-14, "step_limit": 5000}
        values |= {f"{n}_rate": v for n, v in whole.names(segments[0][2]).items()}
        seeds = {"seen_vx": length * rate, "angle": 1.0, "gravity": values["gravity"] + 1e-9}

        def start(values=values, seeds=(), **changes):
            run = whole.start(seeds=seeds, **values | changes)
            run.run.observes = OBSERVE_ALL
            return run

        values["seen_vy"] -= 1e-3 * length * rate  # no apex
        until = (5 + number % 37) / rate
        run = start(seeds=list(seeds)).to(until)
        if run.outcome != "arrived":
            continue
        for i, (seed, unit) in enumerate(seeds.items()):
            found = differences(start, seed, 1e-5 * unit, until, events_of(run))
            if found is None:
                continue
            for at in observed:
                # rounding of times leaves less of a slip that lasts for 1e-9 s
                scale = 1e-3 * max(np.abs(found[1][at]), np.abs(run.x[at]) / unit, 1e-8)
                if (off := abs(found[0][at] - found[1][at])) < scale:
                    checked += 1
                    error, allowed = abs(run.dx[i, at] - found[1][at]), 3 * off + scale / 30
                    if error > allowed:  # two differences that are all rounding may be close by chance
                        allowed += 3 * rounding_of_differences(start, seed, 5e-6 * unit, until)[at]
                    assert error <= allowed, (number, seed, whole.states[at])
    assert checked > 100
