package rasterlab.engine.line;

import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Raster;

/**
 * A straight line written directly into a picture: the same pixels as {@link BresenhamLine}, those
 * outside left out, for the price of one addition and one shift each.
 *
 * <p>The position across is kept in fixed point with {@value #FRACTION} binary places: p = (2·r +
 * 1)/(4·n) at the first pixel, r being {@link LineSection#remainder}, then p ← p + b/n, and ⌊p⌋ is
 * the number of pixels across. For a line that begins in the picture that is p = ½ ∓ 1/(4·n), less
 * where the coordinate across does not fall. Exact positions are multiples of 1/(2·n), and the
 * start adds 1/(4·n), so every exact p keeps a distance of 1/(4·n) from the next whole number. Both
 * quotients are rounded down, so after m steps p is low by less than (m + 1)·2⁻³⁸, which is at most
 * 1/(4·n) for m &lt; 2¹³ (no picture is longer) and n ≤ 2²²: rounding never decides. A longer line
 * takes {@link BresenhamLine}'s walk from where it enters the picture.
 */
public final class RasterLine {
    private static final int FRACTION = 38;
    private static final long HALF = 1L << FRACTION - 1;
    private static final int MOST_STEPS = 1 << 22;

    private RasterLine() {}

    /**
     * Draws the part of the segment from (x0, y0) to (x1, y1) that lies in the picture; any int is
     * allowed.
     *
     * @param argb the colour, 0xAARRGGBB, written as it is
     */
    public static void draw(int x0, int y0, int x1, int y1, int argb, Raster out) {
        if (out.contains(x0, y0) && out.contains(x1, y1)) drawWhole(x0, y0, x1, y1, argb, out);
        else drawSection(x0, y0, x1, y1, argb, out);
    }

    private static void drawWhole(int x0, int y0, int x1, int y1, int argb, Raster out) {
        int width = out.width();
        int dx = x1 - x0;
        int dy = y1 - y0;
        int stepX = dx < 0 ? -1 : 1;
        int stepY = dy < 0 ? -width : width;
        int cell = y0 * width + x0;
        if (Math.abs(dx) >= Math.abs(dy))
            drawSteps(cell, Math.abs(dx), Math.abs(dy), stepX, stepY, argb, out.argb());
        else drawSteps(cell, Math.abs(dy), Math.abs(dx), stepY, stepX, argb, out.argb());
    }

    /**
     * @param cell index of the first pixel
     * @param n steps along, each adding {@code along} to the index
     * @param b steps across among them, each adding {@code across}
     */
    private static void drawSteps(
            int cell, int n, int b, int along, int across, int argb, int[] cells) {
        if (n == 0) {
            cells[cell] = argb;
            return;
        }
        long margin = (HALF >> 1) / n;
        long position = across < 0 ? HALF + margin : HALF - margin - 1;
        long step = ((long) b << FRACTION) / n;
        drawRun(cell, n + 1, along, across, position, step, argb, cells);
    }

    private static void drawSection(int x0, int y0, int x1, int y1, int argb, Raster out) {
        var section = LineSection.within(PixelWindow.of(out), x0, y0, x1, y1);
        if (section.count() == 0) return;
        if (section.n() > MOST_STEPS) {
            drawWalk(x0, y0, section, argb, out);
            return;
        }
        int width = out.width();
        int along = section.steep() ? section.signY() * width : section.signX();
        int across = section.steep() ? section.signX() : section.signY() * width;
        int cell = section.y(y0) * width + section.x(x0);
        long step = (section.b() << FRACTION) / section.n();
        long position = ((2 * section.remainder() + 1) << FRACTION) / (4 * section.n());
        drawRun(cell, (int) section.count(), along, across, position, step, argb, out.argb());
    }

    private static void drawRun(
            int cell,
            int count,
            int along,
            int across,
            long position,
            long step,
            int argb,
            int[] cells) {
        for (int i = 0; i < count; i++) {
            cells[cell + (int) (position >> FRACTION) * across] = argb;
            position += step;
            cell += along;
        }
    }

    private static void drawWalk(int x0, int y0, LineSection section, int argb, Raster out) {
        int[] cells = out.argb();
        int width = out.width();
        var walk = new BresenhamSection(x0, y0, section);
        while (walk.advance()) cells[walk.y() * width + walk.x()] = argb;
    }
}
