"""The behaviour routines, one file each (Tu and Terzopoulos 1994, section on behaviours)."""
