"""The leg: masses, spring and damper, and the coordinates of the runner (7)."""

from ..hybrid import (
    Model, Record, atan2, coordinates, cos, input, on_set, parameter, select, setting, sin, sqrt, state,
)


class Leg(Model):
    """Two point masses with a spring and damper between them.

    The laws read `leg`, `foot`, `body` and `center`, which work in all coordinates.
    """

    prefix = "leg"
    body_mass = parameter(1, "kg", "Mass of the body, m", name="body.mass", least=1e-9, most=1e9)
    foot_mass = parameter(0.1, "kg", "Mass of the foot, m_f", name="foot.mass", least=1e-12, most=1e9)
    stiffness = parameter(1, "N/m", "Stiffness of the leg spring, k", least=1e-9, most=1e12)
    damping = parameter(0.2, "N.s/m", "Damping of the leg, c", least=0, most=1e12)
    free_length = parameter(1, "m", "Length of the unloaded leg, l0", least=1e-6, most=1e6)
    least_length = parameter(
        0.05, "m", "Leg length below which the runner falls", name="leg.min_length", least=1e-9,
        most=1e6)
    gravity = parameter(0.01, "m/s2", "Acceleration of gravity, g", name="gravity", least=1e-9, most=1e6)
    thrust = parameter(
        0, "m", "Thrust: increase of the rest length from greatest compression to lift-off, epsilon",
        tunable=True, least=0, most=1e6)
    notes_compression = parameter(
        True, "1", "Whether a thrust that is set later acts at once if the leg has been shortest before")
    more_thrust = setting(0, "m", "Added to leg.thrust", name="control.thrust", least=-1e6, most=1e6)
    extension = input(0, "m", "Change of the rest length of the leg", least=-1e6, most=1e6)
    external_fx = input(
        0, "N", "Horizontal external force on the body", name="body.external_fx", least=-1e18, most=1e18)
    external_fy = input(
        0, "N", "Vertical external force on the body", name="body.external_fy", least=-1e18, most=1e18)

    # World coordinates, the states of a unit. Flight shares length, angle and length rate.
    seen_x = state(
        -0.4722627765193387, "m", "Horizontal position of the foot, x", name="foot.x", of="world",
        least=-1e12, most=1e12)
    seen_y = state(
        0.6417114468531165, "m", "Height of the foot, y", name="foot.y", of="world", least=-1e9, most=1e9)
    length = state(
        0.9999993776846997, "m", "Length of the leg, r", of="world flight", least=1e-9, most=1e9)
    angle = state(
        -0.5462532571145313, "rad", "Angle of the leg from the vertical, positive with the foot ahead, theta",
        of="world flight", least=-1000, most=1000)
    seen_vx = state(
        1.062035591761993, "m/s", "Horizontal velocity of the foot", name="foot.vx", of="world",
        least=-1e12, most=1e12)
    seen_vy = state(
        -1.9951712441925837e-05, "m/s", "Vertical velocity of the foot", name="foot.vy", of="world",
        least=-1e12, most=1e12)
    length_rate = state(
        1.1268102275039307e-06, "m/s", "Rate of the leg length", of="world flight", least=-1e12, most=1e12)
    angle_rate = state(
        4.039363331769765e-05, "rad/s", "Rate of the leg angle", of="world", least=-1e12, most=1e12)

    # Flight coordinates: the centre of mass and the leg.
    com_x = state(0, "m", "Horizontal position of the centre of mass", of="flight")
    com_y = state(1.4, "m", "Height of the centre of mass", of="flight")
    com_vx = state(1, "m/s", "Horizontal velocity of the centre of mass", of="flight")
    com_vy = state(0, "m/s", "Vertical velocity of the centre of mass", of="flight")
    momentum = state(0, "m2/s", "Angular momentum of the leg per reduced mass, r^2 thetadot", of="flight")

    # Ground coordinates: the body relative to the foot, and the foot along the ground.
    x = state(0, "m", "Position of the body relative to the foot, along the ground", of="ground")
    y = state(1, "m", "Position of the body relative to the foot, normal to the ground", of="ground")
    vx = state(0, "m/s", "Velocity of the body relative to the foot, along the ground", of="ground")
    vy = state(0, "m/s", "Velocity of the body relative to the foot, normal to the ground", of="ground")
    foot_x = state(0, "m", "Position of the foot along the ground", of="ground")
    foot_vx = state(0, "m/s", "Velocity of the foot along the ground", of="ground")
    foot_off = foot_off_rate = 0
    """Distance of the foot from the ground in contact and its rate: states of ground that yields."""
    winding = state(0, "rad", "Leg angle less its principal value: a multiple of 2 pi", of="ground")

    thrusting = state(0, "1", "1 from greatest compression to lift-off, else 0", values=bool)
    leg_work = state(0, "J", "Work of thrust and leg extension since the start", name="leg.work")
    positive_leg_work = state(0, "J", "Positive works of jumps of the rest length since the start")
    external_work = state(
        0, "J", "Work of external forces on the body since the start", name="energy.external_work")
    damper_loss = state(0, "J", "Energy lost in the damper since the start", name="energy.damper_loss")

    @coordinates("world")
    def seen(r):
        """World coordinates: the foot and the leg."""
        foot, leg = r.foot(), r.leg()
        return dict(seen_x=foot.x, seen_y=foot.y, seen_vx=foot.vx, seen_vy=foot.vy,
                    length=leg.length, angle=leg.angle, length_rate=leg.length_rate,
                    angle_rate=leg.angle_rate)

    @coordinates("flight")
    def in_flight(r):
        """Flight coordinates: the centre of mass and the leg."""
        leg, center = r.leg(), r.center()
        return dict(com_x=center.x, com_y=center.y, com_vx=center.vx, com_vy=center.vy,
                    length=leg.length, angle=leg.angle, length_rate=leg.length_rate, momentum=leg.moment)

    @coordinates("ground")
    def from_ground(r):
        """Ground coordinates: the foot, and the body relative to the foot."""
        foot, body = r.foot(), r.body_from_foot()
        place, moves = r.on_line(foot.x, foot.y - r.height), r.on_line(foot.vx, foot.vy)
        at, turns = r.on_line(body.x, body.y), r.on_line(body.vx, body.vy)
        return dict(foot_x=place.along, foot_off=place.off, foot_vx=moves.along, foot_off_rate=moves.off,
                    x=at.along, y=at.off, vx=turns.along, vy=turns.off,
                    winding=r.leg().angle - atan2(-at.along, at.off))

    def leg(r):
        """Length and angle of the leg, their rates, and r^2 thetadot  (7)."""
        if r.seen_in == "ground":
            square = r.x * r.x + r.y * r.y
            length = sqrt(square)
            moment = r.x * r.vy - r.y * r.vx
            return Record(square=square, length=length, angle=atan2(-r.x, r.y) + r.winding,
                          length_rate=(r.x * r.vx + r.y * r.vy) / length, angle_rate=moment / square,
                          moment=moment)
        square = r.length * r.length
        moment = r.momentum if r.seen_in == "flight" else square * r.angle_rate
        rate = r.momentum / square if r.seen_in == "flight" else r.angle_rate
        return Record(square=square, length=r.length, angle=r.angle, length_rate=r.length_rate,
                      angle_rate=rate, moment=moment)

    def spring(r):
        """F_s = k (l - r) - c rdot, with the rest length l; positive when it pushes."""
        leg = r.leg()
        return r.stiffness * (r.rest_length() - leg.length) - r.damping * leg.length_rate

    def rest_length(r):
        """Rest length l: free length, extension, and epsilon, which is not negative, under thrust."""
        longer = r.thrust + r.more_thrust
        return r.free_length + r.extension + r.thrusting * select(longer >= 0, longer, 0)

    @on_set("extension thrust more_thrust")
    def lengthened(r, after):
        """Work that a jump of the rest length does on the spring."""
        jump = after.rest_length() - r.rest_length()
        middle = r.rest_length() + jump / 2 - r.leg().length
        work = r.stiffness * jump * middle
        begins = select(after.thrusting > r.thrusting, select(work >= 0, work, 0), 0)  # varies at a work of 0
        return r.replace(leg_work=r.leg_work + work,
                         positive_leg_work=r.positive_leg_work + select(work > 0, work, begins))

    def with_thrust(r, thrusting):
        """Switch thrust on (1) or off (0)."""
        return r.lengthened(r.replace(thrusting=thrusting)).replace(thrusting=thrusting)

    def leg_rates(r):
        """Power of a ramped extension, and power lost in the damper."""
        leg = r.leg()
        return dict(leg_work=r.stiffness * r.extension_rate * (r.rest_length() - leg.length),
                    damper_loss=r.damping * (leg.length_rate * leg.length_rate))

    def push(r, torque):
        """Force of leg and hip on the body, and opposite on the foot, by components on the ground line."""
        leg = r.leg()
        axial = r.spring() / leg.length
        turning = torque / leg.square
        return Record(along=axial * r.x - turning * r.y, off=axial * r.y + turning * r.x)

    # ---- positions and velocities in the world's axes

    def share(r):
        """Share of the body in the total mass."""
        return r.body_mass / (r.body_mass + r.foot_mass)

    def body_from_foot(r):
        """Position and velocity of the body relative to the foot  (7)."""
        if r.seen_in == "ground":
            return r.in_world(r.x, r.y, r.vx, r.vy)
        sine, cosine = sin(r.angle), cos(r.angle)
        turn = r.momentum / r.length if r.seen_in == "flight" else r.length * r.angle_rate
        return Record(x=-r.length * sine, y=r.length * cosine,
                      vx=-r.length_rate * sine - turn * cosine, vy=r.length_rate * cosine - turn * sine)

    def foot(r):
        """Position and velocity of the foot."""
        if r.seen_in == "world":
            return Record(x=r.seen_x, y=r.seen_y, vx=r.seen_vx, vy=r.seen_vy)
        if r.seen_in == "ground":
            foot = r.in_world(r.foot_x, r.foot_off, r.foot_vx, r.foot_off_rate)
            return Record(x=foot.x, y=r.height + foot.y, vx=foot.vx, vy=foot.vy)
        body, share = r.body_from_foot(), r.share()
        return Record(x=r.com_x - share * body.x, y=r.com_y - share * body.y,
                      vx=r.com_vx - share * body.vx, vy=r.com_vy - share * body.vy)

    def center(r):
        """Position and velocity of the centre of mass."""
        if r.seen_in == "flight":
            return Record(x=r.com_x, y=r.com_y, vx=r.com_vx, vy=r.com_vy)
        foot, body, share = r.foot(), r.body_from_foot(), r.share()
        return Record(x=foot.x + share * body.x, y=foot.y + share * body.y,
                      vx=foot.vx + share * body.vx, vy=foot.vy + share * body.vy)

    def body(r):
        """Position and velocity of the body.

        In flight they are taken from the centre of mass: a light foot may be millions of times as fast, and
        its rounding errors as large.
        """
        body = r.body_from_foot()
        if r.seen_in == "flight":
            share = r.foot_mass / (r.body_mass + r.foot_mass)
            return Record(x=r.com_x + share * body.x, y=r.com_y + share * body.y,
                          vx=r.com_vx + share * body.vx, vy=r.com_vy + share * body.vy)
        foot = r.foot()
        return Record(x=foot.x + body.x, y=foot.y + body.y, vx=foot.vx + body.vx, vy=foot.vy + body.vy)
