"""The hip: drive and coast on the ground (11), retract and place off it (12)."""

from ..hybrid import Model, input, parameter, radians, select, setting, state


class Hip(Model):
    """Torque between body and leg; `stance` and `swing` are the words that say which law is in force."""

    prefix = "hip"
    drive_torque = parameter(
        0.2, "N.m", "Torque that drives the first half of a stance, tau0", name="hip.stance_torque",
        tunable=True)
    kp = parameter(0.1, "N.m/rad", "Proportional gain of the hip in flight", tunable=True, least=0)
    kd = parameter(0.1, "N.m.s/rad", "Derivative gain of the hip in flight", tunable=True, least=0)
    touchdown_angle = parameter(
        radians(40), "rad", "Leg angle that the leg is placed at before touchdown, theta0", tunable=True)
    liftoff_factor = parameter(
        1.2, "1", "Leg angle aimed at after lift-off, over the angle at lift-off, eta",
        name="hip.liftoff_angle_factor", tunable=True, least=0)
    retraction_rate = parameter(
        0, "rad/s", "Rate at which the angle aimed at in place falls from theta0 on, omega", tunable=True)
    swing_clamp = parameter(False, "1", "The torque that retracts the leg is never negative")
    external_torque = input(0, "N.m", "Torque added to the hip law")

    more_angle = setting(0, "rad", "Added to hip.touchdown_angle", name="control.touchdown_angle")
    more_torque = setting(0, "N.m", "Added to hip.stance_torque", name="control.stance_torque")

    liftoff_angle = state(
        0, "rad", "Leg angle when the foot last left the ground, theta_LO", name="hip.liftoff_angle")
    placing = state(0, "s", "Time since place began", name="hip.place_time")
    touchdown_time = state(0, "s", "Time of the last impact")
    was_placed = state(0, "1", "1 if the leg was in place at the last impact")
    rises_again = state(0, "1", "1 in place after an impact that left at once")
    work = state(0, "J", "Work of the total hip torque since the start, W")

    def stance_torque(r):
        """Torque -tau0 until mid-stance, then 0  (11)."""
        return r.external_torque - (r.drive_torque + r.more_torque if r.stance == "drive" else 0)

    def servo(r, target, target_rate=0):
        """-kp (theta - target) - kd (thetadot - its rate)."""
        leg = r.leg()
        return -r.kp * (leg.angle - target) - r.kd * (leg.angle_rate - target_rate)

    def placing_torque(r):
        """(12) from the apex on: the leg is retracted from theta0 at the rate omega."""
        target = r.touchdown_angle + r.more_angle - r.retraction_rate * r.placing
        return r.servo(target, -r.retraction_rate)

    def retracting_torque(r):
        """(12) while the centre of mass rises, before any clamp."""
        return r.servo(r.liftoff_factor * r.liftoff_angle)

    def swing_torque(r):
        """The flight law (12). In `rest` the clamp holds the torque of retract at 0."""
        if r.swing == "rest":
            return r.external_torque
        law = r.retracting_torque() if r.swing == "retract" else r.placing_torque()
        return r.external_torque + law

    def swing_rates(r):
        """The time in place."""
        return dict(placing=1) if r.swing == "place" else {}

    def swinging(r):
        """The hip as the foot leaves a contact: place if the centre of mass falls, else retract.

        An impact that leaves at once does not end place.
        """
        goes_on = select(r.time <= r.touchdown_time, r.was_placed, 0)
        r = r.replace(liftoff_angle=r.leg().angle, placing=goes_on * r.placing, rises_again=goes_on)
        if r.rise() < 0 or goes_on > 0:
            return r.replace(swing="place")
        return r.replace(swing=r.rising_swing())

    def rising_swing(r):
        """Retract, or its rest where a clamp is closed."""
        if r.swing_clamp > 0 and r.retracting_torque() <= 0:
            return "rest"
        return "retract"
