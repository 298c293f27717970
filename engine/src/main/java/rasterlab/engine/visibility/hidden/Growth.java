package rasterlab.engine.visibility.hidden;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleConsumer;
import java.util.stream.Stream;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.Visibility;

/**
 * How the counted work of a method grows with one size while all others stay.
 *
 * <p>Work is comparisons of faces, depth tests and written pixels, each counted as one.
 * Object-space methods are said to need about N² of it for N faces, image-space methods about n·N
 * for n pixels.
 *
 * @param method name of the method
 * @param axis what grows
 * @param sizes N or n, growing
 * @param work for a picture of each size
 */
public record Growth(String method, Axis axis, int[] sizes, long[] work) {
    private static final long SEED = 1974;
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;

    /** Faces of the scenes in which pixels grow. */
    private static final int FACES = 200;

    private static final double REACH = 400;

    /** The quantity that grows. */
    public enum Axis {
        /** N, the number of faces, while they shrink and cover the same area in all. */
        FACES_OF_ONE_AREA(16, 64, 256, 1024, 4096),
        /** N, while each keeps its size: what they cover grows with them. */
        FACES_OF_ONE_SIZE(16, 32, 64, 128, 256),
        /** n, the number of pixels of the picture. */
        PIXELS(40 * 30, 80 * 60, 160 * 120, 320 * 240, 640 * 480);

        private final int[] sizes;

        Axis(int... sizes) {
            this.sizes = sizes;
        }
    }

    public Growth {
        sizes = sizes.clone();
        work = work.clone();
    }

    /** All methods but those that draw no scattered faces, on all three axes. */
    public static List<Growth> all() {
        return all(share -> {}, () -> false);
    }

    /**
     * All methods on all three axes, told how far it is.
     *
     * @param progress gets the share that is done, 0 to 1, after each method on each axis
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static List<Growth> all(DoubleConsumer progress, BooleanSupplier cancelled) {
        var growths = new ArrayList<Growth>();
        List<Method<Visibility>> methods = methods().toList();
        double whole = Axis.values().length * methods.size();
        for (Axis axis : Axis.values()) {
            List<SurfaceView> views =
                    Arrays.stream(axis.sizes).mapToObj(n -> view(axis, n)).toList();
            for (Method<Visibility> method : methods) {
                growths.add(of(method, axis, views, cancelled));
                progress.accept(growths.size() / whole);
            }
        }
        return growths;
    }

    /** The methods whose growth is counted, in teaching order. */
    public static List<String> methodNames() {
        return methods().map(Method::name).toList();
    }

    private static Stream<Method<Visibility>> methods() {
        return new Visibilities()
                .methods().stream().filter(method -> !method.name().equals("convex"));
    }

    private static Growth of(
            Method<Visibility> method,
            Axis axis,
            List<SurfaceView> views,
            BooleanSupplier cancelled) {
        var work = new long[views.size()];
        for (int i = 0; i < work.length; i++)
            work[i] =
                    DrawnFaces.by(method.implementation(), views.get(i), cancelled).work().total();
        return new Growth(method.name(), axis, axis.sizes, work);
    }

    private static SurfaceView view(Axis axis, int size) {
        return switch (axis) {
            case FACES_OF_ONE_AREA ->
                    ScatteredTriangles.seen(
                            ScatteredTriangles.mesh(size, REACH / Math.sqrt(size), SEED),
                            WIDTH,
                            HEIGHT);
            case FACES_OF_ONE_SIZE ->
                    ScatteredTriangles.seen(
                            ScatteredTriangles.mesh(size, REACH / 12, SEED), WIDTH, HEIGHT);
            case PIXELS -> {
                int height = (int) Math.round(Math.sqrt(size * 3 / 4.0));
                double reach = REACH / Math.sqrt(FACES);
                yield ScatteredTriangles.seen(
                        ScatteredTriangles.mesh(FACES, reach, SEED), size / height, height);
            }
        };
    }

    /**
     * The exponent p of work ≈ c·sizeᵖ: the slope of the straight line of least squares through the
     * last three points, both axes logarithmic.
     */
    public double exponent() {
        double sumX = 0;
        double sumY = 0;
        double sumXx = 0;
        double sumXy = 0;
        int from = sizes.length - 3;
        for (int i = from; i < sizes.length; i++) {
            double x = Math.log(sizes[i]);
            double y = Math.log(work[i]);
            sumX += x;
            sumY += y;
            sumXx += x * x;
            sumXy += x * y;
        }
        return (3 * sumXy - sumX * sumY) / (3 * sumXx - sumX * sumX);
    }

    @Override
    public int[] sizes() {
        return sizes.clone();
    }

    @Override
    public long[] work() {
        return work.clone();
    }
}
