package rasterlab.engine.transform.rotate;

import rasterlab.contract.PlaneRotation;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Coordinates;

/** The direct formula in float: sine and cosine are off by up to 2⁻²⁴, n turns add that up. */
final class FloatRotation implements PlaneRotation {
    @Override
    public void rotate(double degrees, int times, double[] points) {
        CountedRotation.require(degrees, times, points, Coordinates.LARGEST_FLOAT);
        Coordinates.requireFloat(points, 2);
        Angle by = Angle.ofDegrees(degrees);
        float sin = (float) by.sin();
        float cos = (float) by.cos();
        for (int at = 0; at < points.length; at += 2) {
            float x = (float) points[at];
            float y = (float) points[at + 1];
            for (int i = 0; i < times; i++) {
                float turned = x * cos - y * sin;
                y = x * sin + y * cos;
                x = turned;
            }
            points[at] = x;
            points[at + 1] = y;
        }
    }
}
