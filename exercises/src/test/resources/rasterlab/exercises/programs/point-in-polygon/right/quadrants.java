import rasterlab.contract.*;

public class MyMethod implements PointInPolygon {

    public boolean contains(double[] px, double[] py, double x, double y) {
        int n = px.length, c = 0;
        for (int i = 0; i < n; i++) {
            int j = (i + 1) % n;
            double ax = px[i] - x, ay = py[i] - y, bx = px[j] - x, by = py[j] - y;
            double cr = ax * by - ay * bx;
            if (cr == 0 && ax * bx <= 0 && ay * by <= 0) return true;
            if (ay <= 0 && by > 0 && cr > 0) c++;
            else if (by <= 0 && ay > 0 && cr < 0) c++;
        }
        return (c & 1) == 1;
    }
}
