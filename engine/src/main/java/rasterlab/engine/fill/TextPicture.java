package rasterlab.engine.fill;

import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.PixelGrid;
import rasterlab.engine.raster.Raster;

/** A picture of characters: a pixel's colour is its character's code point. */
public final class TextPicture implements PixelGrid {
    private final int[][] cells;

    /**
     * @param rows top row first, all of one length, 1×1 to 8192×8192 characters
     * @throws IllegalArgumentException naming the first row that is not
     */
    public TextPicture(List<String> rows) {
        cells = rows.stream().map(row -> row.codePoints().toArray()).toArray(int[][]::new);
        Raster.checkSize(cells.length == 0 ? 0 : cells[0].length, cells.length);
        for (int y = 0; y < cells.length; y++)
            if (cells[y].length != cells[0].length)
                throw new IllegalArgumentException(
                        "row %d must have %d characters as row 0 has, got %d"
                                .formatted(y, cells[0].length, cells[y].length));
    }

    @Override
    public int width() {
        return cells[0].length;
    }

    @Override
    public int height() {
        return cells.length;
    }

    @Override
    public int read(int x, int y) {
        return cells[y][x];
    }

    @Override
    public void write(int x, int y, int color) {
        cells[y][x] = color;
    }

    /** The picture as rows of characters, top row first. */
    public List<String> rows() {
        return IntStream.range(0, cells.length)
                .mapToObj(y -> new String(cells[y], 0, cells[y].length))
                .toList();
    }
}
