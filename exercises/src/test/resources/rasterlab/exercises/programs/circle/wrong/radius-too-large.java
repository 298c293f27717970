import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

public class Backwards implements CircleRasterizer {
    @Override
    public void draw(int centerX, int centerY, int radius, Pixels out) {
        Octant octant = new Octant(centerX, centerY, radius + 1, out);
        long u = (long) (radius / Math.sqrt(2)) + 2;
        for (; u >= 0; u--) octant.column(u);
    }

    static class Octant {
        private final int x;
        private final int y;
        private final long r;
        private final Pixels out;

        Octant(int x, int y, int r, Pixels out) {
            this.x = x;
            this.y = y;
            this.r = r;
            this.out = out;
        }

        void column(long u) {
            if (u > r) return;
            long v = (long) Math.sqrt((double) (r * r - u * u)) + 2;
            while (v > 0 && u * u + v * v - v >= r * r) v--;
            if (u > v) return;
            turn(u, v, 0);
            if (u > 0 && u < v) turn(-u, v, 0);
        }

                private void turn(long u, long v, int turns) {
            if (turns == 4) return;
            if (r == 0 && turns > 0) return;
            out.plot((int) (x + u), (int) (y + v));
            turn(-v, u, turns + 1);
        }
    }
}
