package rasterlab.engine.visibility.order;

import java.util.List;
import java.util.Map;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * The order in which to paint polygons; right is whatever never paints a farther one over a nearer.
 *
 * <p>Up to 10⁻⁷ % of what the polygons cover may be wrong where corners of cuts are rounded.
 */
public final class DepthOrderTopic implements Topic<DepthOrder, Sight, Painting> {
    private static final int MOST_ITEMS = 1_000_000;

    private static final double CORRECT = 1e-7;

    /** Cuts of n polygons by each other's planes can make far more than n pieces. */
    private static final long PIECES_BEFORE_ENDLESS = 200_000;

    @Override
    public String name() {
        return "depth-order";
    }

    @Override
    public String lab() {
        return "visibility";
    }

    @Override
    public Class<DepthOrder> contract() {
        return DepthOrder.class;
    }

    @Override
    public List<Method<DepthOrder>> methods() {
        return DepthOrderMethods.all();
    }

    @Override
    public List<Hazard<Sight>> hazards() {
        return DepthOrderHazards.all();
    }

    @Override
    public List<Workload<Sight>> workloads() {
        return DepthOrderWorkloads.all();
    }

    @Override
    public List<Mutant<DepthOrder>> mutants() {
        return DepthOrderMutants.all();
    }

    @Override
    public List<Slip<DepthOrder>> slips(DepthOrder right) {
        return DepthOrderSlips.of(right);
    }

    @Override
    public Painting run(DepthOrder method, Sight sight, int limit) {
        var painting = new Painting();
        method.order(
                sight.polygons(),
                sight.eye(),
                (polygon, corners) -> {
                    if (painting.size() == limit) throw new LimitReached(limit, painting);
                    painting.add(polygon, corners);
                });
        return painting;
    }

    @Override
    public long spend(DepthOrder method, Sight sight) {
        var count = new long[1];
        method.order(sight.polygons(), sight.eye(), (polygon, corners) -> count[0]++);
        return count[0];
    }

    /**
     * {@inheritDoc}
     *
     * @return the polygons in the input's order: what has to be painted. Which orders are right
     *     {@link #compare} proves, as there are many
     */
    @Override
    public Painting exact(Sight sight, int limit) {
        var all = new Painting();
        for (int k = 0; k < Math.min(limit, sight.size()); k++) all.add(k, sight.polygons()[k]);
        return all;
    }

    @Override
    public Deviation compare(Sight sight, Painting exact, Painting actual) {
        return PaintingComparison.compare(sight, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT && deviation.missing() == 0;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return correct(deviation);
    }

    @Override
    public long mostBeforeEndless(long exactItems) {
        return 2 * exactItems + PIECES_BEFORE_ENDLESS;
    }

    @Override
    public Map<String, Long> operations(DepthOrder method, Sight sight) {
        if (!(method instanceof SteppedOrder stepped)) return Map.of();
        PieceSink nowhere = (polygon, corners) -> {};
        OrderWalk walk = stepped.walk(sight, nowhere);
        boolean more;
        do more = walk.advance();
        while (more);
        return walk.operations();
    }

    /** {@inheritDoc} Methods answer in different orders, so no answer is cut. */
    @Override
    public int mostItems() {
        return MOST_ITEMS;
    }

    @Override
    public String item() {
        return "polygon";
    }

    @Override
    public String errorUnit() {
        return "% of what is covered";
    }

    @Override
    public Format<DepthOrder, Sight, Painting> format() {
        return new DepthOrderFormat(this);
    }
}
