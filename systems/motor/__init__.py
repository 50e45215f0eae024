"""Muscles, repertoires and movement: Yu and Terzopoulos (1999), sections 3 and 4."""
