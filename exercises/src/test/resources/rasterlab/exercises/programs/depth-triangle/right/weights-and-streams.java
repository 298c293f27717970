import java.util.stream.IntStream;
import rasterlab.contract.DepthTriangleFiller;

/** Right: every pixel of the picture by itself, weighted by areas; no rows and no steps. */
public class Weights implements DepthTriangleFiller {
    private record Corner(double x, double y, double z) {
        double area(Corner b, Corner c) {
            return (b.x - x) * (c.y - y) - (c.x - x) * (b.y - y);
        }
    }

    @Override
    public void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {
        Corner[] c = new Corner[3];
        for (int i = 0; i < 3; i++) c[i] = new Corner(x[i], y[i], z[i]);
        if (c[0].area(c[1], c[2]) == 0) return;
        if (c[0].area(c[1], c[2]) < 0) {
            Corner other = c[1];
            c[1] = c[2];
            c[2] = other;
        }
        double whole = c[0].area(c[1], c[2]);
        IntStream.range(0, width * height)
                .forEach(
                        at -> {
                            Corner p = new Corner(at % width, at / width, 0);
                            double depth = 0;
                            for (int i = 0; i < 3; i++) {
                                Corner a = c[(i + 1) % 3];
                                Corner b = c[(i + 2) % 3];
                                double w = p.area(a, b);
                                boolean owned = b.y < a.y || b.y == a.y && b.x > a.x;
                                if (w < 0 || w == 0 && !owned) return;
                                depth += w * c[i].z;
                            }
                            depth /= whole;
                            if (depth < depths[at]) {
                                depths[at] = depth;
                                shown[at] = number;
                            }
                        });
    }
}
