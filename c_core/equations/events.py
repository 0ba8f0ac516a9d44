"""Guards of events: laws of the runner `at` an instant, positive while the event is to come.

An instant is a record of model, inputs, mode, state, leg and force.
"""

from . import friction, hip


def clamp(at):
    """The servo's torque, which closes the clamp of (12) by falling through 0, and opens it by rising."""
    servo = hip.servo_torque(at.model, at.inputs, at.state, "retract", at.mode.liftoff_angle)
    return -servo if at.mode.clamp_closed else servo


def lift_off(at):
    """f_n, the ground's normal force  (10)."""
    return at.force.normal


def slip_onset_positive(at, zone):
    """rho mu f_n + f_t: a foot at rest that reaches the edge of the cone (2) here slips forward."""
    return friction.room(friction.static(at.model, friction.below(at.model, at.inputs, zone)), 1, at.force)


def slip_onset_negative(at, zone):
    """rho mu f_n - f_t: the same, and the foot slips backward."""
    return friction.room(friction.static(at.model, friction.below(at.model, at.inputs, zone)), -1, at.force)


def mid_stance(at):
    """theta: the leg falls through the vertical."""
    return at.state.leg_angle


def greatest_compression(at):
    """-rdot, of a leg that has not been compressed most in this stance."""
    return -at.leg.length_rate


def leg_too_short(at):
    """r less the least length: a fall."""
    return at.leg.length - at.model.parameters.leg.min_length
