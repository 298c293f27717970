import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class Halves implements LineRasterizer {
    record Line(long x0, long y0, long dx, long dy) {
        long n() {
            return Math.max(Math.abs(dx), Math.abs(dy));
        }

        void pixel(long k, Pixels out) {
            out.plot((int) (nearest(k * dx)), (int) (nearest(k * dy)));
        }

        private long nearest(long a) {
            return n() == 0 ? 0 : -Math.floorDiv(n() - 2 * a, 2 * n());
        }
    }

    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        Line line = new Line(x0, y0, (long) x1 - x0, (long) y1 - y0);
        part(line, 0, line.n(), out);
    }

    private static void part(Line line, long from, long to, Pixels out) {
        if (from == to) {
            line.pixel(from, out);
            return;
        }
        long middle = (from + to) / 2;
        part(line, from, middle, out);
        part(line, middle + 1, to, out);
    }
}
