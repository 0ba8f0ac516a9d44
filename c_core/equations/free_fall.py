"""Free acceleration: gravity and the external force on the body, and the centre of mass in flight."""

from .functions import Record

STEADY = Record(x=0, y=0)


def push_on_body(model, inputs):
    """The external force by the body's mass; of inputs' rates, its rate."""
    return Record(
        x=inputs.body.external_fx * model.inverse_body_mass,
        y=inputs.body.external_fy * model.inverse_body_mass,
    )


def of_body(model, push):
    """a = (0, -g) + (external force)/m, of the body alone."""
    return Record(x=push.x, y=push.y - model.parameters.gravity)


def of_center(model, push):
    """(0, -g) + (external force)/(m + m_f), of the centre of mass."""
    return Record(x=model.body_share * push.x, y=model.body_share * push.y - model.parameters.gravity)


def of_runner(model, inputs):
    """(0, -g) + (external force)/(m + m_f), under the inputs."""
    return of_center(model, push_on_body(model, inputs))


def ballistic(start, acceleration, jerk, time):
    """The centre of mass in flight, some time after the start: x + v t + a t^2/2 + (jerk) t^3/6."""
    return Record(
        x=start.x + time * (start.vx + time * (acceleration.x / 2 + time * jerk.x / 6)),
        y=start.y + time * (start.vy + time * (acceleration.y / 2 + time * jerk.y / 6)),
        vx=start.vx + time * (acceleration.x + time * jerk.x / 2),
        vy=start.vy + time * (acceleration.y + time * jerk.y / 2),
    )


def center_of_mass(model, inputs, start, time):
    """The same, where the inputs are held."""
    return ballistic(start, of_runner(model, inputs), STEADY, time)
