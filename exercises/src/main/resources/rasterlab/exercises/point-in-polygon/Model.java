import rasterlab.contract.PointInPolygon;

/** Counts the edges that a ray to the right crosses, by the side of each on which the point is. */
public class Model implements PointInPolygon {
    @Override
    public boolean contains(double[] polygonX, double[] polygonY, double x, double y) {
        boolean inside = false;
        int last = polygonX.length - 1;
        for (int i = 0; i <= last; i++) {
            int j = i == 0 ? last : i - 1;
            double x0 = polygonX[j];
            double y0 = polygonY[j];
            double x1 = polygonX[i];
            double y1 = polygonY[i];
            double side = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
            if (side == 0 && between(x0, x1, x) && between(y0, y1, y)) return true;
            if ((y0 > y) != (y1 > y) && side > 0 == y1 > y0) inside = !inside;
        }
        return inside;
    }

    private static boolean between(double a, double b, double value) {
        return Math.min(a, b) <= value && value <= Math.max(a, b);
    }
}
