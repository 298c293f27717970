import rasterlab.contract.PointInPolygon;

public class Inside implements PointInPolygon {
    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        boolean inside = false;
        for (int i = 0, j = px.length - 1; i < px.length; j = i++) {
            double cross = (px[i] - px[j]) * (y - py[j]) - (py[i] - py[j]) * (x - px[j]);
            double between = (x - px[i]) * (x - px[j]) + (y - py[i]) * (y - py[j]);
            if (cross == 0 && between < 0) return true;
            if (py[i] > y != py[j] > y && x < (px[j] - px[i]) * (y - py[i]) / (py[j] - py[i]) + px[i])
                inside = !inside;
        }
        return inside;
    }
}
