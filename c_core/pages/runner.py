"""TDMF-SLIP: a spring-legged runner whose foot has a mass and can slip (Or & Moravia 2016)."""

from ..hybrid import Model, Record, event, mode, output, require, select, sqrt
from .friction import Friction
from .hip import Hip
from .leg import Leg
from .stride import Stride


class Runner(Hip, Friction, Leg, Stride, Model):
    """The runner on level ground."""

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
    }

    # ---- forces of the ground

    def holding(r, torque):
        """Force of the ground on a foot that it holds still  (10)."""
        push = r.push(torque)
        return Record(normal=push.off + r.foot_mass * r.gravity, along=push.along)

    def standing(r):
        """The same force under the stance law."""
        return r.holding(r.stance_torque())

    def flight_lifts(r):
        """Normal force that would hold the foot under the flight law: below 0 that law lifts the foot."""
        return r.holding(r.swing_torque()).normal

    def equilibrium_turn(r):
        """tau_eq/r^2: the torque between both laws, which keeps the foot on the ground without force."""
        return -(r.spring() / r.leg().length * r.y + r.foot_mass * r.gravity) / r.x

    # ---- the start of a run, in the world's coordinates

    @require("foot.y", "on the ground or above it")
    def starts_above_ground(r):
        """Height of the foot above the ground."""
        return r.foot_above() + 1e-12 * r.free_length

    @require("leg.length", "longer than leg.min_length")
    def starts_long_enough(r):
        """Length of the leg above its least one."""
        return r.length - r.least_length

    @mode(of="world")
    def start_of_run(r):
        """The world as an importer has set it."""
        return {}

    @event("start_of_run", when=lambda r: -1, noted=False)
    def begins(r):
        """On the ground and not leaving it: as after an impact. Else in flight; an apex opens a stride."""
        r = r.replace(liftoff_angle=r.angle)
        foot, speed = r.foot(), r.free_length * sqrt(r.stiffness / r.body_mass)
        flying = r.to("flight", swing="place", placing=0)
        if r.foot_above() <= 1e-12 * r.free_length and foot.vy <= 1e-12 * speed:
            return r.land(was_placed=0)
        if abs(r.rise()) <= 1e-12 * speed:
            return flying.open_stride()
        return flying if r.rise() < 0 else flying.replace(swing=r.rising_swing())

    # ---- modes

    @mode("swing", of="flight")
    def flight(r):
        """The centre of mass is ballistic; the leg obeys rddot = r w^2 + M F_s and d(r^2 w)/dt = M tau."""
        leg = r.leg()
        mobility = 1 / r.body_mass + 1 / r.foot_mass
        torque = r.swing_torque()
        return dict(
            com_x=r.com_vx, com_y=r.com_vy, com_vy=-r.gravity, length=r.length_rate, angle=leg.angle_rate,
            length_rate=r.length * (leg.angle_rate * leg.angle_rate) + mobility * r.spring(),
            momentum=mobility * torque, work=torque * leg.angle_rate, **r.leg_rates(), **r.swing_rates())

    def on_ground(r, push, torque, foot_acceleration=0):
        """Rates of the body as seen from the foot, and of the foot  (8)-(9)."""
        return dict(
            x=r.vx, y=r.vy, vx=push.along / r.body_mass - foot_acceleration,
            vy=push.off / r.body_mass - r.gravity, foot_x=r.foot_vx, foot_vx=foot_acceleration,
            work=torque * r.leg().angle_rate, **r.leg_rates())

    @mode("stance", of="ground")
    def stick(r):
        """The foot is at rest."""
        return r.on_ground(r.push(r.stance_torque()), r.stance_torque())

    @mode("stance", of="ground")
    def slip(r):
        """m_f vdot = p - s mu f_n, with the push p of the leg and the direction s of the slip."""
        friction_force = r.way * r.slip_friction() * r.standing().normal
        acceleration = (-r.standing().along - friction_force) / r.foot_mass
        rates = r.on_ground(r.push(r.stance_torque()), r.stance_torque(), acceleration)
        return rates | dict(friction_loss=friction_force * r.foot_vx)

    @mode("stance swing", of="ground")
    def graze(r):
        """The foot stays on the ground without force, by the torque tau_eq between both laws."""
        axial, turning = r.spring() / r.leg().length, r.equilibrium_turn()
        push = Record(along=axial * r.x - turning * r.y, off=-r.foot_mass * r.gravity)
        return r.on_ground(push, r.torque(), -push.along / r.foot_mass) | r.swing_rates()

    @mode(of="world", ends=True)
    def fallen(r):
        """The run is over."""
        return {}

    # ---- changes of mode

    def contact(r, foot_velocity, **changes):
        """Contact: the foot moves along the ground at this velocity, and the body keeps its own."""
        foot = r.foot()
        landed = r.to("stick", **changes)
        vx = landed.vx + foot.vx - foot_velocity
        return landed.replace(foot_vx=foot_velocity, vx=vx, vy=landed.vy + foot.vy)

    def land(r, was_placed):
        """An impact stops the foot vertically, and friction what it can of the rest  (4)-(6)."""
        foot = r.foot()
        way = select(foot.vx >= 0, 1, -1)
        after = way * r.speed_after_impact(way * foot.vx, -foot.vy)
        lost = r.foot_mass * (foot.vx * foot.vx + foot.vy * foot.vy - after * after) / 2
        landed = r.contact(
            after, stance="drive" if r.leg().angle >= 0 else "coast", impact_loss=r.impact_loss + lost,
            was_placed=was_placed, touchdown_time=r.time, touchdowns_so_far=r.touchdowns_so_far + 1,
            bar_is_due=1)
        landed = landed.replace(slid_from=landed.foot_x)
        return landed.slide(way) if way * after > 0 else landed

    def slide(r, way):
        """Slip in a direction."""
        return r.to("slip", way=way)

    def resting(r):
        """A foot that has come to rest sticks inside the cone, else it slips the way it is pushed."""
        along = r.standing().along
        if abs(along) <= r.cone():
            return r.to("stick", foot_vx=0)
        return r.replace(foot_vx=0).slide(select(along > 0, -1, 1))

    def fly(r):
        """The foot leaves the ground."""
        return r.to("flight")

    # ---- events, in the order in which those due at one instant are taken

    @event("flight stick slip graze", when=lambda r: r.body_above(), unit="m")
    def falls(r):
        """The body reaches the ground."""
        return r.to("fallen")

    @event("flight stick slip graze", when=lambda r: r.leg().length - r.least_length, unit="m")
    def collapses(r):
        """The leg is too short."""
        return r.to("fallen")

    @event("flight", when=lambda r: r.rise(), unit="m/s", crossing=lambda r: r.swing == "place",
           only=lambda r: r.swing != "place" or r.rises_again > 0)
    def apex(r):
        """A stride closes, and place begins. After an impact that left at once the centre rises in it."""
        return r.close_stride().replace(swing="place", placing=0, rises_again=0)

    @event("graze", swing=("retract", "rest"), when=lambda r: r.rise(), unit="m/s")
    def apex_in_graze(r):
        """Place begins; a stride closes in flight only."""
        return r.replace(swing="place", placing=0)

    @event("flight", when=lambda r: r.foot_above(), unit="m")
    def touchdown(r):
        """The foot comes down to the ground."""
        return r.land(was_placed=1 if r.swing == "place" else 0)

    @event("flight graze", swing="retract", when=lambda r: r.retracting_torque(), unit="N.m", noted=False,
           only=lambda r: r.swing_clamp > 0)
    def clamp(r):
        """The clamp of (12) closes."""
        return r.replace(swing="rest")

    @event("flight graze", swing="rest", when=lambda r: -r.retracting_torque(), unit="N.m", noted=False)
    def release(r):
        """The clamp of (12) opens."""
        return r.replace(swing="retract")

    @event("stick slip graze", stance="drive", when=lambda r: r.leg().angle, unit="rad")
    def mid_stance(r):
        """The leg is upright: the drive ends, once per stance."""
        return r.replace(stance="coast")

    @event("stick slip", when=lambda r: r.standing().normal, unit="N")
    def lift_off(r):
        """Flight where both laws let go of the foot; graze where the flight law would push it down again."""
        off = r.swinging()
        if off.flight_lifts() > 1e-12 * r.stiffness * r.free_length:
            return off.to("graze")
        return off.fly()

    @event("stick", when=lambda r: r.cone() + r.standing().along, unit="N")
    def slips_forward(r):
        """The ground cannot hold the foot back."""
        return r.slide(1)

    @event("stick", when=lambda r: r.cone() - r.standing().along, unit="N")
    def slips_backward(r):
        """The ground cannot hold the foot ahead."""
        return r.slide(-1)

    @event("slip", when=lambda r: r.way * r.foot_vx, unit="m/s")
    def comes_to_rest(r):
        """The slip velocity reaches 0."""
        return r.resting()

    @event("graze", when=lambda r: -r.standing().normal, unit="N")
    def graze_to_contact(r):
        """The stance law loads the foot again."""
        return r.slide(select(r.foot_vx > 0, 1, -1)) if abs(r.foot_vx) > 0 else r.resting()

    @event("graze", when=lambda r: r.flight_lifts(), unit="N")
    def graze_to_flight(r):
        """The flight law lifts the foot."""
        return r.fly()

    # ---- outputs

    @output("N.m", name="hip.torque")
    def torque(r):
        """Total hip torque, the external one included."""
        if r.mode in ("stick", "slip"):
            return r.stance_torque()
        if r.mode == "flight":
            return r.swing_torque()
        return r.equilibrium_turn() * r.leg().square if r.mode == "graze" else 0

    @output("N", name="contact.normal")
    def normal_force(r):
        """Force of the ground on the foot across the ground, f_n."""
        return r.standing().normal if r.mode in ("stick", "slip") else 0

    @output("N", name="contact.tangential")
    def tangential_force(r):
        """Force of the ground on the foot along the ground, f_t."""
        if r.mode == "slip":
            return -r.way * r.slip_friction() * r.standing().normal
        return r.standing().along if r.mode == "stick" else 0

    @output("N", name="leg.force")
    def force_of_leg(r):
        """Force of spring and damper along the leg, pushing body and foot apart, F_s."""
        return r.spring()

    @output("m", name="body.x")
    def body_x(r):
        """Horizontal position of the body."""
        return r.body().x

    @output("m", name="body.y")
    def body_y(r):
        """Height of the body."""
        return r.body().y

    @output("m/s", name="body.vx")
    def body_vx(r):
        """Horizontal velocity of the body."""
        return r.body().vx

    @output("m/s", name="body.vy")
    def body_vy(r):
        """Vertical velocity of the body."""
        return r.body().vy

    @output("m", name="com.x")
    def center_x(r):
        """Horizontal position of the centre of mass."""
        return r.center().x

    @output("m", name="com.y")
    def center_y(r):
        """Height of the centre of mass."""
        return r.center().y

    @output("m/s", name="com.vx")
    def center_vx(r):
        """Horizontal velocity of the centre of mass."""
        return r.center().vx

    @output("m/s", name="com.vy")
    def center_vy(r):
        """Vertical velocity of the centre of mass."""
        return r.center().vy

    @output("J", name="energy.kinetic")
    def kinetic_energy(r):
        """Kinetic energy of body and foot."""
        foot, body = r.foot(), r.body()
        of_body = r.body_mass * (body.vx * body.vx + body.vy * body.vy)
        return (of_body + r.foot_mass * (foot.vx * foot.vx + foot.vy * foot.vy)) / 2

    @output("J", name="energy.potential")
    def potential_energy(r):
        """Potential energy of body and foot."""
        return r.gravity * (r.body_mass * r.body().y + r.foot_mass * r.foot().y)

    @output("J", name="energy.elastic")
    def elastic_energy(r):
        """Energy in the leg spring."""
        shorter = r.free_length - r.leg().length
        return r.stiffness * (shorter * shorter) / 2

    @output("J", name="energy.total")
    def energy(r):
        """Mechanical energy: it changes by all work less all losses."""
        return r.kinetic_energy() + r.potential_energy() + r.elastic_energy()

    @output(name="contact.mode", kind=("flight", "stick", "slip_positive", "slip_negative", "graze"))
    def kind_of_contact(r):
        """How the foot meets the ground."""
        if r.mode == "slip":
            return select(r.way > 0, 3, 4)
        return {"stick": 2, "graze": 5}.get(r.mode, 1)

    @output(name="hip.phase", kind=("drive", "coast", "retract", "place"))
    def phase_of_hip(r):
        """What the hip torque does."""
        if r.mode in ("stick", "slip"):
            return 1 if r.stance == "drive" else 2
        return 3 if r.mode in ("flight", "graze") and r.swing != "place" else 4

    @output(name="status.fallen", kind=bool)
    def has_fallen(r):
        """The runner has fallen, and the motion is frozen."""
        return 1 if r.mode == "fallen" else 0
