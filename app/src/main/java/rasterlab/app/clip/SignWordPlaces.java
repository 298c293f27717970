package rasterlab.app.clip;

import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;

/** Where words beside signs stand: over no handle, and over no words that stand already. */
final class SignWordPlaces {
    /** View units between a sign and its words, across and up, the nearest first. */
    private static final int[] AWAY = {12, 26};

    private final Rectangle view;
    private final List<Rectangle> taken;

    /**
     * @param view what is seen
     * @param handles with the points' labels
     */
    SignWordPlaces(Rectangle view, List<Rectangle> handles) {
        this.view = view;
        taken = new ArrayList<>(handles);
    }

    /**
     * Takes a place: to the upper right of the sign where that is free, else in another of its
     * corners or further away; where there is no room, to the upper right.
     *
     * @param x of the sign
     * @param y of the sign
     * @param wide of the words
     * @param high of the words
     */
    Rectangle take(double x, double y, int wide, int high) {
        var places = new ArrayList<Rectangle>();
        for (int away : AWAY) {
            int right = (int) x + away;
            int left = (int) x - away - wide;
            int above = (int) y - away - high;
            int below = (int) y + away;
            places.add(new Rectangle(right, above, wide, high));
            places.add(new Rectangle(right, below, wide, high));
            places.add(new Rectangle(left, above, wide, high));
            places.add(new Rectangle(left, below, wide, high));
        }
        Rectangle found =
                places.stream()
                        .filter(view::contains)
                        .filter(place -> taken.stream().noneMatch(place::intersects))
                        .findFirst()
                        .orElse(places.get(0));
        taken.add(found);
        return found;
    }
}
