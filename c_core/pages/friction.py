"""Friction between foot and ground: Coulomb's law, friction that falls with speed, borders of segments."""

from ..hybrid import Model, event, exp, expm1, input, log1p, parameter, select, state
from .ground import FAR


class Friction(Model):
    """Coulomb's law (2); at rest rho mu, in slip mu (1 + (rho - 1) exp(-|v|/v_s))."""

    prefix = "ground"
    friction = input(0.6, "1", "Friction coefficient between foot and ground, mu", least=0, most=1e6)
    static_ratio = parameter(
        1, "1", "Static over kinetic friction coefficient, rho",
        name="ground.static_friction_ratio", least=1, most=1e6)
    stribeck_velocity = parameter(
        0, "m/s", "Stribeck velocity: scale of the slip speed over which friction falls, v_s; 0 for none",
        least=0, most=1e9)

    way = state(1, "1", "Direction of slip, 1 or -1", values=int, least=-1, most=1)
    friction_loss = state(
        0, "J", "Energy lost to sliding friction since the start", name="energy.friction_loss")
    impact_loss = state(0, "J", "Energy lost in impacts since the start", name="energy.impact_loss")

    @event("flight stick slip graze", when=lambda r: r.friction, counted=False,
           only=lambda r: r.friction_rate < 0)
    def ramp_ends(r):
        """A ramp of the friction coefficient ends at 0."""
        return r.replace(friction=0, friction_rate=0)

    def friction_along(r, way):
        """Friction coefficient of the segment that the foot would slip into, in a direction."""
        own = select(way > 0, r.friction_ahead, r.friction_behind)
        is_own = select(own < 0, 0, 1)
        return is_own * own + (1 - is_own) * r.friction

    def border_distance(r):
        """Distance to the border in the direction of slip."""
        return r.way * (select(r.way > 0, r.segment_end, r.segment_begin) - r.foot().x)

    def has_border_ahead(r):
        """True if a border lies ahead of the slipping foot."""
        return select(r.way > 0, r.segment_end, -r.segment_begin) < FAR

    def cone(r, way):
        """Largest tangential force that static friction bears against slip in a direction."""
        return r.static_ratio * r.friction_along(way) * r.standing().normal

    def slip_friction(r):
        """Friction coefficient of a slipping foot."""
        if r.law == "constant":
            return r.friction_along(r.way)
        return r.friction_along(r.way) * (1 + (r.static_ratio - 1) * r.fading())

    def fading(r):
        """Share of the excess of static friction that is left at the slip speed."""
        return exp(-r.way * r.foot_vx / r.stribeck_velocity)

    def friction_falls(r):
        """True if friction falls with the slip speed."""
        return r.stribeck_velocity > 0 and r.static_ratio > 1

    def speed_of_friction(r):
        """Speed over which friction changes: the Stribeck velocity where friction falls with speed."""
        usual = r.scales["m/s"](r)
        falls = select(r.static_ratio > 1, select(r.stribeck_velocity > 0, 1, 0), 0)
        return select(falls * r.stribeck_velocity > 0, select(
            r.stribeck_velocity < usual, r.stribeck_velocity, usual), usual)

    def speed_in_layer(r):
        """Slip speed over the Stribeck velocity, by which margins are small in a thin layer, too."""
        return r.way * r.foot_vx / select(r.stribeck_velocity > 0, r.stribeck_velocity, 1)

    def time_scale_of_slip(r):
        """Time in which falling friction changes the slip speed by v_s, or lets an error grow e times."""
        if r.law == "constant":
            return None
        growth = (r.static_ratio - 1) * r.friction_along(r.way) * r.standing().normal / r.stribeck_velocity
        force = r.standing().along + r.way * r.slip_friction() * r.standing().normal
        by_growth = r.foot_mass / abs(growth)
        by_speed = r.stribeck_velocity * r.foot_mass / abs(force)
        return select(by_growth < by_speed, by_growth, by_speed)

    def speed_after_impact(r, speed, normal_speed, friction):
        """Speed of the foot along the ground after an impact, 0 where friction stops it  (4)-(6)."""
        lost = friction * normal_speed
        return select(speed <= r.stopped_speed(lost), 0, r.speed_left(speed, lost))

    def stopped_speed(r, lost):
        """Speed of the foot up to which friction stops it in an impact in which slip would lose `lost`."""
        if not r.friction_falls():
            return r.static_ratio * lost
        return lost + r.stribeck_velocity * log1p(r.gained(lost))

    def speed_left(r, speed, lost):
        """Speed of the foot after an impact that does not stop it."""
        if not r.friction_falls():
            return speed - lost
        scale = r.stribeck_velocity
        left = speed - lost + scale * log1p(-r.gained(lost) * exp(-(speed - lost) / scale))
        return select(left > 0, left, 0)

    def gained(r, lost):
        """Change of exp(speed/v_s) in an impact that stops the foot."""
        return -(r.static_ratio - 1) * expm1(-lost / r.stribeck_velocity)
