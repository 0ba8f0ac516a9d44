"""All claims, in the order in which they are told."""

from . import feedback, fits, gaits, optima, retraction, rough, slopes

CLAIMS = (
    *rough.CLAIMS,
    *feedback.CLAIMS,
    *retraction.CLAIMS,
    *gaits.CLAIMS,
    *optima.CLAIMS,
    *slopes.CLAIMS,
    *fits.CLAIMS,
)
"""What is indented is the control of what is above."""
