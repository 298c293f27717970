package rasterlab.engine.polygon.scan;

import java.util.Arrays;
import rasterlab.contract.FillRule;
import rasterlab.engine.raster.Raster;

/**
 * A polygon written directly into a picture: the same pixels as {@link ScanlinePolygon}, for the
 * price of one addition per crossing.
 *
 * <p>Corners are whole 1/{@value #SUBPIXELS} pixels at most 16384 pixels from 0. An edge's crossing
 * is a multiple of 1/(256·Δy), Δy in sub-pixels and at most 2²³, so one that is no whole column is
 * at least 2⁻³¹ away from each. It is kept in fixed point with {@value #FRACTION} binary places:
 * the start, computed in doubles, is off by less than 2⁻³⁵, the slope by less than 2⁻⁴⁶ and 2⁻⁵² of
 * itself, which over 2¹³ rows are less than 2⁻³². So ⌊X + 1 − 2⁻³²⌋ is the first column that is not
 * left of the exact crossing, and rounding never decides. An edge flatter than that crosses one row
 * only and takes no step.
 *
 * <p>Keeps its tables from call to call, so that filling allocates nothing: one per thread.
 */
public final class RasterPolygon {
    /** Parts of a pixel in which corners are given. */
    public static final int SUBPIXELS = 256;

    private static final int FARTHEST = 16384 * SUBPIXELS;
    private static final int FRACTION = 46;
    private static final double ONE = 1L << FRACTION;
    private static final long ROUND_UP = (1L << FRACTION) - (1L << FRACTION - 32);
    private static final int SHORT_SPAN = 24;
    private static final int NONE = -1;

    /** Edge by edge: column + 1 − 2⁻³² of the crossing, and by how much it grows each row. */
    private long[] position = new long[16];

    private long[] step = new long[16];
    private int[] end = new int[16];
    private int[] winding = new int[16];

    /** The edge after this one among those that begin in the same row. */
    private int[] next = new int[16];

    /** The edges that cross the row, from left to right. */
    private int[] active = new int[16];

    /** Row by row: one of the edges that begin there, or {@link #NONE}. */
    private int[] beginning = new int[0];

    private int firstRow;
    private int endRow;

    /**
     * Fills a polygon.
     *
     * @param subpixelX columns of the corners; a pixel's centre is a multiple of {@value
     *     #SUBPIXELS}
     * @param subpixelY rows of the corners
     * @param corners how many of them count
     * @param argb the colour, 0xAARRGGBB, written as it is
     */
    public void fill(
            int[] subpixelX, int[] subpixelY, int corners, FillRule rule, int argb, Raster out) {
        reserve(corners, out.height());
        load(subpixelX, subpixelY, corners, out.height());
        int mask = rule == FillRule.EVEN_ODD ? 1 : -1;
        int count = 0;
        int row = firstRow;
        while (row < endRow) {
            count = enter(row, count);
            if (count == 2) row = fillBetween(row, argb, out);
            else fillRow(count, mask, row++, argb, out);
            count = keep(row, count);
        }
    }

    private void reserve(int corners, int height) {
        if (corners > active.length) {
            int length = Math.max(corners, 2 * active.length);
            position = new long[length];
            step = new long[length];
            end = new int[length];
            winding = new int[length];
            next = new int[length];
            active = new int[length];
        }
        if (height > beginning.length) {
            beginning = new int[height];
            Arrays.fill(beginning, NONE);
        }
    }

    private void load(int[] subpixelX, int[] subpixelY, int corners, int height) {
        firstRow = height;
        endRow = 0;
        for (int i = 0; i < corners; i++) check(subpixelX[i], subpixelY[i], i);
        for (int i = 0, before = corners - 1; i < corners; before = i++) {
            if (subpixelY[before] < subpixelY[i])
                load(i, subpixelX, subpixelY, before, i, 1, height);
            else load(i, subpixelX, subpixelY, i, before, -1, height);
        }
    }

    private static void check(int subpixelX, int subpixelY, int corner) {
        if (Math.abs((long) subpixelX) > FARTHEST || Math.abs((long) subpixelY) > FARTHEST)
            throw new IllegalArgumentException(
                    "corner %d must be at most 16384 pixels from 0, got (%d, %d) / 256"
                            .formatted(corner, subpixelX, subpixelY));
    }

    private void load(
            int edge,
            int[] subpixelX,
            int[] subpixelY,
            int upper,
            int lower,
            int down,
            int height) {
        int x = subpixelX[upper];
        int y = subpixelY[upper];
        int first = Math.max(0, y + SUBPIXELS - 1 >> 8);
        int last = Math.min(height, subpixelY[lower] + SUBPIXELS - 1 >> 8);
        if (first >= last) return;
        double slope = (double) (subpixelX[lower] - x) / (subpixelY[lower] - y);
        double crossing = (x + (first * SUBPIXELS - y) * slope) / SUBPIXELS;
        position[edge] = (long) (crossing * ONE) + ROUND_UP;
        step[edge] = (long) (slope * ONE);
        end[edge] = last;
        winding[edge] = down;
        next[edge] = beginning[first];
        beginning[first] = edge;
        firstRow = Math.min(firstRow, first);
        endRow = Math.max(endRow, last);
    }

    private int enter(int row, int count) {
        for (int edge = beginning[row]; edge != NONE; edge = next[edge]) insert(edge, count++);
        beginning[row] = NONE;
        return count;
    }

    /** Puts an edge at its place among the first {@code count} active ones. */
    private void insert(int edge, int count) {
        long column = position[edge];
        int place = count;
        while (place > 0 && position[active[place - 1]] > column) {
            active[place] = active[place - 1];
            place--;
        }
        active[place] = edge;
    }

    /** Drops the edges that end before a row and sorts the others, most of them sorted already. */
    private int keep(int row, int count) {
        int kept = 0;
        for (int i = 0; i < count; i++) if (end[active[i]] > row) insert(active[i], kept++);
        return kept;
    }

    /** Fills one row, and steps its edges on to the next. */
    private void fillRow(int count, int mask, int row, int argb, Raster out) {
        int width = out.width();
        int start = row * width;
        int sum = 0;
        int from = 0;
        for (int i = 0; i < count; i++) {
            int edge = active[i];
            int column = (int) (position[edge] >> FRACTION);
            position[edge] += step[edge];
            if ((sum & mask) == 0) from = Math.max(0, column);
            sum += winding[edge];
            if ((sum & mask) == 0)
                fillSpan(start + from, start + Math.min(width, column), argb, out.argb());
        }
    }

    /**
     * Fills the rows from {@code row} on that only the first two edges cross, one of them upward
     * and one downward, while their order lasts; steps them on to the row after these.
     *
     * @return that row
     */
    private int fillBetween(int row, int argb, Raster out) {
        int[] cells = out.argb();
        int width = out.width();
        int start = row * width;
        int left = active[0];
        int right = active[1];
        long from = position[left];
        long to = position[right];
        int until = Math.min(end[left], end[right]);
        do {
            fillSpan(
                    start + Math.max(0, (int) (from >> FRACTION)),
                    start + Math.min(width, (int) (to >> FRACTION)),
                    argb,
                    cells);
            from += step[left];
            to += step[right];
            start += width;
            row++;
        } while (row < until && beginning[row] == NONE && from <= to);
        position[left] = from;
        position[right] = to;
        return row;
    }

    private static void fillSpan(int from, int to, int argb, int[] cells) {
        if (to - from >= SHORT_SPAN) Arrays.fill(cells, from, to, argb);
        else for (int i = from; i < to; i++) cells[i] = argb;
    }
}
