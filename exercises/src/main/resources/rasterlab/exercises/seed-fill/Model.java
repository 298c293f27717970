import java.util.Arrays;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

/** Writes a pixel when it is found and keeps it until its neighbours were looked at. */
public class Model implements SeedFiller {
    private int[] waiting;
    private int count;

    @Override
    public void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        waiting = new int[64];
        count = 0;
        find(picture, x, y, with);
        while (count > 0) {
            int pixel = waiting[--count];
            int column = pixel % picture.width();
            int row = pixel / picture.width();
            for (int dy = -1; dy <= 1; dy++)
                for (int dx = -1; dx <= 1; dx++) {
                    if (connectivity == 4 && dx != 0 && dy != 0) continue;
                    int nextX = column + dx;
                    int nextY = row + dy;
                    boolean there =
                            nextX >= 0
                                    && nextX < picture.width()
                                    && nextY >= 0
                                    && nextY < picture.height();
                    if (there && picture.read(nextX, nextY) == old)
                        find(picture, nextX, nextY, with);
                }
        }
    }

    private void find(PixelGrid picture, int x, int y, int with) {
        picture.write(x, y, with);
        if (count == waiting.length) waiting = Arrays.copyOf(waiting, 2 * count);
        waiting[count++] = y * picture.width() + x;
    }
}
