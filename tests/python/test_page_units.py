"""FMI units of any page: one set of C sources, tables that are generated, and modelDescription.xml."""

import fmpy
import numpy as np
import pytest
from conftest import some_of
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu
from unit_pages import Ball, Hopper, units_of
from unit_runs import UnitRun, address

INTERFACES = "ModelExchange", "CoSimulation"
RESULTS = (
    *("y", "vy", "push.work", "push.positive_work", "jump.work", "stance.peak_force", "stance.time"),
    *("spring.force", "energy.total", "hop.count", "hop.word", "contact"),
)


def ball_at(time, restitution=0.8, height=1.0, gravity=9.81):
    """Height and bounces of a ball that was dropped."""
    speed, left, bounces = np.sqrt(2 * gravity * height), time - np.sqrt(2 * height / gravity), 1
    while left > 2 * restitution * speed / gravity:
        left -= 2 * restitution * speed / gravity
        speed, bounces = speed * restitution, bounces + 1
    return restitution * speed * left - gravity * left**2 / 2, bounces


@pytest.mark.parametrize("model", [Ball, Hopper])
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
    """At any step of explicit Euler, touchdown, greatest compression, lift-off and apex take turns."""
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
        expected = value if isinstance(value, str) else pytest.approx(value, rel=1e-8, abs=1e-8)
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


# ---- derivatives ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("time", [0.1, 0.3, 0.45])
def test_directional_derivatives_are_those_of_the_values(time):
    """In flight, in stance while the spring shortens, and while it lengthens, of everything by everything."""
    run = UnitRun(units_of(Hopper)[2], "me", push=1.0, y=1.2)
    run.integrate(time)
    results = [f"der({name})" for name in ("y", "vy", "push.work", "push.positive_work")]
    results += ["energy.total", "spring.force"]
    x = run.states
    for name in ("y", "vy", "push", "spring.stiffness"):
        found = []
        value, in_event_mode = run[name], name == "spring.stiffness"
        for sign in (1, -1):
            run.fmu.setContinuousStates(address(x), len(x))
            if in_event_mode:
                run.fmu.enterEventMode()
            run.write(name, value + sign * 1e-6)
            found.append([run[result] for result in results])
            run.write(name, value)
            if in_event_mode:
                run.fmu.enterContinuousTimeMode()
        differences = (np.array(found[0]) - found[1]) / 2e-6
        slopes = [run.slope(result, name) for result in results]
        assert slopes == pytest.approx(differences, abs=2e-8), name


def test_derivatives_of_a_start_go_through_its_decisions():
    run = UnitRun(units_of(Hopper)[2], "cs", begins=False, push=2.0, vy=-0.5)
    for name in ("y", "vy", "push", "mass"):
        value, found = run[name], []
        for sign in (1, -1):
            run.write(name, value + sign * 1e-6)
            found.append([run["der(vy)"], run["energy.total"], run["der(push.work)"]])
        run.write(name, value)
        differences = (np.array(found[0]) - found[1]) / 2e-6
        slopes = [run.slope(result, name) for result in ("der(vy)", "energy.total", "der(push.work)")]
        assert slopes == pytest.approx(differences, abs=1e-8), name


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
    assert "mass is -1 kg; it must be above 0" in run.messages[-1]
    run.write("y", 0.5)
    with pytest.raises(FMICallException):
        run.begin()
    assert "y is 0.5 m; it must be above the length of the spring" in run.messages[-1]
    run.write("y", 1.2)
    run.begin()
    run.to(0.5)
    assert any("touchdown at 0.2 s: flight -> stance" in message for message in run.messages)


def test_a_run_that_ends_stays_readable_and_model_exchange_may_terminate():
    ends = {"spring__stiffness": 5.0, "y": 2.0}
    simulation = UnitRun(units_of(Hopper)[2], "cs", **ends).to(3.0)
    exchange = UnitRun(units_of(Hopper)[2], "me", **ends).to(3.0)
    assert simulation["contact"] == exchange["contact"] == 3
    assert exchange.terminates and exchange.time < 3.0
    assert simulation["y"] == pytest.approx(0.0, abs=1e-12) and simulation["der(vy)"] == 0.0
