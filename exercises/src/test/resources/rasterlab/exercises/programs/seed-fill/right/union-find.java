import rasterlab.contract.*;

public class MyMethod implements SeedFiller {

    int[] up;

    int root(int i) {
        while (up[i] != i) i = up[i] = up[up[i]];
        return i;
    }

    public void fill(PixelGrid p, int x, int y, int with, int c) {
        int w = p.width(), h = p.height();
        up = new int[w * h];
        int[] col = new int[w * h];
        for (int j = 0; j < h; j++)
            for (int i = 0; i < w; i++) {
                col[j * w + i] = p.read(i, j);
                up[j * w + i] = j * w + i;
            }
        int[][] d =
                c == 4
                        ? new int[][] {{-1, 0}, {0, -1}}
                        : new int[][] {{-1, 0}, {0, -1}, {-1, -1}, {1, -1}};
        for (int j = 0; j < h; j++)
            for (int i = 0; i < w; i++)
                for (int[] e : d) {
                    int a = i + e[0], b = j + e[1];
                    if (a < 0 || a >= w || b < 0) continue;
                    if (col[b * w + a] == col[j * w + i]) up[root(b * w + a)] = root(j * w + i);
                }
        if (col[y * w + x] == with) return;
        int r = root(y * w + x);
        for (int j = h - 1; j >= 0; j--)
            for (int i = 0; i < w; i++) if (root(j * w + i) == r) p.write(i, j, with);
    }
}
