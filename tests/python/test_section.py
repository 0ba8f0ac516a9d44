"""The apex section: there and back, and where the centre of mass is."""

import numpy as np
import pytest
from tdmf_slip import Runner

APEX = (1.4, 1.1, 0.97, 0.6, -0.03, 0.2)


@pytest.mark.parametrize("masses", [{}, {"body.mass": 80.0, "foot.mass": 4.0}])
def test_the_state_at_an_apex_has_its_centre_of_mass_there(masses):
    """The centre of mass weights the bodies' positions and velocities (7) by their masses."""
    runner = Runner(masses)
    values = runner.state_at(APEX)
    body, foot = masses.get("body.mass", 1.0), masses.get("foot.mass", 0.1)
    r, angle = values["leg.length"], values["leg.angle"]
    rate, turn = values["leg.length_rate"], values["leg.angle_rate"]
    along, across = np.array([-np.sin(angle), np.cos(angle)]), np.array([-np.cos(angle), -np.sin(angle)])
    foot_position = np.array([values["foot.x"], values["foot.y"]])
    velocity = np.array([values["foot.vx"], values["foot.vy"]])
    center = foot_position + body / (body + foot) * r * along
    moves = velocity + body / (body + foot) * (rate * along + r * turn * across)
    assert (center[1], values["foot.x"]) == pytest.approx((APEX[0], 0.0), abs=1e-14)
    assert moves == pytest.approx([APEX[1], 0.0], abs=1e-14)
    assert Runner(masses | values).apex() == pytest.approx(APEX, rel=1e-14)
    assert runner.start_values(APEX) == {**runner, **values}


def test_scales_are_those_of_the_runner():
    runner = Runner({"leg.free_length": 2.0, "leg.stiffness": 27.0, "body.mass": 3.0})
    assert runner.scales == pytest.approx((2.0, 6.0, 2.0, 1.0, 6.0, 3.0))
