"""The leg: a spring and a damper between body and foot, whose rest length thrust and input change."""

from .functions import Record, cos, larger, sin, where


def direction(angle):
    """Sine and cosine of theta, positive with the foot ahead of the body."""
    return Record(sine=sin(angle), cosine=cos(angle))


def direction_over(line, direction):
    """Of theta' = theta - sigma, seen from the normal of the ground."""
    return Record(
        sine=direction.sine * line.cosine - direction.cosine * line.sine,
        cosine=direction.cosine * line.cosine + direction.sine * line.sine,
    )


def thrust(model, inputs):
    """epsilon, with what the control adds to it, but no less than 0.

    A leg that grew shorter would leave a ground that it comes down to at once, for ever.
    """
    return larger(model.parameters.leg.thrust + inputs.control.thrust, 0)


def rest_length(model, inputs, thrusts):
    """l0 + u and, from the greatest compression to the end of the stance, epsilon."""
    length = model.parameters.leg.free_length + inputs.leg.extension
    return where(thrusts, True, length + thrust(model, inputs), length)


def axial_force(stiffness, damping, rest_length, length, length_rate):
    """F_s = k (l - r) - c rdot, l being the rest length: it pushes body and foot apart."""
    return stiffness * (rest_length - length) - damping * length_rate


def bounded_length(model, state):
    """r, but no less than half of the least: a solver may try zero and less on its way past a fall."""
    return larger(state.leg_length, model.parameters.leg.min_length / 2)


def evaluate(model, line, state, direction, rest_length, bounded_length):
    """What every force and acceleration is made of; `bounded_length` is r where that is a leg's."""
    leg = model.parameters.leg
    over_ground = direction_over(line, direction)
    return Record(
        length=state.leg_length,
        inverse_length=1 / bounded_length,
        length_rate=state.leg_length_rate,
        angle_rate=state.leg_angle_rate,
        sine=direction.sine,
        cosine=direction.cosine,
        ground_sine=over_ground.sine,
        ground_cosine=over_ground.cosine,
        rest_length=rest_length,
        axial_force=axial_force(
            leg.stiffness, leg.damping, rest_length, state.leg_length, state.leg_length_rate
        ),
    )


def damper_power(damping, length_rate):
    """c rdot^2, which the damper takes."""
    return damping * length_rate * length_rate


def power(stiffness, rest_length, length, rest_length_rate):
    """k (l - r) ldot, what the spring is given along a ramp of its rest length."""
    return stiffness * (rest_length - length) * rest_length_rate


def work_of_jump(stiffness, length, before, after):
    """k/2 ((l+ - r)^2 - (l- - r)^2), what the spring is given where its rest length jumps."""
    return stiffness * (after - before) * (after + before - 2 * length) / 2
