"""Work in blocks that do not depend on each other: here, on all processors, or on a Dask cluster."""
