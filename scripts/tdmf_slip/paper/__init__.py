"""Or and Moravia (2016): its claims and figures, the recorded reference gaits, and their validation."""
