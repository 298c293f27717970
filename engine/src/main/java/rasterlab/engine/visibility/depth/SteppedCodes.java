package rasterlab.engine.visibility.depth;

/** Codes that are computed for a single depth and added up along a scan line. */
final class SteppedCodes implements DepthCoding.RangeCodes {
    /** Begins a scan line. */
    @FunctionalInterface
    interface Start {
        DepthWalk walk(double nearness, double perPixel, int pixels);
    }

    private final DepthCoding.RangeCodes single;
    private final Start start;

    SteppedCodes(DepthCoding.RangeCodes single, Start start) {
        this.single = single;
        this.start = start;
    }

    @Override
    public int code(double nearness) {
        return single.code(nearness);
    }

    @Override
    public void row(double base, double perPixel, int from, int to, int[] codes) {
        if (from >= to) return;
        DepthWalk walk = start.walk(base + from * perPixel, perPixel, to - from);
        int i = 0;
        do codes[i++] = walk.code();
        while (walk.advance());
    }

    @Override
    public double stored(int code) {
        return single.stored(code);
    }

    @Override
    public double depth(int code) {
        return single.depth(code);
    }
}
