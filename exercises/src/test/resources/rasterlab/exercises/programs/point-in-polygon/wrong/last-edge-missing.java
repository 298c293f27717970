import rasterlab.contract.PointInPolygon;

public class MyPolygon implements PointInPolygon {
    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        int crossings = 0;
        for (int i = 0; i < px.length - 1; i++) {
            if (onEdge(px[i], py[i], px[i + 1], py[i + 1], x, y)) return true;
            if (py[i] > y == py[i + 1] > y) continue;
            if (x < px[i] + (y - py[i]) * (px[i + 1] - px[i]) / (py[i + 1] - py[i])) crossings++;
        }
        return crossings % 2 == 1;
    }

    private static boolean onEdge(double x0, double y0, double x1, double y1, double x, double y) {
        if ((x1 - x0) * (y - y0) != (y1 - y0) * (x - x0)) return false;
        return (x - x0) * (x - x1) <= 0 && (y - y0) * (y - y1) <= 0;
    }
}
