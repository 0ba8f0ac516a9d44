"""Graze, or lift-off done exactly.

When the contact force vanishes, the stance law would let the foot rise, while the flight law that takes over
often holds it down: stance says leave, flight says stay. Filippov's solution has no penetration and no
chatter: while the laws disagree the foot stays on the ground without force, and the torque has the value in
between that keeps it there, `ground_force.graze_torque`.

Let N(tau) be f_n of (10). A resting foot is held on the ground by a law if N > 0, and rises under it with the
acceleration -N/m_f if N < 0; tau_eq is the zero of N. So the exits of graze are watched by N of either law,
never by tau_eq, which is 0/0 at theta' = 0.
"""

from . import ground_force, hip
from .functions import larger, where


def force_in_stance(at):
    """N of the stance law, of a foot at rest on the ground that would stay there; with f_t of (10)."""
    torque = hip.stance_torque(at.model, at.inputs, at.state, at.mode.mid_stance_pending)
    return ground_force.under(at.model, at.mode.ground, at.leg, torque)


def force_in_flight(at):
    """N of the flight law, of a foot at rest on the ground that would stay there; with f_t of (10).

    No event locates the clamp of (12) for a foot on the ground: the servo's present sign decides it.
    """
    servo = hip.servo_torque(at.model, at.inputs, at.state, at.mode.phase, at.mode.liftoff_angle)
    if at.mode.phase == "place":
        swing = servo
    else:
        swing = where(at.model.parameters.hip.swing_clamp, True, larger(servo, 0), servo)
    return ground_force.under(at.model, at.mode.ground, at.leg, swing + at.inputs.hip.external_torque)
