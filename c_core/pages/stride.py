"""Strides, from apex to apex: quantities of the open stride, and those of the last completed stride."""

from ..hybrid import Model, clock, cos, letters, observe, select, state

STICK, FORWARD, BACKWARD = 2, 3, 1
"""Digits of the gait word in base 4; 0 is the bar before a new stance."""
LONGEST_WORD = 26
"""Letters that a double holds exactly. The code of a longer word is minus that of its first letters."""


class Stride(Model):
    """Gait word, durations, works and peaks, and the section at the last apex."""

    prefix = "stride"
    time = clock(held_in="last_event mode_began touchdown_time hop_time apex_time")
    events = state(0, "1", "Changes of contact and phase since the start", name="event.count", values=int,
        least=0)
    last_event = state(0, "s", "Time of the last change of contact or phase", name="event.last_time")

    # Measures since the start, of runs that observe them.
    greatest_slip_velocity = state(0, "m/s", "Largest slip velocity since the start")
    greatest_foot_height = state(
        0, "m", "Largest height of the foot above the ground, in flight, since the start")
    squared_torque = state(0, "N2.m2.s", "Integral of the squared hip torque since the start")

    # The open stride, and values at its start.
    is_open = state(0, "1", "1 if the open stride began at an apex, else 0", values=bool)
    work_then = state(0, "J", "Work of the hip at the start of the stride")
    leg_work_then = state(0, "J", "Work of the leg at the start of the stride")
    positive_work_so_far = state(
        0, "J", "Positive work of the hip since the start", name="hip.positive_work")
    positive_work_then = state(0, "J", "Positive work of the hip at the start of the stride")
    peak_force_so_far = state(0, "N", "Largest normal force in the open stride")
    vertical_so_far = state(0, "N", "Largest vertical ground force in the open stride")
    touchdowns_so_far = state(0, "1", "Impacts in the open stride", values=int, least=0)
    slip_so_far = state(0, "m", "Slip distance in the open stride before the present mode")
    slid_from = state(0, "m", "Position of the foot at the last event")
    stance_so_far = state(0, "s", "Time in contact in the open stride before the present mode")
    word_so_far = state(0, "1", "Gait word of the open stride, in base 4", values=int)
    last_letter = state(
        0, "1", "Last letter of the open stride's gait word", values=int, least=0, most=3)
    bar_is_due = state(0, "1", "1 from touchdown until a contact mode lasts, else 0", values=bool)
    mode_began = state(0, "s", "Time of the last event")
    x_then = state(0, "m", "Position of the centre of mass at the start of the stride")
    y_then = state(0, "m", "Height of the centre of mass at the start of the stride")

    # The last completed stride.
    count = state(0, "1", "Number of completed strides", name="stride.count", values=int, least=0)
    word_code = state(
        0, "1", "Gait word: + slip forward, 0 stick, - slip backward, | new stance",
        name="stride.word",
        values=letters("|-0+"))
    period = state(0, "s", "Period of the stride, T", name="stride.period")
    distance = state(0, "m", "Distance covered by the centre of mass in the stride", name="stride.length")
    rise_of_stride = state(0, "m", "Height gained by the centre of mass in the stride", name="stride.rise")
    work_of_stride = state(0, "J", "Net work of hip and leg in the stride, W", name="stride.work")
    hip_work = state(0, "J", "Net work of the hip in the stride", name="stride.hip_work")
    leg_work_of_stride = state(
        0, "J", "Net work of thrust and leg extension in the stride", name="stride.leg_work")
    positive_work = state(0, "J", "Positive work of the hip in the stride", name="stride.positive_work")
    speed = state(0, "m/s", "Average speed of the stride, V", name="stride.speed")
    cost_of_transport = state(
        0, "1", "Mechanical cost of transport of the stride, c_mt", name="stride.cost_of_transport")
    touchdowns = state(
        0, "1", "Impacts of the foot in the stride", name="stride.touchdowns", values=int, least=0)
    stance_time = state(0, "s", "Time in contact in the stride", name="stride.stance_time")
    duty_factor = state(
        0, "1", "Share of the stride in which the foot was in contact", name="stride.duty_factor")
    slip_distance = state(0, "m", "Slip distance of the foot in the stride", name="stride.slip_distance")
    peak_force = state(0, "N", "Largest normal force in the stride", name="stride.peak_force")
    peak_vertical_force = state(
        0, "N", "Largest vertical ground force in the stride", name="stride.peak_vertical_force")

    # The section at the last apex.
    apex_time = state(-1, "s", "Time of the last apex", name="apex.time")
    apex_com_height = state(
        0, "m", "Height of the centre of mass at the last apex", name="apex.com_height")
    apex_com_speed = state(0, "m/s", "Speed of the centre of mass at the last apex", name="apex.com_speed")
    apex_length = state(0, "m", "Leg length at the last apex", name="apex.leg_length")
    apex_angle = state(0, "rad", "Leg angle at the last apex", name="apex.leg_angle")
    apex_length_rate = state(
        0, "m/s", "Rate of the leg length at the last apex", name="apex.leg_length_rate")
    apex_angle_rate = state(0, "rad/s", "Rate of the leg angle at the last apex", name="apex.leg_angle_rate")

    def letter(r):
        """The digit of a contact mode in the gait word; None in flight and graze."""
        if r.mode == "slip":
            return select(r.way > 0, FORWARD, BACKWARD)
        return STICK if r.mode == "stick" else None

    def count_event(r, counted):
        """Count a change of contact or phase (1). A chain in zero time is one change."""
        is_new = select(r.time > r.last_event, counted, 0)
        return r.replace(events=r.events + is_new, last_event=select(counted > 0, r.time, r.last_event))

    def leaving(r, counted):
        """Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar."""
        r = r.count_event(counted)
        letter, lasted = r.letter(), r.time - r.mode_began
        if letter is not None:
            slid = r.way * (r.foot_x - r.slid_from) if r.mode == "slip" else 0
            r = r.replace(stance_so_far=r.stance_so_far + lasted, slip_so_far=r.slip_so_far + slid)
        r = r.replace(mode_began=r.time)
        if r.seen_in == "ground":
            r = r.replace(slid_from=r.foot_x)
        if letter is None:
            return r
        after_bar = select(r.bar_is_due * r.word_so_far > 0, 4 * r.word_so_far, r.word_so_far)
        longer = 4 * after_bar + letter
        most = 4.0**LONGEST_WORD
        longer = select(longer < most, longer, -select(after_bar < most, after_bar, r.word_so_far))
        longer = select(r.word_so_far < 0, r.word_so_far, longer)
        is_new = select(abs(letter - r.last_letter) > 0, 1, r.bar_is_due)
        adds = select(lasted > 0, is_new, 0)
        return r.replace(
            word_so_far=select(adds > 0, longer, r.word_so_far),
            last_letter=select(lasted > 0, letter, r.last_letter),
            bar_is_due=select(lasted > 0, 0, r.bar_is_due))

    def close_stride(r):
        """Latch the quantities of a stride that began and ends at an apex, and open the next one  (13)."""
        center = r.center()
        hip, leg = r.work - r.work_then, r.leg_work - r.leg_work_then
        work, period, distance = hip + leg, r.time - r.apex_time, center.x - r.x_then
        weight = (r.body_mass + r.foot_mass) * r.gravity
        lasts = period > 0  # a light foot may make a hop that is shorter than the rounding of the clock
        done = dict(
            count=r.count + 1, period=period, distance=distance, rise_of_stride=center.y - r.y_then,
            hip_work=hip, leg_work_of_stride=leg, work_of_stride=work,
            speed=select(lasts, distance / period, center.vx),
            cost_of_transport=select(lasts, work / (weight * distance), 0),
            positive_work=r.positive_work_so_far - r.positive_work_then, touchdowns=r.touchdowns_so_far,
            stance_time=r.stance_so_far, slip_distance=r.slip_so_far,
            duty_factor=select(lasts, r.stance_so_far / period, 0),
            peak_force=r.peak_force_so_far, peak_vertical_force=r.peak_of_vertical_force(),
            word_code=r.word_so_far)
        kept = {name: select(r.is_open > 0, value, getattr(r, name)) for name, value in done.items()}
        return r.replace(**kept).open_stride()

    def open_stride(r):
        """Open a stride at an apex."""
        center, leg = r.center(), r.leg()
        return r.replace(
            is_open=1, work_then=r.work, leg_work_then=r.leg_work, x_then=center.x, y_then=center.y,
            positive_work_then=r.positive_work_so_far, touchdowns_so_far=0, stance_so_far=0, slip_so_far=0,
            peak_force_so_far=0, vertical_so_far=0, word_so_far=0, last_letter=0, bar_is_due=0,
            apex_time=r.time, apex_com_height=r.height_of_section(), apex_com_speed=center.vx,
            apex_length=leg.length, apex_angle=leg.angle, apex_length_rate=leg.length_rate,
            apex_angle_rate=leg.angle_rate)

    @observe("flight stick slip graze", "positive integral", into="positive_work_so_far", unit="W")
    def power_of_hip(r):
        """Power of the total hip torque."""
        return r.torque() * r.leg().angle_rate

    def peak_of_vertical_force(r):
        """Largest vertical ground force in the open stride."""
        return r.vertical_so_far

    @observe("stick slip", "largest", into="vertical_so_far", unit="N")
    def vertical_force_on_foot(r):
        """Vertical force of the ground on a sticking or slipping foot."""
        return r.in_world(r.tangential_force(), r.standing().normal, 0, 0).y

    @observe("stick slip", "largest", into="peak_force_so_far", unit="N")
    def force_on_foot(r):
        """Normal force of a sticking or slipping foot."""
        return r.standing().normal

    @observe("slip", "largest", into="greatest_slip_velocity", unit="m/s", usual=False)
    def slip_velocity(r):
        """Speed at which the foot slips."""
        return r.way * r.foot_vx

    @observe("flight", "largest", into="greatest_foot_height", unit="m", usual=False)
    def height_of_foot(r):
        """Height of the foot above the ground vertically below."""
        return r.foot_above(r.height, r.slope) / cos(r.slope)

    @observe("flight stick slip graze", "positive integral", into="squared_torque", unit="N2.m2", usual=False)
    def square_of_torque(r):
        """Square of the total hip torque."""
        return r.torque() ** 2
