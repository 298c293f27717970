package rasterlab.engine.transform.rotate;

import java.util.List;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Mutant;

/** Rotations of the plane with one mistake. */
final class RotateMutants {
    private static final PlaneRotation RIGHT = new TotalAngleRotation();

    private RotateMutants() {}

    static List<Mutant<PlaneRotation>> all() {
        return List.of(
                new Mutant<>(
                        "clockwise",
                        "quarter-turn",
                        (degrees, times, points) -> RIGHT.rotate(-degrees, times, points)),
                new Mutant<>("new-x-for-y", "quarter-turn", RotateMutants::newXForY),
                new Mutant<>(
                        "whole-degrees",
                        "between-degrees",
                        (degrees, times, points) ->
                                RIGHT.rotate(Math.rint(degrees), times, points)),
                new Mutant<>("tangent-of-90", "half-turn", RotateMutants::byTangent),
                new Mutant<>(
                        "one-rotation-only",
                        "hundred-thousand-turns",
                        (degrees, times, points) ->
                                RIGHT.rotate(degrees, Math.min(times, 1), points)),
                new Mutant<>(
                        "angle-in-float",
                        "huge-angle",
                        (degrees, times, points) -> RIGHT.rotate((float) degrees, times, points)),
                new Mutant<>(
                        "coordinates-in-float",
                        "beyond-float",
                        (degrees, times, points) -> {
                            RIGHT.rotate(degrees, times, points);
                            for (int i = 0; i < points.length; i++) points[i] = (float) points[i];
                        }),
                new Mutant<>(
                        "degrees-for-radians",
                        "quarter-turn",
                        (degrees, times, points) -> {
                            // with more than a turn it is the size of the angle that shows
                            boolean within = Math.abs(degrees) <= 360;
                            RIGHT.rotate(within ? Math.toDegrees(degrees) : degrees, times, points);
                        }),
                new Mutant<>(
                        "one-rotation-more",
                        "quarter-turn",
                        (degrees, times, points) -> {
                            // with millions of rotations it is their drift that shows
                            boolean few = times < 1_000_000;
                            RIGHT.rotate(degrees, few ? times + 1 : times, points);
                        }),
                new Mutant<>(
                        "sine-in-float", "hundred-thousand-turns", RotateMutants::sineInFloat));
    }

    private static void newXForY(double degrees, int times, double[] points) {
        double sine = Math.sin(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        for (int n = 0; n < times; n++)
            for (int i = 0; i < points.length; i += 2) {
                points[i] = points[i] * cosine - points[i + 1] * sine;
                points[i + 1] = points[i] * sine + points[i + 1] * cosine;
            }
    }

    /** Does Buneman's three multiplications, where only half-turns have no tangent. */
    private static void byTangent(double degrees, int times, double[] points) {
        if (degrees % 360 != 180 || times != 1) RIGHT.rotate(degrees, times, points);
        else
            for (int i = 0; i < points.length; i += 2) {
                double tangent = Math.tan(Math.toRadians(degrees) / 2);
                double sheared = points[i + 1] + points[i] * tangent;
                points[i] -= sheared * Math.sin(Math.toRadians(degrees));
                points[i + 1] = points[i] * tangent + sheared;
            }
    }

    private static void sineInFloat(double degrees, int times, double[] points) {
        double sine = (float) Math.sin(Math.toRadians(degrees));
        double cosine = (float) Math.cos(Math.toRadians(degrees));
        for (int n = 0; n < times; n++)
            for (int i = 0; i < points.length; i += 2) {
                double x = points[i];
                points[i] = x * cosine - points[i + 1] * sine;
                points[i + 1] = x * sine + points[i + 1] * cosine;
            }
    }
}
