package rasterlab.engine.circle;

/** A circle in whole pixels: an input of topic {@code circle}. */
public record Circle(int centreX, int centreY, int radius) {
    @Override
    public String toString() {
        return "radius " + radius + " about (" + centreX + ", " + centreY + ")";
    }
}
