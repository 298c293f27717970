import rasterlab.contract.PointInPolygon;

public class RayCast implements PointInPolygon {
    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        boolean inside = false;
        for (int i = 0, j = px.length - 1; i < px.length; j = i++)
            if (py[i] > y != py[j] > y && x < (px[j] - px[i]) * (y - py[i]) / (py[j] - py[i]) + px[i])
                inside = !inside;
        return inside;
    }
}
