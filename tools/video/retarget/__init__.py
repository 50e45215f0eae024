"""From a fish's motion to another body's: targets and two-level retargeting (papers/003, sections 3.2 and 5)."""
