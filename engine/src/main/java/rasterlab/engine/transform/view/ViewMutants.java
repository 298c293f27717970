package rasterlab.engine.transform.view;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import rasterlab.contract.EyeView;
import rasterlab.engine.study.Mutant;

/** Views from an eye with one mistake. */
final class ViewMutants {
    private static final EyeView RIGHT = new TakenApartView();

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
                                RIGHT.view(theta, Math.min(phi, 180 - phi), rho, points)));
    }

    private static EyeView angles(DoubleUnaryOperator change) {
        return (theta, phi, rho, points) ->
                RIGHT.view(change.applyAsDouble(theta), change.applyAsDouble(phi), rho, points);
    }

    /** What becomes of one coordinate. */
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
}
