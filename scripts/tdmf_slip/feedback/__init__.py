"""Feedback from stride to stride: gains from a gait's exact return map, and what they are worth."""
