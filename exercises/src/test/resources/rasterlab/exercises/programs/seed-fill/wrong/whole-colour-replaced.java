import java.util.BitSet;
import java.util.stream.IntStream;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

public class Waves implements SeedFiller {
    @Override
    public void fill(PixelGrid g, int x, int y, int with, int connectivity) {
        int old = g.read(x, y);
        if (old == with) return;
        int w = g.width();
        BitSet region = new BitSet(w * g.height());
        region.set(y * w + x);
        int[] wave = {y * w + x};
        while (wave.length > 0)
            wave =
                    IntStream.of(wave)
                            .flatMap(p -> around(p % w, p / w, w, g.height(), connectivity))
                            .filter(p -> !region.get(p) && g.read(p % w, p / w) == old)
                            .peek(region::set)
                            .toArray();
        for (int p = 0; p < w * g.height(); p++) if (g.read(p % w, p / w) == old) g.write(p % w, p / w, with);
    }

    private static IntStream around(int x, int y, int w, int h, int connectivity) {
        return IntStream.range(0, 9)
                .filter(k -> connectivity == 8 || k % 2 == 1)
                .filter(k -> x + k % 3 - 1 >= 0 && x + k % 3 - 1 < w)
                .filter(k -> y + k / 3 - 1 >= 0 && y + k / 3 - 1 < h)
                .map(k -> (y + k / 3 - 1) * w + x + k % 3 - 1);
    }
}
