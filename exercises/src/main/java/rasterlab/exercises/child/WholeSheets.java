package rasterlab.exercises.child;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Arrays;
import rasterlab.contract.CoveragePixels;
import rasterlab.contract.Pixels;
import rasterlab.contract.Spans;

/** Keeps items of a few whole numbers each. */
abstract class WholeSheets extends SinkSheet {
    private final int width;
    private final int most;
    private int[] cells;
    private int size;

    /**
     * @param width numbers of an item
     * @param limit the most items
     * @param room for so many items from the start, so that making more takes no time later
     */
    private WholeSheets(int width, int limit, int room) {
        this.width = width;
        most = Math.multiplyExact(width, limit);
        cells = new int[width * Math.min(limit, room)];
    }

    /** The place of the next item. */
    final int next() {
        int i = size;
        if (i == cells.length) makeRoom();
        size = i + width;
        return i;
    }

    /** Makes room apart from the drawing, which a student's method repeats for each pixel. */
    private void makeRoom() {
        if (size == most) stop();
        cells = Arrays.copyOf(cells, (int) Math.min(most, Math.max(width, 2L * size)));
    }

    @Override
    void writeTo(DataOutputStream out) throws IOException {
        out.writeInt(size / width);
        for (int i = 0; i < size; i++) out.writeInt(cells[i]);
    }

    @Override
    void addTo(ItemSum sum) {
        for (int i = 0; i < size; i += width) add(cells, i, sum);
    }

    abstract void add(int[] cells, int i, ItemSum sum);

    static final class OfPixels extends WholeSheets implements Pixels {
        OfPixels(int limit, int room) {
            super(2, limit, room);
        }

        @Override
        public void plot(int x, int y) {
            int i = next();
            int[] cells = super.cells;
            cells[i] = x;
            cells[i + 1] = y;
        }

        @Override
        void add(int[] cells, int i, ItemSum sum) {
            sum.plot(cells[i], cells[i + 1]);
        }
    }

    /** Keeps x, y and the coverage, or y, from and to. */
    static final class OfThree extends WholeSheets implements CoveragePixels, Spans {
        OfThree(int limit, int room) {
            super(3, limit, room);
        }

        @Override
        public void plot(int x, int y, int coverage) {
            keep(x, y, coverage);
        }

        @Override
        public void span(int y, int from, int to) {
            keep(y, from, to);
        }

        private void keep(int first, int second, int third) {
            int i = next();
            int[] cells = super.cells;
            cells[i] = first;
            cells[i + 1] = second;
            cells[i + 2] = third;
        }

        @Override
        void add(int[] cells, int i, ItemSum sum) {
            sum.add(cells[i], cells[i + 1], cells[i + 2]);
        }
    }
}
