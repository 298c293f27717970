package rasterlab.engine.pipeline.fast;

/** One band of rows after the other: cleared, then drawn in the mesh's order. One per thread. */
final class BandStage {
    private final Band band = new Band();
    private final TriangleScan scan = new TriangleScan();
    private final TinyScan tiny = new TinyScan();
    private final LinearColors linear = new LinearColors();
    private final RowWeights weights = new RowWeights();
    private final SmoothCorners corners = new SmoothCorners();
    private final PixelFill pixels = new PixelFill(band);

    /**
     * @param chunks how many of {@code sorted} are the frame's
     */
    void run(FrameState frame, int number, TriangleChunk[] sorted, int chunks) {
        band.begin(frame, number);
        if (frame.surface instanceof Surface.PerPixel) pixels.begin(frame);
        for (int k = 0; k < chunks; k++) {
            TriangleChunk chunk = sorted[k];
            drawEach(frame, chunk, chunk.start[number], chunk.start[number + 1]);
        }
        if (frame.surface instanceof Surface.PerPixel) pixels.flush();
    }

    /** Drops what belongs to the frame that has been drawn. */
    void end() {
        band.end();
        pixels.end();
    }

    private void drawEach(FrameState frame, TriangleChunk chunk, int from, int end) {
        int[] corners = chunk.corners;
        for (int i = 3 * from; i < 3 * end; i += 3) {
            int first = corners[i];
            int second = corners[i + 1];
            int third = corners[i + 2];
            if (first >= 0) draw(frame, frame.vertices, first, second, third);
            else draw(frame, chunk.clipped, ~first, ~second, ~third);
        }
    }

    private void draw(FrameState frame, ScreenVertices vertices, int first, int second, int third) {
        if (tiny.load(vertices, first, second, third, band)) fillTiny(frame, vertices, third);
        else drawLarge(frame, vertices, first, second, third);
    }

    private void drawLarge(
            FrameState frame, ScreenVertices vertices, int first, int second, int third) {
        scan.load(vertices, first, second, third, band);
        if (frame.surface instanceof Surface.Smooth) {
            fillSmooth(vertices);
            return;
        }
        if (frame.surface instanceof Surface.PerPixel) {
            pixels.fill(scan, vertices, third);
            return;
        }
        scan.scan();
        fillFlat(vertices, FlatFill.argb(vertices, third));
    }

    private void fillFlat(ScreenVertices vertices, int argb) {
        FlatFill.fill(band, scan, vertices, weights, argb);
    }

    private void fillSmooth(ScreenVertices vertices) {
        if (linear.fits(scan, vertices)) {
            linear.load(scan, vertices);
            scan.scan();
            RowLoops.linear(band, scan, linear);
        } else {
            scan.scan();
            SmoothFill.perspective(band, scan, vertices, weights);
        }
    }

    private void fillTiny(FrameState frame, ScreenVertices vertices, int third) {
        if (frame.surface instanceof Surface.Smooth) {
            if (tiny.columns * tiny.rows <= TinyScan.FEW) TinyFill.few(band, tiny, vertices);
            else fillSmall(vertices);
            return;
        }
        if (frame.surface instanceof Surface.PerPixel) {
            pixels.fill(tiny, vertices, third);
            return;
        }
        tiny.look(band.width);
        if (tiny.count > 0) TinyFill.flat(band, tiny, vertices, FlatFill.argb(vertices, third));
    }

    private void fillSmall(ScreenVertices vertices) {
        tiny.look(band.width);
        if (tiny.count == 0) return;
        corners.load(tiny, vertices);
        TinyFill.smooth(band, tiny, corners);
    }
}
