"""Pages of one's own: beginning one, and building its library."""
