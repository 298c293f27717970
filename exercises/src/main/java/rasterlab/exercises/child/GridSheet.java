package rasterlab.exercises.child;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import rasterlab.contract.PixelGrid;

/** A picture that a student's method reads and writes; keeps every writing in order. */
final class GridSheet extends SinkSheet implements PixelGrid {
    private final int width;
    private final int height;
    private final int[] colors;
    private final WholeSheets.OfThree written;

    private GridSheet(int width, int height, int[] colors, int limit) {
        this.width = width;
        this.height = height;
        this.colors = colors;
        this.written = new WholeSheets.OfThree(limit, width * height);
    }

    /** Writes a picture as {@link #read} takes it. */
    static void write(PixelGrid picture, DataOutputStream out) throws IOException {
        out.writeInt(picture.width());
        out.writeInt(picture.width() * picture.height());
        for (int y = 0; y < picture.height(); y++)
            for (int x = 0; x < picture.width(); x++) out.writeInt(picture.read(x, y));
    }

    /**
     * @param limit the most writings
     */
    static GridSheet read(DataInputStream in, int limit) throws IOException {
        int width = in.readInt();
        int[] colors = new int[Values.length(in, Integer.BYTES)];
        for (int i = 0; i < colors.length; i++) colors[i] = in.readInt();
        return new GridSheet(width, width == 0 ? 0 : colors.length / width, colors, limit);
    }

    @Override
    public int width() {
        return width;
    }

    @Override
    public int height() {
        return height;
    }

    @Override
    public int read(int x, int y) {
        return colors[place(x, y)];
    }

    @Override
    public void write(int x, int y, int color) {
        int place = place(x, y);
        written.plot(x, y, color);
        colors[place] = color;
    }

    private int place(int x, int y) {
        if (x < 0 || x >= width || y < 0 || y >= height)
            throw new IndexOutOfBoundsException(
                    "pixel (%d, %d) of a picture of %d × %d".formatted(x, y, width, height));
        return y * width + x;
    }

    @Override
    boolean full() {
        return written.full();
    }

    @Override
    void writeTo(DataOutputStream out) throws IOException {
        written.writeTo(out);
    }

    @Override
    void addTo(ItemSum sum) {
        written.addTo(sum);
    }
}
