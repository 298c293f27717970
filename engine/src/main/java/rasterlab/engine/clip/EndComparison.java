package rasterlab.engine.clip;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import rasterlab.engine.study.Deviation;

/**
 * How far clipped segments are from the exact ones.
 *
 * <p>A segment is misjudged where something is left of it and nothing was sent (missing), or the
 * other way round (extra); this is decided for the exact segment, so touching a corner counts and
 * passing it by any distance does not. A segment sent with an end that is not finite is both. Of
 * the others the worst error is the largest distance of a coordinate of an end from the exact one,
 * in the unit given. An end that has to stay and does not, or a new one that lies outside, is off
 * by {@value #LEAST_BREACH} at least, however near it is.
 */
public final class EndComparison {
    private static final double LEAST_BREACH = 1e-9;

    private final double unit;
    private final List<double[]> given;
    private final Predicate<double[]> inside;
    private double worst;
    private long missing;
    private long extra;
    private String first = "";

    private EndComparison(double unit, List<double[]> given, Predicate<double[]> inside) {
        this.unit = unit;
        this.given = given;
        this.inside = inside;
    }

    /**
     * The largest error.
     *
     * @param given the segments before they were clipped
     * @param inside whether a point, by its coordinates, is one that may be left
     */
    public static Deviation compare(
            ClippedEnds exact,
            ClippedEnds actual,
            double unit,
            List<double[]> given,
            Predicate<double[]> inside) {
        var comparison = new EndComparison(unit, given, inside);
        for (int i = 0; i < exact.parts().size(); i++)
            comparison.segment(i, exact.parts().get(i), actual.parts().get(i));
        if (actual.again() > 0) {
            comparison.extra += actual.again();
            comparison.say(actual.again() + " segments were sent again");
        }
        return new Deviation(
                comparison.worst,
                comparison.missing,
                comparison.extra,
                exact.kept(),
                comparison.first);
    }

    /** Whether no segment is misjudged and every end lies within so many units of the exact one. */
    public static boolean within(double units, Deviation deviation) {
        return deviation.missing() == 0 && deviation.extra() == 0 && deviation.worst() <= units;
    }

    private void segment(int index, Optional<double[]> exact, Optional<double[]> actual) {
        if (exact.isPresent() && actual.isPresent())
            ends("segment " + index, exact.get(), actual.get(), given.get(index));
        else if (exact.isPresent()) {
            missing++;
            say("segment " + index + " is missing, of which " + text(exact.get()) + " is left");
        } else if (actual.isPresent()) {
            extra++;
            say("segment " + index + " is sent as " + text(actual.get()) + ", nothing is left");
        }
    }

    private void ends(String segment, double[] exact, double[] actual, double[] given) {
        double farthest = 0;
        for (int i = 0; i < exact.length; i++) {
            if (!Double.isFinite(actual[i])) {
                missing++;
                extra++;
                say(segment + " is sent as " + text(actual));
                return;
            }
            farthest = Math.max(farthest, distance(exact[i], actual[i]));
        }
        boolean breach = breaks(exact, actual, given);
        if (breach) farthest = Math.max(farthest, LEAST_BREACH);
        worst = Math.max(worst, farthest);
        if (farthest > 0)
            say(segment + " is " + text(actual) + " where " + text(exact) + " is right");
    }

    /** Whether an end that stays has moved, or another one lies outside. */
    private boolean breaks(double[] exact, double[] actual, double[] given) {
        int dimension = exact.length / 2;
        for (int end = 0; end < exact.length; end += dimension) {
            boolean stays = true;
            boolean stayed = true;
            for (int i = end; i < end + dimension; i++) {
                stays &= exact[i] == given[i];
                stayed &= actual[i] == given[i];
            }
            double[] point = Arrays.copyOfRange(actual, end, end + dimension);
            if (stays ? !stayed : !inside.test(point)) return true;
        }
        return false;
    }

    private double distance(double exact, double actual) {
        if (exact == actual) return 0;
        return Math.min(Math.abs(exact / unit - actual / unit), Double.MAX_VALUE);
    }

    private void say(String difference) {
        if (first.isEmpty()) first = difference;
    }

    private static String text(double[] ends) {
        int dimension = ends.length / 2;
        return point(ends, 0, dimension) + "→" + point(ends, dimension, ends.length);
    }

    private static String point(double[] ends, int start, int end) {
        String inside = Arrays.toString(Arrays.copyOfRange(ends, start, end));
        return "(" + inside.substring(1, inside.length() - 1) + ")";
    }
}
