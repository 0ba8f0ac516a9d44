"""Feedback from stride to stride: gains from a gait's exact return map, and measures of their value."""
