package rasterlab.engine.clip.polygon;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.contract.PolygonClipper;
import rasterlab.engine.clip.EndSum;
import rasterlab.engine.clip.exact.ExactPolygonClip;
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
 * Clipping a polygon by a convex window.
 *
 * <p>Right means: as many pieces as there are, and at most 10⁻¹² of the window's area covered by
 * only one of answer and exact pieces; crossings are fractions, which no double is equal to, and
 * moving a corner by a rounding changes the area by a few 10⁻¹⁶ of the window's. Usable means: the
 * area is right to a millionth, whatever the pieces, since a bridge between two fills nothing.
 */
public final class PolygonClipTopic
        implements Topic<PolygonClipper, PolygonInWindow, List<double[]>> {
    private static final int MOST_ITEMS = 1_000_000;
    private static final String PIECES = "pieces";
    private static final String CORNERS_LEFT = "corners left";

    static final double RIGHT_SHARE = 1e-12;
    private static final double USABLE_SHARE = 1e-6;

    @Override
    public String name() {
        return "clip-polygon";
    }

    @Override
    public String lab() {
        return "clip";
    }

    @Override
    public Class<PolygonClipper> contract() {
        return PolygonClipper.class;
    }

    @Override
    public List<Method<PolygonClipper>> methods() {
        return List.of(
                Method.failing("sutherland-hodgman", new SutherlandHodgman()),
                Method.right("weiler-atherton", new WeilerAtherton()),
                Method.failing("sutherland-hodgman-textbook", new SutherlandHodgmanTextbook()));
    }

    @Override
    public List<Hazard<PolygonInWindow>> hazards() {
        return PolygonClipHazards.all();
    }

    @Override
    public List<Workload<PolygonInWindow>> workloads() {
        return PolygonClipWorkloads.all();
    }

    @Override
    public List<Mutant<PolygonClipper>> mutants() {
        return PolygonClipMutants.all();
    }

    @Override
    public List<Slip<PolygonClipper>> slips(PolygonClipper right) {
        return PolygonClipSlips.of(right);
    }

    @Override
    public List<double[]> run(PolygonClipper method, PolygonInWindow input, int limit) {
        var pieces = new ArrayList<double[]>();
        method.clip(
                input.window(),
                input.subject(),
                piece -> {
                    if (pieces.size() == limit) throw new LimitReached(limit, List.copyOf(pieces));
                    pieces.add(piece);
                });
        return pieces;
    }

    /** {@inheritDoc} The items are the subject's corners, whatever is left of them. */
    @Override
    public long spend(PolygonClipper method, PolygonInWindow input) {
        var sum = new EndSum();
        method.clip(
                input.window(),
                input.subject(),
                piece -> sum.segment(piece[0], piece[1], piece.length, 0));
        sum.requireComputed();
        return input.corners();
    }

    @Override
    public List<double[]> exact(PolygonInWindow input, int limit) {
        List<double[]> pieces = ExactPolygonClip.pieces(input.window(), input.subject());
        return pieces.subList(0, Math.min(limit, pieces.size()));
    }

    @Override
    public Deviation compare(PolygonInWindow input, List<double[]> exact, List<double[]> actual) {
        return PolygonComparison.compare(input, exact, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.missing() == 0
                && deviation.extra() == 0
                && deviation.worst() <= RIGHT_SHARE;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE_SHARE;
    }

    @Override
    public Map<String, Long> operations(PolygonClipper method, PolygonInWindow input) {
        var counts = new TreeMap<String, Long>();
        if (!(method instanceof SteppedPolygonClipper stepped)) return counts;
        PolygonWalk walk = stepped.walk(input.window(), input.subject());
        long steps = 0;
        while (walk.advance()) steps++;
        counts.put("steps", steps);
        counts.put("side tests", walk.sideTests());
        counts.put("divisions", walk.divisions());
        counts.put("unrounded crossings", walk.unroundedCrossings());
        walk.send(piece -> counts.merge(PIECES, 1L, Long::sum));
        walk.send(piece -> counts.merge(CORNERS_LEFT, piece.length / 2L, Long::sum));
        return counts;
    }

    @Override
    public boolean isWork(String count) {
        return !count.equals(PIECES) && !count.equals(CORNERS_LEFT);
    }

    /** {@inheritDoc} Methods answer in different orders, so no answer is cut. */
    @Override
    public int mostItems() {
        return MOST_ITEMS;
    }

    @Override
    public String item() {
        return "corner";
    }

    @Override
    public String errorUnit() {
        return "window areas";
    }

    @Override
    public Format<PolygonClipper, PolygonInWindow, List<double[]>> format() {
        return new PolygonClipFormat(this);
    }
}
