package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Mutant;

/** Rotations about an axis with one mistake. */
final class AxisMutants {
    private static final RodriguesRotation RIGHT = new RodriguesRotation();

    private AxisMutants() {}

    static List<Mutant<AxisRotation>> all() {
        return List.of(
                new Mutant<>(
                        "clockwise",
                        "quarter-turn",
                        (through, direction, degrees, points) ->
                                RIGHT.rotate(through, direction, -degrees, points)),
                new Mutant<>(
                        "degrees-for-radians",
                        "quarter-turn",
                        (through, direction, degrees, points) ->
                                RIGHT.rotate(through, direction, Math.toDegrees(degrees), points)),
                new Mutant<>(
                        "axis-through-origin",
                        "axis-through-far-point",
                        (through, direction, degrees, points) ->
                                RIGHT.rotate(new double[3], direction, degrees, points)),
                new Mutant<>(
                        "always-upwards",
                        "axis-against-z",
                        (through, direction, degrees, points) -> {
                            double[] up = direction.clone();
                            if (up[0] == 0 && up[1] == 0) up[2] = Math.abs(up[2]);
                            RIGHT.rotate(through, up, degrees, points);
                        }),
                new Mutant<>("square-overflows", "huge-direction", AxisMutants::bySquares),
                new Mutant<>("square-vanishes", "tiny-direction", AxisMutants::bySquares),
                new Mutant<>(
                        "angle-in-float",
                        "many-turns",
                        (through, direction, degrees, points) ->
                                RIGHT.rotate(through, direction, (float) degrees, points)),
                new Mutant<>(
                        "direction-x-y-swapped",
                        "axis-along-x",
                        (through, direction, degrees, points) ->
                                RIGHT.rotate(
                                        through,
                                        new double[] {direction[1], direction[0], direction[2]},
                                        degrees,
                                        points)));
    }

    /** A direction whose square does not fit in a double has no length to be divided by. */
    private static void bySquares(
            double[] through, double[] direction, double degrees, double[] points) {
        double square = 0;
        for (double each : direction) square += each * each;
        if (square > 0 && square < Double.POSITIVE_INFINITY)
            RIGHT.rotate(through, direction, degrees, points);
        else {
            CheckedAxisRotation.checked(through, direction, points);
            var divided = new double[3];
            for (int i = 0; i < 3; i++) divided[i] = direction[i] / Math.sqrt(square);
            RIGHT.turn(through, divided, degrees, points);
        }
    }
}
