"""Friction between foot and ground: Coulomb's law, one coefficient for stick and slip (2)."""

from ..hybrid import Model, input, select, state


class Friction(Model):
    """The cone of a foot at rest, the force on one that slips, and the impact."""

    prefix = "ground"
    friction = input(0.6, "1", "Coefficient of friction of foot and ground, mu", least=0, most=1e6)

    way = state(1, "1", "Direction of slip, 1 or -1")
    friction_loss = state(
        0, "J", "Energy lost to sliding friction since the start", name="energy.friction_loss")
    impact_loss = state(0, "J", "Energy lost in impacts since the start", name="energy.impact_loss")

    def cone(r):
        """Largest force along the ground on a foot at rest."""
        return r.friction * r.standing().normal

    def slip_friction(r):
        """Coefficient of friction of a foot that slips."""
        return r.friction

    def speed_after_impact(r, speed, normal_speed):
        """Speed of the foot along the ground after an impact, 0 where friction stops it  (4)-(6)."""
        lost = r.friction * normal_speed
        return select(speed <= lost, 0, speed - lost)
