import java.util.stream.LongStream;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class Slope implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        double dx = (double) x1 - x0;
        double dy = (double) y1 - y0;
        double n = Math.max(1, Math.max(Math.abs(dx), Math.abs(dy)));
        LongStream.rangeClosed(0, (long) Math.max(Math.abs(dx), Math.abs(dy)))
                .forEach(k -> out.plot(round(x0 + k * dx / n), round(y0 + k * dy / n)));
    }

    private static int round(double coordinate) {
        return (int) Math.ceil(coordinate - 0.5);
    }
}
