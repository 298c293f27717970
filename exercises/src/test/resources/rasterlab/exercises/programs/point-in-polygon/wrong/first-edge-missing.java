import rasterlab.contract.PointInPolygon;

public class Recursive implements PointInPolygon {
    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        return parity(px, py, 1, x, y) != 0;
    }

        private static int parity(double[] px, double[] py, int i, double x, double y) {
        if (i == px.length) return 0;
        int j = i + 1 == px.length ? 0 : i + 1;
        double turn = (px[j] - px[i]) * (y - py[i]) - (py[j] - py[i]) * (x - px[i]);
        if (turn == 0 && between(px[i], x, px[j]) && between(py[i], y, py[j])) return 2;
        int rest = parity(px, py, i + 1, x, y);
        boolean up = py[i] <= y && y < py[j] && turn > 0;
        boolean down = py[j] <= y && y < py[i] && turn < 0;
        return rest == 2 || !up && !down ? rest : 1 - rest;
    }

    private static boolean between(double a, double b, double c) {
        return a <= b && b <= c || c <= b && b <= a;
    }
}
