"""All claims by section of the page of results, in its order."""

from collections.abc import Mapping

from . import rough
from .claim import OwnClaim

SECTIONS: Mapping[str, tuple[OwnClaim, ...]] = {
    "rough": rough.CLAIMS,
}
