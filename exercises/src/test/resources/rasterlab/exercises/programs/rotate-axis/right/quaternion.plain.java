import rasterlab.contract.AxisRotation;

public class Quaternions implements AxisRotation {
    record Quaternion(double w, double x, double y, double z) {
        Quaternion times(Quaternion q) {
            return new Quaternion(
                    w * q.w - x * q.x - y * q.y - z * q.z,
                    w * q.x + x * q.w + y * q.z - z * q.y,
                    w * q.y - x * q.z + y * q.w + z * q.x,
                    w * q.z + x * q.y - y * q.x + z * q.w);
        }

        Quaternion conjugate() {
            return new Quaternion(w, -x, -y, -z);
        }
    }

    @Override
    public void rotate(double[] through, double[] direction, double degrees, double[] points) {
        double half = Math.toRadians(degrees) / 2;
        double length = 0;
        for (double each : direction) length += each * each;
        double s = Math.sin(half) / Math.sqrt(length);
        var turn = new Quaternion(Math.cos(half), s * direction[0], s * direction[1], s * direction[2]);
        for (int i = 0; i < points.length; i += 3) {
            var v = new Quaternion(0, points[i] - through[0], points[i + 1] - through[1], points[i + 2] - through[2]);
            Quaternion image = turn.times(v).times(turn.conjugate());
            points[i] = through[0] + image.x();
            points[i + 1] = through[1] + image.y();
            points[i + 2] = through[2] + image.z();
        }
    }
}
