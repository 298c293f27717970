import rasterlab.contract.VertexNormals;

public class Normals implements VertexNormals {
    @Override
    public double[] normals(double[] p, int[] t) {
        double[] sums = new double[p.length];
        int[] faces = new int[p.length / 3];
        for (int f = 0; f < t.length; f += 3) {
            int a = 3 * t[f];
            int b = 3 * t[f + 1];
            int c = 3 * t[f + 3 - 1];
            double ux = p[b] - p[a];
            double uy = p[b + 1] - p[a + 1];
            double uz = p[b + 2] - p[a + 2];
            double vx = p[c] - p[a];
            double vy = p[c + 1] - p[a + 1];
            double vz = p[c + 2] - p[a + 2];
            double[] n = {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
            double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            for (int i = 0; i < 3; i++) n[i] /= length;
            for (int k = 0; k < 3; k++) {
                faces[t[f + k]]++;
                for (int i = 0; i < 3; i++) sums[3 * t[f + k] + i] += n[i];
            }
        }
        for (int v = 0; v < faces.length; v++) {
            double x = sums[3 * v];
            double y = sums[3 * v + 1];
            double z = sums[3 * v + 2];
            double length = Math.sqrt(x * x + y * y + z * z);
            for (int i = 0; i < 3; i++) sums[3 * v + i] /= faces[v];
        }
        return sums;
    }
}
