import java.util.Arrays;
import java.util.stream.IntStream;
import rasterlab.contract.VisibleFaces;

public class Streams implements VisibleFaces {
    record Vector(double x, double y, double z) {
        static Vector of(double[] all, int at) {
            return new Vector(all[3 * at], all[3 * at + 1], all[3 * at + 2]);
        }

        Vector minus(Vector o) {
            return new Vector(x - o.x, y - o.y, z - o.z);
        }

        Vector plus(Vector o) {
            return new Vector(x + o.x, y + o.y, z + o.z);
        }

        Vector cross(Vector o) {
            return new Vector(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
        }

        double dot(Vector o) {
            return x * o.x + y * o.y + z * o.z;
        }
    }

    @Override
    public boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside) {
        boolean[] seen = new boolean[faces.length];
        IntStream.range(0, faces.length).forEach(f -> seen[f] = seen(xyz, faces[f], eye));
        return seen;
    }

    private static boolean seen(double[] xyz, int[] face, double[] eye) {
        Vector[] c = Arrays.stream(face).mapToObj(v -> Vector.of(xyz, v)).toArray(Vector[]::new);
        Vector normal =
                IntStream.range(1, c.length - 1)
                        .mapToObj(k -> c[k].minus(c[0]).cross(c[k + 1].minus(c[0])))
                        .reduce(new Vector(0, 0, 0), Vector::plus);
        return normal.dot(Vector.of(eye, 0).minus(c[0])) > 0;
    }
}
