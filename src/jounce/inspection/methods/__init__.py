"""What each method makes of the signals of a wheel."""
