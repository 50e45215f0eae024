"""Muscles, repertoires and movement: the motor system of Yu and Terzopoulos (1999), sections 3 and 4."""
