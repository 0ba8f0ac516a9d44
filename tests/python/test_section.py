"""The apex section: there and back, and where the centre of mass is."""

import numpy as np
import pytest
from tdmf_slip import load
from tdmf_slip.unit import section

APEX = (1.4, 1.1, 0.97, 0.6, -0.03, 0.2)


@pytest.mark.parametrize("masses", [{}, {"body.mass": 80.0, "foot.mass": 4.0}])
def test_start_values_put_the_centre_of_mass_at_the_apex(masses):
    """By its own definition: the bodies' places and velocities (7), weighted by their masses."""
    values = section.start_values(load(), APEX, masses)
    body, foot = masses.get("body.mass", 1.0), masses.get("foot.mass", 0.1)
    r, angle = values["leg.length"], values["leg.angle"]
    rate, turn = values["leg.length_rate"], values["leg.angle_rate"]
    along, across = np.array([-np.sin(angle), np.cos(angle)]), np.array([-np.cos(angle), -np.sin(angle)])
    place = np.array([values["foot.x"], values["foot.y"]])
    velocity = np.array([values["foot.vx"], values["foot.vy"]])
    center = place + body / (body + foot) * r * along
    moves = velocity + body / (body + foot) * (rate * along + r * turn * across)
    assert center == pytest.approx([0.0, APEX[0]], abs=1e-14)
    assert moves == pytest.approx([APEX[1], 0.0], abs=1e-14)
    assert section.apex_of(values | {"body.mass": body, "foot.mass": foot}) == pytest.approx(APEX, rel=1e-14)


def test_scales_are_those_of_the_runner():
    starts = {"leg.free_length": 2.0, "leg.stiffness": 27.0, "body.mass": 3.0}
    assert section.scales(load(), starts) == pytest.approx((2.0, 6.0, 2.0, 1.0, 6.0, 3.0))
