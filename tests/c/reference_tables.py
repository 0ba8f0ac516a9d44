"""Make the reference values in C of the JSON files that the tests in Python read, so that they stand once.

    reference_tables.py ROOT OUTPUT

ROOT is the repository. OUTPUT is a folder, for a header with each table.
"""

import json
import pathlib
import sys

APEX = ("com_height", "com_speed", "leg_length", "leg_angle", "leg_length_rate", "leg_angle_rate")
EVENTS = {
    "touchdown": "TOUCHDOWN",
    "td": "TOUCHDOWN",
    "slip_velocity_zero": "SLIP_VELOCITY_ZERO",
    "v0": "SLIP_VELOCITY_ZERO",
    "slip_onset": "SLIP_ONSET",
    "slip": "SLIP_ONSET",
    "midstance": "MID_STANCE",
    "mid": "MID_STANCE",
    "liftoff_into_graze": "LIFT_OFF_INTO_GRAZE",
    "lo-graze": "LIFT_OFF_INTO_GRAZE",
    "graze_end": "GRAZE_END",
    "graze-end": "GRAZE_END",
    "clamp": "CLAMP_RELEASE",
    "apex": "APEX",
    "thrust": "THRUST_BEGINS",
}
GUARDS = {
    "touchdown": "TOUCHDOWN",
    "rest": "SLIP_VELOCITY_ZERO",
    "slip-": "SLIP_ONSET_NEGATIVE",
    "slip+": "SLIP_ONSET_POSITIVE",
    "midstance": "MID_STANCE",
    "liftoff": "LIFT_OFF",
    "fly": "GRAZE_TO_FLIGHT",
    "clamp": "CLAMP",
    "apex": "APEX",
}


def written(value):
    """A value as an initializer: text that stands for itself in C is a `Name`."""
    if isinstance(value, dict):
        return "{" + ", ".join(f".{name} = {written(item)}" for name, item in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "{" + ", ".join(written(item) for item in value) + "}"
    if isinstance(value, Name):
        return str(value)
    return f'"{value}"' if isinstance(value, str) else repr(value)


class Name(str):
    """An enumerator of C."""


def table(kind, name, rows):
    """The definition of a table."""
    lines = ",\n".join(f"    {written(row)}" for row in rows)
    return f"/* Made by reference_tables.py. */\nconst {kind} {name}[] = {{\n{lines}}};\n"


def degrees(values, name, default=0.0):
    """A start value in degrees, which is given with its unit."""
    return float(str(values.get(name, f"{default} deg")).removesuffix(" deg"))


def reference(gait, friction, swing_clamp, work):
    """A `reference_gait`."""
    same = ("word", "period", "length", "speed", "cost_of_transport", "liftoff_angle")
    known = ("positive_work", "slip_distance", "stance_time", "jacobian")
    events = [(time, EVENTS[event]) for event, time in gait["events"]]
    if "clamp_release" in gait:
        events = sorted([*events, (gait["clamp_release"], "CLAMP_RELEASE")])
    return {
        "friction": friction,
        "swing_clamp": Name(str(swing_clamp).lower()),
        "work": work,
        "apex": dict(zip(APEX, gait["apex"], strict=True)),
        "events": [(Name(event), time) for time, event in events],
        **{name: gait[name] for name in same},
        **{name: gait[name] for name in known if name in gait},
    }


def published(gait):
    """A `reference_gait` at Table 1 values."""
    return reference(gait, gait["friction"], gait["swing_clamp"], gait["work"])


def further(gait):
    """A `further_gait`."""
    given = gait["start_values"]
    same = ("rise", "leg_work", "external_work", "damper_loss", "friction_loss", "impact_loss")
    return {
        "slope": degrees(given, "ground.slope"),
        "touchdown_angle": degrees(given, "hip.touchdown_angle", 40.0),
        "retraction_rate": given.get("hip.retraction_rate", 0.0),
        "static_friction_ratio": given.get("ground.static_friction_ratio", 1.0),
        "stribeck_velocity": given.get("ground.stribeck_velocity", 0.0),
        "thrust": given.get("leg.thrust", 0.0),
        "external_fx": given.get("body.external_fx", 0.0),
        "external_fy": given.get("body.external_fy", 0.0),
        "gait": reference(gait, given["ground.friction"], True, gait["hip_work"] + gait["leg_work"]),
        **{name: gait[name] for name in same},
    }


def reduced(gait):
    """A `reduced_gait`."""
    given = gait["given"]
    same = ("word", "apex", "period", "length", "speed", "eigenvalues")
    return {
        "friction": given["ground.friction"],
        "touchdown_angle": degrees(given, "hip.touchdown_angle", 40.0),
        "retraction_rate": given.get("hip.retraction_rate", 0.0),
        "static_friction_ratio": given.get("ground.static_friction_ratio", 1.0),
        "slope": degrees(given, "ground.slope"),
        "work": gait["stance_work"],
        **{name: gait[name] for name in same},
    }


def free_stride(stride):
    """A `free_stride`."""
    given = {name.removeprefix("ground."): value for name, value in stride["given"].items()}
    given = {name.removeprefix("leg.").removeprefix("hip."): value for name, value in given.items()}
    return {
        **{name.replace(".", "_"): value for name, value in given.items()},
        "start": stride["apex"],
        **{name: stride[name] for name in ("end", "word", "period", "length", "work", "touchdowns")},
    }


def middle(ball):
    """The middle of a ball that is written as "[... +/- ...]"."""
    return float(ball.strip("[]").split(" ")[0])


def proved(gait):
    """A `proved_gait`."""
    return {
        "friction": float(gait["friction"]),
        "period": middle(gait["period"]),
        "length": middle(gait["length"]),
        "apex": [middle(ball) for ball in gait["apex"]],
        "event_count": len(gait["events"]),
        "events": [(Name(f"TDMF_GUARD_{GUARDS[event]}"), middle(time)) for event, time in gait["events"]],
    }


def extended(stride):
    """An `extended_stride`."""
    events = [(Name(f"TDMF_GUARD_{event.upper()}"), time) for event, time in stride["events"]]
    counts = {"apex_count": len(stride["apex"]), "event_count": len(events)}
    return {**stride, "swing_clamp": Name(str(stride["swing_clamp"]).lower()), "events": events, **counts}


def patch(run):
    """A `patch_run`."""
    given, end, first = run["start_values"], run["end"], run.get("first", {"apex": [0.0], "foot.x": 0.0})
    fall, crossings = run.get("fall", {"time": 0.0, "state": [0.0]}), run.get("crossings", [])
    return {
        "friction": given["ground.friction"],
        "static_friction_ratio": given.get("ground.static_friction_ratio", 0.0),
        "stribeck_velocity": given.get("ground.stribeck_velocity", 0.0),
        "slope": given.get("ground.slope", 0.0),
        "begin": given.get("ground.patch_begin", 0.0),
        "end": given.get("ground.patch_end", 0.0),
        "patch_friction": given.get("ground.patch_friction", 0.0),
        "start": run["apex"],
        "strides": len(run["words"]),
        "words": run["words"],
        "end_apex": end["apex"],
        "end_foot_x": end["foot.x"],
        "end_time": end.get("time", 0.0),
        "first_apex": first["apex"],
        "first_foot_x": first["foot.x"],
        "crossings": len(crossings),
        "crossing_times": crossings or [0.0],
        "last": run.get("last", {"period": 0.0}),
        "fall_time": fall["time"],
        "fall_state": fall["state"],
    }


def main(root, output):
    """Write all tables."""

    def rows(path, member="gaits"):
        return json.loads((root / path).read_text(encoding="utf-8"))[member]

    python = pathlib.Path("tests/python")
    gaits = rows("scripts/tdmf_slip/paper/reference_gaits.json") + rows(python / "free_swing.json")
    clamped = [gait for gait in gaits if gait["swing_clamp"]]
    rows_of = {
        "reference_gait": [published(gait) for gait in gaits],
        "further_gait": [further(gait) for gait in rows(python / "further_gaits.json")],
        "reduced_gait": [reduced(gait) for gait in rows(python / "reduced_gaits.json")],
        "proved_gait": [
            proved(gait)
            for given in clamped
            for gait in rows(python / "proved_gaits.json")
            if float(gait["friction"]) == given["friction"]
        ],
        "free_border": [
            {"friction": border["friction"], "above": border["from"], "below": border["to"]}
            for border in rows(python / "free_swing.json", "borders")
        ],
        "free_stride": [free_stride(stride) for stride in rows(python / "free_swing.json", "strides")],
        "extended_stride": [
            extended(stride)
            for stride in rows(pathlib.Path("tests/extended_precision/strides.json"), "strides")
        ],
        "patch_run": [patch(run) for run in rows(python / "patch_runs.json", "runs")],
    }
    output.mkdir(parents=True, exist_ok=True)
    for kind, its_rows in rows_of.items():
        text = table(kind, f"{kind}s", its_rows)
        (output / f"{kind}s_table.h").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
