"""A bouncing ball: the smallest page, and one that can be checked with a pencil."""

from tdmf_slip.hybrid import Model, clock, event, mode, output, parameter, section, sqrt, state


class BouncingBall(Model):
    """A ball that falls freely and keeps the share e of its speed at every bounce.

    Dropped from the height h, it first lands after sqrt(2 h/g), with the speed sqrt(2 g h). The nth bounce
    lasts 2 e^n sqrt(2 h/g), so the ball is at rest after sqrt(2 h/g) (1 + e)/(1 - e). It bounces infinitely
    often until then. A computer cannot, so the ball stays on the ground where a bounce is too slow to matter.
    """

    start = "flight", {}
    scales = {"m": lambda b: b.drop, "m/s": lambda b: sqrt(b.gravity * b.drop)}
    gravity = parameter(9.81, "m/s2", "Acceleration of gravity, g", above=0)
    drop = parameter(1, "m", "Typical height, to which errors are relative", above=0)
    restitution = parameter(0.8, "1", "Coefficient of restitution, e", tunable=True, least=0, most=1)
    slowest = parameter(1e-4, "m/s", "Speed after a bounce below which the ball stays on the ground", above=0)

    time = clock()
    height = state(1, "m", "Height of the ball", least=0)
    speed = state(0, "m/s", "Vertical velocity of the ball")
    bounces = state(0, "1", "Number of bounces", values=int)
    speed_up = state(0, "m/s", "Speed after the last bounce")

    @mode()
    def flight(b):
        """The ball falls."""
        return dict(height=b.speed, speed=-b.gravity)

    @mode()
    def rest(b):
        """The ball lies on the ground."""
        return {}

    @event("flight", when=lambda b: b.height, unit="m")
    def bounce(b):
        """The ground reverses the velocity and takes a share of it."""
        speed = -b.restitution * b.speed
        landed = b.replace(height=0, speed=speed, speed_up=speed, bounces=b.bounces + 1)
        return landed if speed > b.slowest else landed.to("rest", speed=0)

    @section("bounce", "speed_up")
    def after_bounce(b, at):
        """A start just after a bounce."""
        return b.replace(height=0, speed=at.speed_up)

    @output("m2/s2")
    def energy(b):
        """Mechanical energy per mass; a bounce leaves the share e^2 of it."""
        return b.gravity * b.height + b.speed**2 / 2
