package rasterlab.exercises.child;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Arrays;
import rasterlab.contract.CurvePoints;
import rasterlab.contract.SegmentSink;
import rasterlab.contract.SpaceSegmentSink;

/** Keeps points of the plane, or segments of plane or space, by their coordinates. */
final class RealSheet extends SinkSheet implements CurvePoints, SegmentSink, SpaceSegmentSink {
    private final int width;
    private final int most;
    private double[] cells;
    private int size;

    /**
     * @param width numbers of an item: 2, 4 or 6
     * @param limit the most items
     * @param room for so many items from the start
     */
    RealSheet(int width, int limit, int room) {
        this.width = width;
        most = Math.multiplyExact(width, limit);
        cells = new double[width * Math.min(limit, room)];
    }

    @Override
    public void point(double x, double y) {
        int i = next(2);
        cells[i] = x;
        cells[i + 1] = y;
    }

    @Override
    public void segment(double x0, double y0, double x1, double y1) {
        int i = next(4);
        cells[i] = x0;
        cells[i + 1] = y0;
        cells[i + 2] = x1;
        cells[i + 3] = y1;
    }

    @Override
    public void segment(double x0, double y0, double z0, double x1, double y1, double z1) {
        int i = next(6);
        cells[i] = x0;
        cells[i + 1] = y0;
        cells[i + 2] = z0;
        cells[i + 3] = x1;
        cells[i + 4] = y1;
        cells[i + 5] = z1;
    }

    /** The place of the next item, which is of the one kind that this sheet is for. */
    private int next(int numbers) {
        if (numbers != width) throw new ClassCastException("another kind of items is asked for");
        int i = size;
        if (i == cells.length) makeRoom();
        size = i + width;
        return i;
    }

    private void makeRoom() {
        if (size == most) stop();
        cells = Arrays.copyOf(cells, (int) Math.min(most, Math.max(width, 2L * size)));
    }

    @Override
    void writeTo(DataOutputStream out) throws IOException {
        out.writeInt(size / width);
        for (int i = 0; i < size; i++) out.writeDouble(cells[i]);
    }

    @Override
    void addTo(ItemSum sum) {
        for (int i = 0; i < size; i += width) {
            long[] bits = new long[width];
            for (int k = 0; k < width; k++) bits[k] = Double.doubleToLongBits(cells[i + k]);
            sum.add(bits);
        }
    }
}
