"""Hostile values in place of every argument of every public function: refused in a sentence, or taken."""

import collections.abc
import datetime
import decimal
import inspect
import itertools
import pathlib

import numpy as np
import pandas
import pytest
import tdmf_slip
from conftest import RELEASE
from tdmf_slip import Profile, TdmfSlipError

FRICTION, ANGLE, TORQUE = "ground.friction", "hip.touchdown_angle", "hip.stance_torque"
HOME = {FRICTION: 0.6}
AXES = {"com_height": (1.3, 1.4), "com_speed": (1.0, 1.1)}
SPEEDS = pandas.DataFrame({"speed [m/s]": [1.06], "speed_error [m/s]": [0.1]})


class OwnError(Exception):
    """Error that methods of hostile objects raise."""


def fail(*_given, **_named):
    raise OwnError


class Unprintable:
    __repr__ = __str__ = fail


class Number(float):
    __float__ = __repr__ = __str__ = fail


class Array:
    __array__ = fail


class Truth:
    __bool__ = fail


class Path:
    __fspath__ = fail


class Row(collections.abc.Sequence):
    __getitem__ = __iter__ = fail

    def __len__(self):
        return 2


class List(list):
    __len__ = __iter__ = fail


class Names(collections.abc.Mapping):
    __getitem__ = __iter__ = fail

    def __len__(self):
        return 2


class Series:
    to_numpy = items = fail


class Table(Series):
    columns = ("a",)
    __getitem__ = fail


def nested():
    row = []
    row.append(row)
    return row


HOSTILE = {
    "what raises as it is read": [
        *(
            Unprintable(),
            Number(1.0),
            Array(),
            Truth(),
            Path(),
            Row(),
            List([1, 2]),
            Names(),
            Series(),
            Table(),
        ),
        *({FRICTION: Unprintable()}, {Unprintable(): 1.0}, [Unprintable()] * 6),
    ],
    "numbers": [np.nan, -1, 10**400, 1j, True, decimal.Decimal("sNaN"), np.timedelta64(1, "s")],
    "texts": ["", "a\0b", "\ud800", "x" * 100_000, b"abc", "1_0", pathlib.Path("/")],
    "dates": [datetime.datetime(2026, 1, 1), pandas.Timestamp("2026-01-01"), pandas.NaT, pandas.NA],
    "rows": [
        [],
        [[1, 2], [3]],
        ["a"],
        [None],
        [1j] * 6,
        [True] * 6,
        [np.nan] * 6,
        range(10**12),
        nested(),
        {1},
    ],
    "names": [{3: 4}, {FRICTION: None}, {FRICTION: [1, [2]]}, {FRICTION: (np.nan, 1)}, {("a", "b"): 2}],
    "arrays": [
        *(np.array(["2026"] * 6, "M8[D]"), np.ma.masked_array(np.ones(6), [1, 0, 0, 0, 0, 0]), np.ma.masked),
        *(np.ones(6) * 1j, np.ones((2, 2, 2)), np.empty(0), np.array([object()] * 6), np.zeros(2, "f8,f8")),
    ],
    "tables": [
        *(pandas.Series(["a", "b"]), pandas.DataFrame({"a": [1.0, 2.0]}), pandas.Index(["a"])),
        *(
            pandas.DataFrame({FRICTION: pandas.array([1, None], "Int64")}),
            pandas.DataFrame({("a", "b"): [1]}),
        ),
    ],
    "things": [object(), Ellipsis, slice(1), ValueError("x")],
}


@pytest.fixture(scope="module")
def calls(gait):
    """A call of each function that does little, by what it is called."""
    law = tdmf_slip.dead_beat(gait, [ANGLE, TORQUE])
    apex = gait.apex.tolist()
    ground = Profile([0, 1], [0, 1])
    held = {"gait": gait, "inputs": [ANGLE, TORQUE]}
    optimal = {"vary": {TORQUE: (0.2, 0.21)}, "starts": 1, "model": "reduced"}
    return {
        tdmf_slip.find_gait: {"runner": HOME, "target": {"speed": 1.05}, "vary": [TORQUE]},
        tdmf_slip.simulate: {"stop_time": 0.1},
        tdmf_slip.new: {"name": "page"},
        tdmf_slip.load_model: {"path": "nothing"},
        tdmf_slip.simulate_many: {"runners": [HOME], "strides": 1},
        tdmf_slip.sweep: {"runner": HOME, "vary": {FRICTION: [0.6]}},
        tdmf_slip.continue_branch: {"runner": HOME, "vary": {FRICTION: (0.6, 0.601)}, "max_points": 1},
        tdmf_slip.trajectory: {
            "runner": HOME,
            "apex": [1.2, 1.0, 1.0, 0.7, 0.0, 0.0],
            "times": [0.0, 0.5],
            "derivatives": ["com_speed"],
        },
        tdmf_slip.continue_curves: {
            "runner": HOME,
            "vary": {FRICTION: (0.6, 0.601), ANGLE: (0.785, 0.786)},
            "max_points": 1,
        },
        tdmf_slip.stability: {"runner": HOME, "vary": {FRICTION: [0.6]}},
        tdmf_slip.attraction_volume: {"gait": gait, "samples": 2, "ball": "none"},
        tdmf_slip.classic_gaits: {"angle": 0.7},
        tdmf_slip.classic_fold: {},
        tdmf_slip.library_path: {},
        tdmf_slip.basin: {"runner": HOME, "axes": AXES, "n": 2, "ball": "none"},
        tdmf_slip.controllability: held,
        tdmf_slip.dead_beat: held,
        tdmf_slip.lqr: held,
        tdmf_slip.place_poles: {**held, "eigenvalues": [0.5, -0.2, 0.01]},
        tdmf_slip.apex_covariance: {"feedback": law},
        tdmf_slip.compare: {"runners": [HOME, HOME], "hold": ["speed"], "vary": [TORQUE], "model": "reduced"},
        tdmf_slip.fit: {
            "runner": HOME,
            "data": SPEEDS,
            "vary": [TORQUE],
            "profile": False,
            "model": "reduced",
        },
        tdmf_slip.optimize: {"runner": HOME, **optimal, "minimize": "cost_of_transport"},
        tdmf_slip.pareto_front: {
            "runner": HOME,
            **optimal,
            "minimize": ["cost_of_transport"],
            "maximize": ["speed"],
            "points": 3,
        },
        tdmf_slip.stride_map: {"runner": HOME, "apices": [apex]},
        tdmf_slip.strides_to_fall: {
            "runner": HOME,
            "roughness": 0.3,
            "runners": 1,
            "max_strides": 1,
        },
        tdmf_slip.rare_falls: {"runner": HOME, "roughness": 0.1, "walkers": 2, "strides": 2},
        tdmf_slip.viability: {
            "runner": HOME,
            "axes": AXES,
            "vary": {ANGLE: [0.7, 0.8]},
            "n": 2,
        },
        tdmf_slip.load_fmu: {},
        tdmf_slip.fmu_path: {},
        tdmf_slip.prove: {"gait": HOME, "digits": 0},
        tdmf_slip.tube_along: {"gait": HOME, "radius": "0.1"},
        tdmf_slip.prove_border: {"border": 0.5, "digits": 0},
        tdmf_slip.validate: {"tolerance": 0.0},
        Profile: {"x": [0, 1], "y": [0, 1]},
        Profile.steps: {"edges": [1, 2], "heights": [0, 1, 0]},
        Profile.random_steps: {"count": 3, "tread": 1.0, "roughness": 0.1, "seed": 1},
        ground.height: {"x": [0, 1]},
        ground.line: {"x": 0.0},
        tdmf_slip.Runner: {"given": HOME},
        gait.runner.replace: {"values": {FRICTION: 0.3}},
        gait.runner.state_at: {"apex": apex},
        gait.runner.start_values: {"apex": apex},
        tdmf_slip.AffineLaw: {
            **{"inputs": [ANGLE], "nominal": [0.7], "gain": [[0.0] * 6]},
            **{"apex": apex, "low": [0.1], "high": [1.0]},
        },
        law.inputs_at: {"apex": apex},
    }


NOT_CALLED = {"build", "gait_at", "plot", "prove_attraction"}
"""`build` runs its page, and `prove_attraction` proves before it can refuse. The others take results."""


def test_every_public_function_is_called(calls):
    functions = {name for name in tdmf_slip.__all__ if inspect.isfunction(getattr(tdmf_slip, name))}
    assert functions - {function.__name__ for function in calls} == NOT_CALLED


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", HOSTILE)
def test_hostile_values_are_refused_in_a_sentence_or_taken(calls, kind, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    problems, refused, values, turns = [], 0, HOSTILE[kind], itertools.count()
    for function, given in calls.items():
        for name in inspect.signature(function).parameters:
            turn = next(turns) % len(values)  # with --release all, else each in its turn
            for value in values if RELEASE else values[turn : turn + 1]:
                try:
                    function(**{**given, name: value})
                except TdmfSlipError as problem:
                    refused += 1
                    if len(str(problem)) > 800 or len(str(problem).splitlines()) != 1:
                        problems.append(f"{function.__qualname__}({name}=...): {str(problem)[:200]}")
                except Exception as problem:  # which is what the test is about
                    told = f"{type(problem).__name__} of a {type(value).__name__}"
                    problems.append(f"{function.__qualname__}({name}=...): {told}")
    assert not problems, "\n".join(problems)
    assert refused > 150
