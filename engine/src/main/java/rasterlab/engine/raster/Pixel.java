package rasterlab.engine.raster;

/** The pixel of that column and row: x grows right, y grows down. */
public record Pixel(int x, int y) {
    /** The pixel for people: "(1, 2)". */
    @Override
    public String toString() {
        return "(" + x + ", " + y + ")";
    }
}
