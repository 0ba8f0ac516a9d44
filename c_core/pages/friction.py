"""Friction between foot and ground: Coulomb's law, friction that falls with speed, a slippery patch.

The patch divides the ground into zones: 0 before it, 1 on it, 2 beyond.
"""

from ..hybrid import Model, event, exp, expm1, input, log1p, parameter, select, state


class Friction(Model):
    """Coulomb's law (2); at rest rho mu, in slip mu (1 + (rho - 1) exp(-|v|/v_s))."""

    prefix = "ground"
    friction = input(0.6, "1", "Friction coefficient between foot and ground, mu", least=0, most=1e6)
    static_ratio = parameter(
        1, "1", "Static over kinetic friction coefficient, rho",
        name="ground.static_friction_ratio", least=1, most=1e6)
    stribeck_velocity = parameter(
        0, "m/s", "Stribeck velocity: scale of the slip speed over which friction falls, v_s",
        least=0, most=1e9)
    patch_begin = parameter(0, "m", "Position where the patch begins", least=-1e9, most=1e9)
    patch_end = parameter(
        0, "m", "Position where the patch ends; at most ground.patch_begin for no patch", least=-1e9,
        most=1e9)
    patch_friction = parameter(0.1, "1", "Friction coefficient on the patch, mu_p", least=0, most=1e6)

    way = state(1, "1", "Direction of slip, 1 or -1")
    zone = state(0, "1", "Zone of the ground below a slipping foot")
    zone_ahead = state(0, "1", "Zone that a foot at rest would slip into, forward")
    zone_behind = state(0, "1", "Zone that a foot at rest would slip into, backward")
    friction_loss = state(
        0, "J", "Energy lost to sliding friction since the start", name="energy.friction_loss")
    impact_loss = state(0, "J", "Energy lost in impacts since the start", name="energy.impact_loss")

    @event("flight stick slip graze", when=lambda r: r.friction, counted=False,
           only=lambda r: r.friction_rate < 0)
    def ramp_ends(r):
        """A ramp of the friction coefficient ends at 0."""
        return r.replace(friction=0, friction_rate=0)

    def friction_in(r, zone):
        """Friction coefficient in a zone."""
        on_patch = zone * (2 - zone)
        return (1 - on_patch) * r.friction + on_patch * r.patch_friction

    def zones(r):
        """The zones that the foot would slip into, forward and backward; they differ on a border."""
        x, margin, begin, end = r.foot().x, r.margin_of("m"), r.patch_begin, r.patch_end
        ahead = select(x >= begin - margin, 1, 0) + select(x >= end - margin, 1, 0)
        behind = select(x > begin + margin, 1, 0) + select(x > end + margin, 1, 0)
        return dict(zone_ahead=ahead, zone_behind=behind)

    def zone_along(r, way):
        """The zone that the foot would slip into, in a direction."""
        return select(way > 0, r.zone_ahead, r.zone_behind)

    def border_ahead(r):
        """Index of the next border in the direction of slip: 0 where the patch begins, 1 where it ends."""
        return r.zone - (1 - r.way) / 2

    def border_distance(r):
        """Distance to the next border in the direction of slip."""
        border = r.patch_begin + r.border_ahead() * (r.patch_end - r.patch_begin)
        return r.way * (border - r.foot().x)

    def has_border_ahead(r):
        """Whether a border lies ahead of the slipping foot."""
        return r.patch_end > r.patch_begin and r.border_ahead() >= 0 and r.border_ahead() <= 1

    def cone(r, zone):
        """Largest tangential force that static friction bears in a zone."""
        return r.static_ratio * r.friction_in(zone) * r.standing().normal

    def slip_friction(r):
        """Friction coefficient of a slipping foot."""
        if r.law == "constant":
            return r.friction_in(r.zone)
        fading = exp(-r.way * r.foot_vx / r.stribeck_velocity)
        return r.friction_in(r.zone) * (1 + (r.static_ratio - 1) * fading)

    def friction_falls(r):
        """Whether friction falls with the slip speed."""
        return r.stribeck_velocity > 0 and r.static_ratio > 1

    def time_scale_of_slip(r):
        """Time in which falling friction changes the slip speed by v_s, or lets an error grow e times."""
        if r.law == "constant":
            return None
        growth = (r.static_ratio - 1) * r.friction_in(r.zone) * r.standing().normal / r.stribeck_velocity
        force = r.standing().along + r.way * r.slip_friction() * r.standing().normal
        by_growth = r.foot_mass / abs(growth)
        by_speed = r.stribeck_velocity * r.foot_mass / abs(force)
        return select(by_growth < by_speed, by_growth, by_speed)

    def speed_after_impact(r, speed, normal_speed, friction):
        """Speed of the foot along the ground after an impact, 0 where friction stops it  (4)-(6)."""
        lost = friction * normal_speed
        after = select(speed <= r.static_ratio * lost, 0, speed - lost)
        if not r.friction_falls():
            return after
        scale = r.stribeck_velocity
        more = -(r.static_ratio - 1) * expm1(-lost / scale)
        left = speed - lost + scale * log1p(-more * exp(-(speed - lost) / scale))
        return select(speed <= lost + scale * log1p(more), 0, select(left > 0, left, 0))
