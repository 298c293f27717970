import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

public class Gouraud implements FaceShader {
    record Vector(double x, double y, double z) {
        static Vector of(double[] a, int from) {
            return new Vector(a[from], a[from + 1], a[from + 2]);
        }

        Vector minus(Vector v) {
            return new Vector(x - v.x, y - v.y, z - v.z);
        }

        double dot(Vector v) {
            return x * v.x + y * v.y + z * v.z;
        }

        double length() {
            return Math.hypot(Math.hypot(x, y), z);
        }

        Vector unit() {
            double size = length();
            return new Vector(x / size, y / size, z / size);
        }
    }

    record Color(double red, double green, double blue) {
        DoubleStream shares() {
            return DoubleStream.of(red, green, blue);
        }

        static Color mixed(double a, Color one, double b, Color two, double c, Color three) {
            return new Color(
                    a * one.red + b * two.red + c * three.red,
                    a * one.green + b * two.green + c * three.green,
                    a * one.blue + b * two.blue + c * three.blue);
        }
    }

    @Override
    public double[] shade(LitFace face, double[] weights) {
        List<Color> lit = IntStream.range(0, 3).mapToObj(k -> lit(face, k)).toList();
        return IntStream.iterate(0, i -> i < weights.length, i -> i + 3)
                .mapToObj(i -> Color.mixed(weights[i], lit.get(0), weights[i + 1], lit.get(1), weights[i + 2], lit.get(2)))
                .flatMapToDouble(Color::shares)
                .toArray();
    }

    private static Color lit(LitFace face, int vertex) {
        Vector p = Vector.of(face.corners(), 3 * vertex);
        Vector n = Vector.of(face.normals(), 3 * vertex).unit();
        Vector lamp = Vector.of(face.lamp(), 0).minus(p);
        Vector l = lamp.unit();
        Vector v = Vector.of(face.eye(), 0).minus(p).unit();
        double cosine = n.dot(l);
        double gloss = 2 * cosine * n.dot(v) - l.dot(v);
        double power = cosine > 0 ? Math.pow(Math.max(gloss, 0), face.material().shininess()) : 0;
        double fades = face.light().attenuation().factor(lamp.length());
        double[] c = new double[3];
        for (int i = 0; i < 3; i++) {
            c[i] = face.material().ambient()[i] * (face.globalAmbient()[i] + fades * face.light().ambient()[i]);
            if (cosine > 0) c[i] += fades * cosine * face.light().diffuse()[i] * face.material().diffuse()[i];
            c[i] += fades * power * face.light().specular()[i] * face.material().specular()[i];
            c[i] = Math.min(c[i] + face.material().emission()[i], 1);
        }
        return new Color(c[0], c[1], c[2]);
    }
}
