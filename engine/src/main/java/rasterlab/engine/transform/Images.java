package rasterlab.engine.transform;

import java.util.Arrays;
import rasterlab.engine.study.Deviation;

/**
 * Images of points, as a method produced them or as they are right.
 *
 * @param coordinates point after point; NaN throughout where a point has no image
 * @param dimension numbers per point
 */
public record Images(double[] coordinates, int dimension) {
    /** The images of the first {@code limit} points. */
    public Images first(int limit) {
        return limit >= size()
                ? this
                : new Images(Arrays.copyOf(coordinates, limit * dimension), dimension);
    }

    public int size() {
        return coordinates.length / dimension;
    }

    /**
     * How far {@code actual} is from this, the right answer: the largest difference of a coordinate
     * over the point's scale.
     *
     * @param scales of each point, above 0
     */
    public Deviation deviation(Images actual, double[] scales) {
        if (actual.size() != size())
            return new Deviation(
                    Double.POSITIVE_INFINITY,
                    Math.max(0, size() - actual.size()),
                    Math.max(0, actual.size() - size()),
                    size(),
                    actual.size()
                            + (actual.size() == 1 ? " image where " : " images where ")
                            + size()
                            + (size() == 1 ? " is right" : " are right"));
        double worst = 0;
        long missing = 0;
        long extra = 0;
        String first = "";
        for (int i = 0; i < size(); i++) {
            double error = error(actual, i, scales[i]);
            if (error == Double.POSITIVE_INFINITY)
                if (actual.has(i)) extra++;
                else missing++;
            if (error > 0 && first.isEmpty()) first = difference(actual, i);
            worst = Math.max(worst, error);
        }
        return new Deviation(worst, missing, extra, size(), first);
    }

    private double error(Images actual, int i, double scale) {
        if (!has(i) || !actual.has(i))
            return has(i) == actual.has(i) ? 0 : Double.POSITIVE_INFINITY;
        double worst = 0;
        for (int c = i * dimension; c < (i + 1) * dimension; c++)
            worst = Math.max(worst, Math.abs(actual.coordinates[c] - coordinates[c]));
        return worst / scale;
    }

    /** Whether point {@code i} has an image. */
    public boolean has(int i) {
        for (int c = i * dimension; c < (i + 1) * dimension; c++)
            if (!Double.isFinite(coordinates[c])) return false;
        return true;
    }

    private String difference(Images actual, int i) {
        return "points[" + i + "] goes to " + actual.text(i) + ", right is " + text(i);
    }

    private String text(int i) {
        if (!has(i)) return "no point";
        return Arrays.toString(Arrays.copyOfRange(coordinates, i * dimension, (i + 1) * dimension));
    }
}
