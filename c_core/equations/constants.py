"""What is constant while a mode lasts, in its motion's own coordinates."""

from . import free_fall, ground_force, ground_line, hip
from .functions import Record


def of_flight(model, law, rest_length, push):
    """Leg, hip and the push on the body, of flight as seen from the centre of mass."""
    leg = model.parameters.leg
    return Record(
        inverse_reduced_mass=model.inverse_reduced_mass,
        stiffness=leg.stiffness,
        damping=leg.damping,
        rest_length=rest_length,
        gain=law.gain,
        rate_gain=law.rate_gain,
        target=law.target,
        torque=law.torque,
        torque_rate=hip.drift(law),
        push_x=push.x,
        push_y=push.y,
    )


def on_ground(model, line, law, rest_length, push, friction, excess, fading):
    """Leg, masses, m_f g, gravity less the push on the body, torque and friction, in the ground's axes.

    `friction` has the sign of the foot's velocity; `excess` and `fading` tell how it falls with speed.
    """
    acceleration = free_fall.of_body(model, push)
    weight = ground_force.foot_weight(model)
    return Record(
        stiffness=model.parameters.leg.stiffness,
        damping=model.parameters.leg.damping,
        rest_length=rest_length,
        inverse_body_mass=model.inverse_body_mass,
        inverse_foot_mass=model.inverse_foot_mass,
        foot_weight_x=weight * line.sine,
        foot_weight_y=weight * line.cosine,
        gravity_x=-ground_line.along(line, acceleration.x, acceleration.y),
        gravity_y=-ground_line.off(line, acceleration.x, acceleration.y),
        torque=law.torque,
        torque_rate=law.torque_rate,
        friction=friction,
        excess=excess,
        fading=fading,
    )
