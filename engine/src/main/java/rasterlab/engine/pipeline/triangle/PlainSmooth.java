package rasterlab.engine.pipeline.triangle;

/** One pixel after the other. One per thread. */
final class PlainSmooth implements SmoothTriangles {
    private final TriangleScan scan = new TriangleScan();
    private final TinyScan tiny = new TinyScan();
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
        scan.scan();
        if (colors.fits(scan, vertices)) {
            colors.load(scan, vertices);
            SmoothFill.linear(out, scan, colors);
        } else SmoothFill.perspective(out, scan, vertices);
    }
}
