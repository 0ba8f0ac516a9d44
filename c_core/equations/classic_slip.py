"""The classic SLIP between its stances: a point mass whose massless leg is put to an angle at no cost.

An apex is at the height h over the ground below it, with the speed v of the energy m (v^2/2 + g h). With t
the time since, the leg is at phi = theta0 - omega t, and the mass is told as it is seen from the foot. Its
stance is that of a foot that sticks, on the page of the ground. Lines of the ground go through the foot.
"""

from .functions import Record, cos, sin, sqrt


def apex_speed(slip, energy, height):
    """v = sqrt(2 (E/m - g h))."""
    return sqrt(2 * (energy / slip.mass - slip.gravity * height))


def landing(slip, speed, time):
    """-l0 sin phi, l0 cos phi, v, -g t: the mass where the foot comes down at that time."""
    angle = slip.touchdown_angle - slip.retraction_rate * time
    return Record(
        x=-(slip.free_length * sin(angle)),
        y=slip.free_length * cos(angle),
        vx=speed,
        vy=-(slip.gravity * time),
    )


def foot_from_apex(speed, time, point):
    """v t + l0 sin phi, how far the foot is ahead of the apex."""
    return speed * time - point.x


def clearance(slip, line, height, speed, time):
    """F = h - g t^2/2 - l0 cos phi - (v t + l0 sin phi) tan sigma: the foot comes down where F falls to 0."""
    point = landing(slip, speed, time)
    fallen = slip.gravity * time * time / 2
    return height - fallen - point.y - foot_from_apex(speed, time, point) * (line.sine / line.cosine)


def foot_velocity(slip, point):
    """The velocity of the foot of a leg that turns back as it comes down."""
    return Record(
        x=point.vx - slip.retraction_rate * point.y,
        y=point.vy + slip.retraction_rate * point.x,
    )


def next_apex(slip, line, point, foot_x):
    """The apex after a take-off: its height over the ground below, its energy there, and the step's length.

    The mass rises by vy^2/(2 g), and goes vx vy/g ahead.
    """
    ahead = point.x + point.vx * point.vy / slip.gravity
    height = point.y + point.vy * point.vy / (2 * slip.gravity) - line.sine / line.cosine * ahead
    return Record(
        height=height,
        energy=slip.mass * (point.vx * point.vx / 2 + slip.gravity * height),
        length=foot_x + ahead,
    )
