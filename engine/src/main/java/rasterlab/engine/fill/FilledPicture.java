package rasterlab.engine.fill;

import java.util.HashSet;
import java.util.Set;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.Pixels;

/**
 * A picture that reports what is written in the new colour, and what is written in any other one
 * outside the region.
 */
final class FilledPicture implements PixelGrid {
    private final PixelGrid picture;
    private final FillTask task;
    private final Pixels onWrite;

    /** Pixels of the region by number, row by row; found when another colour is written. */
    private Set<Integer> region;

    FilledPicture(PixelGrid picture, FillTask task, Pixels onWrite) {
        this.picture = picture;
        this.task = task;
        this.onWrite = onWrite;
    }

    @Override
    public int width() {
        return picture.width();
    }

    @Override
    public int height() {
        return picture.height();
    }

    @Override
    public int read(int x, int y) {
        return picture.read(x, y);
    }

    @Override
    public void write(int x, int y, int with) {
        picture.write(x, y, with);
        if (with == task.with() || !region().contains(y * width() + x)) onWrite.plot(x, y);
    }

    private Set<Integer> region() {
        if (region == null) {
            region = new HashSet<>();
            new ExactSeedFill(task).fill((x, y) -> region.add(y * width() + x));
        }
        return region;
    }
}
