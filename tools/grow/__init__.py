"""Growing: flora and places turned into fibres at rest (papers/002, section 3). Drawn only, never simulation state."""
