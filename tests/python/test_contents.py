"""Results are compared by their contents, wherever arrays and NaN are in them."""

import copy
import dataclasses
import importlib
import inspect
import math
import pickle
import pkgutil
import re

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip.analysis.search import periodic_gait
from tdmf_slip.contents import ByContents, same
from tdmf_slip.fitting.measurements import Measured, Measurements
from tdmf_slip.optimization.pareto import Front

FRICTION = "ground.friction"
RESULTS = {
    "a gait": lambda: periodic_gait({FRICTION: 0.6}, along=FRICTION),
    "a run": lambda: tdmf_slip.simulate({FRICTION: 0.6}, strides=2),
    "a sweep": lambda: tdmf_slip.sweep({}, {"ground.friction": [0.5, 0.6]}),
    "a branch": lambda: tdmf_slip.continue_branch({}, {FRICTION: (0.5, 0.6)}, switch=False),
    "a fit": lambda: tdmf_slip.fit(
        None, Measurements(({"speed": Measured(1.0, 0.01)},), "one"), ["hip.stance_torque"]
    ),
    "a feedback": lambda: tdmf_slip.lqr(tdmf_slip.find_gait({FRICTION: 0.6}), ["hip.stance_torque"]),
    "what can be controlled": lambda: tdmf_slip.controllability(
        tdmf_slip.find_gait({FRICTION: 0.6}), ["hip.stance_torque"]
    ),
    "an optimum": lambda: tdmf_slip.optimize(
        {}, {"hip.stance_torque": (0.15, 0.3)}, minimize="slip_distance", starts=1
    ),
}


@pytest.mark.parametrize("name", RESULTS)
def test_copies_are_equal_and_what_differs_is_not(name):
    one = RESULTS[name]()
    for other in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one), dataclasses.replace(one)):
        assert (one == other) is True and (one != other) is False
        assert other in [None, one] and [one].index(other) == 0
    assert (one == None) is False and one not in ["a text", 3, np.zeros(3)]  # noqa: E711 # None is compared
    with pytest.raises(TypeError, match=f"^{type(one).__name__} is compared by its contents and has no hash"):
        hash(one)


def test_a_single_number_makes_a_difference():
    gait = RESULTS["a gait"]()
    for field in ("apex", "jacobian", "by_parameter"):
        array = getattr(gait, field).copy()
        array.flat[-1] = np.nextafter(array.flat[-1], 9.0)
        assert gait != dataclasses.replace(gait, **{field: array}), field
    assert gait != dataclasses.replace(gait, stride={**gait.stride, "speed": math.nan})
    assert gait != dataclasses.replace(gait, word="+")
    nothing = dataclasses.replace(gait, stride={**gait.stride, "speed": math.nan})
    assert nothing == pickle.loads(pickle.dumps(nothing))
    run = RESULTS["a run"]()
    table = run.table.copy()
    table["time"][1] += 1e-9
    assert run != dataclasses.replace(run, table=table)


def test_nan_is_nan_at_any_depth():
    one, other = ({"a": [1.0, (float("nan"), np.array([np.nan, 2.0]))]} for _ in range(2))
    assert same(one, other)
    assert not same(one, {"a": [1.0, (0.0, np.array([np.nan, 2.0]))]})
    assert not same(np.array([1.0, 2.0]), np.array([1.0])) and not same(np.array([1.0]), [1.0])
    assert not same({"a": 1}, {"b": 1}) and not same([1], [1, 2]) and not same([1], (1,))
    texts = np.array(["a", None], dtype=object)
    assert same(texts, texts.copy()) and not same(texts, np.array(["a", "b"], dtype=object))


def classes():
    """All but those of proofs, whose numbers are balls: two that are alike are not known to be equal."""
    for module in pkgutil.walk_packages(tdmf_slip.__path__, "tdmf_slip."):
        if any(part in module.name for part in (".peers", ".proof", "__main__")):
            continue
        for one in vars(importlib.import_module(module.name)).values():
            if inspect.isclass(one) and dataclasses.is_dataclass(one) and one.__module__ == module.name:
                yield one


def test_no_other_dataclass_has_an_array_in_it():
    """`==` of a plain one would give an array, or raise."""
    found = {one: " ".join(str(field.type) for field in dataclasses.fields(one)) for one in classes()}
    assert len(found) > 80 and Front in found
    arrays = {one for one, types in found.items() if "ndarray" in types}
    while True:  # and of what has one of these in it
        names = "|".join(one.__name__ for one in arrays)
        more = {one for one, types in found.items() if re.search(rf"\b({names})\b", types)} - arrays
        if not more:
            break
        arrays |= more
    assert len(arrays) > 40
    plain = {one for one in arrays if not issubclass(one, ByContents)}
    assert {one for one in plain if "Callable" not in found[one]} == set()
    wrong = {one for one in arrays - plain if "__eq__" in vars(one) or "__hash__" in vars(one)}
    assert wrong == set()


def test_a_profile_is_equal_by_its_points_and_tells_of_them():
    ramp = tdmf_slip.Profile([0.0, 10.0], [0.0, 1.0])
    assert ramp == tdmf_slip.Profile([0, 10], [0, 1]) != tdmf_slip.Profile([0.0, 10.0], [0.0, 2.0])
    assert repr(ramp) == "<Profile of 2 points: positions 0 to 10 m, heights 0 to 1 m>"
    assert repr(tdmf_slip.load_fmu()).startswith("<Fmu TDMF_SLIP by FMI 2.0: ")
