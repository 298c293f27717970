package rasterlab.engine.pipeline.triangle;

/**
 * Eight pixels of a row at a time, each computed as {@link PlainSmooth} computes it; tiny
 * triangles, and those with a division for each pixel, one by one as there. One per thread.
 *
 * <p>All eight pixels are read and written back, those that the triangle does not own as they were:
 * a band belongs to one thread. Where the eight would leave the band they are drawn one by one.
 */
final class VectorSmooth implements SmoothTriangles {
    private final TinyScan tiny = new TinyScan();
    private final TriangleScan scan = new TriangleScan();
    private final VectorRows rows = new VectorRows();
    private final LinearColors colors = new LinearColors();

    @Override
    public void draw(
            ScreenVertices vertices,
            int first,
            int second,
            int third,
            DepthRaster out,
            int bandTop) {
        if (tiny.load(vertices, first, second, third, out, bandTop)) {
            tiny.look(out.width());
            if (tiny.count > 0) TinyFill.smooth(out, tiny, vertices);
            return;
        }
        scan.load(vertices, first, second, third, out, bandTop);
        if (colors.fits(scan, vertices)) {
            colors.load(scan, vertices);
            rows.scan(scan);
            int end = Math.min(bandTop + TriangleScan.ROWS, out.height()) * out.width();
            VectorFill.linear(out, scan, rows, colors, end);
        } else {
            scan.scan();
            SmoothFill.perspective(out, scan, vertices);
        }
    }
}
