"""What a runner's parameters make once: inverse masses and shares."""

from .functions import Record


def derived(body_mass, foot_mass):
    """1/m, 1/m_f, 1/m + 1/m_f, m + m_f and m/(m + m_f)."""
    inverse_body_mass = 1 / body_mass
    inverse_foot_mass = 1 / foot_mass
    total_mass = body_mass + foot_mass
    return Record(
        inverse_body_mass=inverse_body_mass,
        inverse_foot_mass=inverse_foot_mass,
        inverse_reduced_mass=inverse_body_mass + inverse_foot_mass,
        total_mass=total_mass,
        body_share=body_mass / total_mass,
    )
