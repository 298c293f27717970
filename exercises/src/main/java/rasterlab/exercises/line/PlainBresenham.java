package rasterlab.exercises.line;

import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

/**
 * Bresenham's line as a student writes it, right for every int: two loops, one decision. It is what
 * a student's speed is held against, and not the engine's own, which is built to be stepped through
 * and compiles to something else.
 *
 * <p>With n and b the extents along the longer and the shorter axis and t = 1 where the shorter
 * axis's coordinate does not fall, else 0: {@code d = 2·(i + 1)·b − (2·j + 1)·n − t} after i steps
 * along and j across; step across when d ≥ 0. A long holds d: |d| ≤ 2·n &lt; 2³⁴.
 *
 * <p>Source: J. E. Bresenham, Algorithm for computer control of a digital plotter, IBM Systems
 * Journal 4(1), 1965, pp. 25–30.
 */
public final class PlainBresenham implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        long dx = Math.abs((long) x1 - x0);
        long dy = Math.abs((long) y1 - y0);
        int signX = x1 < x0 ? -1 : 1;
        int signY = y1 < y0 ? -1 : 1;
        int x = x0;
        int y = y0;
        if (dx >= dy) {
            long d = 2 * dy - dx - (signY > 0 ? 1 : 0);
            for (long k = 0; k <= dx; k++) {
                out.plot(x, y);
                if (d >= 0) {
                    y += signY;
                    d -= 2 * dx;
                }
                x += signX;
                d += 2 * dy;
            }
        } else {
            long d = 2 * dx - dy - (signX > 0 ? 1 : 0);
            for (long k = 0; k <= dy; k++) {
                out.plot(x, y);
                if (d >= 0) {
                    x += signX;
                    d -= 2 * dy;
                }
                y += signY;
                d += 2 * dx;
            }
        }
    }
}
