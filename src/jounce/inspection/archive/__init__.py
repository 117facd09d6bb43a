"""The archive of a lane: original records and their gradings, in a database."""
