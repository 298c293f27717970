package rasterlab.app.light.panel;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.List;

/** Where the letter of the line's end and a picture's name stand: over no lamp. */
final class EndLabel {
    /** View units from a lamp's middle to the ends of its rays. */
    static final int LAMP = 16;

    /** View units from the end's middle to its letter. */
    private static final int AWAY = 10;

    /** View units from a picture's edges to its name. */
    private static final int INSET = 7;

    private EndLabel() {}

    /**
     * The place below the end, above it, to its left or right: the first of them that neither a
     * lamp nor the plate touches; below it where all are touched.
     *
     * @param lamps their middles
     * @param plate what else must stay in sight
     */
    static Rectangle place(
            Point2D end, int width, int height, List<Point2D> lamps, Rectangle plate) {
        int x = (int) end.getX();
        int y = (int) end.getY();
        List<Rectangle> places =
                List.of(
                        new Rectangle(x - width / 2, y + AWAY, width, height),
                        new Rectangle(x - width / 2, y - AWAY - height, width, height),
                        new Rectangle(x - AWAY - width, y - height / 2, width, height),
                        new Rectangle(x + AWAY, y - height / 2, width, height));
        return places.stream()
                .filter(place -> !place.intersects(plate))
                .filter(place -> lamps.stream().noneMatch(lamp -> touches(lamp, place)))
                .findFirst()
                .orElse(places.get(0));
    }

    /**
     * The upper left corner of a picture, the upper right or a lower one: the first of them in
     * which no lamp lies; the upper left where there is one in each.
     *
     * @param lamps their middles
     */
    static Rectangle corner(Dimension picture, int width, int height, List<Point2D> lamps) {
        int right = picture.width - INSET - width;
        int low = picture.height - INSET - height;
        List<Rectangle> places =
                List.of(
                        new Rectangle(INSET, INSET, width, height),
                        new Rectangle(right, INSET, width, height),
                        new Rectangle(INSET, low, width, height),
                        new Rectangle(right, low, width, height));
        return places.stream()
                .filter(place -> lamps.stream().noneMatch(lamp -> touches(lamp, place)))
                .findFirst()
                .orElse(places.get(0));
    }

    private static boolean touches(Point2D lamp, Rectangle place) {
        return place.intersects(lamp.getX() - LAMP, lamp.getY() - LAMP, 2 * LAMP, 2 * LAMP);
    }
}
