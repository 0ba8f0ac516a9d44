"""A rimless wheel that rolls down a slope (McGeer 1990; Coleman 1998)."""

from tdmf_slip.hybrid import (
    Model, clock, cos, event, mode, output, parameter, radians, section, sin, sqrt, state,
)


class RimlessWheel(Model):
    """A wheel without a rim: it vaults over one spoke after the other, and each landing takes speed.

    The standing spoke has the angle theta from the vertical. With the spoke length l, half the angle between
    two spokes a and the slope s, a step leads from theta = s - a to s + a. On the way gravity adds
    4 g/l sin s sin a to thetadot^2. A landing keeps the share e = cos 2a of thetadot. So after each landing

        thetadot^2 <- e^2 (thetadot^2 + 4 g/l sin s sin a).

    This map has the fixed point thetadot^2 = e^2/(1 - e^2) 4 g/l sin s sin a, at which a deviation decays by
    e^2 in a step. The wheel rolls on if that speed brings it over the top of its vault. Otherwise it rocks
    until it stands on two spokes.
    """

    start = "rolls", {}
    scales = {"1/s": lambda w: sqrt(w.gravity / w.length)}
    gravity = parameter(9.81, "m/s2", "Acceleration of gravity, g", above=0)
    length = parameter(1, "m", "Length of a spoke, l", above=0)
    half_angle = parameter(radians(15), "rad", "Half the angle between two spokes, a", above=0, below=0.78)
    slope = parameter(0.08, "rad", "Slope of the ground, positive downhill, s", least=-0.7, most=0.7)
    slowest = parameter(1e-4, "rad/s", "Rate below which a rocking wheel stands on two spokes", above=0)

    time = clock()
    angle = state(0, "rad", "Angle of the standing spoke from the vertical, positive downhill, theta")
    rate = state(0.5, "rad/s", "Rate of the angle")
    steps = state(0, "1", "Spokes passed downhill, less those passed uphill", values=int)
    landing_rate = state(0, "rad/s", "Rate after the last landing downhill")

    @mode()
    def rolls(w):
        """The wheel is an inverted pendulum, l thetaddot = g sin theta."""
        return dict(angle=w.rate, rate=w.gravity / w.length * sin(w.angle))

    @mode()
    def stands(w):
        """The wheel stands on two spokes."""
        return {}

    def land(w, way):
        """The next spoke lands, downhill (1) or uphill (-1): the angular momentum about its foot is kept."""
        rate = w.rate * cos(2 * w.half_angle)
        landed = w.replace(angle=w.slope - way * w.half_angle, rate=rate, steps=w.steps + way)
        return landed if abs(rate) > w.slowest else landed.to("stands", rate=0)

    @event("rolls", when=lambda w: w.slope + w.half_angle - w.angle, unit="rad")
    def lands_downhill(w):
        """The spoke ahead lands."""
        landed = w.land(1)
        return landed.replace(landing_rate=landed.rate)

    @event("rolls", when=lambda w: w.angle - (w.slope - w.half_angle), unit="rad")
    def lands_uphill(w):
        """The wheel has not come over the top, and the spoke behind lands."""
        return w.land(-1)

    @section("lands_downhill", "landing_rate")
    def at_landing(w, at):
        """A start just after a landing."""
        return w.replace(angle=w.slope - w.half_angle, rate=at.landing_rate)

    @output("1/s2")
    def energy(w):
        """Mechanical energy, twice and over m l^2."""
        return w.rate**2 + 2 * w.gravity / w.length * cos(w.angle)
