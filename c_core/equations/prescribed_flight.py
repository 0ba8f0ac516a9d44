"""Flight in the reduced map: the leg is where the hip is to place it, as one rigid body.

r = l0 + u, theta = theta0 - omega t, t after the apex; the centre of mass is ballistic, at the body's share
of the leg from the foot.
"""

from . import coordinates, free_fall, hip, leg
from .functions import Record


def placed_leg(model, inputs, time):
    """The leg some time after the apex."""
    law = hip.place(model.parameters.hip, inputs.control, time)
    return Record(
        leg_length=leg.rest_length(model, inputs, thrusts=False),
        leg_angle=law.target,
        leg_length_rate=0,
        leg_angle_rate=law.target_rate,
        hip_place_time=time,
    )


def state(model, inputs, start, time):
    """The state some time after an apex, where the centre of mass began: leg, foot and clock of place."""
    placed = placed_leg(model, inputs, time)
    center = free_fall.center_of_mass(model, inputs, start, time)
    foot = coordinates.foot_below(model, center, placed, leg.direction(placed.leg_angle))
    return Record(**vars(coordinates.foot_at(foot)), **vars(placed))


def time_to_apex(model, inputs, start):
    """How long a centre of mass rises; where nothing pulls it down the time is infinite or negative."""
    acceleration = free_fall.of_runner(model, inputs)
    return start.vy / -acceleration.y
