package rasterlab.engine.line;

import rasterlab.contract.CoveragePixels;

/** A line method that shares its brightness among pixels instead of choosing one. */
public interface CoverageLine extends SteppedLine {
    /** The coverage of a pixel that lies wholly on the line. */
    int FULL = 255;

    /**
     * Sends the pixels of the segment from (x0, y0) to (x1, y1) with their coverage, none of which
     * is 0. {@code draw} without coverage sends those covered by at least a half.
     *
     * @throws IllegalArgumentException if the method cannot draw this segment; the message names
     *     the value and the range
     */
    void shade(int x0, int y0, int x1, int y1, CoveragePixels out);
}
