"""What things do: one verb a file, grouped as figure 1 of Yu and Terzopoulos (1999)."""
