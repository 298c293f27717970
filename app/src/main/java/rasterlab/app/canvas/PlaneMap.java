package rasterlab.app.canvas;

import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;

/**
 * Where a plane of real coordinates lies in the stage: {@code view = origin + scale · world}.
 *
 * @param originX view x of world x 0
 * @param originY view y of world y 0
 * @param scaleX view units per world unit, above 0
 * @param scaleY view units per world unit; below 0 where the world's y grows upward
 */
public record PlaneMap(double originX, double originY, double scaleX, double scaleY) {
    private static final double SMALLEST = 1e-250;
    private static final double LARGEST = 1e250;

    /** Share of the view that a fitted box leaves free on each side. */
    private static final double FREE = 0.11;

    public PlaneMap {
        requireScale("scaleX", scaleX);
        requireScale("scaleY", Math.abs(scaleY));
    }

    private static void requireScale(String name, double scale) {
        if (!(scale >= SMALLEST && scale <= LARGEST))
            throw new IllegalArgumentException(
                    name + " must be from " + SMALLEST + " to " + LARGEST + ", got " + scale);
    }

    /**
     * The map that shows {@code world} whole and centred, with a margin around it.
     *
     * @param world finite; a side without length counts as long as the other one, or 1
     */
    public static PlaneMap fitting(Rectangle2D world, Rectangle view, PlaneAxes axes) {
        double width = length(world.getWidth(), world.getHeight());
        double height = length(world.getHeight(), world.getWidth());
        double scaleX = view.getWidth() * (1 - 2 * FREE) / width;
        double scaleY = view.getHeight() * (1 - 2 * FREE) / height;
        if (axes.equal()) scaleX = scaleY = Math.min(scaleX, scaleY);
        scaleX = clamp(scaleX);
        scaleY = axes.up() ? -clamp(scaleY) : clamp(scaleY);
        return new PlaneMap(
                view.getCenterX() - scaleX * world.getCenterX(),
                view.getCenterY() - scaleY * world.getCenterY(),
                scaleX,
                scaleY);
    }

    private static double length(double side, double other) {
        if (side > 0) return side;
        return other > 0 ? other : 1;
    }

    public double viewX(double worldX) {
        return originX + scaleX * worldX;
    }

    public double viewY(double worldY) {
        return originY + scaleY * worldY;
    }

    public double worldX(double viewX) {
        return (viewX - originX) / scaleX;
    }

    public double worldY(double viewY) {
        return (viewY - originY) / scaleY;
    }

    /** World units in x that {@code view} units show. */
    public double worldWidth(double view) {
        return view / scaleX;
    }

    /** World units in y that {@code view} units show; not negative. */
    public double worldHeight(double view) {
        return view / Math.abs(scaleY);
    }

    /** World x there, with no more decimals than a view unit can tell apart. */
    public double pointedX(double viewX) {
        return RoundTicks.rounded(worldX(viewX), worldWidth(1));
    }

    /** World y there, with no more decimals than a view unit can tell apart. */
    public double pointedY(double viewY) {
        return RoundTicks.rounded(worldY(viewY), worldHeight(1));
    }

    /** Zooms by a factor about a view point, which keeps its place; stops at the scales' range. */
    public PlaneMap zoomed(double factor, Point2D view) {
        double nextX = clamp(scaleX * factor);
        double nextY = Math.copySign(clamp(Math.abs(scaleY) * factor), scaleY);
        return new PlaneMap(
                view.getX() + (originX - view.getX()) * (nextX / scaleX),
                view.getY() + (originY - view.getY()) * (nextY / scaleY),
                nextX,
                nextY);
    }

    public PlaneMap moved(double viewDx, double viewDy) {
        return new PlaneMap(originX + viewDx, originY + viewDy, scaleX, scaleY);
    }

    private static double clamp(double scale) {
        return Math.max(SMALLEST, Math.min(LARGEST, scale));
    }
}
