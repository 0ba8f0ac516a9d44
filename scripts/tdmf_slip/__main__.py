"""`python -m tdmf_slip` is the command `tdmf-slip`."""

import sys

from .command import main

sys.exit(main())
