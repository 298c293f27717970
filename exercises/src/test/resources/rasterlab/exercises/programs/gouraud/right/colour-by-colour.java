import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

/** Works out one colour of the whole face after the other, from the differences to the first vertex. */
public class Planes implements FaceShader {
    @Override
    public double[] shade(LitFace face, double[] weights) {
        double[] all = new double[weights.length];
        for (int color = 0; color < 3; color++) {
            double first = light(face, 0, color);
            double second = light(face, 1, color) - first;
            double third = light(face, 2, color) - first;
            for (int i = 0; i < weights.length; i += 3)
                all[i + color] = first + weights[i + 1] * second + weights[i + 2] * third;
        }
        return all;
    }

    private double light(LitFace face, int vertex, int color) {
        double[] l = way(face.corners(), vertex, face.lamp());
        double[] v = way(face.corners(), vertex, face.eye());
        double nx = face.normals()[3 * vertex];
        double ny = face.normals()[3 * vertex + 1];
        double nz = face.normals()[3 * vertex + 2];
        double n = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double nl = (nx * l[0] + ny * l[1] + nz * l[2]) / (n * l[3]);
        double nv = (nx * v[0] + ny * v[1] + nz * v[2]) / (n * v[3]);
        double lv = (l[0] * v[0] + l[1] * v[1] + l[2] * v[2]) / (l[3] * v[3]);
        var material = face.material();
        var light = face.light();
        double sent = light.ambient()[color] * material.ambient()[color];
        if (nl > 0) {
            sent += light.diffuse()[color] * material.diffuse()[color] * nl;
            double mirrored = Math.max(0, 2 * nl * nv - lv);
            sent += light.specular()[color] * material.specular()[color] * Math.pow(mirrored, material.shininess());
        }
        double sum = material.emission()[color] + face.globalAmbient()[color] * material.ambient()[color];
        return Math.min(1, sum + sent * light.attenuation().factor(l[3]));
    }

    /** The way from a vertex, and its length. */
    private double[] way(double[] corners, int vertex, double[] to) {
        double x = to[0] - corners[3 * vertex];
        double y = to[1] - corners[3 * vertex + 1];
        double z = to[2] - corners[3 * vertex + 2];
        return new double[] {x, y, z, Math.sqrt(x * x + y * y + z * z)};
    }
}
