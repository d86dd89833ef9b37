// Right: what others include wrongly.
