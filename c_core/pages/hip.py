"""The hip: drive and coast in stance (11), retract and place in flight (12)."""

from ..hybrid import Model, input, parameter, radians, select, setting, state

REST, RETRACT, PLACE = 0, 1, 2
"""Values of `swing`: the clamp holds the retracting torque at 0, the leg is retracted, or it is placed."""


class Hip(Model):
    """Torque between body and leg. In flight, `swing` selects the law in force."""

    prefix = "hip"
    drive_torque = parameter(
        0.2, "N.m", "Hip torque in the first half of a stance, tau0", name="hip.stance_torque",
        tunable=True, least=-1e18, most=1e18)
    kp = parameter(
        0.1, "N.m/rad", "Proportional gain of the hip in flight", tunable=True, least=0, most=1e18)
    kd = parameter(
        0.1, "N.m.s/rad", "Derivative gain of the hip in flight", tunable=True, least=0, most=1e18)
    touchdown_angle = parameter(
        radians(40), "rad", "Touchdown angle: target of the leg angle before touchdown, theta0",
        tunable=True, least=-radians(90), most=radians(90))
    liftoff_factor = parameter(
        1.2, "1", "Target of the leg angle after lift-off, over the angle at lift-off, eta",
        name="hip.liftoff_angle_factor", tunable=True, least=0, most=100)
    retraction_rate = parameter(
        0, "rad/s", "Swing-leg retraction: rate at which the target angle falls after the apex, omega",
        tunable=True, least=-1e9, most=1e9)
    swing_clamp = parameter(False, "1", "True if the torque that retracts the leg is clamped at 0 from below")
    external_torque = input(0, "N.m", "Torque added to the hip law", least=-1e18, most=1e18)

    more_angle = setting(
        0, "rad", "Added to hip.touchdown_angle", name="control.touchdown_angle", least=-radians(180),
        most=radians(180))
    more_torque = setting(
        0, "N.m", "Added to hip.stance_torque", name="control.stance_torque", least=-1e18, most=1e18)

    liftoff_angle = state(
        0, "rad", "Leg angle when the foot last left the ground, theta_LO", name="hip.liftoff_angle")
    driving = state(0, "1", "1 from touchdown to mid-stance, else 0", values=bool)
    swing = state(
        PLACE, "1", "Law of the hip in flight: 0 rest, 1 retract, 2 place", values=int, least=REST,
        most=PLACE)
    placing = state(
        0, "s", "Time since the phase place began; 0 in other phases", name="hip.place_time", least=0)
    touchdown_time = state(0, "s", "Time of the last impact")
    has_hopped = state(
        0, "1", "1 once the flight law has hardly lifted the foot at a lift-off, else 0", values=bool)
    hop_time = state(0, "s", "Time of the last lift-off at which the flight law hardly lifted the foot")
    was_placed = state(0, "1", "1 if the leg was being placed at the last impact, else 0", values=bool)
    placed_for = state(0, "s", "Time in place at the last impact", least=0)
    rises_again = state(
        0, "1", "1 if an impact with immediate lift-off interrupted place, else 0", values=bool)
    work = state(0, "J", "Work of the total hip torque since the start, W")

    def stance_torque(r):
        """Torque -tau0 until mid-stance, then 0  (11)."""
        return r.external_torque - r.driving * (r.drive_torque + r.more_torque)

    def servo(r, target, target_rate=0, share=1):
        """-kp (theta - target) - kd (thetadot - rate of the target), or a share of this torque."""
        leg = r.leg()
        return -share * r.kp * (leg.angle - target) - share * r.kd * (leg.angle_rate - target_rate)

    def retracting_torque(r):
        """Torque of (12) while the centre of mass rises, without the clamp."""
        return r.servo(r.liftoff_factor * r.liftoff_angle)

    def swing_torque(r):
        """Total torque of the flight law (12). In `rest` the clamp holds the retracting torque at 0.

        In `place` the target angle decreases at the rate omega.
        """
        first = select(r.swing < PLACE, r.liftoff_factor * r.liftoff_angle, r.placing_angle())
        turn, share = r.is_placing() * r.retraction_rate, select(r.swing > REST, 1, 0)
        return r.external_torque + r.servo(first - turn * r.placing, -turn, share)

    def placing_angle(r):
        """Target angle theta0 with which `place` begins."""
        return r.touchdown_angle + r.more_angle

    def is_placing(r):
        """1 in place, else 0."""
        return select(r.swing < PLACE, 0, 1)

    def is_retracting(r):
        """True while the hip retracts the leg, which the clamp may end."""
        return not r.in_stance() and abs(r.swing - RETRACT) <= 0

    def is_resting(r):
        """True while the clamp holds the retracting torque at 0."""
        return not r.in_stance() and r.swing < RETRACT

    def swing_rates(r):
        """Rate of the time in place."""
        return {} if r.in_stance() else dict(placing=r.is_placing())

    def swinging(r):
        """Phase of the hip at lift-off: place if the centre of mass falls, else retract.

        An impact with immediate lift-off does not end place.
        """
        goes_on = select(r.time <= r.touchdown_time, r.was_placed, 0)
        r = r.replace(liftoff_angle=r.leg().angle, placing=goes_on * r.placed_for, rises_again=goes_on)
        if r.rise() < 0 or goes_on > 0:
            return r.replace(swing=PLACE)
        return r.replace(swing=r.rising_swing())

    def rising_swing(r):
        """Phase of the hip while the centre of mass rises: retract, or rest if the clamp is closed."""
        if r.swing_clamp > 0 and r.retracting_torque() <= 0:
            return REST
        return RETRACT
