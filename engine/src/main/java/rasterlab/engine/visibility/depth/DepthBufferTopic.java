package rasterlab.engine.visibility.depth;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.DepthFormat;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Storing depths in a depth buffer.
 *
 * <p>An output is exact if the codes in every pixel are in the order of the true depths, and only
 * equal depths have equal codes. The error is that of the stored depth, as a share of the true one;
 * codes that are not exact are usable while it is at most 1/1000.
 */
public final class DepthBufferTopic implements Topic<DepthFormat, DepthRows, StoredDepths> {
    private static final double USABLE = 1e-3;

    @Override
    public String name() {
        return "depth-buffer";
    }

    @Override
    public String lab() {
        return "visibility";
    }

    @Override
    public Class<DepthFormat> contract() {
        return DepthFormat.class;
    }

    @Override
    public List<Method<DepthFormat>> methods() {
        return DepthMethods.all();
    }

    @Override
    public List<Hazard<DepthRows>> hazards() {
        return DepthHazards.all();
    }

    @Override
    public List<Workload<DepthRows>> workloads() {
        return DepthWorkloads.all();
    }

    @Override
    public List<Mutant<DepthFormat>> mutants() {
        return DepthBufferMutants.all();
    }

    @Override
    public StoredDepths run(DepthFormat method, DepthRows rows, int limit) {
        return StoredDepths.of(method, rows);
    }

    /** Storing alone, where the method tells it from what a code stands for. */
    @Override
    public long spend(DepthFormat method, DepthRows rows) {
        var row = new int[rows.pixels()];
        if (method instanceof DepthCoding coding) {
            DepthCoding.RangeCodes codes = coding.over(rows.range());
            for (int s = 0; s < rows.surfaces(); s++)
                codes.row(rows.nearness(s), rows.perPixel(s), 0, row.length, row);
            return rows.count();
        }
        var depths = new double[rows.pixels()];
        for (int s = 0; s < rows.surfaces(); s++)
            method.store(
                    rows.range(), rows.nearness(s), rows.perPixel(s), 0, row.length, row, depths);
        return rows.count();
    }

    @Override
    public StoredDepths exact(DepthRows rows, int limit) {
        return ExactDepths.of(rows);
    }

    @Override
    public Deviation compare(DepthRows rows, StoredDepths exact, StoredDepths actual) {
        long wrong = 0;
        String first = "";
        for (int pixel = 0; pixel < rows.pixels(); pixel++) {
            List<Integer> order = order(exact, pixel);
            for (int k = 1; k < order.size(); k++) {
                int nearer = order.get(k - 1) * rows.pixels() + pixel;
                int farther = order.get(k) * rows.pixels() + pixel;
                int right = Integer.compare(exact.codes()[nearer], exact.codes()[farther]);
                int told = Integer.compare(actual.codes()[nearer], actual.codes()[farther]);
                if (told == right) continue;
                wrong++;
                if (first.isEmpty())
                    first =
                            "in pixel %d depths %s and %s are stored as %s and %s"
                                    .formatted(
                                            pixel,
                                            exact.depths()[nearer],
                                            exact.depths()[farther],
                                            actual.depths()[nearer],
                                            actual.depths()[farther]);
            }
        }
        return new Deviation(worst(exact, actual), wrong, 0, rows.count(), first);
    }

    /** The surfaces from the nearest to the farthest. */
    private static List<Integer> order(StoredDepths exact, int pixel) {
        return IntStream.range(0, exact.surfaces())
                .boxed()
                .sorted(Comparator.comparingInt(s -> exact.codes()[s * exact.pixels() + pixel]))
                .toList();
    }

    private static double worst(StoredDepths exact, StoredDepths actual) {
        double worst = 0;
        for (int i = 0; i < exact.depths().length; i++)
            worst = Math.max(worst, Math.abs(actual.depths()[i] / exact.depths()[i] - 1));
        return worst;
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.missing() == 0;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    @Override
    public int mostItems() {
        return DepthRows.MOST_DEPTHS;
    }

    @Override
    public String item() {
        return "depth";
    }

    @Override
    public String errorUnit() {
        return "of the depth";
    }

    @Override
    public Format<DepthFormat, DepthRows, StoredDepths> format() {
        return new DepthBufferFormat(this);
    }
}
