"""Design: springs, dampers and other parameters from requirements; adjustments; simpler models."""
