package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;

/**
 * A fill pixel by pixel, with its own stack instead of recursion.
 *
 * <p>A pixel is written when it is put on the stack, so none is put there twice; when it is taken
 * off, its neighbours of the old colour follow. Up to 4 (or 8) reads for each pixel, and in the
 * worst case most of the region waits on the stack.
 *
 * <p>Source: A. R. Smith, Tint fill, SIGGRAPH 1979, pp. 276–283.
 */
public final class StackFill implements SteppedFill {
    @Override
    public FillWalk walk(PixelGrid picture, int x, int y, int with, int connectivity) {
        FillCheck.check(picture, x, y, connectivity);
        return new Walk(picture, x, y, with, connectivity == 8);
    }

    private static final class Walk implements FillWalk {
        private final PixelGrid picture;
        private final int old;
        private final int with;
        private final boolean diagonal;
        private final IntStack stack = new IntStack();
        private int x;
        private int y;

        Walk(PixelGrid picture, int x, int y, int with, boolean diagonal) {
            this.picture = picture;
            this.with = with;
            this.diagonal = diagonal;
            old = picture.read(x, y);
            if (old != with) take(x, y);
        }

        @Override
        public boolean advance() {
            if (stack.size() == 0) return false;
            y = stack.pop();
            x = stack.pop();
            for (int dy = -1; dy <= 1; dy++)
                for (int dx = -1; dx <= 1; dx++)
                    if (dx == 0 ^ dy == 0 || diagonal && dx != 0) visit(x + dx, y + dy);
            return true;
        }

        private void visit(int x, int y) {
            if (x < 0 || x >= picture.width() || y < 0 || y >= picture.height()) return;
            if (picture.read(x, y) == old) take(x, y);
        }

        private void take(int x, int y) {
            picture.write(x, y, with);
            stack.push(x);
            stack.push(y);
        }

        @Override
        public int y() {
            return y;
        }

        @Override
        public int from() {
            return x;
        }

        @Override
        public int to() {
            return x + 1;
        }

        @Override
        public int waiting() {
            return stack.size() / 2;
        }
    }
}
