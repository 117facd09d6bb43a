"""Both sides of an axle as bodies, joints and elastic elements, packed for its static equilibrium."""
