"""Which motions are expanded into series, in which cases, and what of them is noted: a header a mode."""

from functools import partial
from typing import Any

from .. import constants, flight, ground, hip
from .c import comment, header, struct
from .law_series import law_series
from .motion import Family
from .values import Function, Record, members

GROUND = Family(
    "ground",
    ground,
    start="x y vx vy foot_vx",
    constants=members(constants.on_ground),
    ramps=dict.fromkeys(("rest_length", "gravity_x", "gravity_y", "friction", "torque"), "ramp"),
    rates={"length_rate": "length"},
    noted="length length_rate normal_force tangential_push torque power speed_square",
    varied="torque power friction_power",
    cases={
        # Without a torque the leg does not turn, but a torque that varies would turn it.
        "stick": {"contact": "stick", "has_torque": False, "noted": "square turning along off"},
        "stick_with_torque": {"contact": "stick", "has_torque": True},
        "slip": {"contact": "slip", "has_torque": False, "noted": "square turning along off friction_power"},
        "slip_with_torque": {"contact": "slip", "has_torque": True, "noted": "friction_power"},
        "falling_slip": {"contact": "slip", "has_torque": True, "falls": True, "noted": "friction_power"},
        "graze": {"contact": "graze", "has_torque": True, "noted": "angle_rate axial_y"},
    },
)

FLIGHT = Family(
    "flight",
    flight,
    start="length angle length_rate angle_rate",
    constants=members(constants.of_flight),
    ramps={"torque": "drift", "rest_length": "ramp", "push_x": "ramp", "push_y": "ramp"},
    rates={},
    noted="square angle_rate rate_square speed_square",
    varied="torque power",
    cases={
        "flight": {"pushed": False, "ramp": False},
        "pushed_flight": {"pushed": True, "noted": "push_moment"},
    },
)
FAMILIES = {"flight": FLIGHT, "ground": GROUND}


def of_cases(mode: str, family: Family, cases: list[str]) -> str:
    """Write a header of some cases; without a torque variations are those of a leg that turns."""
    parts = [family.motion(case).source() for case in cases]
    parts += [family.motion(case).variation() for case in cases if family.cases[case].get("has_torque", True)]
    is_first = mode == family.name
    include = "series_products.h" if is_first else f"{family.name}_series.h"
    parts = [family.structs(), *parts] if is_first else parts
    return header(f"{mode}_series", f"{family.name}.py", f'#include "{include}"\n', *parts)


# The structs that the model has the coordinates in.
COORDINATES = {"flight": "tdmf_flying", "ground": "tdmf_standing"}


def copies() -> str:
    """Write copies between what motions start with and the coordinates of the model."""
    parts = []
    for name, family in FAMILIES.items():

        def same(at: Any, family: Family = family) -> Record:
            """What a motion starts with, of the model's coordinates, or back."""
            return Record(**{name: getattr(at, name) for name in family.start})

        model, start = COORDINATES[name], f"{name}_start"
        parts += [
            Function(start, f"{name}_start_of", {"at": f"const {model} *"}, same, varied=False).c(),
            Function(
                "void", f"set_{name}", {"at": f"const {start} *", "written": f"{model} *"}, same, varied=False
            ).c(),
        ]
    includes = "".join(f'#include "{name}.h"\n' for name in ("coordinate_laws", "motion_series"))
    return header("motion_coordinates", "flight.py and ground.py", includes, *parts)


def ends() -> str:
    """Write where motions lead."""
    includes = '#include "motion_series.h"\n#include "step_sums.h"\n'
    ends = [family.end() for family in FAMILIES.values()]
    return header("motion_ends", "flight.py and ground.py", includes, *ends)


LAW = members(hip.signed)
SERVO: dict[str, Any] = {name: f"servo->{name}" for name in LAW if name != "torque_rate"}
SERVO["torque"] = ("servo->torque", "servo->torque_rate")
SLOPE = {"sine": "slope_sine", "cosine": "slope_cosine"}
CONE = {"normal": ("cone_normal", "cone_normal_rate"), "tangential": "cone_tangential"}


def guard_series() -> str:
    """Write guards that are made of series of the motion, and what they are made of."""
    return header(
        "guard_series",
        "ground.py, flight.py and hip.py",
        '#include "series_products.h"\n',
        comment(hip.signed.__doc__) + struct("signed_law", LAW, "real"),
        law_series(ground.ahead, {"slope": SLOPE}),
        law_series(ground.room, {"cone": CONE, "side": "side"}),
        law_series(ground.rise, {"slope": SLOPE, "share": "share"}),
        law_series(ground.lever, {}),
        law_series(ground.load, {"weight_y": "weight_y"}),
        law_series(hip.torque, {"law": SERVO}),
        law_series(flight.drop, {"slope": "slope"}, {"angle": "angle_rate"}),
    )


FILES = {
    "guard_series.h": guard_series,
    "motion_coordinates.h": copies,
    "motion_ends.h": ends,
    "ground_series.h": partial(of_cases, "ground", GROUND, []),
    "stick_series.h": partial(of_cases, "stick", GROUND, ["stick", "stick_with_torque"]),
    "slip_series.h": partial(of_cases, "slip", GROUND, ["slip", "slip_with_torque"]),
    "falling_slip_series.h": partial(of_cases, "falling_slip", GROUND, ["falling_slip"]),
    "graze_series.h": partial(of_cases, "graze", GROUND, ["graze"]),
    "flight_series.h": partial(of_cases, "flight", FLIGHT, list(FLIGHT.cases)),
}
