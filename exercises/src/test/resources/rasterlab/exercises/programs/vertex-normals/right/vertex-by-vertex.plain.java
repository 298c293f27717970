import java.util.stream.IntStream;
import rasterlab.contract.VertexNormals;

public class ByVertex implements VertexNormals {
    @Override
    public double[] normals(double[] p, int[] t) {
        return IntStream.range(0, p.length / 3)
                .boxed()
                .flatMap(v -> of(v, p, t))
                .mapToDouble(Double::doubleValue)
                .toArray();
    }

    private java.util.stream.Stream<Double> of(int v, double[] p, int[] t) {
        double x = 0, y = 0, z = 0, w = 0;
        for (int f = 0; f < t.length; f += 3)
            for (int c = 0; c < 3; c++) {
                if (t[f + c] != v) continue;
                int a = 3 * v, b = 3 * t[f + (c + 1) % 3], d = 3 * t[f + (c + 2) % 3];
                double ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
                double vx = p[d] - p[a], vy = p[d + 1] - p[a + 1], vz = p[d + 2] - p[a + 2];
                double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
                x += nx;
                y += ny;
                z += nz;
                w += Math.sqrt(nx * nx + ny * ny + nz * nz);
            }
        double l = Math.sqrt(x * x + y * y + z * z);
        return l <= 1e-9 * w
                ? java.util.stream.Stream.of(0.0, 0.0, 0.0)
                : java.util.stream.Stream.of(x / l, y / l, z / l);
    }
}
