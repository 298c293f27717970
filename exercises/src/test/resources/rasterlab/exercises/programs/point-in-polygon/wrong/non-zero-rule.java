import rasterlab.contract.PointInPolygon;

public class WindingNumber implements PointInPolygon {
    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        int winding = 0;
        for (int i = 0; i < px.length; i++) {
            int j = (i + 1) % px.length;
            double side = (px[j] - px[i]) * (y - py[i]) - (py[j] - py[i]) * (x - px[i]);
            boolean beside = Math.min(px[i], px[j]) <= x && x <= Math.max(px[i], px[j]);
            boolean level = Math.min(py[i], py[j]) <= y && y <= Math.max(py[i], py[j]);
            if (side == 0 && beside && level) return true;
            if (py[i] <= y && py[j] > y && side > 0) winding++;
            if (py[i] > y && py[j] <= y && side < 0) winding--;
        }
        return winding != 0;
    }
}
