"""TDMF-SLIP: a spring-legged runner whose foot has a mass and can slip (Or & Moravia 2016)."""

from ..hybrid import Model, Record, cos, event, mode, output, require, section, select, sin, sqrt, state
from .friction import Friction
from .ground import Ground
from .hip import PLACE, REST, RETRACT, Hip
from .leg import Leg
from .stride import Stride


HIGHEST_HOP = 1e-6
"""Lift of the flight law, over k l0, up to which a hop may last no time.

A stronger lift can only end at once by rounding errors of a foot that is far away.
"""


class Runner(Hip, Friction, Leg, Ground, Stride, Model):
    """The whole runner. `PlainRunner` below leaves out everything but level ground."""

    start = "start_of_run", {}
    scales = {
        "m": lambda r: r.free_length,
        "m/s": lambda r: r.free_length * sqrt(r.stiffness / r.body_mass),
        "m2/s": lambda r: r.free_length * r.free_length * sqrt(r.stiffness / r.body_mass),
        "rad/s": lambda r: sqrt(r.stiffness / r.body_mass),
        "s": lambda r: sqrt(r.body_mass / r.stiffness),
        "N": lambda r: r.stiffness * r.free_length,
        "N.m": lambda r: r.stiffness * r.free_length * r.free_length,
        "J": lambda r: r.stiffness * r.free_length * r.free_length,
        "N2.m2.s": lambda r: (r.stiffness * r.free_length * r.free_length) ** 2
        * sqrt(r.body_mass / r.stiffness),
    }

    nominals = {"seen_vx": lambda r: r.speed_of_friction()}

    # ---- forces of the ground

    def holding(r, torque):
        """Force of the ground on a foot at rest, under a given hip torque  (10)."""
        push = r.push(torque)
        weight = r.on_line(0, r.foot_mass * r.gravity)
        return Record(normal=push.off + weight.off, along=push.along + weight.along)

    def standing(r):
        """Force of the ground on a foot at rest, under the stance law."""
        return r.holding(r.stance_torque())

    def in_stance(r):
        """True in the modes in which the stance law drives the hip."""
        return r.mode in ("stick", "slip")

    def flight_lifts(r):
        """Normal force that holds the foot under the flight law; if negative, that law lifts the foot."""
        return r.holding(r.swing_torque()).normal

    def equilibrium_turn(r):
        """tau_eq/r^2, where the torque tau_eq keeps the foot on the ground without force."""
        weight = r.on_line(0, r.foot_mass * r.gravity)
        return -(r.spring() / r.leg().length * r.y + weight.off) / r.x

    # ---- the start of a run, in the world's coordinates

    @require("foot.y", "on the ground or above it")
    def starts_above_ground(r):
        """Height of the foot above the ground."""
        return r.foot_above(r.set_height(), r.set_slope()) + r.margin_of("m")

    @require("leg.length", "at least leg.min_length")
    def starts_long_enough(r):
        """Length of the leg in excess of leg.min_length."""
        return r.length - r.least_length

    @require("body.y", "above the ground; it follows from foot.y, leg.length and leg.angle")
    def body_starts_above_ground(r):
        """Positive where the body is above the ground."""
        body, height, slope = r.body(), r.set_height(), r.set_slope()
        return select(cos(slope) * (body.y - height) - sin(slope) * body.x > 0, 1, -1)

    @require("leg.min_length", "at most leg.free_length")
    def can_be_unloaded(r):
        """Length of the unloaded leg in excess of leg.min_length."""
        return r.free_length - r.least_length

    @require("ground.patch_end", "at least ground.patch_begin")
    def patch_has_length(r):
        """Length of the patch."""
        return r.patch_end - r.patch_begin

    @require("ground.stribeck_velocity", "0, or at least 1e-9 leg.free_length sqrt(leg.stiffness/body.mass)")
    def layer_is_wide(r):
        """Positive if the layer in which friction falls is not too narrow, or absent."""
        narrowest = 1e-9 * r.free_length * sqrt(r.stiffness / r.body_mass)
        return select(r.stribeck_velocity > 0, r.stribeck_velocity - narrowest, 0)

    @mode(of="world")
    def start_of_run(r):
        """Start of a run, in the world's states."""
        return {}

    @event("start_of_run", when=lambda r: -1, counted=False)
    def begins(r):
        """An impact if the foot is on the ground and does not rise, else flight. An apex opens a stride."""
        r = r.replace(liftoff_angle=r.angle, height=r.set_height(), slope=r.set_slope())
        foot, slow = r.foot(), r.margin_of("m/s")
        falls = r.on_line(foot.vx, foot.vy).off
        if r.foot_above(r.height, r.slope) <= r.margin_of("m") and falls <= slow:
            return r.land(was_placed=0)
        return r.start_flight()

    def start_flight(r):
        """A run begins in flight, with a stride if it begins at an apex."""
        flying, slow = r.to("flight", wind="calm", swing=PLACE, placing=0), r.margin_of("m/s")
        if abs(r.rise()) <= slow:
            return flying.open_stride()
        return flying if r.rise() < 0 else flying.replace(swing=r.rising_swing())

    @section("apex", "apex_com_height apex_com_speed apex_length apex_angle apex_length_rate apex_angle_rate")
    def at_apex(r, at):
        """A start at an apex, with the foot at x = 0."""
        leg = r.replace(length=at.apex_length, angle=at.apex_angle, length_rate=at.apex_length_rate,
                        angle_rate=at.apex_angle_rate)
        body, share, slope = leg.body_from_foot(), r.share(), r.set_slope()
        ground = r.set_height() + sin(slope) / cos(slope) * (share * body.x)
        return leg.replace(
            seen_x=0, seen_y=ground + at.apex_com_height - share * body.y,
            seen_vx=at.apex_com_speed - share * body.vx, seen_vy=-share * body.vy)

    # ---- modes

    @mode("wind", of="flight")
    def flight(r):
        """The centre of mass is ballistic; the leg obeys rddot = r w^2 + M F_s and d(r^2 w)/dt = M tau."""
        leg = r.leg()
        mobility = 1 / r.body_mass + 1 / r.foot_mass
        torque = r.swing_torque()
        rates = dict(
            com_x=r.com_vx, com_y=r.com_vy, com_vy=-r.gravity, length=r.length_rate, angle=leg.angle_rate,
            length_rate=r.length * (leg.angle_rate * leg.angle_rate) + mobility * r.spring(),
            momentum=mobility * torque, work=torque * leg.angle_rate, **r.leg_rates(), **r.swing_rates())
        return rates if r.wind == "calm" else rates | r.pushed(rates)

    def pushed(r, rates):
        """Rates of flight that an external force on the body changes."""
        leg, fx, fy, sine, cosine = r.leg(), r.external_fx, r.external_fy, sin(r.angle), cos(r.angle)
        total_mass = r.body_mass + r.foot_mass
        axial, moment = fy * cosine - fx * sine, -r.length * (fx * cosine + fy * sine)
        power_on_leg = (1 - r.share()) * (r.length_rate * axial + leg.angle_rate * moment)
        return dict(
            com_vx=fx / total_mass, com_vy=fy / total_mass - r.gravity,
            length_rate=rates["length_rate"] + axial / r.body_mass,
            momentum=rates["momentum"] + moment / r.body_mass,
            external_work=fx * r.com_vx + fy * r.com_vy + power_on_leg)

    def on_ground(r, push, torque, foot_acceleration=0):
        """Rates of the body relative to the foot, and of the foot  (8)-(9)."""
        weight, outside = r.on_line(0, r.gravity), r.on_line(r.external_fx, r.external_fy)
        return dict(
            x=r.vx, y=r.vy,
            vx=(push.along + outside.along) / r.body_mass - weight.along - foot_acceleration,
            vy=(push.off + outside.off) / r.body_mass - weight.off,
            foot_x=r.foot_vx, foot_vx=foot_acceleration, work=torque * r.leg().angle_rate, **r.leg_rates(),
            external_work=outside.along * (r.foot_vx + r.vx) + outside.off * r.vy)

    @mode(of="ground")
    def stick(r):
        """The foot is at rest."""
        return r.on_ground(r.push(r.stance_torque()), r.stance_torque())

    @mode("law", of="ground", time_scale=lambda r: r.time_scale_of_slip())
    def slip(r):
        """m_f vdot = p - s mu f_n, where p is the push of the leg and s the direction of slip."""
        friction_force = r.way * r.slip_friction() * r.standing().normal
        acceleration = (-r.standing().along - friction_force) / r.foot_mass
        rates = r.on_ground(r.push(r.stance_torque()), r.stance_torque(), acceleration)
        return rates | dict(friction_loss=friction_force * r.foot_vx)

    @mode(of="ground")
    def graze(r):
        """The foot touches the ground without force, under the torque tau_eq between both hip laws."""
        axial, turning = r.spring() / r.leg().length, r.equilibrium_turn()
        weight = r.on_line(0, r.foot_mass * r.gravity)
        push = Record(along=axial * r.x - turning * r.y, off=-weight.off)
        acceleration = -(push.along + weight.along) / r.foot_mass
        return r.on_ground(push, r.torque(), acceleration) | r.swing_rates()

    @mode(of="world", ends=True, keeps_outputs=True)
    def fallen(r):
        """The run is over."""
        return {}

    has_fallen = state(
        0, "1", "True after a fall, which freezes the motion", name="status.fallen", values=bool)

    # ---- changes of mode

    def contact(r, foot_velocity, **changes):
        """Contact with this velocity of the foot along the ground; the body keeps its velocity."""
        body = r.body()
        kept = r.on_line(body.vx, body.vy)
        landed = r.to("stick", **changes)
        return landed.replace(foot_vx=foot_velocity, vx=kept.along - foot_velocity, vy=kept.off)

    def land(r, was_placed):
        """Inelastic impact of the foot, with the impulse of friction along the ground  (4)-(6)."""
        foot = r.foot()
        before = r.on_line(foot.vx, foot.vy)
        way = select(before.along >= 0, 1, -1)
        landing = r.replace(**r.neighbours())
        friction = landing.friction_along(way)
        after = way * r.speed_after_impact(way * before.along, -before.off, friction)
        speeds = before.along * before.along + before.off * before.off - after * after
        lost = r.foot_mass * speeds / 2
        landed = landing.contact(
            after, driving=select(r.leg().angle >= 0, 1, 0), impact_loss=r.impact_loss + lost,
            was_placed=was_placed, placed_for=r.placing, placing=0, touchdown_time=r.time,
            touchdowns_so_far=r.touchdowns_so_far + 1, bar_is_due=1)
        landed = landed.replace(slid_from=landed.foot_x)
        return landed.slide(way) if way * after > 0 else landed

    def slide(r, way):
        """Slip in a direction. Slow slip enters the layer of falling friction at once."""
        onto = r.on_segment(r.segment_towards(way))
        return r.to("slip", way=way, law="constant", **onto | r.kept_in_stance(onto))

    def resting(r):
        """A foot at rest sticks inside the friction cone; outside, it slips in the direction of the push.

        Where it stops late, the body keeps its velocity.
        """
        r = r.replace(vx=r.vx + r.foot_vx, foot_vx=0)
        along = r.standing().along
        way = select(along > 0, -1, 1)
        return r.to("stick") if abs(along) <= r.cone(way) else r.slide(way)

    def fly(r):
        """Flight begins, and thrust ends."""
        return r.with_thrust(0).to("flight", wind="calm")

    # ---- events, in the order in which those due at one instant are taken

    @event("flight", wind="calm", when=lambda r: -1, counted=False, only=lambda r: r.is_pushed())
    def wind_rises(r):
        """An external force acts, so flight is no longer ballistic."""
        return r.replace(wind="pushed")

    def is_pushed(r):
        """True if an external force acts or is ramped."""
        now, soon = abs(r.external_fx) + abs(r.external_fy), abs(r.external_fx_rate) + abs(r.external_fy_rate)
        return now > 0 or soon > 0

    @event("flight", when=lambda r: -r.foot_above(r.set_height(), r.set_slope()), unit="m",
           closely=True, only=lambda r: r.line_waits())
    def new_ground(r):
        """The foot is above the pending ground line, which comes into force."""
        return r.replace(height=r.set_height(), slope=r.set_slope())

    @event("flight stick slip graze", when=lambda r: r.body_above(), unit="m", counted=False)
    def falls(r):
        """The body reaches the ground."""
        return r.to("fallen", has_fallen=1)

    @event("flight stick slip graze", when=lambda r: r.leg().length - r.least_length, unit="m",
           counted=False)
    def collapses(r):
        """The leg is shorter than leg.min_length."""
        return r.to("fallen", has_fallen=1)

    @event("flight", when=lambda r: r.rise(), unit="m/s", crossing=lambda r: r.swing > RETRACT,
           only=lambda r: r.wind == "pushed" or r.swing < PLACE or r.rises_again > 0)
    def apex(r):
        """A stride closes and place begins. An external force can cause further apices in place."""
        return r.close_stride().replace(swing=PLACE, placing=0, rises_again=0)

    @event("graze", when=lambda r: r.rise(), unit="m/s", only=lambda r: r.swing < PLACE)
    def apex_in_graze(r):
        """Place begins. No stride closes, because the foot is on the ground."""
        return r.replace(swing=PLACE, placing=0)

    @event("flight", when=lambda r: r.foot_above(r.height, r.slope), unit="m")
    def touchdown(r):
        """The foot reaches the ground.

        Where the lift of the flight law vanishes, shorter and shorter hops follow each other. After one of
        no time the foot grazes, until the flight law has ceased to lift it and lifts it again.
        """
        if r.has_hopped > 0 and r.time <= r.hop_time:
            return r.to("graze")
        return r.land(was_placed=r.is_placing())

    @event("flight graze", when=lambda r: r.retracting_torque(), unit="N.m", counted=False,
           only=lambda r: r.swing_clamp > 0 and r.is_retracting())
    def clamp(r):
        """The clamp of the hip torque closes: it holds the retracting torque at 0."""
        return r.replace(swing=REST)

    @event("flight graze", when=lambda r: -r.retracting_torque(), unit="N.m", counted=False,
           only=lambda r: r.is_resting())
    def release(r):
        """The clamp of the hip torque opens: it releases the retracting torque."""
        return r.replace(swing=RETRACT)

    @event("stick slip", when=lambda r: -r.leg().length_rate, unit="m/s", counted=False,
           only=lambda r: r.thrusting <= 0 and r.notes_compression > 0)
    def greatest_compression(r):
        """Thrust begins where the leg is shortest, once per stance. A thrust of 0 is not counted."""
        return r.with_thrust(1).count_event(select(r.thrust + r.more_thrust > 0, 1, 0))

    @event("stick slip graze", when=lambda r: r.leg().angle, unit="rad", only=lambda r: r.driving > 0)
    def mid_stance(r):
        """Drive ends where the leg is upright, once per stance."""
        return r.replace(driving=0)

    @event("stick slip", when=lambda r: r.standing().normal, unit="N")
    def lift_off(r):
        """The normal force ends: flight if the flight law lifts the foot, too, else graze.

        A foot that is hardly lifted grazes, too: the guard of its flight decides by its rate. Not so below
        an upright leg, whose torque does not act along the normal.
        """
        off, leans = r.swinging(), r.x**2 > (1e-6 * r.free_length) ** 2
        lift, hardly = -off.flight_lifts(), select(leans, r.margin_of("N", "late"), -r.margin_of("N"))
        hops = select(leans, HIGHEST_HOP * r.scales["N"](r) - lift, -1)
        if lift > hardly:
            hopped, hop_time = select(hops > 0, 1, r.has_hopped), select(hops > 0, r.time, r.hop_time)
            return off.replace(has_hopped=hopped, hop_time=hop_time).fly()
        return off.to("graze")

    @event("slip", law="constant", unit="1", counted=False, only=lambda r: r.friction_falls(),
           when=lambda r: r.speed_in_layer() - r.decayed)
    def enters_layer(r):
        """Slip is slow enough for friction to depend on the speed."""
        return r.replace(law="falling")

    @event("slip", law="falling", unit="1", counted=False,
           when=lambda r: r.decayed + 1 - r.speed_in_layer())
    def leaves_layer(r):
        """Slip is fast enough for friction to be constant."""
        return r.replace(law="constant")

    @event("stick", when=lambda r: r.cone(1) + r.standing().along, unit="N")
    def slips_forward(r):
        """The push of the leg exceeds static friction, and the foot slips forward."""
        return r.slide(1)

    @event("stick", when=lambda r: r.cone(-1) - r.standing().along, unit="N")
    def slips_backward(r):
        """The push of the leg exceeds static friction, and the foot slips backward."""
        return r.slide(-1)

    @event("slip", when=lambda r: r.way * r.foot_vx, unit="m/s")
    def comes_to_rest(r):
        """The slip velocity reaches 0: the foot sticks, or slips the other way."""
        return r.replace(**r.kept_in_stance(r.neighbours())).resting()

    @event("slip", when=lambda r: r.border_distance(), unit="m", only=lambda r: r.has_border_ahead())
    def crosses_border(r):
        """The foot slips onto the next segment, whose line waits until the foot lifts off."""
        number = r.segment + r.way
        return r.moves_onto(number, **r.kept_in_stance(r.on_segment(number)))

    @event("graze", when=lambda r: -r.standing().normal, unit="N")
    def graze_to_contact(r):
        """The stance law presses the foot on the ground again."""
        r = r.replace(placing=0, **r.kept_in_stance(r.neighbours()))
        return r.slide(select(r.foot_vx > 0, 1, -1)) if abs(r.foot_vx) > 0 else r.resting()

    @event("graze", when=lambda r: r.flight_lifts(), unit="N", only=lambda r: not r.in_stance(),
           crossing=lambda r: r.has_hopped > 0 and r.mode_began <= r.hop_time)
    def graze_to_flight(r):
        """The flight law lifts the foot."""
        return r.fly()

    # ---- outputs

    @output("N.m", name="hip.torque")
    def torque(r):
        """Total hip torque, external torque included."""
        if r.in_stance():
            return r.stance_torque()
        if r.mode == "flight":
            return r.swing_torque()
        return r.equilibrium_turn() * r.leg().square if r.mode == "graze" else 0

    normal_force = output(
        "N", "Normal force of the ground on the foot, f_n", name="contact.normal",
        of=lambda r: r.standing().normal if r.mode in ("stick", "slip") else 0)

    @output("N", name="contact.tangential")
    def tangential_force(r):
        """Tangential force of the ground on the foot, positive uphill, f_t."""
        if r.mode == "slip":
            return -r.way * r.slip_friction() * r.standing().normal
        return r.standing().along if r.mode == "stick" else 0

    ground_force_x = output(
        "N", "Horizontal force of the ground on the foot", name="contact.fx",
        of=lambda r: r.in_world(r.tangential_force(), r.normal_force(), 0, 0).x)
    ground_force_y = output(
        "N", "Vertical force of the ground on the foot", name="contact.fy",
        of=lambda r: r.in_world(r.tangential_force(), r.normal_force(), 0, 0).y)
    force_of_leg = output(
        "N", "Force of spring and damper along the leg, positive when it pushes, F_s", name="leg.force",
        of=lambda r: r.spring())
    body_x = output("m", "Horizontal position of the body", name="body.x", of=lambda r: r.body().x)
    body_y = output("m", "Height of the body", name="body.y", of=lambda r: r.body().y)
    body_vx = output("m/s", "Horizontal velocity of the body", name="body.vx", of=lambda r: r.body().vx)
    body_vy = output("m/s", "Vertical velocity of the body", name="body.vy", of=lambda r: r.body().vy)
    center_x = output(
        "m", "Horizontal position of the centre of mass", name="com.x", of=lambda r: r.center().x)
    center_y = output("m", "Height of the centre of mass", name="com.y", of=lambda r: r.center().y)
    center_vx = output(
        "m/s", "Horizontal velocity of the centre of mass", name="com.vx", of=lambda r: r.center().vx)
    center_vy = output(
        "m/s", "Vertical velocity of the centre of mass", name="com.vy", of=lambda r: r.center().vy)

    @output("J", name="energy.kinetic")
    def kinetic_energy(r):
        """Kinetic energy of body and foot."""
        foot, body = r.foot(), r.body()
        of_body = r.body_mass * (body.vx * body.vx + body.vy * body.vy)
        return (of_body + r.foot_mass * (foot.vx * foot.vx + foot.vy * foot.vy)) / 2

    potential_energy = output(
        "J", "Potential energy of body and foot", name="energy.potential",
        of=lambda r: r.gravity * (r.body_mass * r.body().y + r.foot_mass * r.foot().y))

    @output("J", name="energy.elastic")
    def elastic_energy(r):
        """Elastic energy of the leg spring."""
        shorter = r.rest_length() - r.leg().length
        return r.stiffness * (shorter * shorter) / 2

    energy = output(
        "J", "Mechanical energy, which changes by all work less all losses", name="energy.total",
        of=lambda r: r.kinetic_energy() + r.potential_energy() + r.elastic_energy())

    @output(name="contact.mode", kind={
        "flight": "off the ground", "stick": "at rest on the ground", "slip_positive": "slipping forward",
        "slip_negative": "slipping backward",
        "graze": "on the ground without force, between stance and flight"})
    def kind_of_contact(r):
        """Contact mode of the foot."""
        if r.mode == "slip":
            return select(r.way > 0, 3, 4)
        return {"stick": 2, "graze": 5}.get(r.mode, 1)

    @output(name="hip.phase", kind={
        "drive": "touchdown to mid-stance", "coast": "the rest of the stance",
        "retract": "off the ground, centre of mass rising", "place": "off the ground, from the apex on"})
    def phase_of_hip(r):
        """Phase of the hip law."""
        if r.in_stance():
            return select(r.driving > 0, 1, 2)
        return select(r.swing < PLACE, 3, 4) if r.mode in ("flight", "graze") else 4


class RunnerOnOneLine(Runner):
    """The runner on ground that is one line, of one friction."""

    patch_begin = patch_end = patch_friction = trips = keeps_friction = 0
    segment = segment_begin = segment_end = segment_height = segment_slope = 0
    friction_ahead = friction_behind = -1
    ground_segment = passes_end = passes_begin = crosses_border = patch_has_length = None

    def on_segment(r, number):
        """No changes, because there is one segment."""
        return {}

    def neighbours(r):
        """No changes, because there is one segment."""
        return {}


class PlainRunner(RunnerOnOneLine):
    """The runner on level ground with constant friction, driven by the hip alone. No input ramps."""

    height = slope = ground_height = ground_slope = more_angle = more_torque = more_thrust = 0
    thrust = extension = external_fx = external_fy = retraction_rate = 0
    leg_work = positive_leg_work = external_work = leg_work_of_stride = leg_work_then = 0
    static_ratio, friction_rate, external_torque_rate = 1, 0, 0
    stribeck_velocity, vertical_so_far, vertical_force_on_foot, ramp_ends = 0, 0, None, None
    new_ground = wind_rises = enters_layer = leaves_layer = layer_is_wide = None
    copies = {"vertical_so_far": "peak_force_so_far"}
    """States of the whole runner that are equal to another one."""

    @staticmethod
    def excess(r):
        """Number of effects that act on the whole runner `r` and are missing on the plain page."""
        patch = select(r.patch_end > r.patch_begin, 1, 0)
        acting = (
            r.ground_height, r.ground_slope, r.height, r.slope, r.thrust, r.more_thrust, r.retraction_rate,
            r.more_angle, r.more_torque, r.static_ratio - 1, r.extension, r.external_fx, r.external_fy,
            r.friction_rate, r.extension_rate, r.external_fx_rate, r.external_fy_rate,
            r.external_torque_rate, r.leg_work - r.leg_work_then, r.leg_work_of_stride,
            r.peak_force_so_far - r.vertical_so_far)
        return sum(select(abs(value) <= 0, 0, 1) for value in acting) + patch

    def peak_of_vertical_force(r):
        """Largest vertical ground force, which is the normal force."""
        return r.peak_force_so_far
