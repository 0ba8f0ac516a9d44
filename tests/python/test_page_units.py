"""FMI units of any page: one set of C sources, tables that are generated, and modelDescription.xml."""

from pathlib import Path

import fmpy
import numpy as np
import pytest
from conftest import RELEASE, some_of, succeed
from fmpy import extract, read_model_description
from fmpy.fmi1 import FMICallException
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
from page_runs import compiler
from scipy.integrate import solve_ivp
from unit_pages import Ball, Cart, Hopper, Yoyo, ball_at, units_of
from unit_runs import UnitRun

from c_core.hybrid import Model, cos, mode, output, parameter, select, sin, state
from c_core.hybrid.page import Page
from c_core.hybrid.unit import Unit
from c_core.hybrid.unit_files import compile_unit, fmi_headers, write_unit

INTERFACES = "ModelExchange", "CoSimulation"
RESULTS = (
    *("y", "vy", "push.work", "push.positive_work", "jump.work", "stance.peak_force", "stance.time"),
    *("spring.force", "energy.total", "hop.count", "hop.word", "contact"),
)


@pytest.mark.parametrize("model", [Ball, Hopper, Yoyo])
@pytest.mark.parametrize("version", [2, 3])
def test_the_description_of_a_unit_is_valid(model, version):
    assert validate_fmu(units_of(model)[version]) == []


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("interface", INTERFACES)
def test_a_ball_bounces_by_its_closed_form(version, interface):
    unit, given = units_of(Ball)[version], {"stop_time": 2.0, "output_interval": 0.25}
    rows = fmpy.simulate_fmu(unit, fmi_type=interface, relative_tolerance=1e-9, **given)
    on_grid = [row for row in rows if row["time"] >= 0.5 and row["time"] % 0.25 == 0]
    assert len(on_grid) >= 7
    for row in on_grid:
        height, bounces = ball_at(row["time"])
        assert row["height"] == pytest.approx(height, abs=1e-7 if interface == "ModelExchange" else 1e-12)
        assert row["bounce.count"] == bounces


def test_a_step_by_explicit_euler_takes_each_bounce_once():
    """Events are found up to a step late. The same steps in Python say what has to come out."""
    run = UnitRun(units_of(Ball)[2], "me", restitution=0.5)
    height, speed, bounces, is_late = 1.0, 0.0, 0, False
    for _ in range(400):
        run.euler_step(0.01)
        height, speed = height + 0.01 * speed, speed - 0.01 * 9.81
        is_late &= height <= 0 and speed > 0
        if height <= 0 and not is_late:
            speed, bounces, is_late = -0.5 * speed, bounces + 1, True
        assert run.states == pytest.approx([height, speed], abs=1e-12)
        assert run["bounce.count"] == bounces
    assert bounces > 10


def test_a_hopper_by_coarse_steps_writes_down_what_happens():
    """Touchdown, greatest compression, lift-off and apex take turns at any step of explicit Euler."""
    for step in (0.02, 0.01, 0.003, 0.0007):
        run = UnitRun(units_of(Hopper)[2], "me", spring__stiffness=100.0)
        words, last = "", 0
        while run.time < 3.0:
            run.euler_step(step)
            code = run["hop.word_code"]
            words += run["hop.word"][-1] if code != last else ""
            last = code
        assert words.startswith("tcla" * 2), step
        assert {words[i : i + 4] for i in range(0, len(words) - 3, 4)} == {"tcla"}, (step, words)


# ---- random runs ---------------------------------------------------------------------------------------


def random_hopper(seed, highest=0.05):
    """Start values, and what is set at later times. Ground that comes up to a foot loads the spring."""
    draw = np.random.default_rng(seed)
    start = {"y": draw.uniform(1.1, 1.6), "vy": draw.uniform(-1, 1), "push": draw.uniform(-3, 3)}
    start |= {"spring__stiffness": draw.uniform(100, 300), "mass": draw.uniform(0.8, 1.2)}
    times = np.cumsum(draw.uniform(0.05, 0.3, 12))
    jumps = [{"push": lambda: draw.uniform(-3, 3)}, {"ground": lambda: draw.uniform(-0.1, highest)}]
    jumps += [{"spring__stiffness": lambda: draw.uniform(100, 300)}]
    return start, [(t, {n: of() for n, of in jumps[draw.integers(3)].items()}) for t in times]


def played(interface, seed, **given):
    start, jumps = random_hopper(seed, **given)
    run, values = UnitRun(units_of(Hopper)[2], interface, **start), {}
    for time, more in jumps:
        run.to(time, **values)
        values = more
    return run.to(jumps[-1][0] + 0.3, **values)


@pytest.mark.parametrize("seed", some_of(range(40), 10))
def test_both_interfaces_agree_on_random_runs(seed):
    exchange, simulation = played("me", seed), played("cs", seed)
    for name in RESULTS:
        value = simulation[name]
        error = 3e-6 if name == "spring.force" else 1e-8  # a stiffness of up to 300 N/m times a place
        expected = value if isinstance(value, str) else pytest.approx(value, rel=1e-8, abs=error)
        assert exchange[name] == expected, name


@pytest.mark.parametrize("seed", some_of(range(40, 60), 5))
@pytest.mark.parametrize("interface", ["me", "cs"])
def test_energy_changes_by_works_alone(seed, interface):
    start, _ = random_hopper(seed, highest=-0.1)
    run = played(interface, seed, highest=-0.1)
    mass, height, speed = start["mass"], start["y"], start["vy"]
    before = mass * (10 * height + speed**2 / 2)
    assert run["energy.total"] == pytest.approx(before + run["push.work"] + run["jump.work"], abs=1e-9)
    assert run["push.positive_work"] >= max(0.0, run["push.work"]) - 1e-9


@pytest.mark.parametrize("interface", ["me", "cs"])
def test_a_run_may_start_in_coordinates_that_the_unit_does_not_show(interface):
    """A mass released at 1.2 rad swings as a pendulum. The world's coordinates follow from the start."""
    run = UnitRun(units_of(Yoyo)[2], interface, begins=False, start__angle=1.2, start__turn=0.3)
    assert run["x"] == pytest.approx(np.sin(1.2), abs=1e-15)
    slopes = [run.slope(name, "start.angle") for name in ("x", "vy")]
    assert slopes == pytest.approx([np.cos(1.2), 0.3 * np.cos(1.2)], abs=1e-14)
    run.begin()
    run.to(2.0)
    assert run["x"] ** 2 + run["y"] ** 2 == pytest.approx(1.0, abs=1e-9)
    energy = (run["vx"] ** 2 + run["vy"] ** 2) / 2 + 9.81 * run["y"]
    assert energy == pytest.approx(0.3**2 / 2 - 9.81 * np.cos(1.2), abs=1e-8)
    solution = solve_ivp(
        lambda _, z: [z[1], -9.81 * np.sin(z[0])], (0, 2.0), [1.2, 0.3], rtol=1e-12, atol=1e-12
    )
    assert run["x"] == pytest.approx(np.sin(solution.y[0, -1]), abs=1e-8)
    assert run["start.angle"] == 1.2


def test_interfaces_agree_where_the_string_is_slack_at_once():
    exchange, simulation = (UnitRun(units_of(Yoyo)[2], interface).to(1.5) for interface in ("me", "cs"))
    for name in ("x", "y", "vx", "vy"):
        assert exchange[name] == pytest.approx(simulation[name], abs=1e-8)


def gap_of(hand, steps):
    """The largest gap of the ledger, where the hand moves along an importer's Runge-Kutta steps."""
    run, size = UnitRun(units_of(Cart)[2], "me"), 2.0 / steps
    start, gap, x = run["energy"], 0.0, run.states

    def rates(time, states):
        run.write("hand", hand(time))
        return run.rates(time, states)

    for i in range(steps):
        time = i * size
        a = rates(time, x)
        b = rates(time + size / 2, x + size / 2 * a)
        c = rates(time + size / 2, x + size / 2 * b)
        d = rates(time + size, x + size * c)
        x = x + size / 6 * (a + 2 * b + 2 * c + d)
        rates(time + size, x)
        if run.complete():
            run.event()
        x = run.states
        gap = max(gap, abs(run["energy"] - start - run["work"]))
    return gap


def test_the_work_of_an_input_that_moves_between_events_is_accounted_for():
    """The error is of fourth order along a ramp, and of second order along a curve."""
    ramp = [gap_of(lambda t: 0.3 * t, steps) for steps in (50, 100)]
    curve = [gap_of(lambda t: 0.1 * np.sin(3 * t), steps) for steps in (50, 100)]
    assert ramp[1] < 1e-6 and ramp[1] < ramp[0] / 12
    assert curve[1] < 1e-3 and curve[1] < curve[0] / 3.5
    assert gap_of(lambda _: 0.0, 100) < 1e-7


# ---- dependencies and derivatives ----------------------------------------------------------------------


class Cancelling(Model):
    """A value far from the states that it depends on, and one whose terms cancel."""

    start = "drift", {}
    rate = parameter(1.0, "1/s")
    x = state(1.0)
    y = state(1.0)

    @mode()
    def drift(r):
        return {"x": r.rate / r.y, "y": 2e-20 * r.rate * r.x}

    far = output(of=lambda r: 1e18 - r.y)
    cancelled = output(of=lambda r: sin(r.x) ** 2 + cos(r.x) ** 2 + abs(r.y))
    selected = output(of=lambda r: select(r.x > 1e30, r.y, 0))


def test_a_value_depends_on_what_can_change_it():
    rows = {row.name: row.depends for row in Unit(Page(Cancelling)).rows}
    found = {name: rows[name] for name in ("far", "cancelled", "selected", "der(x)", "der(y)")}
    y = {"y"}
    assert found == {"far": y, "cancelled": y, "selected": {"x", "y"}, "der(x)": y, "der(y)": {"x"}}


@pytest.mark.parametrize("time", [0.1, 0.3, 0.45])
def test_directional_derivatives_are_those_of_the_values(time):
    """The times are in flight, and in stance while the spring shortens and while it lengthens."""
    run = UnitRun(units_of(Hopper)[2], "me", push=1.0, y=1.2)
    run.integrate(time)
    results = [f"der({name})" for name in ("y", "vy", "push.work", "push.positive_work")]
    results += ["energy.total", "spring.force"]
    for name in ("y", "vy", "push", "spring.stiffness"):
        if in_event_mode := name == "spring.stiffness":
            run.fmu.enterEventMode()
        differences = run.differences(results, name)
        if in_event_mode:
            run.fmu.enterContinuousTimeMode()
        slopes = [run.slope(result, name) for result in results]
        assert slopes == pytest.approx(differences, abs=2e-8), name


def test_derivatives_of_a_start_go_through_its_decisions():
    run = UnitRun(units_of(Hopper)[2], "cs", begins=False, push=2.0, vy=-0.5)
    results = "der(vy)", "energy.total", "der(push.work)"
    for name in ("y", "vy", "push", "mass"):
        slopes = [run.slope(result, name) for result in results]
        assert slopes == pytest.approx(run.differences(results, name), abs=1e-8), name


# ---- saved states --------------------------------------------------------------------------------------


@pytest.mark.parametrize("interface", ["me", "cs"])
def test_a_saved_state_goes_on_in_another_instance_to_the_bit(interface):
    run = UnitRun(units_of(Hopper)[2], interface, push=1.0).to(0.83)
    saved = run.fmu.getFMUstate()
    data = run.fmu.serializeFMUstate(saved)
    run.to(2.1)
    other = UnitRun(units_of(Hopper)[2], interface)
    other.fmu.setFMUstate(other.fmu.deSerializeFMUstate(data))
    other.time = 0.83
    other.to(2.1)
    assert [other[name] for name in RESULTS] == [run[name] for name in RESULTS]
    for at in (60, len(data) // 2, len(data) - 1):
        forged = data[:at] + bytes([data[at] ^ 1]) + data[at + 1 :]
        with pytest.raises(FMICallException):
            other.fmu.deSerializeFMUstate(forged)


# ---- what is refused, and what is logged -----------------------------------------------------------------


def test_refusals_name_the_variable_its_value_and_what_is_allowed():
    run = UnitRun(units_of(Hopper)[2], "cs", begins=False, logs=True)
    with pytest.raises(FMICallException):
        run.write("mass", -1.0)
    assert "mass = -1 kg is refused: allowed above 0 kg" in run.messages[-1]
    run.write("y", 0.5)
    with pytest.raises(FMICallException):
        run.begin()
    assert "y = 0.5 m is refused: it must be above the length of the spring" in run.messages[-1]
    run.write("y", 1e80)
    with pytest.raises(FMICallException):
        run.begin()
    assert "y is larger than in any motion" in run.messages[-1]
    run.write("y", 1.2)
    run.begin()
    run.to(0.5)
    assert any("touchdown at 0.2 s: flight -> stance" in message for message in run.messages)


@pytest.mark.parametrize("rate", [1e3, 1e150, 1e300])
def test_an_input_that_is_ramped_out_of_its_range_ends_the_step_with_a_message(rate):
    run = UnitRun(units_of(Hopper)[2], "cs", logs=True)
    run.fmu.setRealInputDerivatives([run.of["push"].valueReference], [1], [rate])
    with pytest.raises(FMICallException):
        run.to(1.0)
    assert "out of range" in run.messages[-1] or "finite result" in run.messages[-1]
    assert "push" in run.messages[-1] or rate > 1e3


def test_a_run_that_ends_stays_readable_and_model_exchange_may_terminate():
    ends = {"spring__stiffness": 5.0, "y": 2.0}
    simulation = UnitRun(units_of(Hopper)[2], "cs", **ends).to(3.0)
    exchange = UnitRun(units_of(Hopper)[2], "me", **ends).to(3.0)
    assert simulation["contact"] == exchange["contact"] == 3
    assert exchange.terminates and exchange.time < 3.0
    assert simulation["y"] == pytest.approx(0.0, abs=1e-12) and simulation["der(vy)"] == 0.0
    simulation.fmu.setRealInputDerivatives([simulation.of["push"].valueReference], [1], [1e3])
    assert simulation.to(9.0)["contact"] == 3  # whatever its inputs do


# ---- FMI 3.0 Co-Simulation with event mode ---------------------------------------------------------------


def events_of(unit, until, step, **at_events):
    """Run to each event by early return. Returns the times of the events, and the final values by name."""
    description = read_model_description(unit)
    of = {v.name: v.valueReference for v in description.modelVariables}
    given = {"guid": description.guid, "modelIdentifier": description.modelName, "instanceName": "run"}
    fmu = FMU3Slave(unzipDirectory=extract(unit), **given)
    fmu.instantiate(eventModeUsed=True, earlyReturnAllowed=True)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    fmu.updateDiscreteStates()
    fmu.enterStepMode()
    time, times = 0.0, []
    while time < until - 1e-12:
        size = min(step, until - time)
        event, _, early, last = fmu.doStep(time, size)
        assert early == (last < time + size) and (event or not early)
        time = last
        if event:
            times.append(time)
            fmu.enterEventMode()
            for name, value in at_events.items():
                fmu.setFloat64([of[name.replace("__", ".")]], [value])
            fmu.updateDiscreteStates()
            fmu.enterStepMode()
    wanted = {*RESULTS[:9], "height", "speed"} & of.keys()
    values = {name: fmu.getFloat64([of[name]])[0] for name in wanted}
    fmu.terminate()
    fmu.freeInstance()
    return times, values


@pytest.mark.parametrize("step", [0.03, 10.0])
def test_a_step_returns_at_the_exact_time_of_each_event(step):
    times, values = events_of(units_of(Ball)[3], 2.0, step)
    first = np.sqrt(2 / 9.81)
    expected = [first * (1 + 2 * sum(0.8**k for k in range(1, n))) for n in (1, 2, 3)]
    assert times == pytest.approx(expected, abs=1e-12)
    assert values["height"] == pytest.approx(ball_at(2.0)[0], abs=1e-12)


def test_what_is_set_at_an_event_decides_what_comes_of_it():
    times, _ = events_of(units_of(Ball)[3], 0.74, 10.0, restitution=0.25)
    first = np.sqrt(2 / 9.81)
    assert times[:3] == pytest.approx([first, 1.5 * first, 1.625 * first], abs=1e-11)


@pytest.mark.parametrize("step", [0.07, 10.0])
def test_event_mode_changes_no_result(step):
    times, values = events_of(units_of(Hopper)[3], 2.0, step)
    plain = UnitRun(units_of(Hopper)[2], "cs").to(2.0)
    assert len(times) == 7
    for name, value in values.items():
        assert value == pytest.approx(plain[name], abs=1e-10), name


# ---- two units in one program ------------------------------------------------------------------------------


def test_two_units_link_into_one_program(tmp_path):
    """Every name with external linkage has the prefix of its unit, those of the kernel included."""
    objects = []
    for model in (Ball, Hopper):
        folder = tmp_path / model.__name__
        write_unit(model, folder)
        own = compile_unit(folder, compiler(), ["-DUNIT_IS_STATIC", "-O0"]).values()
        listed = map(str.split, succeed("nm", "-g", "--defined-only", *own).splitlines())
        names = [words[2] for words in listed if len(words) == 3]
        assert len(names) > 150
        assert [name for name in names if not name.startswith(f"{model.__name__}_")] == []
        objects += own
    program, source = tmp_path / "program", Path(__file__).with_name("linked_units.c")
    command = [*compiler(), "-std=c99", "-isystem", fmi_headers(), source, *objects, "-o", program, "-lm"]
    succeed(*command)
    given = []
    for model, name in ((Ball, "height"), (Hopper, "y")):
        description = read_model_description(units_of(model)[2])
        reference = next(v.valueReference for v in description.modelVariables if v.name == name)
        given += [description.guid, str(reference)]
    said = succeed(program, *given).split()
    assert float(said[0]) == pytest.approx(ball_at(2.0)[0], abs=1e-12)
    assert float(said[1]) == pytest.approx(UnitRun(units_of(Hopper)[2], "cs").to(2.0)["y"], abs=1e-12)


def test_no_random_calls_crash_a_unit_or_give_nan(tmp_path):
    """The sanitizers watch both interfaces; some calls pass hostile values and forged saved states."""
    sanitizers = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-g"]
    write_unit(Hopper, tmp_path)
    objects = compile_unit(tmp_path, compiler(), ["-DUNIT_IS_STATIC", "-O0", *sanitizers]).values()
    program, source = tmp_path / "program", Path(__file__).with_name("hostile_calls.c")
    command = [*compiler(), "-std=c99", *sanitizers, "-isystem", fmi_headers(), source, *objects]
    succeed(*command, "-o", program, "-lm")
    description = read_model_description(units_of(Hopper)[2])
    counts = description.numberOfContinuousStates, description.numberOfEventIndicators
    runs = 20000 if RELEASE else 1000
    assert succeed(program, description.guid, *counts, runs) == "survived\n"
