package rasterlab.engine.visibility.triangle;

import java.math.BigDecimal;
import java.util.List;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Filling triangles into a depth buffer.
 *
 * <p>Each pixel shows one triangle or the background; the error is that of the stored depths, as a
 * share of the range from the near to the far plane. Up to 10⁻¹¹ counts as exact, and depths that
 * are within 10⁻¹² of each other may show either triangle, but for one that was drawn before with
 * the same corners. An output is usable where the triangles are right, and the depths to a step of
 * a buffer of 16 bits.
 */
public final class DepthTriangleTopic
        implements Topic<DepthTriangleFiller, DepthTriangles, DepthTriangles.TrianglePicture> {
    private static final double CORRECT = 1e-11;
    private static final double SAME = 1e-12;
    private static final double BEHIND = 2;
    private static final double USABLE = 1.0 / (1 << 16);

    @Override
    public String name() {
        return "depth-triangle";
    }

    @Override
    public String lab() {
        return "visibility";
    }

    @Override
    public Class<DepthTriangleFiller> contract() {
        return DepthTriangleFiller.class;
    }

    @Override
    public List<Method<DepthTriangleFiller>> methods() {
        return List.of(
                Method.failing("left-edge-textbook", new LeftEdgeTriangle()),
                Method.failing("slopes", new SlopesTriangle()),
                Method.failing("rows-float", new FloatRowsTriangle()),
                Method.right("rows", new RowsTriangle()),
                Method.right("weights", new WeightsTriangle()));
    }

    @Override
    public List<Hazard<DepthTriangles>> hazards() {
        return DepthTriangleHazards.all();
    }

    @Override
    public List<Workload<DepthTriangles>> workloads() {
        return List.of(square(16), square(64), square(256));
    }

    /** Two triangles that pass through each other and fill most of a square picture. */
    private static Workload<DepthTriangles> square(int side) {
        double[] rising = {0, 0, 0.1, side, 0, 0.9, 0, side, 0.3};
        double[] falling = {side, 0, 0.2, side, side, 0.6, 0, 0, 0.8};
        return new Workload<>(
                "side-" + side,
                side * side,
                List.of(new DepthTriangles(List.of(rising, falling), side, side, 1)));
    }

    @Override
    public List<Mutant<DepthTriangleFiller>> mutants() {
        return DepthTriangleMutants.all();
    }

    @Override
    public List<Slip<DepthTriangleFiller>> slips(DepthTriangleFiller right) {
        return DepthTriangleSlips.of(right);
    }

    @Override
    public DepthTriangles.TrianglePicture run(
            DepthTriangleFiller method, DepthTriangles input, int limit) {
        return DepthTriangles.TrianglePicture.by(method, input);
    }

    @Override
    public long spend(DepthTriangleFiller method, DepthTriangles input) {
        return DepthTriangles.TrianglePicture.by(method, input).shown().length;
    }

    @Override
    public DepthTriangles.TrianglePicture exact(DepthTriangles input, int limit) {
        return new ExactTriangles(input).picture();
    }

    @Override
    public Deviation compare(
            DepthTriangles input,
            DepthTriangles.TrianglePicture exact,
            DepthTriangles.TrianglePicture actual) {
        double worst = 0;
        long wrong = 0;
        String first = "";
        for (int at = 0; at < exact.shown().length; at++) {
            int shown = actual.shown()[at];
            boolean right = shown == exact.shown()[at] || mayShow(input, at, shown, exact);
            double error = Math.abs(exact.depths()[at] - actual.depths()[at]);
            if (Double.isNaN(error)) error = Double.POSITIVE_INFINITY;
            if (!right) wrong++;
            worst = Math.max(worst, error);
            if (first.isEmpty() && (!right || error > CORRECT))
                first = right ? depth(at, exact, actual) : shown(at, exact, actual);
        }
        return new Deviation(worst, wrong, 0, exact.shown().length, first);
    }

    /** Whether rounding alone decides between what a pixel shows and what is right. */
    private static boolean mayShow(
            DepthTriangles input, int at, int shown, DepthTriangles.TrianglePicture right) {
        if (shown < 0 || shown > input.triangles().size()) return false;
        var exact = new ExactTriangles(input);
        if (shown > 0 && exact.again(shown - 1)) return false;
        double apart = depth(exact, shown, at) - depth(exact, right.shown()[at], at);
        return Math.abs(apart) <= SAME;
    }

    /** The depth of a triangle or the background; far behind where a triangle has no such pixel. */
    private static double depth(ExactTriangles exact, int shown, int at) {
        if (shown == 0) return exact.background();
        return exact.depth(shown - 1, at).map(BigDecimal::doubleValue).orElse(BEHIND);
    }

    private static String shown(
            int at, DepthTriangles.TrianglePicture exact, DepthTriangles.TrianglePicture actual) {
        return "pixel (%d, %d) shows triangle %d, right is %d, 0 is the background"
                .formatted(
                        at % exact.width(),
                        at / exact.width(),
                        actual.shown()[at],
                        exact.shown()[at]);
    }

    private static String depth(
            int at, DepthTriangles.TrianglePicture exact, DepthTriangles.TrianglePicture actual) {
        return "depth at pixel (%d, %d) is %s, right is %s"
                .formatted(
                        at % exact.width(),
                        at / exact.width(),
                        actual.depths()[at],
                        exact.depths()[at]);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.missing() == 0 && deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.missing() == 0 && deviation.worst() <= USABLE;
    }

    /** {@inheritDoc} A picture is answered whole: the most that one may have. */
    @Override
    public int mostItems() {
        return DepthTriangleFiller.LARGEST_SIDE * DepthTriangleFiller.LARGEST_SIDE;
    }

    @Override
    public String item() {
        return "pixel";
    }

    @Override
    public String errorUnit() {
        return "of the depth range";
    }

    @Override
    public Format<DepthTriangleFiller, DepthTriangles, DepthTriangles.TrianglePicture> format() {
        return new DepthTriangleFormat(this);
    }
}
