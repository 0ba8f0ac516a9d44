"""The classic spring-loaded inverted pendulum: a point mass on a massless spring leg (sections 2 and 3)."""

from ..hybrid import (
    Model, clock, cos, event, mode, observe, parameter, radians, section, select, sin, sqrt, state,
)


class ClassicSlip(Model):
    """A mass that bounces on a leg. In flight the leg is put to an angle at no cost, and may turn back."""

    start = "start_of_run", {}
    scales = {
        "m": lambda s: s.free_length,
        "m2": lambda s: s.free_length * s.free_length,
        "m/s": lambda s: s.free_length * sqrt(s.stiffness / s.mass),
        "s": lambda s: sqrt(s.mass / s.stiffness),
        "J": lambda s: s.stiffness * s.free_length * s.free_length,
    }
    mass = parameter(80, "kg", "Mass of the body, m", least=1e-9, most=1e9)
    stiffness = parameter(20000, "N/m", "Stiffness of the leg spring, k", least=1e-9, most=1e12)
    free_length = parameter(1, "m", "Length of the unloaded leg, l0", least=1e-6, most=1e6)
    gravity = parameter(9.81, "m/s2", "Acceleration of gravity, g", least=1e-9, most=1e6)
    touchdown_angle = parameter(
        radians(40), "rad", "Leg angle at the apex, positive with the foot ahead, theta0",
        above=-radians(90), below=radians(90))
    retraction_rate = parameter(
        0, "rad/s", "Rate at which the leg angle falls after the apex, omega", least=-1e9, most=1e9)
    friction = parameter(1e9, "1", "Friction coefficient; by default the foot holds, mu", least=0, most=1e9)
    slope = parameter(0, "rad", "Slope of the ground, positive uphill, sigma", above=-1, below=1)
    energy = parameter(6000, "J", "Energy at the start, above the ground vertically below", least=0)

    time = clock()
    x, y = state(0, "m", "Horizontal position of the mass"), state(1.04, "m", "Height of the mass")
    vx, vy = state(5, "m/s", "Horizontal velocity of the mass"), state(0, "m/s", "Vertical velocity")
    angle = state(radians(40), "rad", "Leg angle from the vertical in flight, positive with the foot ahead")
    foot_x, foot_y = state(0, "m", "Position of the foot in stance"), state(0, "m", "Height of the foot")

    touchdown_time = state(0, "s", "Time of the last touchdown")
    stance_time = state(0, "s", "Duration of the last stance")
    impact_friction = state(0, "1", "Friction that a small foot mass needs to stick at the impact  (5)")
    stance_friction = state(0, "1", "Friction that the stance needs  (3)")
    tilt = state(0, "1", "Sine of the largest angle between the leg and the normal of the ground in stance")
    left_early = state(0, "1", "1 if the leg left the friction cone with energy in its spring, else 0")
    apex_x = state(0, "m", "Position of the mass at the last apex")
    apex_height = state(0, "m", "Height of the mass above the ground at the last apex")
    apex_energy = state(0, "J", "Energy at the last apex, above the ground vertically below")
    step_length = state(0, "m", "Distance between the last two apices")

    def above_ground(s, x, y):
        """Height above the ground vertically below."""
        return y - x * (sin(s.slope) / cos(s.slope))

    def foot(s):
        """Position of the foot in flight."""
        return s.x + s.free_length * sin(s.angle), s.y - s.free_length * cos(s.angle)

    def along(s):
        """Position of the mass relative to a standing foot, along the ground."""
        return (s.x - s.foot_x) * cos(s.slope) + (s.y - s.foot_y) * sin(s.slope)

    def off(s):
        """Position of the mass relative to a standing foot, normal to the ground."""
        return (s.y - s.foot_y) * cos(s.slope) - (s.x - s.foot_x) * sin(s.slope)

    def length(s):
        """Length of the leg in stance."""
        x, y = s.x - s.foot_x, s.y - s.foot_y
        return sqrt(x * x + y * y)

    def in_cone(s, side):
        """Distance of the leg from the edge of the friction cone with the mass ahead, or behind for -1."""
        return (s.friction * s.off() - side * s.along()) / (1 + s.friction)

    # ---- sections

    def at_height(s, height, energy):
        """A start at an apex: v = sqrt(2 (E/m - g h))."""
        kinetic = energy / s.mass - s.gravity * height
        speed = sqrt(2 * select(kinetic > 0, kinetic, 0))
        return s.replace(y=height, vx=speed, vy=0, angle=s.touchdown_angle)

    @section("apex", "apex_height")
    def at_energy(s, at):
        """Apices of the energy `energy`."""
        return s.at_height(at.apex_height, s.energy)

    @section("apex", "apex_height apex_energy")
    def at_apex(s, at):
        """All apices."""
        return s.at_height(at.apex_height, at.apex_energy)

    # ---- modes

    @mode()
    def start_of_run(s):
        """Start of a run."""
        return {}

    @mode("way")
    def flight(s):
        """The mass is ballistic. The leg turns after the apex, on the way down."""
        rates = dict(x=s.vx, y=s.vy, vy=-s.gravity)
        return rates | dict(angle=-s.retraction_rate) if s.way == "down" else rates

    @mode()
    def stance(s):
        """The foot stands, and the leg pushes with k (l0 - r)  (1)."""
        push = s.stiffness / s.mass * (s.free_length - s.length()) / s.length()
        x, y = s.x - s.foot_x, s.y - s.foot_y
        return dict(x=s.vx, y=s.vy, vx=push * x, vy=push * y - s.gravity)

    @mode(ends=True)
    def no_start(s):
        """The foot is not above the ground at the apex, or the runner does not move forward."""
        return {}

    @mode(ends=True)
    def slides(s):
        """The leg is outside the friction cone: the foot slides out forward, and the mass falls."""
        return {}

    @mode(ends=True)
    def fallen(s):
        """The mass has reached the ground, or leaves it downward."""
        return {}

    # ---- events

    @event("start_of_run", when=lambda s: -1, counted=False)
    def begins(s):
        """Every run begins at an apex, with the foot above the ground."""
        s = s.replace(apex_x=s.x, apex_height=s.above_ground(s.x, s.y))
        return s.to("no_start") if s.vx <= 0 else s.goes_down()

    def goes_down(s):
        """The model at an apex, with the leg put to its angle and the foot above the ground."""
        s = s.to("flight", way="down", angle=s.touchdown_angle)
        return s if s.above_ground(*s.foot()) > 0 else s.to("no_start")

    @event("flight", way="down", when=lambda s: s.above_ground(*s.foot()), unit="m")
    def touchdown(s):
        """The foot reaches the ground. It slides at once outside the friction cone."""
        foot_x, foot_y = s.foot()
        s = s.replace(foot_x=foot_x, foot_y=foot_y, touchdown_time=s.time, left_early=0)
        foot_vx = s.vx - s.retraction_rate * (s.y - foot_y)
        foot_vy = s.vy + s.retraction_rate * (s.x - foot_x)
        slip = foot_vx * cos(s.slope) + foot_vy * sin(s.slope)
        fall = foot_vy * cos(s.slope) - foot_vx * sin(s.slope)
        s = s.replace(impact_friction=abs(slip / fall), stance_friction=abs(s.along() / s.off()),
                      tilt=abs(s.along() / s.free_length))
        if s.off() <= 0:
            return s.to("fallen")
        return s.to("slides") if s.stance_friction > s.friction else s.to("stance")

    @event("flight", when=lambda s: s.above_ground(s.x, s.y), unit="m")
    def falls(s):
        """The mass reaches the ground."""
        return s.to("fallen")

    @event("stance", unit="m2",
           when=lambda s: s.free_length**2 - (s.x - s.foot_x) ** 2 - (s.y - s.foot_y) ** 2)
    def take_off(s):
        """The spring is relaxed."""
        return s.rises()

    def end_stance(s):
        """The stance's duration, and the friction that it needed, up to the largest friction allowed."""
        squared_cosine = 1 - s.tilt * s.tilt
        cosine = sqrt(select(squared_cosine > 1e-18, squared_cosine, 1e-18))
        return s.replace(stance_time=s.time - s.touchdown_time, stance_friction=s.tilt / cosine)

    def rises(s):
        """Flight after a stance, or a fall if the mass does not rise."""
        s = s.end_stance()
        return s.to("fallen") if s.vy <= 0 else s.to("flight", way="up")

    @event("stance", when=lambda s: s.in_cone(1), unit="m")
    def leaves_cone(s):
        """The leg reaches theta = -arctan mu: the energy left in the spring is lost."""
        return s.replace(left_early=1).rises()

    @event("stance", when=lambda s: s.in_cone(-1), unit="m")
    def slides_out(s):
        """The leg turns back and leaves the friction cone."""
        return s.end_stance().to("slides")

    @event("stance", when=lambda s: s.off(), unit="m")
    def collapses(s):
        """The mass reaches the ground in stance."""
        return s.to("fallen")

    @event("flight", way="up", when=lambda s: s.vy, unit="m/s")
    def apex(s):
        """The mass rises no more, and the leg is put to its angle."""
        height = s.above_ground(s.x, s.y)
        energy = s.mass * (s.vx * s.vx / 2 + s.gravity * height)
        s = s.replace(apex_height=height, apex_energy=energy, apex_x=s.x, step_length=s.x - s.apex_x)
        return s.goes_down()

    @observe("stance", "largest", into="tilt")
    def tilt_ahead(s):
        """Sine of the leg's angle while the mass is ahead of the foot."""
        return s.along() / s.length()

    @observe("stance", "largest", into="tilt")
    def tilt_behind(s):
        """Sine of the leg's angle while the mass is behind the foot."""
        return -s.along() / s.length()
