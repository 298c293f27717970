package rasterlab.engine.transform.axis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Mutant;

/** Rotations about an axis with one mistake. */
final class AxisMutants {
    private static final RodriguesRotation RIGHT = new RodriguesRotation();

    private AxisMutants() {}

    static List<Mutant<AxisRotation>> all() {
        return Stream.concat(ofArguments().stream(), ofTerms().stream()).toList();
    }

    private static List<Mutant<AxisRotation>> ofArguments() {
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

    private static List<Mutant<AxisRotation>> ofTerms() {
        return List.of(
                new Mutant<>(
                        "direction-not-normalized",
                        "quarter-turn",
                        (through, direction, degrees, points) ->
                                formula(through, direction, degrees, points, 1, 1, 1)),
                new Mutant<>(
                        "not-moved-back",
                        "axis-through-far-point",
                        (through, direction, degrees, points) ->
                                formula(through, unit(direction), degrees, points, 0, 1, 1)),
                new Mutant<>(
                        "third-term-left-out",
                        "axis-itself",
                        (through, direction, degrees, points) ->
                                formula(through, unit(direction), degrees, points, 1, 0, 0)),
                new Mutant<>(
                        "cosine-not-taken-from-1",
                        "axis-itself",
                        (through, direction, degrees, points) ->
                                formula(through, unit(direction), degrees, points, 1, 1, 0)),
                new Mutant<>("new-coordinates-used", "quarter-turn", AxisMutants::overwriting));
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

    /**
     * Computes Rodrigues' formula, parts of which may be left out.
     *
     * @param back 0 where the image is not moved back to the axis
     * @param third 0 where the term along the axis is left out
     * @param less 0 where that term is not multiplied by 1 − cos
     */
    private static void formula(
            double[] through,
            double[] k,
            double degrees,
            double[] points,
            int back,
            int third,
            int less) {
        double sine = Math.sin(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        var v = new double[3];
        for (int at = 0; at < points.length; at += 3) {
            for (int i = 0; i < 3; i++) v[i] = points[at + i] - through[i];
            double along = (k[0] * v[0] + k[1] * v[1] + k[2] * v[2]) * (1 - less * cosine);
            for (int i = 0; i < 3; i++)
                points[at + i] =
                        back * through[i]
                                + v[i] * cosine
                                + Cross.of(k, v, i) * sine
                                + third * k[i] * along;
        }
    }

    private static double[] unit(double[] direction) {
        double length = Math.hypot(direction[0], Math.hypot(direction[1], direction[2]));
        return Arrays.stream(direction).map(each -> each / length).toArray();
    }

    /** Each coordinate is computed from those that stand there already. */
    private static void overwriting(
            double[] through, double[] direction, double degrees, double[] points) {
        double[] k = unit(direction);
        double sine = Math.sin(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        var v = new double[3];
        for (int at = 0; at < points.length; at += 3) {
            for (int i = 0; i < 3; i++) v[i] = points[at + i] - through[i];
            double along = (k[0] * v[0] + k[1] * v[1] + k[2] * v[2]) * (1 - cosine);
            for (int i = 0; i < 3; i++) {
                v[i] = v[i] * cosine + Cross.of(k, v, i) * sine + k[i] * along;
                points[at + i] = through[i] + v[i];
            }
        }
    }
}
