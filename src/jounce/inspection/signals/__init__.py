"""From plate signals to turns and the response of a wheel."""
