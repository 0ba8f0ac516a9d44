"""Friction between foot and ground: Coulomb's law, friction that falls with speed, a slippery patch.

The patch divides the ground into zones: 0 before it, 1 on it, 2 beyond.
"""

from ..hybrid import Model, exp, expm1, input, log1p, parameter, select, state

LAYER, CHANGE = 60, 3
"""Above 60 v_s friction is constant. Below, a step changes the speed by at most 3 v_s."""


class Friction(Model):
    """Coulomb's law (2); at rest rho mu, in slip mu (1 + (rho - 1) exp(-|v|/v_s))."""

    prefix = "ground"
    friction = input(0.6, "1", "Coefficient of friction of foot and ground, mu", least=0, most=1e6)
    static_ratio = parameter(
        1, "1", "Friction of a foot at rest over that of one that slips, rho",
        name="ground.static_friction_ratio", least=1, most=1e6)
    stribeck_velocity = parameter(
        0, "m/s", "Speed over which friction falls from that of a foot at rest to that of slip, v_s",
        least=0, most=1e9)
    patch_begin = parameter(0, "m", "Where a patch of ground with a friction of its own begins")
    patch_end = parameter(0, "m", "Where the patch ends; no patch where it begins")
    patch_friction = parameter(0.1, "1", "Coefficient of friction of foot and patch, mu_p", least=0, most=1e6)

    way = state(1, "1", "Direction of slip, 1 or -1")
    zone = state(0, "1", "Zone of a foot that slips")
    zone_ahead = state(0, "1", "Zone of a foot that is pushed forward")
    zone_behind = state(0, "1", "Zone of a foot that is pushed backward")
    friction_loss = state(
        0, "J", "Energy lost to sliding friction since the start", name="energy.friction_loss")
    impact_loss = state(0, "J", "Energy lost in impacts since the start", name="energy.impact_loss")

    def friction_in(r, zone):
        """Coefficient of friction in a zone."""
        on_patch = zone * (2 - zone)
        return (1 - on_patch) * r.friction + on_patch * r.patch_friction

    def zones(r):
        """The zones of a foot that moves, or is pushed, forward or backward: on a border they differ."""
        x, margin, begin, end = r.foot().x, 1e-12 * r.free_length, r.patch_begin, r.patch_end
        ahead = select(x >= begin - margin, 1, 0) + select(x >= end - margin, 1, 0)
        behind = select(x > begin + margin, 1, 0) + select(x > end + margin, 1, 0)
        return dict(zone_ahead=ahead, zone_behind=behind)

    def zone_along(r, way):
        """The zone of a foot that moves in a direction."""
        return select(way > 0, r.zone_ahead, r.zone_behind)

    def border_ahead(r):
        """The next border along the slip: 0 where the patch begins, 1 where it ends."""
        return r.zone - (1 - r.way) / 2

    def border_distance(r):
        """Distance to that border."""
        border = r.patch_begin + r.border_ahead() * (r.patch_end - r.patch_begin)
        return r.way * (border - r.foot().x)

    def has_border_ahead(r):
        """Whether the foot slips towards a border."""
        return r.patch_end > r.patch_begin and r.border_ahead() >= 0 and r.border_ahead() <= 1

    def cone(r, zone):
        """Largest force along the ground on a foot at rest."""
        return r.static_ratio * r.friction_in(zone) * r.standing().normal

    def slip_friction(r):
        """Coefficient of friction of a foot that slips."""
        if r.law == "constant":
            return r.friction_in(r.zone)
        fading = exp(-r.way * r.foot_vx / r.stribeck_velocity)
        return r.friction_in(r.zone) * (1 + (r.static_ratio - 1) * fading)

    def friction_falls(r):
        """Whether friction depends on the speed."""
        return r.stribeck_velocity > 0 and r.static_ratio > 1

    def longest_step(r):
        """Longest step that resolves falling friction: neither growth nor change of speed is large."""
        if r.law == "constant":
            return None
        growth = (r.static_ratio - 1) * r.friction_in(r.zone) * r.standing().normal / r.stribeck_velocity
        force = r.standing().along + r.way * r.slip_friction() * r.standing().normal
        by_growth = 3 * r.foot_mass / abs(growth)
        by_speed = CHANGE * r.stribeck_velocity * r.foot_mass / abs(force)
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
