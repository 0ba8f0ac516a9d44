"""Many runs of a page side by side, in lanes and threads: each ends as the driver ends it, bit for bit."""

import numpy as np
import pytest
from page_runs import LANES, OUTCOMES, CompiledPage, StuckError, ffi, run_batch, widths_of
from runner_pages import drawn, world_of

from c_core.hybrid import Model, event, exp, mode, parameter, sin, state

LEVEL = "-O1"
APEX = 1.406106854441984, 1.062891224817656, 1.004282245348082, 1.242779537928858, 0, 0.2165916273954818


class Hopper(Model):
    """A ball on a floor that swings, in air that is thicker below; it rests where its speed is small."""

    start = "flight", {}
    gravity, drag, restitution = parameter(1, "m/s2"), parameter(0.1, "1/s"), parameter(0.8)
    sticks, swing = parameter(0.05, "m/s"), parameter(0.1, "m")
    height, speed, angle = state(1, "m"), state(0, "m/s"), state(0)
    hops = state(0)

    @mode()
    def flight(b):
        """The drag falls with the height."""
        wind = b.drag * exp(-b.height / b.unit_height) * b.speed
        return {"height": b.speed, "speed": -b.gravity - wind, "angle": b.rate}

    @mode(ends=True)
    def rest(b):
        """The hopper rests on the floor."""
        return {}

    unit_height, rate = parameter(1, "m"), parameter(1, "1/s")

    @event("flight", when=lambda b: b.height - b.swing * sin(b.angle), unit="m")
    def hits(b):
        """The hopper bounces, or comes to rest."""
        if b.speed**2 < b.sticks**2:
            return b.to("rest", speed=0)
        return b.replace(speed=-b.restitution * b.speed, hops=b.hops + 1)


@pytest.fixture(scope="module")
def hopper():
    return CompiledPage(Hopper, LEVEL, in_lanes=True)


def bits(run):
    """Bits of a run's whole state."""
    r, rows = run.run, min(len(run.rows), run.run.log_count)
    numbers = run.outcome, r.mode, r.time, r.time_rest, r.steps, r.events, r.chain, r.log_count, r.is_shifted
    memory = r.taken, r.above, r.late, run.log[:rows]
    return numbers, memory, run.x.tobytes(), run.dx.tobytes(), run.shift.tobytes()


def driven(runs, until=1e6, stop=None):
    """Run each by the driver."""
    until = np.broadcast_to(until, len(runs))
    for run, end in zip(runs, until, strict=True):
        try:
            run.to(end, stop)
        except StuckError:
            assert run.outcome == "endless-chain"
    return runs


def random_hopper(page, number):
    """A hopper with any parameters, light and heavy ones side by side."""
    u = np.random.default_rng([7, number]).uniform
    values = {"height": u(0.2, 3), "speed": u(-1, 3), "restitution": u(0.3, 0.95), "swing": u(0, 0.3)}
    values |= {"drag": 10 ** u(-3, 1), "rate": u(0.1, 3), "sticks": 10 ** u(-3, -1)}
    return page.start(seeds=["height", "drag"], tolerance=1e-10, step_limit=2000, **values)


def test_machines_of_this_kind_have_lanes(hopper):
    assert widths_of(hopper)[:2] == [1, 2]
    assert set(widths_of(hopper)) <= {1, *LANES}


@pytest.mark.parametrize("count", [1, 2, 3, 5, 8, 17])
def test_any_number_of_runs_in_any_order_ends_as_the_driver_ends_them(hopper, count):
    ends = np.random.default_rng(count).uniform(3, 12, count)
    wanted = [bits(run) for run in driven([random_hopper(hopper, i) for i in range(count)], ends)]
    assert len({run[0][0] for run in wanted}) > 1 or count < 6
    order = np.random.default_rng(count).permutation(count)
    for width in widths_of(hopper):
        for numbers in (range(count), order):
            runs = [random_hopper(hopper, i) for i in numbers]
            run_batch(runs, ends[list(numbers)], width=width)
            assert [bits(run) for run in runs] == [wanted[i] for i in numbers]


def runner_near_the_gait(page, number, **more):
    """A runner near the gait."""
    random = np.random.default_rng([5, number])
    apex = np.array(APEX) + random.uniform(-0.05, 0.05, 6)
    given = {"friction": random.choice([0.2, 0.6, 10]), "swing_clamp": number % 2} | world_of(apex)
    return page.start(**given | more)


@pytest.mark.parametrize("width", LANES)
def test_strides_and_jacobians_in_lanes_are_those_of_the_driver(whole, width):
    if width not in widths_of(whole):
        pytest.skip(f"this processor has no {width} lanes")
    seeds = ["seen_y", "seen_vx", "length", "angle", "length_rate", "angle_rate", "friction", "kp"]

    def runs():
        return [runner_near_the_gait(whole, i, seeds=seeds, tolerance=1e-11) for i in range(30)]

    wanted, mine = runs(), runs()
    for _ in range(2):
        driven(wanted, stop="apex")
        work = run_batch(mine, stop="apex", width=width)
        assert [bits(run) for run in mine] == [bits(run) for run in wanted]
    assert work.steps > 3 * work.single_steps
    assert sum(run.outcome == "stopped" for run in mine) > 15


def test_random_runs_with_everything_on_end_as_the_driver_ends_them(whole):
    """Ramps and jumps in mid-stance, every parameter over its range, stiff and extreme runners."""

    def start(number):
        parameters, inputs, world, segments, _ = drawn(number)
        given = whole.names(parameters | inputs) | world
        given |= {"swing_clamp": number % 2, "tolerance": 1e-11, "step_limit": 2000}
        return whole.start(seeds=["seen_y", "gravity"], **given), segments

    def set_part(runs, part):
        """Set the inputs and rates of a part of each run; returns when it ends."""
        for run, segments in runs:
            _, sets, rates = segments[part]
            run.set(**whole.names(sets), **{f"{n}_rate": v for n, v in whole.names(rates).items()})
        return [run.time + segments[part][0] for run, segments in runs]

    widths = [None, *(width for width in LANES if width in widths_of(whole))]
    groups = {width: [start(i) for i in range(60)] for width in widths}
    for part in range(len(groups[None][0][1])):
        ends = {width: set_part(runs, part) for width, runs in groups.items()}
        driven([run for run, _ in groups[None]], ends[None])
        wanted = [bits(run) for run, _ in groups[None]]
        for width in widths[1:]:
            run_batch([run for run, _ in groups[width]], ends[width], width=width)
            assert [bits(run) for run, _ in groups[width]] == wanted, width
        kept = [i for i, (run, _) in enumerate(groups[None]) if run.outcome == "arrived"]
        groups = {width: [runs[i] for i in kept] for width, runs in groups.items()}
    assert 20 < len(kept) < 60


@pytest.mark.parametrize("count", [1, 13])
def test_batches_sample_as_the_driver_does(whole, count):
    """Densely and rarely, at events, beyond the end, and in runs that fall."""

    def runs():
        made = []
        for i in range(count):
            random = np.random.default_rng([3, i])
            given = world_of(np.array(APEX) + random.uniform(-0.05, 0.05, 6)) | {"friction": 0.4}
            run = whole.start(seeds=["friction", "length"], ground_slope=0.03 * (i % 3), **given)
            times = np.sort(random.uniform(-1, 40, 3 + 40 * (i % 4)))
            run.sample_at([0.0, 0.0, *times[times > 0], *times[-1:], 1e9])
            made.append(run)
        return made

    wanted = driven(runs(), 30.0)
    assert all(0 < run.run.sampled < len(run.sampled[0]) for run in wanted)
    for width in widths_of(whole):
        mine = runs()
        run_batch(mine, 30.0, width=width)
        for run, other in zip(mine, wanted, strict=True):
            assert bits(run) == bits(other)
            assert run.run.sampled == other.run.sampled
            assert [a.tobytes() for a in run.sampled] == [a.tobytes() for a in other.sampled]


def test_threads_decide_nothing(hopper):
    wanted = [bits(run) for run in driven([random_hopper(hopper, i) for i in range(300)], 10.0)]
    for threads in (2, 5):
        runs = [random_hopper(hopper, i) for i in range(300)]
        run_batch(runs, 10.0, threads=threads)
        assert [bits(run) for run in runs] == wanted


def test_each_outcome_is_told_apart(hopper):
    """One batch has runs at rest, arrived, at a limit, endless, and without a finite step."""
    given = {
        "ended": {"sticks": 0.5}, "arrived": {"height": 1e3}, "too-many-steps": {"rate": 1e4},
        "endless-chain": {"sticks": 0, "restitution": 0}, "no-progress": {"gravity": np.nan},
        "too-many-events": {"restitution": 0.99, "sticks": 0},
    }  # fmt: skip

    def runs():
        made = [hopper.start(step_limit=500, **values) for values in given.values() for _ in range(5)]
        for run in made[25:]:
            run.run.event_limit = 3
        return made

    wanted = [bits(run) for run in driven(runs(), 20.0)]
    assert [run[0][0] for run in wanted] == [name for name in given for _ in range(5)]
    for width in widths_of(hopper):
        mine = runs()
        run_batch(mine, 20.0, width=width)
        assert [bits(run) for run in mine] == wanted
        assert all(np.isfinite(run.x).all() for run in mine if run.outcome in ("ended", "arrived"))


def test_a_run_that_ends_in_the_last_step_or_event_of_its_limits_has_ended(hopper):
    end = hopper.start(sticks=0.5).to(20.0)

    def runs():
        made = [hopper.start(sticks=0.5) for _ in range(2)]
        made[0].run.step_limit = end.run.steps
        made[1].run.event_limit = end.run.events
        return made

    for run in driven(runs(), 20.0):
        assert bits(run) == bits(end) and run.outcome == "ended"
    for width in widths_of(hopper):
        mine = runs()
        run_batch(mine, 20.0, width=width)
        assert [bits(run) for run in mine] == [bits(end)] * 2


@pytest.mark.parametrize("threads", [1, 3])
def test_a_callback_changes_states_from_stop_to_stop(hopper, threads):
    """Each hop makes the ball faster, in the batch as by the driver; each run has hops of its own."""
    speed, count = hopper.states.index("speed"), hopper.states.index("hops")

    def again(run):
        run.x[speed] *= 1.1
        return run.x[count] < 5

    def hoppers():
        return [random_hopper(hopper, i) for i in range(40)]

    wanted = hoppers()
    for run in wanted:
        while driven([run], 30.0, "hits") and run.outcome == "stopped" and again(run):
            pass
    mine = hoppers()

    def at_end(_context, number, _run, outcome):
        return OUTCOMES[outcome] == "stopped" and bool(again(mine[number]))

    for width in widths_of(hopper):
        mine = hoppers()
        run_batch(mine, 30.0, "hits", width, threads, at_end)
        assert [bits(run) for run in mine] == [bits(run) for run in wanted]


def test_a_run_that_a_callback_leaves_as_it_is_goes_on_in_its_lane(hopper):
    """The run ends like one begun anew at each stop. Some runs have less time from a stop on."""
    ends = np.random.default_rng(1).uniform(8, 12, 40)
    steps = {}
    for unchanged in (False, True):
        for width in widths_of(hopper):
            runs = [random_hopper(hopper, i) for i in range(40)]
            until = ends.copy()

            def at_end(_context, number, _run, outcome, until=until, unchanged=unchanged):
                until[number] = ends[number] - 4 * (number % 3 == 0)
                return (1 + unchanged) * (OUTCOMES[outcome] == "stopped")

            work = run_batch(runs, until, "hits", width, 1, at_end)
            steps[unchanged, width] = work.lane_steps
            if not unchanged and width == 1:
                wanted = [bits(run) for run in runs]
            assert [bits(run) for run in runs] == wanted
    assert all(steps[True, width] < steps[False, width] for width in widths_of(hopper)[1:])


def test_a_cancelled_run_is_where_it_was_and_goes_on_from_there(hopper):
    for width in widths_of(hopper):
        cancel = ffi.new("int *", 1)
        runs = [random_hopper(hopper, i) for i in range(20)]
        run_batch(runs, 10.0, width=width, cancel=cancel)
        assert {(run.outcome, run.time) for run in runs} == {("cancelled", 0.0)}
        cancel[0], calls = 0, []

        def at_end(_context, number, _run, outcome, cancel=cancel, calls=calls):
            calls.append(number)
            cancel[0] = len(calls) > 10
            return OUTCOMES[outcome] == "stopped"

        run_batch(runs, 10.0, "hits", width, 2, at_end, cancel)
        assert sum(run.outcome == "cancelled" for run in runs) > 3
        wanted = driven([random_hopper(hopper, i) for i in range(20)], 10.0)
        for run, other in zip(runs, wanted, strict=True):
            driven([run], 10.0)
            assert run.hops == other.hops
            assert run.x == pytest.approx(other.x, abs=1e-7)


def test_runs_that_do_not_match_and_widths_that_are_not_there_are_refused(hopper):
    runs = [random_hopper(hopper, i) for i in range(4)]
    runs[2].run.tolerance = 1e-9
    with pytest.raises(AssertionError, match="refused"):
        run_batch(runs, 10.0)
    with pytest.raises(AssertionError, match="refused"):
        run_batch(runs[:2], 10.0, width=3)
    with pytest.raises(AssertionError, match="refused"):
        runs[0].run.order = 30
        run_batch(runs[:1], 10.0)
    run_batch(runs[1:2], 10.0)
    assert run_batch(runs[1:2], 0.0).steps == 0
