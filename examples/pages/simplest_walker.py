"""The simplest walking model (Garcia, Chatterjee, Coleman and Ruina 1998)."""

from tdmf_slip.hybrid import Model, clock, cos, event, mode, parameter, section, sin, state


class SimplestWalker(Model):
    """Two straight legs with a mass at the hip and vanishing masses at the feet, on a slope, without motors.

    theta is the angle of the stance leg from the normal of the slope, phi the angle between the legs, gamma
    the slope. The feet are so light that the swing leg does not move the hip. Numbers in parentheses are the
    equations of the paper, whose unit of time is sqrt(l/g).
    """

    start = "walks", {}
    slope = parameter(0.009, "rad", "Slope of the ground, gamma", least=0, most=0.1)
    gravity = parameter(1, "1/s2", "Acceleration of gravity over leg length, g/l", above=0)

    time = clock()
    stance = state(0.2003109005, "rad", "Angle of the stance leg from the slope's normal, theta")
    stance_rate = state(-0.1998324730, "rad/s", "Rate of theta")
    swing = state(0.4006218011, "rad", "Angle between the legs, phi")
    swing_rate = state(-0.0158229999, "rad/s", "Rate of phi")
    steps = state(0, "1", "Number of steps", values=int)
    first_angle = state(0, "rad", "theta at the beginning of the step")
    first_rate = state(0, "rad/s", "Rate of theta at the beginning of the step")

    @mode()
    def walks(w):
        """The stance leg is an inverted pendulum (1), from whose hip the swing leg hangs (2)."""
        leaning = w.stance - w.slope
        stance = w.gravity * sin(leaning)
        swing = stance + w.stance_rate**2 * sin(w.swing) - w.gravity * cos(leaning) * sin(w.swing)
        return dict(stance=w.stance_rate, stance_rate=stance, swing=w.swing_rate, swing_rate=swing)

    @mode(ends=True)
    def fallen(w):
        """The hip has reached the ground."""
        return {}

    def after_heel_strike(w, angle, rate):
        """The legs as a step begins (4): the velocity of the hip determines that of the new swing leg."""
        return w.replace(
            stance=angle, stance_rate=rate, swing=2 * angle, swing_rate=(1 - cos(2 * angle)) * rate,
            first_angle=angle, first_rate=rate)

    @event("walks", when=lambda w: 2 * w.stance - w.swing, unit="rad", crossing=lambda w: True)
    def heel_strike(w):
        """The swing foot lands ahead (3), and the legs change roles (4).

        The guard is 0 where a step begins, too. It has to rise first: the swing foot has to pass the stance
        foot, and straight legs let it pass below the ground.
        """
        landed = w.after_heel_strike(-w.stance, cos(2 * w.stance) * w.stance_rate)
        return landed.replace(steps=w.steps + 1)

    @event("walks", when=lambda w: cos(w.stance))
    def falls(w):
        """The stance leg lies on the ground."""
        return w.to("fallen")

    @section("heel_strike", "first_angle first_rate")
    def at_heel_strike(w, at):
        """A start just after a heel strike, which angle and rate of the stance leg determine."""
        return w.after_heel_strike(at.first_angle, at.first_rate)
