import rasterlab.contract.PointInPolygon;

public class Inside implements PointInPolygon {
    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        boolean inside = false;
        for (int i = 0, j = px.length - 1; i < px.length; j = i++) {
            double cross = (px[i] - px[j]) * (y - py[j]) - (py[i] - py[j]) * (x - px[j]);
            if (cross == 0 && (x - px[i]) * (x - px[j]) <= 0) return true;
            boolean up = py[i] > y;
            if (up != py[j] > y && cross > 0 == up) inside = !inside;
        }
        return inside;
    }
}
