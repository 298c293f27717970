package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;

/**
 * The textbook's recursive fill run by run, with its faults.
 *
 * <p>From a run the fill goes on into the next row in its direction wherever a pixel there has the
 * old colour, and back into the row it came from beyond the ends of the run it came from. The loop
 * back beyond the right end begins at that end and stops one column early (PredXR to XR − 1), so a
 * region that goes on only behind the last column, such as a corridor one pixel wide behind the
 * seed, is left out. Each run is a call, so a long region overflows the call stack. Where the new
 * colour is the old one, a written pixel looks unwritten, and around a hole the calls never end. It
 * knows no diagonal steps.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. 75.
 */
public final class RecursiveTextbookFill implements TracedFill {
    @Override
    public void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
        trace(picture, x, y, with, connectivity, (row, from, to, waiting) -> {});
    }

    @Override
    public void trace(
            PixelGrid picture, int x, int y, int with, int connectivity, FillObserver observer) {
        FillCheck.check(picture, x, y, connectivity);
        new Filling(picture, picture.read(x, y), with, observer).fillFrom(x, y, -1, x, x);
    }

    @Override
    public String waitingMeans() {
        return "how many calls wait for this one to end";
    }

    private static final class Filling {
        private final PixelGrid picture;
        private final int old;
        private final int with;
        private final FillObserver observer;
        private int depth;

        Filling(PixelGrid picture, int old, int with, FillObserver observer) {
            this.picture = picture;
            this.old = old;
            this.with = with;
            this.observer = observer;
        }

        /**
         * @param direction the row to go on to is y + direction
         * @param lastLeft first column of the run in the row this one was entered from
         * @param lastRight last column of that run
         * @return the last column of the run around (x, y)
         */
        int fillFrom(int x, int y, int direction, int lastLeft, int lastRight) {
            int left = x;
            while (isOld(left - 1, y)) left--;
            int right = x;
            while (isOld(right + 1, y)) right++;
            for (int i = left; i <= right; i++) picture.write(i, y, with);
            observer.onRun(y, left, right + 1, depth++);
            for (int i = left; i <= right; i++)
                if (isOld(i, y + direction)) i = fillFrom(i, y + direction, direction, left, right);
            for (int i = left; i < lastLeft; i++)
                if (isOld(i, y - direction))
                    i = fillFrom(i, y - direction, -direction, left, right);
            for (int i = lastRight; i < right; i++)
                if (isOld(i, y - direction))
                    i = fillFrom(i, y - direction, -direction, left, right);
            depth--;
            return right;
        }

        private boolean isOld(int x, int y) {
            boolean outside = x < 0 || x >= picture.width() || y < 0 || y >= picture.height();
            return !outside && picture.read(x, y) == old;
        }
    }
}
