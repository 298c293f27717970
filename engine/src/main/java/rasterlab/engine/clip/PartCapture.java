package rasterlab.engine.clip;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.SegmentSink;
import rasterlab.contract.SpaceSegmentSink;
import rasterlab.engine.study.LimitReached;

/** Takes what methods send, segment after segment, up to a limit. */
public final class PartCapture implements SegmentSink, SpaceSegmentSink {
    private final List<Optional<double[]>> parts = new ArrayList<>();
    private final int limit;
    private int sent;
    private int again;
    private double[] part = {};

    /**
     * @param limit the most parts to take
     */
    public PartCapture(int limit) {
        this.limit = limit;
    }

    @Override
    public void segment(double x0, double y0, double x1, double y1) {
        take(x0, y0, x1, y1);
    }

    @Override
    public void segment(double x0, double y0, double z0, double x1, double y1, double z1) {
        take(x0, y0, z0, x1, y1, z1);
    }

    private void take(double... ends) {
        if (sent == limit) throw new LimitReached(limit, captured());
        sent++;
        if (part.length > 0) again++;
        else part = ends;
    }

    /** Closes the account of one segment. */
    public void next() {
        parts.add(part.length > 0 ? Optional.of(part) : Optional.empty());
        part = new double[0];
    }

    public ClippedEnds captured() {
        return new ClippedEnds(parts, again);
    }
}
