package rasterlab.engine.pipeline.triangle;

import rasterlab.engine.lanes.Lanes;

/** One band of rows after the other: cleared, then drawn in the mesh's order. One per thread. */
final class BandStage {
    /** The most pixels of a box that are asked one by one. */
    static final int FEW = 4;

    private final Band band = new Band();
    private final TriangleScan scan = new TriangleScan();
    private final TinyScan tiny = new TinyScan();
    private final LinearColors linear = new LinearColors();
    private final RowWeights weights = new RowWeights();
    private final RowLoops loops;
    private final PixelFill pixels;

    BandStage(Lanes lanes) {
        loops = RowLoops.of(lanes);
        pixels = new PixelFill(band, loops);
    }

    /**
     * @param chunks how many of {@code sorted} are the frame's
     */
    void run(Frame frame, int number, TriangleChunk[] sorted, int chunks) {
        band.begin(frame, number);
        if (frame.surface instanceof Surface.PerPixel) pixels.begin(frame);
        for (int k = 0; k < chunks; k++) {
            TriangleChunk chunk = sorted[k];
            int[] corners = chunk.corners;
            for (int i = 3 * chunk.start[number]; i < 3 * chunk.start[number + 1]; i += 3) {
                int first = corners[i];
                int second = corners[i + 1];
                int third = corners[i + 2];
                if (first >= 0) draw(frame, frame.vertices, first, second, third);
                else draw(frame, chunk.clipped, ~first, ~second, ~third);
            }
        }
        if (frame.surface instanceof Surface.PerPixel) pixels.flush();
    }

    private void draw(Frame frame, ScreenVertices vertices, int first, int second, int third) {
        if (tiny.load(vertices, first, second, third, band)) {
            fillTiny(frame, vertices, third);
            return;
        }
        scan.load(vertices, first, second, third, band);
        if (frame.surface instanceof Surface.Smooth) {
            fillSmooth(vertices);
            return;
        }
        if (frame.surface instanceof Surface.PerPixel) {
            pixels.fill(scan, vertices, third);
            return;
        }
        loops.scan(scan);
        fillFlat(vertices, FlatFill.argb(vertices, third));
    }

    private void fillFlat(ScreenVertices vertices, int argb) {
        FlatFill.fill(band, scan, vertices, weights, argb);
    }

    private void fillSmooth(ScreenVertices vertices) {
        if (linear.fits(scan, vertices)) {
            linear.load(scan, vertices);
            loops.linear(band, scan, linear);
        } else {
            loops.scan(scan);
            SmoothFill.perspective(band, scan, vertices, weights);
        }
    }

    private void fillTiny(Frame frame, ScreenVertices vertices, int third) {
        if (frame.surface instanceof Surface.Smooth) {
            if (tiny.columns * tiny.rows <= FEW) TinyFill.few(band, tiny, vertices);
            else loops.smooth(band, tiny, vertices);
            return;
        }
        if (frame.surface instanceof Surface.PerPixel) {
            pixels.fill(tiny, vertices, third);
            return;
        }
        tiny.look(band.width);
        if (tiny.count > 0) TinyFill.flat(band, tiny, vertices, FlatFill.argb(vertices, third));
    }
}
