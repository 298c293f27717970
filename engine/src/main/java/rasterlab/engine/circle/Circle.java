package rasterlab.engine.circle;

/** A circle in whole pixels: an input of topic {@code circle}. */
public record Circle(int centerX, int centerY, int radius) {
    @Override
    public String toString() {
        return "radius " + radius + " about (" + centerX + ", " + centerY + ")";
    }
}
