"""jounce: from bench measurements to a validated suspension model, and from the model to decisions."""
