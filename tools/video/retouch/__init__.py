"""Fine tuning of a motion: one edit on one frame, its neighbours follow (papers/003, section 6)."""
