"""Offline work: capture of repertoires and what benches compare with; loads no world (DESIGN 1)."""
