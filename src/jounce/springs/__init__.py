"""Springs and bump stops from a press: force over deflection with intervals, and the law for a rig."""
