package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;

/**
 * A fill run by run, with its own stack instead of recursion; it goes around holes.
 *
 * <p>On the stack wait pieces of rows that touch a filled run of the row above or below and may
 * hold pixels of the old colour. A step goes along the last piece to the next such pixel, widens it
 * to the whole run between its ends, fills the run, and puts the pieces above and below it on the
 * stack: as wide as the run, and one pixel wider on both sides where diagonals connect. Every run
 * of the region touches another one, so all are found; each pixel is written once and read a few
 * times, and at most three pieces are put on the stack for each run.
 *
 * <p>Source: after A. R. Smith, Tint fill, SIGGRAPH 1979, pp. 276–283.
 */
public final class SpanFill implements SteppedFill {
    @Override
    public FillWalk walk(PixelGrid picture, int x, int y, int with, int connectivity) {
        FillCheck.check(picture, x, y, connectivity);
        return new Walk(picture, x, y, with, connectivity == 8 ? 1 : 0);
    }

    private static final class Walk implements FillWalk {
        private final PixelGrid picture;
        private final int old;
        private final int with;
        private final int wider;
        private final IntStack pieces = new IntStack();
        private int y;
        private int from;
        private int to;

        Walk(PixelGrid picture, int x, int y, int with, int wider) {
            this.picture = picture;
            this.with = with;
            this.wider = wider;
            old = picture.read(x, y);
            if (old != with) push(y, x, x + 1);
        }

        @Override
        public boolean advance() {
            while (pieces.size() > 0) {
                int end = pieces.pop();
                from = pieces.pop();
                y = pieces.pop();
                while (from < end && !isOld(from)) from++;
                if (from == end) continue;
                fillRun();
                if (to < end) push(y, to, end);
                pushBeside(y - 1);
                pushBeside(y + 1);
                return true;
            }
            return false;
        }

        /** Fills the run around column {@code from}. */
        private void fillRun() {
            to = from;
            while (to < picture.width() && isOld(to)) picture.write(to++, y, with);
            while (from > 0 && isOld(from - 1)) picture.write(--from, y, with);
        }

        private void pushBeside(int row) {
            if (row < 0 || row >= picture.height()) return;
            push(row, Math.max(0, from - wider), Math.min(picture.width(), to + wider));
        }

        private boolean isOld(int x) {
            return picture.read(x, y) == old;
        }

        private void push(int y, int from, int to) {
            pieces.push(y);
            pieces.push(from);
            pieces.push(to);
        }

        @Override
        public int y() {
            return y;
        }

        @Override
        public int from() {
            return from;
        }

        @Override
        public int to() {
            return to;
        }

        @Override
        public int waiting() {
            return pieces.size() / 3;
        }
    }
}
