"""Makes C99 of the pages, by Python's standard library alone."""
