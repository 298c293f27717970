package rasterlab.engine.visibility;

import rasterlab.engine.raster.Raster;

/** Colours faces in a picture and counts the pixels. */
public final class FaceBrush {
    private final FacePaint paint;
    private final Raster out;
    private final Tally tally;
    private final SpanSink fill = (y, from, to) -> span(this.face, y, from, to);
    private int face;

    public FaceBrush(FacePaint paint, Raster out, Tally tally) {
        this.paint = paint;
        this.out = out;
        this.tally = tally;
    }

    /**
     * Paints one face, or a piece of it, over whatever the picture holds: its fill, then its
     * outline.
     */
    public void paint(ScreenPolygon polygon, int face) {
        fill(polygon, face);
        if (paint.hasOutline()) new OutlineStroke(out, paint.outline(face)).around(polygon);
    }

    public void fill(ScreenPolygon polygon, int face) {
        this.face = face;
        polygon.fill(out.width(), out.height(), fill);
    }

    /** Paints the pixels [from, to) of row y. */
    public void span(int face, int y, int from, int to) {
        tally.pixelsWritten += to - from;
        paint.span(face, y, from, to, out);
    }
}
