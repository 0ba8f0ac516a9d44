"""The ground: a line with tangent t = (cos sigma, sin sigma), normal n = (-sin sigma, cos sigma).

Its pivot is (0, h).
"""

from .functions import Record


def along(line, x, y):
    """t.(x, y), what of a vector is along the line."""
    return line.cosine * x + line.sine * y


def off(line, x, y):
    """n.(x, y), what of a vector is across the line."""
    return line.cosine * y - line.sine * x


def offset_along(line, x, y):
    """t.(p - (0, h)), from the pivot along the line."""
    return along(line, x, y - line.height)


def point_on(line, along, velocity):
    """The point at a distance from the pivot that moves along the line."""
    return Record(
        x=line.cosine * along,
        y=line.height + line.sine * along,
        vx=line.cosine * velocity,
        vy=line.sine * velocity,
    )


def vector_on(line, tangential, normal):
    """f_t t + f_n n, in horizontal and vertical components."""
    return Record(
        x=tangential * line.cosine - normal * line.sine,
        y=tangential * line.sine + normal * line.cosine,
    )
