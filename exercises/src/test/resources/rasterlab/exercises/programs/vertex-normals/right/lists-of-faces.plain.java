import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.VertexNormals;

public class Lists implements VertexNormals {
    record Face(double[] unit, double area) {}

    @Override
    public double[] normals(double[] p, int[] triangles) {
        List<List<Face>> around = new ArrayList<>();
        for (int v = 0; v < p.length / 3; v++) around.add(new ArrayList<>());
        for (int t = 0; t < triangles.length; t += 3) {
            Face face = face(p, triangles[t], triangles[t + 1], triangles[t + 2]);
            if (face.area > 0)
                for (int c = 0; c < 3; c++) around.get(triangles[t + c]).add(face);
        }
        double[] result = new double[p.length];
        for (int v = 0; v < around.size(); v++) {
            double[] sum = new double[3];
            double weight = 0;
            for (Face face : around.get(v)) {
                for (int i = 0; i < 3; i++) sum[i] += face.area * face.unit[i];
                weight += face.area;
            }
            double length = length(sum);
            if (length > 1e-9 * weight)
                for (int i = 0; i < 3; i++) result[3 * v + i] = sum[i] / length;
        }
        return result;
    }

    private static Face face(double[] p, int a, int b, int c) {
        double[] u = {p[3 * b] - p[3 * a], p[3 * b + 1] - p[3 * a + 1], p[3 * b + 2] - p[3 * a + 2]};
        double[] v = {p[3 * c] - p[3 * a], p[3 * c + 1] - p[3 * a + 1], p[3 * c + 2] - p[3 * a + 2]};
        double[] n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        double length = length(n);
        for (int i = 0; i < 3; i++) n[i] /= length;
        return new Face(n, length / 2);
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
