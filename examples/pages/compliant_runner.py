"""A runner on ground that yields: a spring with the damping of Hunt and Crossley (1975)."""

from tdmf_slip.hybrid import Record, event, mode, observe, parameter, select, state
from tdmf_slip.pages import PLACE, PlainRunner


class CompliantRunner(PlainRunner):
    """The foot sinks into the ground: it has no impact, may bounce, and is free where nothing bears it.

    At the penetration d = -y the normal force is f_n = k_g d (1 + c_g ddot), 0 where the foot leaves its dent
    faster than the ground follows. In `graze` the foot is free: it bounces until the law of stance presses it
    down no more, and is released while the law of flight still does.
    """

    prefix = "ground"
    ground_stiffness = parameter(1000, "N/m", "Stiffness, k_g", name="ground.stiffness", above=0)
    dissipation = parameter(50, "s/m", "Damping over stiffness, c_g", least=0)
    foot_off = state(0, "m", "Height of the foot, y", of="ground")
    foot_off_rate = state(0, "m/s", "Vertical velocity of the foot", of="ground")
    in_dent, pressed = state(0, "1", "1 if a free foot is below 0"), state(1, "1", "-1 if stance lifts it")
    ground_loss = state(0, "J", "Energy lost in the ground since the start", name="energy.ground_loss")
    contacts, contacts_so_far = state(0, "1", "Contacts in the last stride"), state(0, "1", "In the open one")
    depth, depth_so_far = state(0, "m", "Largest d in the last stride"), state(0, "m", "In the open one")
    impact_loss, rises_again, starts_above_ground, apex_in_graze = 0, 0, None, None

    def standing(r):
        """The normal force f_n, and the force along the ground that holds the foot in place."""
        normal = -r.ground_stiffness * r.foot_off * r.follows()
        return Record(normal=normal, along=r.push(r.stance_torque()).along)

    def follows(r):
        """1 + c_g ddot, which is positive while the ground follows the foot."""
        return 1 - r.dissipation * r.foot().vy

    def on_ground(r, push, torque, foot_acceleration=0):
        """The foot moves up and down, too."""
        rises = ((0 if r.mode == "graze" else r.standing().normal) - push.off) / r.foot_mass - r.gravity
        rates = super().on_ground(push, torque, foot_acceleration)
        return rates | dict(vy=rates["vy"] - rises, foot_off=r.foot_off_rate, foot_off_rate=rises)

    def leg_rates(r):
        """Power lost in the damper, and in the ground: (f_n - k_g d) ddot."""
        lost = r.dissipation * r.foot().vy if r.mode in ("stick", "slip") else r.in_dent
        return super().leg_rates() | dict(ground_loss=-r.ground_stiffness * r.foot().y * r.foot().vy * lost)

    @mode("course", of="ground")
    def graze(r):
        """The foot is free."""
        push = r.push(r.torque())
        return r.on_ground(push, r.torque(), -push.along / r.foot_mass) | r.swing_rates()

    def bounces(r):
        """True while the foot is free in a stance that goes on."""
        return r.mode == "graze" and r.course == "bounce"

    def in_stance(r):
        """True while the stance law drives the hip."""
        return super().in_stance() or r.bounces()

    @event("start_of_run", when=lambda r: -1, counted=False)
    def begins(r):
        """A run begins with a free foot, and contact may follow at once. An apex opens a stride."""
        r = r.replace(liftoff_angle=r.angle, in_dent=select(r.foot().y < -r.margin_of("m"), 1, 0))
        return r.start_flight()

    @event("flight graze", only=lambda r: r.mode == "flight" or r.bounces(),
           when=lambda r: (1 - r.in_dent) * r.foot().y / r.free_length - r.in_dent * r.follows())
    def touchdown(r):
        """Contact begins, at d = 0 or in a dent at 1 + c_g ddot = 0. After a flight it begins a stance."""
        if r.mode == "flight":
            r = r.replace(
                driving=select(r.angle >= 0, 1, 0), touchdowns_so_far=r.touchdowns_so_far + 1, bar_is_due=1,
                touchdown_time=r.time, placing=0, placed_for=r.placing, was_placed=r.is_placing())
        r = r.to("stick", contacts_so_far=r.contacts_so_far + 1)
        r = r.replace(foot_off=r.in_dent * r.foot_off, slid_from=r.foot_x)
        return r.slide(select(r.foot_vx > 0, 1, -1)) if abs(r.foot_vx) > 0 else r.resting()

    @event("stick slip", when=lambda r: r.standing().normal, unit="N")
    def contact_ends(r):
        """The ground bears the foot no more. The foot bounces, or lifts off at once."""
        in_dent = select(-r.foot_off / r.free_length > r.follows(), 1, 0)
        return r.to("graze", course="bounce", pressed=1, in_dent=in_dent, foot_off=in_dent * r.foot_off)

    @event("flight graze", when=lambda r: -r.foot().y, unit="m", counted=False, only=lambda r: r.in_dent > 0)
    def leaves_dent(r):
        """A free foot rises above y = 0."""
        return r.replace(in_dent=0)

    @event("graze", when=lambda r: r.pressed * r.holding(r.stance_torque()).normal, unit="N", counted=False)
    def graze_to_contact(r):
        """The law of stance presses the foot down, or ceases to. A released foot then bounces again."""
        turned = r.replace(pressed=-r.pressed)
        return turned if r.bounces() else turned.replace(course="bounce").count_event(1)

    @event("graze", course="bounce", when=lambda r: -r.foot_off_rate, unit="m/s",
           only=lambda r: r.pressed < 0)
    def lift_off(r):
        """The stance is over. A stance that began at this instant has not ended place."""
        return super().lift_off().replace(course="release")

    @event("flight graze", when=lambda r: r.rise(), unit="m/s", crossing=lambda r: r.bounces(),
           only=lambda r: r.bounces() or r.swing < PLACE)
    def apex(r):
        """A stride closes and place begins. In a bounce, the leg angle is latched."""
        return PlainRunner.apex(r.replace(liftoff_angle=r.leg().angle) if r.bounces() else r).fly()

    def open_stride(r):
        """Count contacts anew at each apex."""
        return super().open_stride().replace(
            contacts=r.contacts_so_far, contacts_so_far=0, depth=r.depth_so_far, depth_so_far=0)

    @observe("stick slip", "largest", into="depth_so_far", unit="m")
    def penetration(r):
        """Penetration, d."""
        return -r.foot_off

    def energy(r):
        """Mechanical energy, with that of the ground."""
        return super().energy() + r.ground_stiffness * select(r.foot().y < 0, r.foot().y, 0) ** 2 / 2
