"""Dependencies that the unit of FMI 3.0 declares, and its derivatives, against perturbations.

The unit of FMI 2.0 declares the same, see test_fmi3, and has the same source of values.
"""

import ctypes
import math
import random
from collections import Counter

import numpy as np
import pytest
from conftest import RELEASE
from fmpy.fmi1 import FMICallException
from fmpy.fmi3 import FMU3Model, FMU3Slave

STARTS, RUNS, INITIAL_STARTS = (600, 60, 240) if RELEASE else (150, 20, 40)
"""Starts, runs in steps and start values that are tried; with --release four, three and six times as many."""
WIDE = {
    "ground.friction": (0, 3), "ground.height": (-1, 1), "ground.slope": (-0.5, 0.5),
    "leg.extension": (-0.3, 0.3), "control.thrust": (-0.3, 0.3), "leg.length": (0.2, 2),
    "hip.place_time": (0, 10),
}  # fmt: skip
"""Ranges of jumps, where they are not between -2 and 2."""
UNIT_SETTINGS = {"status.terminate_on_fall", "solver.method", "solver.relative_tolerance"}
"""Settings of the unit, which change no motion."""
PATCHES = [(-30, 30), (0, 30), (40, 60)]
"""Patches of ground below the foot, near it and elsewhere."""
UNLOADED_EARLY = (
    {"foot.y": 0, "foot.vx": 0, "foot.vy": -0.1, "leg.length": 0.9, "leg.angle": 0.6, "leg.angle_rate": 0.5},
    {"leg.extension": -0.3, "control.touchdown_angle": -2},
)
"""Start and jumps of inputs of a foot that grazes before mid-stance, which no random start comes to."""
SLIDING_GRAZE = {
    "foot.x": 0, "foot.y": 0, "foot.vx": 0.5, "foot.vy": 0.5 * math.tan(0.2), "ground.slope": 0.2,
    "leg.length": 0.95, "leg.angle": -0.4, "leg.length_rate": 0.4, "leg.angle_rate": -0.6,
}  # fmt: skip
"""Start of a foot that grazes on a slope while the mass rises, which random starts rarely come to."""


def random_start(draw):
    """A posture near the ground; on it, in contact or grazing, three times out of four."""
    u = draw.uniform
    on_ground = draw.random() < 0.75
    x, height, slope = u(-1, 1), u(-0.5, 0.5), u(-0.2, 0.2)
    speed = draw.choice([0.0, u(-1, 1)])
    return {
        "foot.x": x, "foot.y": height + x * math.tan(slope) + (0.0 if on_ground else u(0.1, 1)),
        "leg.length": u(0.7, 1.2), "leg.angle": u(-0.9, 0.9),
        "foot.vx": speed, "foot.vy": speed * math.tan(slope) if on_ground else u(-1, 1),
        "leg.length_rate": u(-1, 1), "leg.angle_rate": u(-1, 1), "ground.friction": u(0.1, 1),
        "ground.height": height, "ground.slope": slope, "leg.extension": u(-0.02, 0.02),
        "leg.thrust": u(0.01, 0.05), "body.external_fx": u(-0.01, 0.01), "body.external_fy": u(-0.01, 0.01),
        "hip.external_torque": u(-0.1, 0.1), "hip.retraction_rate": u(-0.5, 0.5),
        "ground.static_friction_ratio": u(1, 1.5), "ground.stribeck_velocity": draw.choice([0, 0.1, 0.5]),
        **dict(zip(("ground.patch_begin", "ground.patch_end"), draw.choice(PATCHES), strict=True)),
    }  # fmt: skip


class Unit:
    """The unit, and what its description declares."""

    def __init__(self, folder, description):
        self.folder, self.description = folder, description
        variables = self.description.modelVariables
        self.variables = {v.name: v for v in variables}
        self.inputs = [v.name for v in variables if v.causality == "input"]
        self.tunable = [v.name for v in variables if v.variability == "tunable"]
        self.ramped = [v.name for v in variables if v.causality == "input" and v.variability == "continuous"]
        self.states = [unknown.variable.derivative.name for unknown in self.description.derivatives]

    def exchange(self):
        return Probe(self, FMU3Model)

    def stepper(self, **options):
        return Probe(self, FMU3Slave, **options)

    def declared(self, *groups):
        """Unknown -> names of all that it depends on."""
        return {
            unknown.variable.name: {known.name for known in unknown.dependencies}
            for group in groups
            for unknown in getattr(self.description, group)
        }


class Probe:
    """An instance whose variables can be read and set by name."""

    def __init__(self, unit, kind, **options):
        self.unit = unit
        given = {"guid": unit.description.guid, "modelIdentifier": "TDMF_SLIP", "instanceName": "runner"}
        self.model = kind(unzipDirectory=unit.folder, **given)
        self.model.instantiate(**options)

    def of_each_type(self, names):
        """(FMPy's name of a type, names of that type)."""
        groups = {}
        for name in names:
            kind = self.unit.variables[name].type
            groups.setdefault("Int64" if kind == "Enumeration" else kind, []).append(name)
        return groups.items()

    def read(self, names):
        """Values by name, of any type."""
        values = {}
        for kind, members in self.of_each_type(names):
            references = [self.unit.variables[name].valueReference for name in members]
            values.update(zip(members, getattr(self.model, f"get{kind}")(references), strict=True))
        return values

    def write(self, name, value):
        ((kind, _),) = self.of_each_type([name])
        getattr(self.model, f"set{kind}")([self.unit.variables[name].valueReference], [value])

    def begin(self, start, time=0.0):
        """Enter Initialization Mode and set start values."""
        self.model.enterInitializationMode(startTime=time)
        for name, value in start.items():
            self.write(name, value)
        return self

    def states(self):
        values = (ctypes.c_double * len(self.unit.states))()
        self.model.getContinuousStates(values, len(values))
        return list(values)

    def set_states(self, values):
        self.model.setContinuousStates((ctypes.c_double * len(values))(*values), len(values))


@pytest.fixture(scope="module")
def unit(unpacked3, description3):
    return Unit(unpacked3, description3)


class Observed:
    """Record of the knowns that unknowns were seen to follow at once."""

    def __init__(self, unknowns):
        self.of = {name: set() for name in unknowns}

    def compare(self, known, before, after):
        """Note what has changed by more than rounding: states of a mode follow from those that are seen."""
        for name, values in self.of.items():
            old, new = before[name], after[name]
            is_text = isinstance(old, str)
            if old != new and (is_text or not math.isclose(old, new, rel_tol=1e-10, abs_tol=1e-10)):
                values.add(known)


def elsewhere(draw, name, value):
    """Values to try: one a little off, and two jumps."""
    return [value + 1e-3, *(draw.uniform(*WIDE.get(name, (-2, 2))) for _ in range(2))]


def move_inputs(probe, observed, draw, names):
    """Set each of these inputs to other values, and back."""
    before = probe.read(observed.of)
    for known in names:
        (value,) = probe.read([known]).values()
        for other in elsewhere(draw, known, value):
            probe.write(known, other)
            observed.compare(known, before, probe.read(observed.of))
        probe.write(known, value)
    assert probe.read(observed.of) == before


def move_states_and_time(probe, observed, draw):
    """Set each state and the clock to other values, and back."""
    before, states = probe.read(observed.of), probe.states()
    for i, known in enumerate(probe.unit.states):
        for other in elsewhere(draw, known, states[i]):
            probe.set_states([*states[:i], other, *states[i + 1 :]])
            observed.compare(known, before, probe.read(observed.of))
    probe.set_states(states)
    for time in (1e-3, 3.7):
        probe.model.setTime(time)
        observed.compare("time", before, probe.read(observed.of))
    probe.model.setTime(0.0)
    assert probe.read(observed.of) == before


def fall(probe):
    """Make the runner fall, because its leg is too short."""
    probe.model.enterContinuousTimeMode()
    states = probe.states()
    states[probe.unit.states.index("leg.length")] = 0.01
    probe.set_states(states)
    probe.model.enterEventMode()
    probe.model.updateDiscreteStates()


def test_declared_dependencies_are_those_observed(unit):
    """Outputs of every type are asked in event mode and in continuous time: none is missing or idle."""
    draw = random.Random(2016)
    declared = unit.declared("outputs", "derivatives", "eventIndicators")
    observed, seen = Observed(declared), set()
    for i in range(STARTS):
        start, jumps = random_start(draw) | {"hip.swing_clamp": i % 4 < 2}, {}
        if i % 2:  # inputs that have jumped since, and a ground that waits
            jumps = {name: draw.uniform(*WIDE.get(name, (-0.1, 0.1))) for name in unit.inputs}
        if i == 1:
            start, jumps = UNLOADED_EARLY
        if i == 2:
            start = SLIDING_GRAZE
        probe = unit.exchange().begin(start)
        probe.model.exitInitializationMode()
        probe.model.updateDiscreteStates()
        for name, value in jumps.items():
            probe.write(name, value)
        probe.model.updateDiscreteStates()
        if i % 10 == 0:
            fall(probe)
        now = probe.read(["contact.mode_index", "ground.pending", "status.fallen"])
        seen |= {(name, int(value)) for name, value in now.items()}
        move_inputs(probe, observed, draw, unit.inputs)
        probe.model.enterContinuousTimeMode()
        move_states_and_time(probe, observed, draw)
        move_inputs(probe, observed, draw, unit.ramped)
        probe.model.freeInstance()
    assert seen >= {("contact.mode_index", mode) for mode in range(1, 6)}
    assert seen >= {(name, value) for name in ("ground.pending", "status.fallen") for value in (0, 1)}
    assert observed.of == declared


@pytest.mark.parametrize("early", [False, True], ids=["plain", "at an event that is not taken yet"])
def test_at_communication_points_outputs_follow_the_declared_inputs(unit, early):
    draw, observed = random.Random(22), Observed(unit.declared("outputs"))
    strides, falls, events = 0, 0, 0
    for i in range(RUNS):
        grazes = UNLOADED_EARLY[0] | UNLOADED_EARLY[1]
        options = {"eventModeUsed": True, "earlyReturnAllowed": True} if early else {}
        probe = unit.stepper(**options)
        probe.begin(grazes if i == 1 else {} if i % 3 == 0 else random_start(draw))
        probe.model.exitInitializationMode()
        time = 0.0
        for k in range(20):
            if early:
                probe.model.updateDiscreteStates()
                probe.model.enterStepMode()
            step = draw.uniform(0.1, 6.0) if (i, k) != (1, 0) else 0.01
            done = probe.model.doStep(time, step)
            time = done[3] if early else time + step
            move_inputs(probe, observed, draw, unit.inputs)
            if early:
                events += bool(done[0])
                probe.model.enterEventMode()
                move_inputs(probe, observed, draw, unit.inputs)
        end = probe.read(["stride.count", "status.fallen"])
        strides, falls = strides + end["stride.count"], falls + end["status.fallen"]
        probe.model.freeInstance()
    assert strides > RUNS // 6 and falls > RUNS // 12 and (events > 4 * RUNS) == early
    inputs = set(unit.inputs)
    assert observed.of == {name: known & inputs for name, known in unit.declared("outputs").items()}


def initial_start(draw, i):
    """Start values: an apex, an impact, a leg at its shortest, any posture."""
    if i % 4 == 0:
        return {"leg.thrust": 0.02}
    start = random_start(draw)
    if i % 4 == 1:
        x, height, slope = start["foot.x"], start["ground.height"], start["ground.slope"]
        start |= {"foot.y": height + x * math.tan(slope), "foot.vy": -draw.uniform(0.5, 1.0)}
    if i % 4 == 2:
        start |= {"leg.length": 0.7, "leg.min_length": 0.7}
    return start


def test_initial_unknowns_follow_the_declared_start_values(unit):
    """No dependency is missing. Each declared one is seen, those on a whole start by any unknown."""
    draw = random.Random(29)
    declared = unit.declared("initialUnknowns")
    observed = Observed(declared)
    settable = [v for v in unit.variables.values() if v.initial == "exact" or v.causality == "input"]
    whole_start = {v.name for v in settable} - UNIT_SETTINGS | {"time"}
    read, refused = Counter(), 0
    for i in range(INITIAL_STARTS):
        start, time = initial_start(draw, i), draw.choice([0.0, 2.0])
        probe, later = unit.exchange().begin(start, time), unit.exchange().begin(start, time + 5.0)
        before = probe.read(declared)
        observed.compare("time", before, later.read(declared))
        later.model.freeInstance()
        for variable in settable:
            (value,) = probe.read([variable.name]).values()
            others = [*elsewhere(draw, variable.name, value), draw.uniform(0.5, 1.5) * value]
            for other in {"Boolean": [not value], "Enumeration": [3 - value]}.get(variable.type, others):
                try:
                    probe.write(variable.name, other)
                    observed.compare(variable.name, before, probe.read(declared))
                    read[variable.name] += 1
                except FMICallException:  # no value of this variable, or no start with it
                    refused += 1
            probe.write(variable.name, value)
        assert probe.read(declared) == before
        probe.model.freeInstance()
    assert refused > 0 and min(read[v.name] for v in settable) > INITIAL_STARTS // 2
    of_any_start = {name for name, known in declared.items() if known == whole_start}
    assert all(observed.of[name] <= whole_start for name in of_any_start)
    assert set.union(*map(observed.of.get, of_any_start)) == whole_start
    missed = {name: declared[name] - observed.of[name] for name in set(declared) - of_any_start}
    assert all(observed.of[name] <= declared[name] for name in missed)
    tolerated = 0 if RELEASE else 0.15 * sum(len(declared[name]) for name in missed)
    assert sum(map(len, missed.values())) <= tolerated


def test_directional_derivatives_in_a_run_are_differences(unit):
    """Every continuous output and state derivative is varied by inputs, tunable parameters and states.

    Adjoint derivatives are the same matrix.
    """
    draw, step = random.Random(14), 1e-5
    unknowns = [
        name for name in unit.declared("outputs", "derivatives")
        if unit.variables[name].variability == "continuous"
        and name != "der(hip.positive_work)"  # has a kink where the power is zero
    ]  # fmt: skip
    references = [unit.variables[name].valueReference for name in unknowns]
    compared, modes, columns = 0, set(), {}

    def compare(probe, known, value, change):
        of = unit.variables[known].valueReference
        exact = np.array(probe.model.getDirectionalDerivative(references, [of], [1.0]))
        columns[of] = exact
        sides = []
        for at in (value + step, value - step, value):
            change(at)
            sides.append(np.array(list(probe.read(unknowns).values())))
        size = 1e-6 * (1.0 + np.max(np.abs(exact)))
        assert (sides[0] - sides[1]) / (2 * step) == pytest.approx(exact, abs=size), known

    def compare_adjoint(probe):
        exact, weights = np.stack(list(columns.values())), np.random.default_rng(3).random(len(references))
        adjoint = probe.model.getAdjointDerivative(references, list(columns), weights, len(exact))
        assert adjoint == pytest.approx(exact @ weights, abs=1e-12 * (1.0 + np.abs(exact).max()))
        columns.clear()

    for _ in range(60):
        start = random_start(draw)
        if abs(start["leg.angle"]) < 0.2:
            continue  # in graze the torque is steep near upright
        probe = unit.exchange().begin(start)
        probe.model.exitInitializationMode()
        probe.model.updateDiscreteStates()
        modes |= set(probe.read(["contact.mode_index"]).values())
        for known, value in probe.read(unit.inputs + unit.tunable).items():
            compare(probe, known, value, lambda at, known=known, probe=probe: probe.write(known, at))
        compare_adjoint(probe)
        probe.model.enterContinuousTimeMode()
        states = probe.states()
        for i, known in enumerate(unit.states):
            compare(
                probe, known, states[i],
                lambda at, i=i, probe=probe, x=states: probe.set_states([*x[:i], at, *x[i + 1 :]]),
            )  # fmt: skip
        compare_adjoint(probe)
        probe.model.freeInstance()
        compared += len(unit.inputs + unit.tunable) + len(states)
    assert modes == {1, 2, 3, 4, 5} and compared > 40 * 32
