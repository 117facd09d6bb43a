"""Archive of a test lane: original records and their gradings in a database."""
