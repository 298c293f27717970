package rasterlab.app.line;

import rasterlab.engine.line.Segment;

/** The two ends of a segment. */
public enum End {
    A,
    B;

    public int x(Segment segment) {
        return this == A ? segment.x0() : segment.x1();
    }

    public int y(Segment segment) {
        return this == A ? segment.y0() : segment.y1();
    }

    /**
     * The segment with this end at (x, y). Its window stays as long as the lab draws the whole
     * segment, so that nobody waits for the pixels outside.
     */
    public Segment moved(Segment segment, int x, int y) {
        Segment whole =
                this == A
                        ? new Segment(x, y, segment.x1(), segment.y1())
                        : new Segment(segment.x0(), segment.y0(), x, y);
        return whole.steps() < LineDrawing.LIMIT ? whole.in(segment.window()) : whole;
    }
}
