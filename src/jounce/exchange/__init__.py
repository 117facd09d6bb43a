"""Models for other programs, and models of other programs."""
