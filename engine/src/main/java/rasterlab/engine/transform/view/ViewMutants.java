package rasterlab.engine.transform.view;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import rasterlab.contract.EyeView;
import rasterlab.engine.study.Mutant;

/** Views from an eye with one mistake. */
final class ViewMutants {
    private static final EyeView RIGHT = new DecomposedView();

    /** The distance from which nothing but itself would be left of z. */
    private static final double FAR = 1e6;

    private ViewMutants() {}

    static List<Mutant<EyeView>> all() {
        return List.of(
                new Mutant<>("z-towards-the-eye", "origin", changed(2, (z, rho) -> -z)),
                new Mutant<>("y-downwards", "upwards", changed(1, (y, rho) -> -y)),
                new Mutant<>("x-to-the-left", "to-the-right", changed(0, (x, rho) -> -x)),
                new Mutant<>(
                        "phi-from-the-equator",
                        "pole",
                        (theta, phi, rho, points) -> RIGHT.view(theta, 90 - phi, rho, points)),
                new Mutant<>("degrees-for-radians", "quarter-turn", angles(Math::toDegrees)),
                new Mutant<>(
                        "theta-clockwise",
                        "quarter-turn",
                        (theta, phi, rho, points) -> RIGHT.view(-theta, phi, rho, points)),
                new Mutant<>(
                        "always-above",
                        "from-below",
                        (theta, phi, rho, points) ->
                                RIGHT.view(theta, Math.min(phi, 180 - phi), rho, points)),
                new Mutant<>(
                        "angles-swapped",
                        "upwards",
                        (theta, phi, rho, points) -> RIGHT.view(phi, theta, rho, points)),
                new Mutant<>(
                        "distance-left-out",
                        "origin",
                        changed(2, (z, rho) -> rho < FAR ? z - rho : z)),
                new Mutant<>("divided-by-depth", "upwards", ViewMutants::divided),
                new Mutant<>("new-x-for-the-others", "to-the-right", ViewMutants::overwriting));
    }

    private static EyeView angles(DoubleUnaryOperator change) {
        return (theta, phi, rho, points) ->
                RIGHT.view(change.applyAsDouble(theta), change.applyAsDouble(phi), rho, points);
    }

    /** The change of one coordinate. */
    @FunctionalInterface
    private interface Change {
        double of(double coordinate, double rho);
    }

    private static EyeView changed(int coordinate, Change change) {
        return (theta, phi, rho, points) -> {
            RIGHT.view(theta, phi, rho, points);
            for (int i = coordinate; i < points.length; i += 3)
                points[i] = change.of(points[i], rho);
        };
    }

    private static void divided(double theta, double phi, double rho, double[] points) {
        RIGHT.view(theta, phi, rho, points);
        for (int i = 0; i < points.length; i += 3)
            for (int c = 0; c < 2; c++) points[i + c] /= points[i + 2];
    }

    private static void overwriting(double theta, double phi, double rho, double[] points) {
        double sine = Math.sin(Math.toRadians(theta));
        double cosine = Math.cos(Math.toRadians(theta));
        double down = Math.sin(Math.toRadians(phi));
        double up = Math.cos(Math.toRadians(phi));
        for (int i = 0; i < points.length; i += 3) {
            points[i] = points[i + 1] * cosine - points[i] * sine;
            double ahead = points[i] * cosine + points[i + 1] * sine;
            points[i + 1] = points[i + 2] * down - ahead * up;
            points[i + 2] = rho - ahead * down - points[i + 2] * up;
        }
    }
}
