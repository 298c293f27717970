import rasterlab.contract.VisibleFaces;

public class Faces implements VisibleFaces {
    @Override
    public boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside) {
        boolean[] visible = new boolean[faces.length];
        for (int f = 0; f < faces.length; f++) {
            visible[f] = det(xyz, faces[f][0], faces[f][1], faces[f][2], eye) > 0;
        }
        return visible;
    }

    private static double det(double[] xyz, int o, int p, int q, double[] eye) {
        double ax = xyz[3 * p] - xyz[3 * o];
        double ay = xyz[3 * p + 1] - xyz[3 * o + 1];
        double az = xyz[3 * p + 2] - xyz[3 * o + 2];
        double bx = xyz[3 * q] - xyz[3 * o];
        double by = xyz[3 * q + 1] - xyz[3 * o + 1];
        double bz = xyz[3 * q + 2] - xyz[3 * o + 2];
        return (ay * bz - az * by) * (eye[0] - xyz[3 * o])
                + (az * bx - ax * bz) * (eye[1] - xyz[3 * o + 1])
                + (ax * by - ay * bx) * (eye[2] - xyz[3 * o + 2]);
    }
}
