"""The numbers by which a bed counts as at rest, and by which its stiffness rises; `settling` applies them."""
from __future__ import annotations

from .. import checks

CHECK_STEPS = 150      # time steps between two looks at the criterion
CHECKS_IN_A_ROW = 4    # the criterion must hold as often, so that a turning point of the motion does not count
QUIET_SHARE = 0.99     # of the particles must be quiet: a grain that tips or rolls in its cage for long does not carry the bed
QUIET = 5e-6           # at rest: kinetic energy per particle over m g d (d: diameter of the sphere of equal volume),
SUPPORT = 5e-3         # and distance of the supports' vertical force from the weight, over the weight
TRUE_QUIET = 2e-5      # the same with the true stiffness, where a step is a tenth as long; for 5 mm particles this is
TRUE_SUPPORT = 1e-2    # a speed of 2 mm/s, or a hundredth of a millimetre during the impact
CALM = 1e-4            # kinetic energy, as above, below which the packing is decided and damping may help
RAMP_STAGES = 40       # steps of stiffness between soft and true
RAMP_STEPS = 25        # time steps in the first of them, at least; they grow with the cube root of the stiffness, see rampSteps
LAYER_STEPS = 10       # the same for every layer of the bed: each swells, and the surface must not be thrown up by their sum
RAMP_DAMPING = 0.5     # non-viscous damping during the ramp
DAMPING = 0.3          # the same in a calm bed


def rampSteps(softening: float, layers: float = 1.0) -> list[int]:
    """Time steps of each stage of `stiffen`, for a bed of so many `layers`.

    Overlaps go with E^(-2/3), time steps with E^(-1/2): so many steps let the bed swell ever more slowly, as E^(-1/2).
    With a constant number it would keep its speed to the end, and hop.
    """
    first = max(RAMP_STEPS, LAYER_STEPS * checks.positive('layers', layers))
    return [round(first * softening ** (stage / (3 * RAMP_STAGES))) for stage in range(RAMP_STAGES)]
