"""What everything stands on: units, errors, findings, descriptions, serialisation."""
