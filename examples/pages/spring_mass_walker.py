"""The bipedal spring-mass model, which walks and runs (Geyer, Seyfarth and Blickhan 2006)."""

from tdmf_slip.hybrid import (
    Model, Record, clock, cos, event, mode, output, parameter, radians, section, select, sin, sqrt, state,
)


class SpringMassWalker(Model):
    """A point mass on two massless springs. A leg that swings has the length l0 and the angle of attack.

    A leg lands where the mass falls below the height of a swinging leg, and leaves where it has its free
    length again. If the next leg lands before the last one leaves, the model walks, else it runs.
    """

    start = "single", {}
    scales = {
        "m": lambda b: b.free_length,
        "m/s": lambda b: sqrt(b.gravity * b.free_length),
    }
    mass = parameter(80, "kg", "Mass of the body, m", above=0)
    stiffness = parameter(14e3, "N/m", "Stiffness of a leg, k", above=0)
    free_length = parameter(1, "m", "Length of an unloaded leg, l0", above=0)
    attack = parameter(radians(69), "rad", "Angle of attack, alpha0", above=0, most=radians(90))
    gravity = parameter(9.81, "m/s2", "Acceleration of gravity, g", above=0)
    energy_given = parameter(820, "J", "Energy of starts on the section", name="energy.given", above=0)

    time = clock()
    x, y = state(0, "m", "Position of the mass"), state(0.976754873, "m", "Height of the mass", above=0)
    vx, vy = state(1.1142, "m/s", "Horizontal velocity of the mass"), state(0, "m/s", "Vertical velocity")
    foot = state(0, "m", "Position of the standing foot; if two stand, of the rear one")
    front_foot = state(0, "m", "Position of the front foot, if two stand")
    steps = state(0, "1", "Number of touchdowns", values=int)
    middle_height = state(0, "m", "Height of the mass when it last was above its foot")
    middle_rise = state(0, "m/s", "Vertical velocity of the mass when it last was above its foot")
    apex_height = state(0, "m", "Height of the last apex in flight")

    def length(b, foot):
        """Length of a leg that stands on a foot."""
        return sqrt((b.x - foot) ** 2 + b.y**2)

    def push(b, foot):
        """Acceleration of the mass by a standing leg, k (l0 - l)/m along the leg."""
        length = b.length(foot)
        share = b.stiffness / b.mass * (b.free_length - length) / length
        return Record(x=share * (b.x - foot), y=share * b.y)

    @mode()
    def flight(b):
        """No leg stands."""
        return dict(x=b.vx, y=b.vy, vy=-b.gravity)

    @mode()
    def single(b):
        """One leg stands, with its foot at `foot`."""
        push = b.push(b.foot)
        return dict(x=b.vx, y=b.vy, vx=push.x, vy=push.y - b.gravity)

    @mode()
    def double(b):
        """Two legs stand."""
        rear, front = b.push(b.foot), b.push(b.front_foot)
        return dict(x=b.vx, y=b.vy, vx=rear.x + front.x, vy=rear.y + front.y - b.gravity)

    @mode(ends=True)
    def fallen(b):
        """The mass has reached the ground."""
        return {}

    @event("flight single", when=lambda b: b.y - b.free_length * sin(b.attack), unit="m",
           crossing=lambda b: True)
    def touchdown(b):
        """A swinging leg lands ahead of the mass."""
        ahead, steps = b.x + b.free_length * cos(b.attack), b.steps + 1
        if b.mode == "flight":
            return b.to("single", foot=ahead, steps=steps)
        return b.to("double", front_foot=ahead, steps=steps)

    @event("single double", when=lambda b: b.free_length - b.length(b.foot), unit="m")
    def take_off(b):
        """The leg that landed first has its free length again."""
        return b.to("flight") if b.mode == "single" else b.to("single", foot=b.front_foot)

    @event("double", when=lambda b: b.free_length - b.length(b.front_foot), unit="m")
    def stumble(b):
        """The front leg has its free length again and leaves first."""
        return b.to("single")

    @event("single", when=lambda b: b.foot - b.x, unit="m", counted=False, crossing=lambda b: True)
    def passes_foot(b):
        """The mass is above its foot."""
        return b.replace(middle_height=b.y, middle_rise=b.vy)

    @event("flight", when=lambda b: b.vy, unit="m/s", counted=False, crossing=lambda b: True)
    def apex(b):
        """The mass rises no more."""
        return b.replace(apex_height=b.y)

    @event("flight single double", when=lambda b: b.y, unit="m")
    def falls(b):
        """The mass reaches the ground."""
        return b.to("fallen")

    @section("passes_foot", "middle_height middle_rise")
    def above_foot(b, at):
        """A start above the foot, whose velocity follows from the energy."""
        start = b.replace(x=b.foot, y=at.middle_height, vx=0, vy=at.middle_rise)
        kinetic = b.energy_given - start.energy()
        return start.replace(vx=sqrt(2 / b.mass * select(kinetic > 0, kinetic, 0)))

    @output("J")
    def energy(b):
        """Mechanical energy, which is constant until a fall."""
        feet = {"single": [b.foot], "double": [b.foot, b.front_foot]}.get(b.mode, [])
        springs = sum(b.stiffness * (b.free_length - b.length(foot)) ** 2 / 2 for foot in feet)
        return springs + b.mass * ((b.vx**2 + b.vy**2) / 2 + b.gravity * b.y)
