import rasterlab.contract.EyeView;

/** Distances along the eye's axes, which cross products find. */
public class LookAt implements EyeView {
    record Vector(double x, double y, double z) {
        Vector times(double k) {
            return new Vector(k * x, k * y, k * z);
        }

        Vector minus(Vector v) {
            return new Vector(x - v.x, y - v.y, z - v.z);
        }

        double dot(Vector v) {
            return x * v.x + y * v.y + z * v.z;
        }

        Vector cross(Vector v) {
            return new Vector(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x);
        }

        Vector unit() {
            return times(1 / Math.sqrt(dot(this)));
        }
    }

    @Override
    public void view(double theta, double phi, double rho, double[] points) {
        double t = Math.toRadians(theta);
        double p = Math.toRadians(phi);
        Vector out = new Vector(Math.sin(p) * Math.cos(t), Math.sin(p) * Math.sin(t), Math.cos(p));
        Vector eye = out.times(rho);
        Vector right = new Vector(0, 0, 1).cross(out).unit();
        Vector up = out.cross(right);
        for (int i = 0; i < points.length; i += 3) {
            Vector seen = new Vector(points[i], points[i + 1], points[i + 2]).minus(eye);
            points[i] = seen.dot(right);
            points[i + 1] = seen.dot(up);
            points[i + 2] = -seen.dot(out);
        }
    }
}
