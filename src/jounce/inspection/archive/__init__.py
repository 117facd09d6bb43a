"""What a lane keeps: records as they came in, and their gradings, in a database."""
