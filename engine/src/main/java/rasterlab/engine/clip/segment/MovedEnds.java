package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * Base of the listings in real numbers: ends are swapped so that it is always the first that is
 * moved. NaN lies on no side.
 */
abstract class MovedEnds implements SegmentWalk {
    final ClipWindow window;
    double x1;
    double y1;
    double x2;
    double y2;
    int divisions;
    private int code;
    private String at = "";
    private boolean swapped;

    MovedEnds(ClipWindow window, double x1, double y1, double x2, double y2) {
        this.window = window;
        this.x1 = x1;
        this.y1 = y1;
        this.x2 = x2;
        this.y2 = y2;
    }

    private boolean reject() {
        return (window.code(x1, y1) & window.code(x2, y2)) != 0;
    }

    @Override
    public final boolean advance() {
        if (reject() || (window.code(x1, y1) | window.code(x2, y2)) == 0) return false;
        if (window.code(x1, y1) == 0) swap();
        code = window.code(x1, y1);
        at = move(code);
        return true;
    }

    /**
     * Moves the first end.
     *
     * @param outcode its code, not 0
     * @return the side it was moved to; empty where it was not
     */
    abstract String move(int outcode);

    private void swap() {
        swapped = !swapped;
        double x = x1;
        double y = y1;
        x1 = x2;
        y1 = y2;
        x2 = x;
        y2 = y;
    }

    @Override
    public final void piece(SegmentSink out) {
        if (swapped) out.segment(x2, y2, x1, y1);
        else out.segment(x1, y1, x2, y2);
    }

    @Override
    public final void send(SegmentSink out) {
        if (!reject()) piece(out);
    }

    @Override
    public final String at() {
        return at;
    }

    @Override
    public final double decision() {
        return code;
    }

    @Override
    public final int divisions() {
        return divisions;
    }

    @Override
    public final boolean unsure() {
        return false;
    }
}
