"""The equations of motion (8)-(9), solved for the accelerations by writing Newton's law for each point mass.

With u = (-sin, cos) along the leg, t = (-cos, -sin) across it and the ground force (f_x, f_y) of the mode:

    foot:  m_f ax = f_x + F_s sin + (tau/r) cos        m_f ay = f_y - F_s cos + (tau/r) sin - m_f g
    body:  u.a_body = F_s/m + u.a                      t.a_body = tau/(m r) + t.a
    leg:   rddot = r thetadot^2 + u.(a_body - a_foot)
           r thetaddot = t.(a_body - a_foot) - 2 rdot thetadot

with a = (0, -g) + (external force)/m. A foot on the ground is accelerated along it alone, and one that
sticks not at all, exactly and not by cancellation.
"""

from . import free_fall, ground_force, ground_line, hip
from .functions import Record, larger
from .leg import damper_power


def foot_in_flight(model, leg, torque):
    """m_f a = F_s (sin, -cos) + (tau/r) (cos, sin) - (0, m_f g), off the ground  (8)."""
    across = torque * leg.inverse_length
    push_x = leg.axial_force * leg.sine + across * leg.cosine
    push_y = across * leg.sine - leg.axial_force * leg.cosine
    return Record(
        x=push_x * model.inverse_foot_mass, y=push_y * model.inverse_foot_mass - model.parameters.gravity
    )


def foot_acceleration(model, line, leg, torque, force, contact):
    """m_f a = f - f_stick, along the ground, and in flight by the leg and gravity  (8)."""
    if contact == "flight":
        return foot_in_flight(model, leg, torque)
    if contact == "stick":
        return Record(x=0, y=0)
    holding = ground_force.under(model, line, leg, torque)
    along = along_ground(model.inverse_foot_mass, force.tangential, holding.tangential)
    return Record(x=along * line.cosine, y=along * line.sine)


def along_ground(inverse_foot_mass, tangential, holding):
    """m_f a = f_t - f_stick, of a foot on the ground  (8)."""
    return (tangential - holding) * inverse_foot_mass


def leg_acceleration(inverse_mass, leg, across, free_body, foot):
    """rddot = r thetadot^2 + u.(a_body - a_foot), r thetaddot = t.(a_body - a_foot) - 2 rdot thetadot (9).

    `across` is tau/r. By the body's mass `free_body` is what it would have without the leg and `foot` what
    the foot has. In flight they may be taken together: by the reduced mass `free_body` is the push alone, and
    a foot has no acceleration.
    """
    turning = (
        across * inverse_mass
        - (free_body.x * leg.cosine + free_body.y * leg.sine)
        + foot.x * leg.cosine
        + foot.y * leg.sine
        - 2 * leg.length_rate * leg.angle_rate
    )
    return Record(
        length=leg.length * leg.angle_rate * leg.angle_rate
        + leg.axial_force * inverse_mass
        + (free_body.y * leg.cosine - free_body.x * leg.sine)
        + foot.x * leg.sine
        - foot.y * leg.cosine,
        angle=turning * leg.inverse_length,
    )


def rates(at, external_power):
    """The right-hand side: velocities, accelerations, powers, and what the hip has of its own.

    Of powers the state has the integrals. The hip's is tau thetadot, the damper's c rdot^2 and friction's
    -f_t v_t; with the inputs held the leg does no work.
    """
    model, state, leg, line = at.model, at.state, at.leg, at.mode.ground
    free_body = free_fall.of_body(model, free_fall.push_on_body(model, at.inputs))
    foot = foot_acceleration(model, line, leg, at.torque, at.force, at.mode.contact)
    across = at.torque * leg.inverse_length
    of_leg = leg_acceleration(model.inverse_body_mass, leg, across, free_body, foot)
    slip_velocity = ground_line.along(line, state.foot_vx, state.foot_vy)
    power = at.torque * leg.angle_rate
    return Record(
        foot_x=state.foot_vx,
        foot_y=state.foot_vy,
        leg_length=leg.length_rate,
        leg_angle=leg.angle_rate,
        foot_vx=foot.x,
        foot_vy=foot.y,
        leg_length_rate=of_leg.length,
        leg_angle_rate=of_leg.angle,
        hip_work=power,
        leg_work=0,
        energy_damper_loss=damper_power(model.parameters.leg.damping, leg.length_rate),
        energy_friction_loss=-at.force.tangential * slip_velocity,
        hip_positive_work=larger(0, power),
        energy_external_work=external_power,
        **vars(hip.rates(at)),
    )


def external_power(inputs, body):
    """f.v_m, the power of the external force on the body."""
    return inputs.body.external_fx * body.vx + inputs.body.external_fy * body.vy
