"""Names that were replaced: whoever asks for an old one is told the name that it has now."""

from collections.abc import Mapping

NAMES: Mapping[str, str] = {
    "Orbit": "Gait",
    "OrderNotMetError": "TargetNotMetError",
    "Unit": "Fmu",
    "find_orbit": "find_gait",
    "load": "load_fmu",
    "read_parameters": "Runner.of",
    "run_batch": "simulate_many",
    "run_ensemble": "library.ensemble.run_ensemble",
    "simulate_over": "simulate",
}
"""Of the package, from the old to the new."""
OPTIONS: Mapping[str, str] = {
    "--at": "--target QUANTITY=VALUE",
    "--free": "--vary NAME,NAME",
    "--free-each": "--vary-each NAME,NAME",
    "--most-strides": "--max-strides",
    "--over": "--vary NAME=A:B",
    "--piece-length": "--segment-length",
    "--workers": "--threads",
    "--range": "--axes NAME=A:B",
    **{
        f"--{name.replace('_', '-')}": f"--target {name}=VALUE"
        for name in (
            *("speed", "frequency", "length", "stance_time", "duty_factor", "slip_distance", "peak_force"),
            *("peak_vertical_force", "cost_of_transport", "apex_height", "apex_speed", "apex_leg_angle"),
            *("foot_clearance", "greatest_foot_height", "positive_hip_work", "positive_leg_work"),
            *("positive_work", "positive_cost_of_transport", "squared_torque", "greatest_slip_velocity"),
            "friction_loss",
        )
    },
}
"""Of the command."""


def sentence(old: str, new: str) -> str:
    """What a user of an old name is told."""
    return f"{old} is called {new} now"
