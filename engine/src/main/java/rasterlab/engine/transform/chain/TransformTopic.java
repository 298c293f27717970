package rasterlab.engine.transform.chain;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.transform.Images;

/**
 * Sending points through a list of matrices.
 *
 * <p>The error of an image is the largest difference of a coordinate over the image's largest
 * coordinate, or the difference of H over H where that is more. Up to 10⁻¹² counts as exact, since
 * a few digits cancel in every chain; up to 10⁻⁴, a tenth of a pixel in a picture of a thousand, is
 * usable.
 */
public final class TransformTopic implements Topic<PointTransformer, Chain, TransformTopic.Output> {
    private static final double CORRECT = 1e-12;
    private static final double USABLE = 1e-4;

    /**
     * The answer of a method.
     *
     * @param h H of each point
     */
    public record Output(Images images, double[] h) {}

    @Override
    public String name() {
        return "transform";
    }

    @Override
    public String lab() {
        return "coordinates";
    }

    @Override
    public Class<PointTransformer> contract() {
        return PointTransformer.class;
    }

    @Override
    public List<Method<PointTransformer>> methods() {
        return TransformMethods.all();
    }

    @Override
    public List<Hazard<Chain>> hazards() {
        return TransformHazards.all();
    }

    @Override
    public List<Workload<Chain>> workloads() {
        return TransformWorkloads.all();
    }

    @Override
    public List<Mutant<PointTransformer>> mutants() {
        return TransformMutants.all();
    }

    @Override
    public Output run(PointTransformer method, Chain chain, int limit) {
        double[] points = chain.points().clone();
        double[] h = chain.h().clone();
        method.transform(chain.dimension(), chain.matrices(), points, h);
        return new Output(
                new Images(points, chain.dimension()).first(limit),
                Arrays.copyOf(h, Math.min(limit, h.length)));
    }

    @Override
    public long spend(PointTransformer method, Chain chain) {
        method.transform(
                chain.dimension(), chain.matrices(), chain.points().clone(), chain.h().clone());
        return chain.size();
    }

    @Override
    public Output exact(Chain chain, int limit) {
        int dimension = chain.dimension();
        double[] rows = ExactChain.images(chain, limit);
        int count = rows.length / (dimension + 1);
        var points = new double[count * dimension];
        var h = new double[count];
        for (int i = 0; i < count; i++) {
            System.arraycopy(rows, i * (dimension + 1), points, i * dimension, dimension);
            h[i] = rows[i * (dimension + 1) + dimension];
        }
        return new Output(new Images(points, dimension), h);
    }

    @Override
    public Deviation compare(Chain chain, Output exact, Output actual) {
        Deviation images = compareImages(chain, exact, actual);
        if (actual.h().length != exact.h().length) return images;
        double worst = images.worst();
        String first = images.first();
        for (int i = 0; i < exact.h().length; i++) {
            if (exact.images().has(i) || isNowhere(actual.images(), i)) continue;
            worst = Double.POSITIVE_INFINITY;
            if (first.isEmpty()) first = "points[%d] has no image and is not NaN".formatted(i);
        }
        for (int i = 0; i < exact.h().length; i++) {
            double right = exact.h()[i];
            double scale = Math.max(Double.MIN_NORMAL, Math.abs(right));
            double error = Math.abs(actual.h()[i] - right) / scale;
            if (!(error <= CORRECT) && first.isEmpty())
                first = "H of points[%d] is %s, right is %s".formatted(i, actual.h()[i], right);
            worst = Math.max(worst, Double.isNaN(error) ? Double.POSITIVE_INFINITY : error);
        }
        return new Deviation(worst, images.missing(), images.extra(), images.of(), first);
    }

    private static boolean isNowhere(Images images, int point) {
        boolean nowhere = true;
        for (int i = 0; i < images.dimension(); i++)
            nowhere &= Double.isNaN(images.coordinates()[point * images.dimension() + i]);
        return nowhere;
    }

    private static Deviation compareImages(Chain chain, Output exact, Output actual) {
        int dimension = chain.dimension();
        var scales = new double[exact.h().length];
        for (int i = 0; i < scales.length; i++) {
            scales[i] = Double.MIN_NORMAL;
            for (int j = 0; j < dimension; j++)
                scales[i] =
                        Math.max(
                                scales[i],
                                Math.abs(exact.images().coordinates()[i * dimension + j]));
            if (Double.isNaN(scales[i])) scales[i] = 1;
        }
        return exact.images().deviation(actual.images(), scales);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    /** Operations by name; nothing is counted of a student's method. */
    @Override
    public Map<String, Long> operations(PointTransformer method, Chain chain) {
        return CountingChain.counts(method, chain);
    }

    @Override
    public String item() {
        return "point";
    }

    @Override
    public String errorUnit() {
        return "of the image's largest coordinate";
    }

    @Override
    public Format<PointTransformer, Chain, Output> format() {
        return new TransformFormat(this);
    }
}
