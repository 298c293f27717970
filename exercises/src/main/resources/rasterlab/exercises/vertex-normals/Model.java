import rasterlab.contract.VertexNormals;

/** Adds up the cross products of the faces at each vertex, which weights them by area. */
public class Model implements VertexNormals {
    @Override
    public double[] normals(double[] vertices, int[] triangles) {
        double[] crosses = new double[triangles.length];
        double largest = 0;
        for (int t = 0; t < triangles.length; t += 3) {
            double[] a = way(vertices, triangles[t], triangles[t + 1]);
            double[] b = way(vertices, triangles[t], triangles[t + 2]);
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                int k = (i + 2) % 3;
                crosses[t + i] = a[j] * b[k] - a[k] * b[j];
                largest = Math.max(largest, Math.abs(crosses[t + i]));
            }
        }
        double[] normals = new double[vertices.length];
        if (largest == 0) return normals;
        double[] weights = new double[vertices.length / 3];
        for (int t = 0; t < triangles.length; t += 3) {
            // the largest number is 1 now, so that no square is lost
            double x = crosses[t] / largest;
            double y = crosses[t + 1] / largest;
            double z = crosses[t + 2] / largest;
            double length = Math.sqrt(x * x + y * y + z * z);
            for (int c = t; c < t + 3; c++) {
                int v = triangles[c];
                normals[3 * v] += x;
                normals[3 * v + 1] += y;
                normals[3 * v + 2] += z;
                weights[v] += length;
            }
        }
        for (int v = 0; v < weights.length; v++) finish(normals, 3 * v, weights[v]);
        return normals;
    }

    private static double[] way(double[] vertices, int from, int to) {
        double[] way = new double[3];
        for (int i = 0; i < 3; i++) way[i] = vertices[3 * to + i] - vertices[3 * from + i];
        return way;
    }

    private static void finish(double[] normals, int at, double weight) {
        double x = normals[at];
        double y = normals[at + 1];
        double z = normals[at + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        boolean none = length <= 1e-9 * weight;
        for (int i = at; i < at + 3; i++) normals[i] = none ? 0 : normals[i] / length;
    }
}
