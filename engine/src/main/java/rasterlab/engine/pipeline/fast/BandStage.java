package rasterlab.engine.pipeline.fast;

import rasterlab.engine.lanes.Lanes;

/** One band of rows after the other: cleared, then drawn in the mesh's order. One per thread. */
final class BandStage {
    /**
     * The pixels a triangle below which a band counts as dense with small ones: of tori of 100,000
     * to 1,000,000 triangles at 720p and 1080p none gained by 4 or 8 instead.
     */
    private static final int DENSE = 5;

    private final Band band = new Band();
    private final TriangleScan scan = new TriangleScan();
    private final TinyScan tiny = new TinyScan();
    private final TinyBlock block = new TinyBlock();
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
    void run(FrameState frame, int number, TriangleChunk[] sorted, int chunks) {
        band.begin(frame, number);
        if (frame.surface instanceof Surface.PerPixel) pixels.begin(frame);
        boolean inBlocks = loops.findsInBlocks() && isDense(count(sorted, chunks, number), cells());
        for (int k = 0; k < chunks; k++) {
            TriangleChunk chunk = sorted[k];
            if (inBlocks) drawBlocks(frame, chunk, chunk.start[number], chunk.start[number + 1]);
            else drawEach(frame, chunk, chunk.start[number], chunk.start[number + 1]);
        }
        if (frame.surface instanceof Surface.PerPixel) pixels.flush();
    }

    private static long count(TriangleChunk[] sorted, int chunks, int number) {
        long triangles = 0;
        for (int k = 0; k < chunks; k++) triangles += sorted[k].triangles(number);
        return triangles;
    }

    private long cells() {
        return (long) (band.bottom() - band.top) * band.width;
    }

    static boolean isDense(long triangles, long pixels) {
        return DENSE * triangles > pixels;
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

    private void drawBlocks(FrameState frame, TriangleChunk chunk, int from, int end) {
        for (int first = from; first < end; first += block.count) {
            block.take(chunk, first, end, frame.vertices);
            loops.find(block, band);
            block.list();
            int place = fillListed(frame, 0);
            while (place < block.length) {
                drawOther(frame, block.kind(place), block.triangle(place));
                place = fillListed(frame, place + 1);
            }
        }
    }

    /** Returns the place after the pixels that are listed from a place on. */
    private int fillListed(FrameState frame, int place) {
        if (frame.surface instanceof Surface.Smooth) return TinyFill.listed(band, block, place);
        if (frame.surface instanceof Surface.PerPixel) return pixels.addListed(block, place);
        return TinyFill.listedFlat(band, block, place);
    }

    private void drawOther(FrameState frame, int kind, int triangle) {
        int third = block.corner(triangle, 2);
        if (kind == TinyBlock.LARGE) {
            int first = block.corner(triangle, 0);
            drawLarge(frame, block.vertices, first, block.corner(triangle, 1), third);
        } else {
            tiny.take(block, triangle);
            fillTiny(frame, block.vertices, third);
        }
    }

    private void drawLarge(FrameState frame, ScreenVertices vertices, int first, int second, int third) {
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

    private void fillTiny(FrameState frame, ScreenVertices vertices, int third) {
        if (frame.surface instanceof Surface.Smooth) {
            if (tiny.columns * tiny.rows <= TinyScan.FEW) TinyFill.few(band, tiny, vertices);
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
