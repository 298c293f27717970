import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

public class Phong implements FaceShader {
    record Vector(double x, double y, double z) {
        static Vector of(double[] a, int from) {
            return new Vector(a[from], a[from + 1], a[from + 2]);
        }

        static Vector mixed(double[] shares, int from, Vector[] three) {
            Vector sum = new Vector(0, 0, 0);
            for (int i = 0; i < 3; i++) sum = sum.plus(three[i].times(shares[from + i]));
            return sum;
        }

        Vector plus(Vector v) {
            return new Vector(x + v.x, y + v.y, z + v.z);
        }

        Vector times(double k) {
            return new Vector(k * x, k * y, k * z);
        }

        double dot(Vector v) {
            return x * v.x + y * v.y + z * v.z;
        }

        double length() {
            return Math.hypot(Math.hypot(x, y), z);
        }

        Vector unit() {
            return new Vector(x / length(), y / length(), z / length());
        }
    }

    @Override
    public double[] shade(LitFace face, double[] weights) {
        Vector[] corners = three(face.corners());
        Vector[] normals = three(face.normals());
        for (int i = 0; i < 3; i++) normals[i] = normals[i].unit();
        return IntStream.range(0, weights.length / 3)
                .mapToObj(k -> point(face, Vector.mixed(weights, 3 * k, corners), Vector.mixed(weights, 3 * k, normals)))
                .flatMapToDouble(color -> IntStream.range(0, 3).mapToDouble(color))
                .toArray();
    }

    private static Vector[] three(double[] nine) {
        return new Vector[] {Vector.of(nine, 0), Vector.of(nine, 3), Vector.of(nine, 6)};
    }

    private static IntToDoubleFunction point(LitFace face, Vector p, Vector sum) {
        Vector n = sum.unit();
        Vector lamp = Vector.of(face.lamp(), 0).plus(p.times(-1));
        Vector l = lamp.unit();
        Vector v = Vector.of(face.eye(), 0).plus(p.times(-1)).unit();
        Vector r = n.times(2 * n.dot(l)).plus(l.times(-1));
        double lambert = Math.max(0, n.dot(l));
        double gloss = lambert == 0 ? 0 : Math.pow(Math.max(0, r.dot(v)), face.material().shininess());
        double f = face.light().attenuation().factor(lamp.length());
        return i ->
                Math.min(
                        1,
                        face.material().emission()[i]
                                + face.material().ambient()[i] * face.globalAmbient()[i]
                                + f * lambert * face.light().diffuse()[i] * face.material().diffuse()[i]
                                + f * gloss * face.light().specular()[i] * face.material().specular()[i]);
    }
}
