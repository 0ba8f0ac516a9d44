"""The ground: segments along x, each a sloped line with a friction of its own.

A patch of other friction and terrain are ways to fill the table of segments. The line of a segment, or one
that is set at an apex, is pending until the foot is above it in flight.
"""

from ..hybrid import Model, Record, cos, event, output, parameter, select, setting, sin, state, table

FAR = 1e12
"""Borders that are not reached are this far away."""


class Ground(Model):
    """The line y = height + x tan(slope), and components of vectors tangential and normal to it."""

    prefix = "ground"
    ground_height = setting(
        0, "m", "Height of the ground at x = 0, h", name="ground.height", least=-1e9, most=1e9)
    ground_slope = setting(
        0, "rad", "Slope of the ground, positive uphill, sigma", name="ground.slope", least=-1, most=1)
    patch_begin = parameter(0, "m", "Position where the patch begins", least=-1e9, most=1e9)
    patch_end = parameter(
        0, "m", "Position where the patch ends; ground.patch_begin for no patch", least=-1e9,
        most=1e9)
    patch_friction = parameter(0.1, "1", "Friction coefficient on the patch, mu_p", least=0, most=1e6)
    trips = parameter(False, "1", "True if a foot that meets the face of a higher segment falls")
    keeps_friction = parameter(
        False, "1", "True if a stance keeps the friction of the segment on which it began")

    height = state(0, "m", "Height at x = 0 of the ground line in force")
    slope = state(0, "rad", "Slope of the ground line in force", least=-1.5, most=1.5)
    segment = state(
        -1, "1", "Segment of the ground below the foot; a run starts before the first", values=int)
    segment_begin = state(-FAR, "m", "Position where the segment begins")
    segment_end = state(-FAR, "m", "Position where the segment ends")
    segment_height = state(0, "m", "Height of the segment's line at x = 0, above ground.height")
    segment_slope = state(0, "rad", "Slope of the segment's line, added to ground.slope")
    friction_ahead = state(-1, "1", "Friction that the foot would slip into, forward; see ground_segment")
    friction_behind = state(-1, "1", "Friction that the foot would slip into, backward")

    @table(begin="m", end="m", height="m", slope="rad", friction="1")
    def ground_segment(r, row):
        """A segment; a negative friction stands for `ground.friction`. The page's own make the patch."""
        begin = select(r.patch_end > r.patch_begin, r.patch_begin, FAR)
        end = select(r.patch_end > r.patch_begin, r.patch_end, FAR)
        return dict(
            begin=select(row > 0, select(row > 1, end, begin), -FAR),
            end=select(row > 0, select(row > 1, FAR, end), begin), height=0, slope=0,
            friction=select(abs(row - 1) > 0, -1, r.patch_friction))

    def on_segment(r, number):
        """States of a foot on a segment, or in flight above it."""
        of = r.row_of("ground_segment", number)
        return dict(segment=number, segment_begin=of.begin, segment_end=of.end, segment_height=of.height,
                    segment_slope=of.slope, friction_ahead=of.friction, friction_behind=of.friction)

    def moves_onto(r, number, **kept):
        """Move the foot onto a segment, or let it fall over the face of a higher one."""
        moved = r.replace(**r.on_segment(number) | kept)
        if r.mode == "start_of_run" or r.trips <= 0:
            return moved
        if moved.foot_above(moved.set_height(), moved.set_slope()) < -r.margin_of("m"):
            return moved.to("fallen", has_fallen=1)
        return moved

    def kept_in_stance(r, changes):
        """Changes in a stance, which may keep the friction of its segment."""
        return {name: select(r.keeps_friction > 0, getattr(r, name), value)
                for name, value in changes.items() if name in ("friction_ahead", "friction_behind")}

    def segment_towards(r, way):
        """The segment that the foot would slip into, in a direction: on a border the one that it enters."""
        x = r.foot().x + way * r.margin_of("m")
        ends, begins = select(r.segment_end < FAR, 1, 0), select(r.segment_begin > -FAR, 1, 0)
        return r.segment + ends * select(x > r.segment_end, 1, 0) - begins * select(x < r.segment_begin, 1, 0)

    def neighbours(r):
        """Friction that the foot would slip into, forward and backward; it differs on a border."""
        ahead, behind = (r.row_of("ground_segment", r.segment_towards(way)) for way in (1, -1))
        return dict(friction_ahead=ahead.friction, friction_behind=behind.friction)

    @event("start_of_run flight graze", when=lambda r: r.segment_end - r.foot().x, unit="m", counted=False,
           only=lambda r: r.mode == "start_of_run" or r.segment_end < FAR)
    def passes_end(r):
        """The foot is above the next segment."""
        return r.moves_onto(r.segment + 1)

    @event("start_of_run flight graze", when=lambda r: r.foot().x - r.segment_begin, unit="m",
           counted=False, only=lambda r: r.mode == "start_of_run" or r.segment_begin > -FAR)
    def passes_begin(r):
        """The foot is above the segment before."""
        return r.moves_onto(r.segment - 1)

    def set_height(r):
        """Height at x = 0 of the line of the segment."""
        return r.ground_height + r.segment_height

    def set_slope(r):
        """Slope of the line of the segment."""
        return r.ground_slope + r.segment_slope

    def line_waits(r):
        """True while the line of the segment is pending."""
        return abs(r.set_height() - r.height) + abs(r.free_length * (r.set_slope() - r.slope)) > 0

    @output(name="ground.pending", kind=bool)
    def pending(r):
        """True while a new ground line is pending, until the foot is above it in flight."""
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
        return r.foot_off + r.y

    def rise(r):
        """Vertical velocity of the centre of mass."""
        if r.seen_in == "ground":
            along = r.foot_vx + r.share() * r.vx
            return sin(r.slope) * along + cos(r.slope) * (r.foot_off_rate + r.share() * r.vy)
        return r.center().vy

    def height_of_section(r):
        """Height of the centre of mass above the ground, measured vertically."""
        center = r.center()
        return center.y - r.height - center.x * (sin(r.slope) / cos(r.slope))
