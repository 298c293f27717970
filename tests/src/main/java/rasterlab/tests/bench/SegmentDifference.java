package rasterlab.tests.bench;

import java.awt.Graphics2D;
import java.util.Arrays;
import rasterlab.engine.line.RasterLine;
import rasterlab.engine.raster.Raster;

/** Whether the peer's segments are ours. */
final class SegmentDifference {
    private static final int BLACK = 0xFF000000;
    private static final int WHITE = 0xFFFFFFFF;

    private SegmentDifference() {}

    /**
     * How many pixels only one of the two lights, segment by segment.
     *
     * @param ends x0, y0, x1, y1 of each segment
     * @param graphics draws into {@code peers} in white
     * @throws IllegalStateException if a segment lights no pixel, so that nothing is compared
     */
    static long count(int[] ends, Raster ours, Raster peers, Graphics2D graphics) {
        long different = 0;
        for (int i = 0; i < ends.length; i += 4) {
            ours.clear(BLACK);
            peers.clear(BLACK);
            RasterLine.draw(ends[i], ends[i + 1], ends[i + 2], ends[i + 3], WHITE, ours);
            graphics.drawLine(ends[i], ends[i + 1], ends[i + 2], ends[i + 3]);
            if (Arrays.stream(ours.argb()).noneMatch(cell -> cell == WHITE))
                throw new IllegalStateException("segment " + i / 4 + " lights no pixel");
            for (int cell = 0; cell < ours.argb().length; cell++)
                if (ours.argb()[cell] != peers.argb()[cell]) different++;
        }
        return different;
    }
}
