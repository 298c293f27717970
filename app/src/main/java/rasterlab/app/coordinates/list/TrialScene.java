package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.Images;

/**
 * The images that a method gave a hazard's points, beside the right ones.
 *
 * @param given the points, three numbers each
 * @param exact where they belong
 * @param made where the method has them; empty where it gave no answer, or one for other points
 * @param fates of each point; none where nothing is made
 * @param reach the largest coordinate of the exact images; of what there is, where there are none
 */
record TrialScene(
        Trial trial,
        double[] given,
        TrialPoints exact,
        Optional<TrialPoints> made,
        List<Fate> fates,
        Verdict verdict,
        double reach) {
    /**
     * The factor beyond the reach of the exact points at which a point is left out of the picture.
     */
    static final double FAR = 100;

    /** Points that are nearer to each other, over the picture's reach, are seen as one. */
    private static final double SEEN = 0.02;

    TrialScene {
        fates = List.copyOf(fates);
    }

    TrialScene(
            Trial trial,
            double[] given,
            TrialPoints exact,
            Optional<TrialPoints> made,
            List<Fate> fates,
            Verdict verdict) {
        this(trial, given, exact, made, fates, verdict, reach(given, exact, made));
    }

    private static double reach(double[] given, TrialPoints exact, Optional<TrialPoints> made) {
        double reach = exact.reach();
        if (reach == 0) reach = made.map(TrialPoints::reach).orElse(0.0);
        if (reach == 0) reach = new TrialPoints(given, Optional.empty()).reach();
        return reach == 0 ? 1 : reach;
    }

    /**
     * Points and their H.
     *
     * @param points three numbers each, not finite where a point has no image
     * @param h of each point; empty where nothing is divided
     */
    record TrialPoints(double[] points, Optional<double[]> h) {
        /** The point's three numbers. */
        double[] of(int point) {
            return Arrays.copyOfRange(points, 3 * point, 3 * point + 3);
        }

        boolean has(int point) {
            return new Images(points, 3).has(point);
        }

        /** The largest coordinate. */
        double reach() {
            double reach = 0;
            for (int i = 0; i < points.length; i++)
                if (has(i / 3)) reach = Math.max(reach, Math.abs(points[i]));
            return reach;
        }
    }

    /** The fate of a point. */
    enum Fate {
        RIGHT,
        /** The point has an image of other numbers, be it only its H. */
        WRONG,
        /** The point has an image, but not by the method. */
        MISSING,
        /** The point has no image, but one by the method. */
        EXTRA;

        /**
         * @param exact whether it has an image
         * @param made whether the method has one
         */
        static Fate of(boolean exact, boolean made, boolean correct) {
            if (exact && !made) return MISSING;
            if (made && !exact) return EXTRA;
            return correct ? RIGHT : WRONG;
        }
    }

    int size() {
        return given.length / 3;
    }

    /** Points that are not right. */
    int off() {
        return (int) fates.stream().filter(fate -> fate != Fate.RIGHT).count();
    }

    /** Whether the point lies where the picture reaches to. */
    boolean inReach(double[] points, int point) {
        for (int i = 3 * point; i < 3 * point + 3; i++)
            if (!(Math.abs(points[i]) <= FAR * reach)) return false;
        return true;
    }

    /** How the picture of the end differs from the numbers. */
    List<ShownDifference> differences() {
        var differences = new ArrayList<ShownDifference>();
        if (any(i -> !exact.has(i) && !isMade(i)))
            differences.add(ShownDifference.of(ShownDifference.ShownDifferenceKind.NO_IMAGE));
        long hidden = IntStream.range(0, size()).filter(this::isHidden).count();
        if (hidden > 0)
            differences.add(
                    ShownDifference.of(
                            ShownDifference.ShownDifferenceKind.POINTS_TOGETHER, hidden, off()));
        if (any(i -> isMade(i) && !inReach(made.orElseThrow().points(), i)))
            differences.add(ShownDifference.of(ShownDifference.ShownDifferenceKind.POINT_BEYOND));
        return differences;
    }

    private boolean any(IntPredicate which) {
        return IntStream.range(0, size()).anyMatch(which);
    }

    private boolean isMade(int point) {
        return made.filter(all -> all.has(point)).isPresent();
    }

    /** Whether a wrong point is seen where the right one is. */
    private boolean isHidden(int point) {
        return isMade(point) && fates.get(point) == Fate.WRONG && distance(point) < SEEN * reach;
    }

    /** The distance between where the point is and where it belongs. */
    private double distance(int point) {
        double sum = 0;
        for (int i = 3 * point; i < 3 * point + 3; i++)
            sum = Math.hypot(sum, made.orElseThrow().points()[i] - exact.points()[i]);
        return sum;
    }
}
