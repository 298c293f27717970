import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

public class StreamedEllipse implements EllipseRasterizer {
    private record Pixel(int u, int v) {}

    @Override
    public void draw(int x, int y, int a, int bb, Pixels out) { int b = a;
        Stream<Pixel> columns = IntStream.rangeClosed(0, a).mapToObj(u -> new Pixel(u, near(u, a, b)));
        Stream<Pixel> rows = IntStream.rangeClosed(0, b).mapToObj(v -> new Pixel(near(v, b, a), v));
        Stream.concat(rows, columns)
                .flatMap(p -> Stream.of(p, new Pixel(-p.u, p.v), new Pixel(p.u, -p.v), new Pixel(-p.u, -p.v)))
                .distinct()
                .forEach(p -> out.plot(x + p.u, y + p.v));
    }

    private static int near(double i, double along, double across) {
        double share = along == 0 ? 0 : i / along;
        return (int) Math.rint(across * Math.sqrt((1 - share) * (1 + share)));
    }
}
