"""Dependencies declared in the model structure, and directional derivatives, against perturbations."""

import ctypes
import math
import random
from collections import Counter

import fmpy
import numpy as np
import pytest
import tdmf_slip
from conftest import RELEASE
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave

INPUTS = (
    "ground.friction",
    "hip.external_torque",
    "ground.height",
    "ground.slope",
    "leg.extension",
    "body.external_fx",
    "body.external_fy",
    "control.touchdown_angle",
    "control.stance_torque",
    "control.thrust",
)
CONTINUOUS_INPUTS = (
    "ground.friction",
    "hip.external_torque",
    "leg.extension",
    "body.external_fx",
    "body.external_fy",
)
STATES = (
    "foot.x",
    "foot.y",
    "leg.length",
    "leg.angle",
    "foot.vx",
    "foot.vy",
    "leg.length_rate",
    "leg.angle_rate",
    "hip.work",
    "hip.place_time",
    "leg.work",
    "energy.damper_loss",
    "energy.friction_loss",
    "hip.positive_work",
    "energy.external_work",
)
ALL_MODES = {1, 2, 3, 4, 5}
STARTS, RUNS, INITIAL_STARTS = (600, 60, 240) if RELEASE else (150, 20, 40)
"""Starts, runs in steps and start values that are tried; with --release four, three and six times as many."""


def random_start(draw):
    """A posture near the ground; on it, in contact or grazing, three times out of four."""
    on_ground = draw.random() < 0.75
    x, height, slope = draw.uniform(-1, 1), draw.uniform(-0.5, 0.5), draw.uniform(-0.2, 0.2)
    speed = draw.choice([0.0, draw.uniform(-1, 1)])
    return {
        "foot.x": x,
        "foot.y": height + x * math.tan(slope) + (0.0 if on_ground else draw.uniform(0.1, 1)),
        "leg.length": draw.uniform(0.7, 1.2),
        "leg.angle": draw.uniform(-0.9, 0.9),
        "foot.vx": speed,
        "foot.vy": speed * math.tan(slope) if on_ground else draw.uniform(-1, 1),
        "leg.length_rate": draw.uniform(-1, 1),
        "leg.angle_rate": draw.uniform(-1, 1),
        "ground.friction": draw.uniform(0.1, 1),
        "ground.height": height,
        "ground.slope": slope,
        "leg.extension": draw.uniform(-0.02, 0.02),
        "leg.thrust": draw.uniform(0.01, 0.05),
        "body.external_fx": draw.uniform(-0.01, 0.01),
        "body.external_fy": draw.uniform(-0.01, 0.01),
        "hip.external_torque": draw.uniform(-0.1, 0.1),
        "hip.retraction_rate": draw.uniform(-0.5, 0.5),
        "ground.static_friction_ratio": draw.uniform(1, 1.5),
        "ground.stribeck_velocity": draw.choice([0, 0.1, 0.5]),
        **dict(zip(("ground.patch_begin", "ground.patch_end"), draw.choice(PATCHES), strict=True)),
    }


WIDE = {
    "ground.friction": (0, 3),
    "ground.height": (-1, 1),
    "ground.slope": (-0.5, 0.5),
    "leg.extension": (-0.3, 0.3),
    "control.thrust": (-0.3, 0.3),
    "leg.length": (0.2, 2),
    "hip.place_time": (0, 10),
}
"""Where a jump leads, of what is not between -2 and 2."""
OF_THE_UNIT = {"status.terminate_on_fall", "solver.method", "solver.relative_tolerance"}
"""Settings of the unit, which change no motion."""
READERS = {
    2: {
        "Real": "Real",
        "Integer": "Integer",
        "Enumeration": "Integer",
        "Boolean": "Boolean",
        "String": "String",
    },
    3: {
        "Float64": "Float64",
        "Int32": "Int32",
        "Enumeration": "Int64",
        "Boolean": "Boolean",
        "String": "String",
    },
}
"""FMPy's functions for each type of variable, by the version of FMI."""


@pytest.fixture(scope="module")
def declared(description):
    """Continuous unknown -> the knowns that it depends on."""
    return {
        unknown.variable.name: {known.name for known in unknown.dependencies}
        for unknown in (*description.outputs, *description.derivatives)
        if unknown.variable.variability == "continuous"
    }


class Probe:
    """An instance of either version of FMI, of which everything may be read and much be set."""

    def __init__(self, unit, kind, **options):
        self.fmi, self.description = unit.fmi, unit.description
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.model = kind(
            guid=self.description.guid,
            unzipDirectory=unit.folder,
            modelIdentifier="TDMF_SLIP",
            instanceName="runner",
        )
        self.model.instantiate(**options)

    def of_each_type(self, names):
        """(FMPy's name of a type, names of that type)."""
        groups = {}
        for name in names:
            groups.setdefault(READERS[self.fmi][self.variables[name].type], []).append(name)
        return groups.items()

    def read(self, names):
        """Values by name, of any type."""
        values = {}
        for kind, members in self.of_each_type(names):
            references = [self.variables[name].valueReference for name in members]
            values.update(zip(members, getattr(self.model, f"get{kind}")(references), strict=True))
        return values

    def write(self, name, value):
        ((kind, _),) = self.of_each_type([name])
        getattr(self.model, f"set{kind}")([self.variables[name].valueReference], [value])

    def begin(self, start, time=0.0):
        """Into Initialization Mode, with start values."""
        if self.fmi == 2:
            self.model.setupExperiment(startTime=time)
            self.model.enterInitializationMode()
        else:
            self.model.enterInitializationMode(startTime=time)
        for name, value in start.items():
            self.write(name, value)

    def update(self):
        self.model.newDiscreteStates() if self.fmi == 2 else self.model.updateDiscreteStates()

    def states(self):
        values = (ctypes.c_double * len(STATES))()
        self.model.getContinuousStates(values, len(STATES))
        return list(values)

    def set_states(self, values):
        self.model.setContinuousStates((ctypes.c_double * len(STATES))(*values), len(STATES))


class Unit:
    """The unit of a version of FMI, and what its description declares."""

    def __init__(self, fmi, folder):
        self.fmi = fmi
        self.description = fmpy.read_model_description(tdmf_slip.fmu_path(fmi=fmi))
        self.folder = fmpy.extract(str(tdmf_slip.fmu_path(fmi=fmi)), str(folder))

    def exchange(self):
        return Probe(self, FMU2Model if self.fmi == 2 else FMU3Model)

    def stepper(self, **options):
        return Probe(self, FMU2Slave if self.fmi == 2 else FMU3Slave, **options)

    def declared(self, *groups):
        """Unknown -> names of all that it depends on."""
        return {
            unknown.variable.name: {known.name for known in unknown.dependencies}
            for group in groups
            for unknown in getattr(self.description, group)
        }


@pytest.fixture(scope="module", params=[2, 3], ids=["FMI 2.0", "FMI 3.0"])
def version(request, tmp_path_factory):
    return Unit(request.param, tmp_path_factory.mktemp("unit"))


class Observed:
    """Which unknowns have been seen to follow which knowns at once."""

    def __init__(self, unknowns):
        self.of = {name: set() for name in unknowns}

    def compare(self, known, before, after):
        """Note what has changed by more than rounding: states of a mode follow from those that are seen."""
        for name, values in self.of.items():
            old, new = before[name], after[name]
            is_text = isinstance(old, str)
            if old != new and (is_text or not math.isclose(old, new, rel_tol=1e-10, abs_tol=1e-10)):
                values.add(known)


UNLOADED_EARLY = (
    {"foot.y": 0, "foot.vx": 0, "foot.vy": -0.1, "leg.length": 0.9, "leg.angle": 0.6, "leg.angle_rate": 0.5},
    {"leg.extension": -0.3, "control.touchdown_angle": -2},
)
"""Start and jumps of inputs of a foot that grazes before mid-stance, which no random start comes to."""
PATCHES = [(-30, 30), (0, 30), (40, 60)]
"""Patches of ground below the foot, near it and elsewhere."""


def elsewhere(draw, name, value):
    """A little off, and two jumps."""
    return [value + 1e-3, *(draw.uniform(*WIDE.get(name, (-2, 2))) for _ in range(2))]


def move_inputs(probe, observed, draw, names):
    """Set each of these inputs elsewhere, and back."""
    before = probe.read(observed.of)
    for known in names:
        (value,) = probe.read([known]).values()
        for other in elsewhere(draw, known, value):
            probe.write(known, other)
            observed.compare(known, before, probe.read(observed.of))
        probe.write(known, value)
    assert probe.read(observed.of) == before


def move_states_and_time(probe, observed, draw):
    """Set each state elsewhere, and the clock, and back."""
    before, states = probe.read(observed.of), probe.states()
    for i, known in enumerate(STATES):
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
    """By a leg that is too short."""
    probe.model.enterContinuousTimeMode()
    states = probe.states()
    states[STATES.index("leg.length")] = 0.01
    probe.set_states(states)
    probe.model.enterEventMode()
    probe.update()


def test_declared_dependencies_are_those_observed(version):
    """Outputs of every type are asked in event mode and in continuous time: none is missing or idle."""
    draw = random.Random(2016)
    declared = version.declared("outputs", "derivatives", "eventIndicators")
    observed = Observed(declared)
    seen = set()
    for i in range(STARTS):
        probe = version.exchange()
        start, jumps = random_start(draw) | {"hip.swing_clamp": i % 4 < 2}, {}
        if i % 2:  # inputs that have jumped since, and a ground that waits
            jumps = {name: draw.uniform(*WIDE.get(name, (-0.1, 0.1))) for name in INPUTS}
        if i == 1:
            start, jumps = UNLOADED_EARLY
        probe.begin(start)
        probe.model.exitInitializationMode()
        probe.update()
        for name, value in jumps.items():
            probe.write(name, value)
        probe.update()
        if i % 10 == 0:
            fall(probe)
        now = probe.read(["contact.mode_index", "ground.pending", "status.fallen"])
        seen |= {(name, int(value)) for name, value in now.items()}
        move_inputs(probe, observed, draw, INPUTS)
        probe.model.enterContinuousTimeMode()
        move_states_and_time(probe, observed, draw)
        move_inputs(probe, observed, draw, CONTINUOUS_INPUTS)
        probe.model.freeInstance()
    assert seen >= {*(("contact.mode_index", mode) for mode in ALL_MODES)}
    assert seen >= {(name, value) for name in ("ground.pending", "status.fallen") for value in (0, 1)}
    assert observed.of == declared


def runs_in_steps(version, early, **options):
    """What is seen to follow inputs at communication points, and the strides, falls and events meanwhile."""
    draw = random.Random(22)
    observed = Observed(version.declared("outputs"))
    strides, falls, events = 0, 0, 0
    for i in range(RUNS):
        probe = version.stepper(**options)
        grazes = UNLOADED_EARLY[0] | UNLOADED_EARLY[1]
        probe.begin(grazes if i == 1 else {} if i % 3 == 0 else random_start(draw))
        probe.model.exitInitializationMode()
        time = 0.0
        for k in range(20):
            if early:
                probe.update()
                probe.model.enterStepMode()
            step = draw.uniform(0.1, 6.0) if (i, k) != (1, 0) else 0.01
            done = probe.model.doStep(time, step)
            time = done[3] if early else time + step
            move_inputs(probe, observed, draw, INPUTS)
            if early:
                events += bool(done[0])
                probe.model.enterEventMode()
                move_inputs(probe, observed, draw, INPUTS)
        end = probe.read(["stride.count", "status.fallen"])
        strides, falls = strides + end["stride.count"], falls + end["status.fallen"]
        probe.model.freeInstance()
    return observed.of, strides, falls, events


def inputs_declared(version):
    return {name: known & set(INPUTS) for name, known in version.declared("outputs").items()}


def test_at_communication_points_outputs_follow_the_declared_inputs(version):
    observed, strides, falls, _ = runs_in_steps(version, early=False)
    assert strides > RUNS // 3 and falls > RUNS // 12
    assert observed == inputs_declared(version)


def test_so_they_do_where_an_event_is_found_and_not_taken_yet(tmp_path):
    version = Unit(3, tmp_path)
    options = {"eventModeUsed": True, "earlyReturnAllowed": True}
    observed, strides, falls, events = runs_in_steps(version, early=True, **options)
    assert strides > RUNS // 6 and falls > RUNS // 12 and events > 4 * RUNS
    assert observed == inputs_declared(version)


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


def test_initial_unknowns_follow_the_declared_start_values(version):
    """No dependency is missing, and those declared are seen; one of a whole start by any unknown."""
    draw = random.Random(29)
    declared = version.declared("initialUnknowns")
    observed = Observed(declared)
    variables = version.description.modelVariables
    settable = [v for v in variables if v.initial == "exact" or v.causality == "input"]
    whole_start = {v.name for v in settable} - OF_THE_UNIT | {"time"}
    read, refused = Counter(), 0
    for i in range(INITIAL_STARTS):
        start, time = initial_start(draw, i), draw.choice([0.0, 2.0])
        probe, later = version.exchange(), version.exchange()
        probe.begin(start, time)
        later.begin(start, time + 5.0)
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
    assert sum(map(len, missed.values())) <= (
        0 if RELEASE else 0.15 * sum(len(declared[name]) for name in missed)
    )


def difference(instance, unknowns, known):
    """Central differences of the unknowns by an input, in event mode, or by a state, in continuous time."""
    step, sides = 1e-5, []
    if known in INPUTS:
        value = instance.real(known)[0]
        for sign in (-1, 1):
            instance.set_values({known: value + sign * step})
            sides.append(instance.real(*unknowns))
        instance.set_values({known: value})
    else:
        states = instance.continuous_states()
        for sign in (-1, 1):
            instance.set_continuous_states(states + sign * step * (np.array(instance.states) == known))
            sides.append(instance.real(*unknowns))
        instance.set_continuous_states(states)
    return (np.array(sides[1]) - np.array(sides[0])) / (2 * step)


def derivative(instance, unknowns, known):
    references = [instance.references[name] for name in unknowns]
    return np.array(instance.model.getDirectionalDerivative(references, [instance.references[known]], [1.0]))


def test_directional_derivatives_in_a_run_are_differences(new_instance, declared):
    """Every continuous output and state derivative is varied by every input and every state."""
    draw = random.Random(14)
    unknowns = sorted(set(declared) - {"der(hip.positive_work)"})  # has a kink where the power is zero
    compared, modes = 0, set()
    for _ in range(60):
        start = random_start(draw)
        instance = new_instance()
        instance.set_values(start)
        instance.start()
        if abs(start["leg.angle"]) < 0.2:
            continue  # in graze the torque is steep near upright
        modes.add(instance.integer("contact.mode"))
        for knowns in (INPUTS, instance.states):
            for known in knowns:
                exact = derivative(instance, unknowns, known)
                size = 1e-6 * (1.0 + np.max(np.abs(exact)))
                assert difference(instance, unknowns, known) == pytest.approx(exact, abs=size), known
                compared += 1
            if knowns is INPUTS:
                instance.model.enterContinuousTimeMode()
    assert modes == ALL_MODES and compared > 40 * 25
