"""What is constant while a mode lasts, in its motion's own coordinates."""

from . import free_fall, friction, ground_force, ground_line, hip, leg
from .functions import Record


def of_flight(model, law, rest_length, push):
    """Leg, hip and the push on the body, of flight as seen from the centre of mass."""
    return Record(
        inverse_reduced_mass=model.inverse_reduced_mass,
        stiffness=model.parameters.leg.stiffness,
        damping=model.parameters.leg.damping,
        rest_length=rest_length,
        gain=law.gain,
        rate_gain=law.rate_gain,
        target=law.target,
        torque=law.torque,
        torque_rate=hip.drift(law),
        push_x=push.x,
        push_y=push.y,
    )


def on_ground(model, line, law, rest_length, push, sliding, excess, fading):
    """Leg, masses, m_f g, gravity less the push on the body, torque and friction, in the ground's axes.

    `sliding` is mu, signed as the foot's velocity; `excess` and `fading` tell how it falls with speed.
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
        friction=sliding,
        excess=excess,
        fading=fading,
    )


# ---- the same of a runner whose inputs are held, from its mode ---------------------------------------------


def of_flight_in(model, inputs, mode, place_time):
    """Of flight in a mode."""
    law = hip.flight(
        model,
        inputs,
        hip.CONSTANT_INPUTS,
        mode.phase,
        mode.clamp_closed,
        mode.liftoff_angle,
        place_time,
    )
    rest_length = leg.rest_length(model, inputs, mode.thrusts)
    return of_flight(model, law, rest_length, free_fall.push_on_body(model, inputs))


def on_ground_in(model, inputs, mode, sign, falls):
    """On the ground in a mode; `sign` is that of the foot's velocity, 0 where it does not slip."""
    law = hip.on_ground(model, inputs, hip.CONSTANT_INPUTS, mode.contact, mode.mid_stance_pending)
    rest_length = leg.rest_length(model, inputs, mode.thrusts)
    sliding = friction.sliding(friction.below(model, inputs, mode.zone), sign)
    excess, fading = (friction.excess(model), friction.fading(model, sign)) if falls else (0, 0)
    push = free_fall.push_on_body(model, inputs)
    return on_ground(model, mode.ground, law, rest_length, push, sliding, excess, fading)
