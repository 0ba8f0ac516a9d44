"""The reduced map: the leg is placed in flight as if by itself, so that an apex has two coordinates."""

from ..hybrid import Record, cos, event, mode, output, section, sin
from .hip import PLACE, RETRACT
from .runner import PlainRunner, RunnerOnOneLine


class ReducedRunner(RunnerOnOneLine):
    """After the apex the leg has the length l0 + u and the angle theta0 - omega t; after lift-off it is lost.

    Impact and stance are those of `Runner`. A stance ends where the stance law loads the foot no more.
    """

    friction_rate = extension_rate = external_fx_rate = external_fy_rate = external_torque_rate = 0
    kp = kd = liftoff_factor = swing_clamp = was_placed = placed_for = rises_again = has_hopped = hop_time = 0
    positive_leg_work = greatest_slip_velocity = greatest_foot_height = squared_torque = 0
    slip_velocity = height_of_foot = square_of_torque = None
    graze = wind_rises = new_ground = apex_in_graze = clamp = release = ramp_ends = None
    graze_to_contact = graze_to_flight = None
    notes_compression = 0

    def place_leg(r):
        """The leg at an apex, which begins to turn."""
        length = r.free_length + r.extension
        return r.replace(
            length=length, length_rate=0, angle=r.touchdown_angle + r.more_angle,
            momentum=-r.retraction_rate * (length * length))

    @section("apex", "apex_com_height apex_com_speed")
    def at_apex(r, at):
        """A start at an apex, with the centre of mass at x = 0 and the leg at rest."""
        start = super().at_apex(Record(
            **vars(at), apex_length=r.free_length + r.extension, apex_length_rate=0,
            apex_angle=r.touchdown_angle + r.more_angle, apex_angle_rate=0))
        center, slope = start.center().x, r.set_slope()
        return start.replace(seen_x=-center, seen_y=start.seen_y - sin(slope) / cos(slope) * center)

    @event("start_of_run", when=lambda r: -1, counted=False)
    def begins(r):
        """Every run begins at an apex, with the foot above the ground."""
        r = r.replace(liftoff_angle=r.angle, height=r.set_height(), slope=r.set_slope())
        flying = r.to("flight", swing=PLACE, placing=0).place_leg()
        if flying.foot_above(r.height, r.slope) <= 0:
            return r.to("no_start")
        return flying.open_stride()

    @mode(of="flight")
    def flight(r):
        """The centre of mass is ballistic. The leg turns after the apex."""
        total, fx, fy = r.body_mass + r.foot_mass, r.external_fx, r.external_fy
        return dict(com_x=r.com_vx, com_y=r.com_vy, com_vx=fx / total, com_vy=fy / total - r.gravity,
                    external_work=fx * r.com_vx + fy * r.com_vy, placing=r.is_placing(),
                    angle=r.is_placing() * r.leg().angle_rate)

    @mode(of="world", ends=True)
    def no_start(r):
        """The foot is not above the ground at the apex."""
        return {}

    @mode(of="world", ends=True)
    def no_stance(r):
        """The impact leaves no load on the foot."""
        return {}

    @mode(of="world", ends=True)
    def no_apex(r):
        """The centre of mass does not rise at lift-off, or nothing pulls it down."""
        return {}

    @event("flight stick slip", when=lambda r: r.body_above(), unit="m", only=lambda r: r.may_fall())
    def falls(r):
        """The body reaches the ground."""
        return r.to("fallen")

    def may_fall(r):
        """True if the body may reach the ground; in flight, before the foot, where the leg may lie flat."""
        if r.mode != "flight":
            return True
        if r.swing < PLACE:
            return False
        if abs(r.retraction_rate) > 0:
            return True
        return cos(r.angle - r.slope) < 0.01

    @event("stick slip", when=lambda r: -r.leg().length_rate, unit="m/s", counted=False,
           only=lambda r: r.may_thrust())
    def greatest_compression(r):
        """Thrust begins where the leg is shortest, once per stance."""
        return r.with_thrust(1).count_event(1)

    def may_thrust(r):
        """True while a thrust is to come in this stance."""
        return r.thrusting <= 0 and r.thrust + r.more_thrust > 0

    @event("stick slip", when=lambda r: r.leg().length - r.least_length, unit="m")
    def collapses(r):
        """The leg is shorter than leg.min_length."""
        return r.to("fallen")

    @event("flight", when=lambda r: r.foot_above(r.height, r.slope), unit="m",
           only=lambda r: r.swing > RETRACT)
    def touchdown(r):
        """The foot reaches the ground."""
        return r.land(was_placed=1)

    @event("stick slip", when=lambda r: r.standing().normal, unit="N")
    def lift_off(r):
        """The centre of mass flies to the next apex."""
        if r.time <= r.touchdown_time:
            return r.to("no_stance")
        if r.rise() <= 0 or r.external_fy >= (r.body_mass + r.foot_mass) * r.gravity:
            return r.to("no_apex")
        return r.replace(liftoff_angle=r.leg().angle, placing=0).with_thrust(0).to("flight", swing=RETRACT)

    @event("flight", when=lambda r: r.rise(), unit="m/s", only=lambda r: r.swing < PLACE)
    def apex(r):
        """A stride closes, and the leg is placed anew."""
        closed = r.replace(swing=PLACE, placing=0).place_leg().close_stride()
        return closed.to("no_start") if closed.foot_above(r.height, r.slope) <= 0 else closed

    @output("N.m", name="hip.torque")
    def torque(r):
        """Total hip torque in stance, external torque included."""
        return r.stance_torque() if r.mode in ("stick", "slip") else 0


class PlainReducedRunner(PlainRunner, ReducedRunner):
    """The reduced map of the runner on level ground with constant friction, driven by the hip alone."""

    thrusting, greatest_compression = 0, None
