import java.util.stream.IntStream;
import rasterlab.contract.PointInPolygon;

public class HalfOpen implements PointInPolygon {
    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        int n = px.length;
        return IntStream.range(0, n)
                                .filter(i -> Math.min(py[i], py[(i + 1) % n]) <= y && y < Math.max(py[i], py[(i + 1) % n]))
                                .mapToDouble(i -> px[i] + (y - py[i]) * (px[(i + 1) % n] - px[i]) / (py[(i + 1) % n] - py[i]))
                                .filter(at -> at > x)
                                .count()
                        % 2
                == 1;
    }
}
