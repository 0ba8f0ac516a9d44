"""The unit of the runner's page, with the variables that modelDescription.xml declares."""

from ..hybrid.declared import DeclaredUnit
from ..hybrid.limits import C_CORE
from ..hybrid.page import Page
from .runner import Runner

GUARDS = {
    "apex": ["apex", "apex_in_graze"], "clamp": ["clamp", "release"],
    "slip_onset_positive": ["slips_forward"], "slip_onset_negative": ["slips_backward"],
    "slip_velocity_zero": ["comes_to_rest", "enters_layer", "leaves_layer"], "force_peak": ["force_on_foot"],
    "vertical_force_peak": ["vertical_force_on_foot"], "body_down": ["falls"], "leg_too_short": ["collapses"],
    "patch_border": ["crosses_border", "passes_end", "passes_begin"],
}
"""Events, or the observed quantity, behind event indicators that are called otherwise."""


def runner_unit(page=None):
    """The unit of the runner's page, or of a page of that model which has been generated."""
    source = C_CORE.parent / "modelDescription.xml"
    unit = DeclaredUnit(page or Page(Runner), source, GUARDS, "status.terminate_on_fall")
    unit.part = "plain_runner"
    return unit
