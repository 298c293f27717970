package rasterlab.engine.line;

import rasterlab.engine.raster.Blend;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Raster;

/**
 * Wu's anti-aliased line blended directly into a picture; what lies outside is left out.
 *
 * <p>The position across is kept in fixed point with {@value #FRACTION} binary places, as Wu does,
 * half a level ahead: then its whole part names the first of the two pixels the line passes
 * between, and its first eight places are the coverage of the second in 256ths, rounded; the rest
 * to 256 is that of the first. Start and step are rounded to the nearest, so after m &lt; 2¹³
 * steps, the most a picture shows, the position errs by less than 2⁻¹⁹ pixels, however long the
 * line is outside: a coverage is right to a little more than half a 256th, and the ends, which lie
 * on whole pixels, are covered wholly.
 *
 * <p>Source: X. Wu, An efficient antialiasing technique, Computer Graphics (SIGGRAPH) 25(4), 1991,
 * pp. 143–152.
 */
public final class ShadedRasterLine {
    private static final int FRACTION = 32;
    private static final int LEVEL = FRACTION - 8;
    private static final long HALF_LEVEL = 1L << LEVEL - 1;

    private ShadedRasterLine() {}

    /**
     * Draws the part of the segment from (x0, y0) to (x1, y1) that lies in the picture; any int is
     * allowed.
     *
     * @param argb the colour, 0xAARRGGBB
     */
    public static void draw(int x0, int y0, int x1, int y1, int argb, Raster out) {
        var frame = new PixelWindow(-1, -1, out.width(), out.height());
        var section = LineSection.within(frame, x0, y0, x1, y1);
        if (section.count() == 0) return;
        int along = section.steep() ? section.signY() * out.width() : section.signX();
        int across = section.steep() ? section.signX() : section.signY() * out.width();
        int x = section.x(x0);
        int y = section.y(y0);
        boolean inside = out.contains(x0, y0) && out.contains(x1, y1);
        if (inside) drawInside(section, y * out.width() + x, along, across, argb, out.argb());
        else drawPartly(section, x, y, argb, out);
    }

    /**
     * The exact position of the first pixel across, less the whole pixels it is rounded to, and
     * half a level.
     */
    private static long start(LineSection section) {
        if (section.n() == 0) return HALF_LEVEL;
        double twice = 2.0 * section.n();
        long offset = section.remainder() - section.n() + section.tie();
        return HALF_LEVEL + Math.round(offset / twice * (1L << FRACTION));
    }

    private static long step(LineSection section) {
        if (section.n() == 0) return 0;
        return Math.round((double) section.b() / section.n() * (1L << FRACTION));
    }

    private static void drawInside(
            LineSection section, int cell, int along, int across, int argb, int[] cells) {
        long position = start(section);
        long step = step(section);
        for (int left = (int) section.count(); left > 0; left--) {
            int first = cell + (int) (position >> FRACTION) * across;
            int second = (int) (position >> LEVEL) & 0xFF;
            cells[first] = Blend.over(argb, cells[first], Blend.WHOLE - second);
            if (second != 0) {
                int beside = first + across;
                cells[beside] = Blend.over(argb, cells[beside], second);
            }
            position += step;
            cell += along;
        }
    }

    private static void drawPartly(LineSection section, int x, int y, int argb, Raster out) {
        long position = start(section);
        long step = step(section);
        boolean steep = section.steep();
        int across = steep ? section.signX() : section.signY();
        for (long k = 0; k < section.count(); k++) {
            int shift = (int) (position >> FRACTION) * across;
            int second = (int) (position >> LEVEL) & 0xFF;
            int pixelX = x + (steep ? shift : section.signX() * (int) k);
            int pixelY = y + (steep ? section.signY() * (int) k : shift);
            blend(pixelX, pixelY, argb, Blend.WHOLE - second, out);
            if (second != 0)
                blend(
                        pixelX + (steep ? across : 0),
                        pixelY + (steep ? 0 : across),
                        argb,
                        second,
                        out);
            position += step;
        }
    }

    private static void blend(int x, int y, int argb, int coverage, Raster out) {
        if (!out.contains(x, y)) return;
        int cell = y * out.width() + x;
        out.argb()[cell] = Blend.over(argb, out.argb()[cell], coverage);
    }
}
