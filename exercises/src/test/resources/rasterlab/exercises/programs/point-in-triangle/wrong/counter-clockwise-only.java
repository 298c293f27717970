import rasterlab.contract.PointInTriangle;

public class Triangle implements PointInTriangle {
    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        double[] u = {ax, bx, cx};
        double[] v = {ay, by, cy};
        for (int i = 0; i < 3; i++) {
            int k = (i + 1) % 3;
            if ((u[k] - u[i]) * (y - v[i]) < (v[k] - v[i]) * (x - u[i])) return false;
        }
        return true;
    }
}
