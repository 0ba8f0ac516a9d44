"""The ground: a sloped line. A new line is pending until the foot is above it in flight."""

from ..hybrid import Model, Record, cos, output, setting, sin, state


class Ground(Model):
    """The line y = height + x tan(slope), and components of vectors tangential and normal to it."""

    prefix = "ground"
    ground_height = setting(
        0, "m", "Height of the ground at x = 0, h", name="ground.height", least=-1e9, most=1e9)
    ground_slope = setting(
        0, "rad", "Slope of the ground, positive uphill, sigma", name="ground.slope", least=-1, most=1)
    height = state(0, "m", "Height at x = 0 of the ground line in force")
    slope = state(0, "rad", "Slope of the ground line in force")

    def line_waits(r):
        """Whether a new line is pending."""
        return abs(r.ground_height - r.height) + abs(r.free_length * (r.ground_slope - r.slope)) > 0

    @output(name="ground.pending", kind=bool)
    def pending(r):
        """Whether a new ground line is pending, until the foot is above it in flight."""
        return r.line_waits()

    def on_line(r, x, y):
        """Components of a vector, tangential (`along`) and normal (`off`) to the ground."""
        sine, cosine = sin(r.slope), cos(r.slope)
        return Record(along=x * cosine + y * sine, off=y * cosine - x * sine)

    def in_world(r, along, off, along_rate, off_rate):
        """World components of a vector and of its rate, from components along and off the ground."""
        sine, cosine = sin(r.slope), cos(r.slope)
        return Record(x=along * cosine - off * sine, y=along * sine + off * cosine,
                      vx=along_rate * cosine - off_rate * sine, vy=along_rate * sine + off_rate * cosine)

    def above(r, height, slope, share):
        """Distance from a line to the point of the leg at `share` of its length above the centre of mass."""
        level = cos(slope) * (r.com_y - height) - sin(slope) * r.com_x
        return level + share * r.length * cos(r.angle - slope)

    def foot_above(r, height, slope):
        """Distance from a line to the foot."""
        if r.seen_in == "flight":
            return r.above(height, slope, -r.share())
        foot = r.foot()
        return cos(slope) * (foot.y - height) - sin(slope) * foot.x

    def body_above(r):
        """Distance from the ground line in force to the body."""
        if r.seen_in == "flight":
            return r.above(r.height, r.slope, 1 - r.share())
        return r.y

    def rise(r):
        """Vertical velocity of the centre of mass."""
        if r.seen_in == "ground":
            along = r.foot_vx + r.share() * r.vx
            return sin(r.slope) * along + cos(r.slope) * (r.share() * r.vy)
        return r.center().vy

    def height_of_section(r):
        """Height of the centre of mass above the ground, measured vertically."""
        center = r.center()
        return center.y - r.height - center.x * (sin(r.slope) / cos(r.slope))
