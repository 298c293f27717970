package rasterlab.engine.visibility.order;

import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Polygons on which methods fail, with what each makes of them. The eye looks along z. */
final class DepthOrderHazards {
    private static final double[] EYE = {0, 0, 0};
    private static final double[] FLOOR = {-4, -3, 4, 4, -3, 4, 4, -3, 40, -4, -3, 40};

    private DepthOrderHazards() {}

    static List<Hazard<Sight>> all() {
        return Stream.of(ofMeans(), ofEyes(), ofCuts(), ofPlaces(), outOfRange())
                .flatMap(List::stream)
                .toList();
    }

    private static List<Hazard<Sight>> ofMeans() {
        return List.of(
                hazard(
                        "one-behind-the-other",
                        recorded(EXACT, EXACT, EXACT, EXACT),
                        square(0, 0, 10, 2),
                        square(1, 0, 20, 4),
                        square(0, 1, 30, 6)),
                hazard(
                        "mean-mis-sorts",
                        recorded(WRONG, WRONG, EXACT, EXACT),
                        FLOOR,
                        square(0, -1.5, 30, 1)),
                hazard(
                        "rounded-to-one-depth",
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        square(0, 0, 20, 3),
                        square(1, 0, 20.4, 3)),
                hazard(
                        "fourth-corner-left-out",
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        new double[] {9, -1, 20, 9, 9, 30, -1, 9, 20, -1, -1, 10},
                        square(0, 0, 23, 1)));
    }

    private static List<Hazard<Sight>> ofEyes() {
        double[] aside = {100, -30, 7};
        return List.of(
                new Hazard<>(
                        "eye-on-the-other-side",
                        new Sight(
                                new double[][] {square(0, 0, -20, 4), square(1, 0, -10, 4)},
                                new double[] {0, 0, -40}),
                        recorded(EXACT, EXACT, EXACT, EXACT)),
                new Hazard<>(
                        "eye-aside",
                        new Sight(
                                new double[][] {
                                    moved(FLOOR, aside), moved(square(0, -1.5, 30, 1), aside)
                                },
                                aside),
                        recorded(WRONG, WRONG, EXACT, EXACT)),
                new Hazard<>(
                        "nearest-corner-mis-sorts",
                        new Sight(
                                new double[][] {
                                    {3, -3, 5, -3, -3, 35, -3, 3, 35, 3, 3, 5},
                                    square(-1.5, 0, 12, 1)
                                },
                                EYE),
                        recorded(EXACT, EXACT, EXACT, EXACT)));
    }

    private static double[] moved(double[] polygon, double[] by) {
        var moved = new double[polygon.length];
        for (int i = 0; i < moved.length; i++) moved[i] = polygon[i] + by[i % 3];
        return moved;
    }

    private static List<Hazard<Sight>> ofCuts() {
        return List.of(
                hazard("circle-of-three", recorded(WRONG, WRONG, EXACT, EXACT), circle()),
                hazard("through-each-other", recorded(WRONG, WRONG, EXACT, EXACT), crossing()),
                hazard(
                        "coplanar",
                        recorded(EXACT, EXACT, EXACT, EXACT),
                        new double[] {-3, -3, 17, 1, -3, 21, 1, 1, 21, -3, 1, 17},
                        new double[] {-1, -1, 19, 3, -1, 23, 3, 3, 23, -1, 3, 19}),
                hazard(
                        "edge-on",
                        recorded(EXACT, EXACT, EXACT, EXACT),
                        new double[] {0, -2, 12, 0, -2, 16, 0, 2, 16, 0, 2, 12},
                        square(0, 0, 20, 3)));
    }

    private static List<Hazard<Sight>> ofPlaces() {
        return List.of(
                hazard(
                        "behind-the-eye",
                        recorded(WRONG, WRONG, REFUSED, EXACT),
                        new double[] {-4, -3, -10, 4, -3, -10, 4, -3, 40, -4, -3, 40},
                        square(0, -1.5, 30, 1)),
                hazard(
                        "eye-in-the-middle",
                        recorded(REFUSED, REFUSED, REFUSED, EXACT),
                        square(0, 0, 10, 4),
                        square(0, 0, -10, 4),
                        square(0, 0, 5, 1),
                        square(0, 0, -5, 1)),
                new Hazard<>(
                        "huge",
                        new Sight(crossing(), EYE).scaled(1e200),
                        recorded(WRONG, WRONG, EXACT, EXACT)),
                new Hazard<>(
                        "tiny",
                        new Sight(circle(), EYE).scaled(1e-200),
                        recorded(WRONG, WRONG, EXACT, EXACT)));
    }

    private static List<Hazard<Sight>> outOfRange() {
        return List.of(
                hazard(
                        "too-near-the-eye",
                        recorded(REFUSED, REFUSED, REFUSED, REFUSED),
                        square(0, 0, 1e-12, 1e4),
                        square(0, 0, 1e-3, 1)),
                hazard(
                        "too-narrow",
                        recorded(REFUSED, REFUSED, REFUSED, REFUSED),
                        new double[] {-1e4, 0, 20, 1e4, 0, 30, 1e4, 1e-4, 30, -1e4, 1e-4, 20},
                        square(0, 0, 26, 5e3)));
    }

    /** A square across the look, as wide as high, round (x, y, z). */
    private static double[] square(double x, double y, double z, double half) {
        return new double[] {
            x - half, y - half, z, x + half, y - half, z, x + half, y + half, z, x - half, y + half,
            z
        };
    }

    /** Three bars along the sides of a triangle, each near at its beginning and far at its end. */
    static double[][] circle() {
        var bars = new double[3][12];
        for (int k = 0; k < 3; k++) {
            double angle = 2 * Math.PI * k / 3;
            double[] along = {Math.cos(angle), Math.sin(angle)};
            double[] across = {-along[1], along[0]};
            double[][] ends = {{-6, -2.5, 18}, {6, -2.5, 22}, {6, -1.5, 22}, {-6, -1.5, 18}};
            for (int i = 0; i < 4; i++) {
                bars[k][3 * i] = ends[i][0] * along[0] + ends[i][1] * across[0];
                bars[k][3 * i + 1] = ends[i][0] * along[1] + ends[i][1] * across[1];
                bars[k][3 * i + 2] = ends[i][2];
            }
        }
        return bars;
    }

    private static double[][] crossing() {
        return new double[][] {
            {-4, -2, 16, 4, -2, 24, 4, 2, 24, -4, 2, 16},
            {-4, -2, 24, 4, -2, 16, 4, 2, 16, -4, 2, 24}
        };
    }

    private static Hazard<Sight> hazard(
            String name, Map<String, Verdict.Kind> recorded, double[]... polygons) {
        return new Hazard<>(name, new Sight(polygons, EYE), recorded);
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind textbook, Verdict.Kind meanZ, Verdict.Kind newell, Verdict.Kind bsp) {
        return Map.of("mean-z-textbook", textbook, "mean-z", meanZ, "newell", newell, "bsp", bsp);
    }
}
