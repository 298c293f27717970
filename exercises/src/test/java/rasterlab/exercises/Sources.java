package rasterlab.exercises;

import static java.util.stream.Collectors.joining;

import java.util.stream.IntStream;

/** Sources as students might send them, for tests. */
public final class Sources {
    /** A source that is right on every int, whatever the direction. */
    public static final String RIGHT =
            """
            import rasterlab.contract.*;

            public class Bresenham implements LineRasterizer {
                public void draw(int x0, int y0, int x1, int y1, Pixels out) {
                    long dx = Math.abs((long) x1 - x0), dy = Math.abs((long) y1 - y0);
                    int sx = x1 < x0 ? -1 : 1, sy = y1 < y0 ? -1 : 1;
                    boolean steep = dy > dx;
                    long n = steep ? dy : dx, b = steep ? dx : dy;
                    long d = 2 * b - n - ((steep ? sx : sy) > 0 ? 1 : 0);
                    int x = x0, y = y0;
                    for (long k = 0; k <= n; k++) {
                        out.plot(x, y);
                        if (d >= 0) {
                            if (steep) x += sx; else y += sy;
                            d -= 2 * n;
                        }
                        if (steep) y += sy; else x += sx;
                        d += 2 * b;
                    }
                }
            }
            """;

    /** The course's first listing: every column from x0 to x1 gets one pixel. */
    public static final String NAIVE_TEXTBOOK =
            method(
                    """
                    double k = (double) (y1 - y0) / (x1 - x0), b = y0 - k * x0;
                    for (int x = x0; x <= x1; x++) out.plot(x, (int) Math.round(k * x + b));
                    """);

    /** The course's full version: counts from one beyond the first end, in both directions. */
    public static final String BRESENHAM_TEXTBOOK =
            method(
                    """
                    int dx = Math.abs(x1 - x0), dy = Math.abs(y1 - y0);
                    int sx = x1 > x0 ? 1 : -1, sy = y1 > y0 ? 1 : -1;
                    if (dy <= dx) {
                        int d = 2 * dy - dx, d1 = 2 * dy, d2 = 2 * (dy - dx), y = y0;
                        out.plot(x0, y0);
                        for (int x = x0 + 1; sx > 0 ? x <= x1 : x >= x1; x += sx) {
                            if (d > 0) { d += d2; y += sy; } else d += d1;
                            out.plot(x, y);
                        }
                    } else {
                        int d = 2 * dx - dy, d1 = 2 * dx, d2 = 2 * (dx - dy), x = x0;
                        out.plot(x0, y0);
                        for (int y = y0 + 1; sy > 0 ? y <= y1 : y >= y1; y += sy) {
                            if (d > 0) { d += d2; x += sx; } else d += d1;
                            out.plot(x, y);
                        }
                    }
                    """);

    private Sources() {}

    /** A class whose draw method has that body, which begins in line 5. */
    public static String method(String body) {
        return """
        import rasterlab.contract.*;

        public class Mine implements LineRasterizer {
            public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        """
                + body
                + "    }\n}\n";
    }

    /** A lattice of which each level, from the top, doubles the ways: 2^levels of them. */
    public static String latticeOf(int levels) {
        return "interface A0 { }\ninterface B0 { }\n"
                + IntStream.rangeClosed(1, levels)
                        .mapToObj(
                                i ->
                                        "interface A%1$d extends A%2$d, B%2$d { }%ninterface B%1$d extends A%2$d, B%2$d { }%n"
                                                .formatted(i, i - 1))
                        .collect(joining())
                + "class Tangled extends Exception implements A%1$d, B%1$d { }%n".formatted(levels);
    }
}
