import rasterlab.contract.*;

public class MyMethod implements SeedFiller {

    public void fill(PixelGrid p, int x, int y, int with, int c) {
        int old = p.read(x, y);
        if (old == with) return;
        int i = x;
        while (i >= 0 && p.read(i, y) == old) i--;
        for (i++; i < p.width() && p.read(i, y) == old; i++) p.write(i, y, with);
    }
}
