import java.util.LinkedHashSet;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

public class RootCircle implements CircleRasterizer {
    record Pixel(int x, int y) {
        Stream<Pixel> mirrored() {
            return Stream.of(this, new Pixel(y, x))
                    .flatMap(p -> Stream.of(p, new Pixel(-p.x, p.y)))
                    .flatMap(p -> Stream.of(p, new Pixel(p.x, -p.y)));
        }
    }

    @Override
    public void draw(int cx, int cy, int r, Pixels out) {
        Set<Pixel> pixels = new LinkedHashSet<>();
        IntStream.iterate(0, u -> u <= row(r, u), u -> u + 1)
                .mapToObj(u -> new Pixel(u, row(r, u)))
                .flatMap(Pixel::mirrored)
                .forEach(pixels::add);
        for (Pixel p : pixels) out.plot(cx + p.x(), cy + p.y());
    }

    private static int row(int r, int u) {
        return (int) Math.round(Math.sqrt((double) r * r - (double) u * u));
    }
}
