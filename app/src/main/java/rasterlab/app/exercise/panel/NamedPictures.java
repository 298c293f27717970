package rasterlab.app.exercise.panel;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * Where pictures of one size stand, each above its name: beside or below each other, whichever
 * shows them larger. A pixel of their raster is a whole number of view units where it is one at
 * least.
 *
 * @param places of the pictures, without their names
 * @param type of the names
 */
public record NamedPictures(List<Rectangle> places, Font type) {
    /** The gap between a picture and its name. */
    static final int ABOVE_NAME = 2;

    /** Names become smaller in such steps, where they have no room otherwise, down to the least. */
    private static final float STEP = 0.05f;

    private static final float LEAST = 0.7f;

    /** Columns or rows that a part of a picture has at least. */
    private static final int LEAST_PART = 8;

    /**
     * The things that are to be placed.
     *
     * @param raster pixels of each picture, across and down
     * @param type of the names, where they have room
     * @param gap between two pictures
     */
    record PicturesToPlace(
            List<String> names,
            Dimension raster,
            Font type,
            Function<Font, FontMetrics> metrics,
            int gap) {
        /** The pictures placed in the room; empty where the names have no room. */
        Optional<NamedPictures> in(Dimension room) {
            Optional<NamedPictures> best = Optional.empty();
            for (int columns = names.size(); columns >= 1; columns--) {
                Optional<NamedPictures> next = inColumns(columns, room);
                if (width(next) > width(best)) best = next;
            }
            return best;
        }

        /**
         * The size of the raster's part that has so many units for each pixel in that room; the
         * whole where too little would be left.
         */
        Dimension part(int pixel, Dimension room) {
            Dimension best = new Dimension();
            int name = metrics.apply(type).getHeight() + ABOVE_NAME;
            for (int columns = names.size(); columns >= 1; columns--) {
                int rows = (names.size() + columns - 1) / columns;
                int wide = widest(columns, room.width - gap * (columns - 1)) / pixel;
                int high = ((room.height + gap) / rows - gap - name) / pixel;
                var next =
                        new Dimension(Math.min(raster.width, wide), Math.min(raster.height, high));
                boolean enough = next.width >= LEAST_PART && next.height >= LEAST_PART;
                boolean whole = next.equals(raster);
                if ((enough || whole) && area(next) > area(best)) best = next;
            }
            return area(best) > 0 ? best : raster;
        }

        /** The width that each picture can have beside the names of the others. */
        private int widest(int columns, int rest) {
            int wide = rest / columns;
            while (wide > 0 && width(columns, type, wide) > rest) wide--;
            return wide;
        }

        private static int area(Dimension part) {
            return part.width * part.height;
        }

        PicturesToPlace of(Dimension part) {
            return new PicturesToPlace(names, part, type, metrics, gap);
        }

        private static int width(Optional<NamedPictures> placed) {
            return placed.map(NamedPictures::width).orElse(0);
        }

        private Optional<NamedPictures> inColumns(int columns, Dimension room) {
            for (float share = 1; share >= LEAST; share -= STEP) {
                Font smaller = type.deriveFont(share * type.getSize2D());
                int rest = room.width - gap * (columns - 1);
                if (width(columns, smaller, 0) <= rest)
                    return Optional.of(new Columns(this, columns, smaller, room).placed());
            }
            return Optional.empty();
        }

        /** Width of all columns with pictures of that width, without the gaps. */
        private int width(int columns, Font worn, int picture) {
            return IntStream.range(0, columns)
                    .map(column -> Math.max(picture, nameWidth(column, columns, worn)))
                    .sum();
        }

        private int nameWidth(int column, int columns, Font worn) {
            return IntStream.range(0, names.size())
                    .filter(i -> i % columns == column)
                    .map(i -> metrics.apply(worn).stringWidth(names.get(i)))
                    .max()
                    .orElse(0);
        }
    }

    private record Columns(PicturesToPlace wanted, int columns, Font type, Dimension room) {
        NamedPictures placed() {
            Dimension size = size();
            int rest = freeWidth() - wanted.width(columns, type, size.width);
            int row = (room.height + wanted.gap()) / rows();
            var places = new ArrayList<Rectangle>();
            for (int i = 0, left = 0; i < wanted.names().size(); i++) {
                int column = i % columns;
                if (column == 0) left = 0;
                int top = rows() == 1 ? 0 : i / columns * Math.min(row, rowHeight(size.height));
                places.add(new Rectangle(left, top, size.width, size.height));
                int own = Math.max(size.width, wanted.nameWidth(column, columns, type));
                left += own + wanted.gap() + rest / columns;
            }
            return new NamedPictures(List.copyOf(places), type);
        }

        private int rows() {
            return (wanted.names().size() + columns - 1) / columns;
        }

        private int rowHeight(int picture) {
            return picture + nameHeight() + wanted.gap();
        }

        private int nameHeight() {
            return wanted.metrics().apply(type).getHeight() + ABOVE_NAME;
        }

        private int freeWidth() {
            return room.width - wanted.gap() * (columns - 1);
        }

        /** Size of a picture. */
        private Dimension size() {
            int across = wanted.raster().width;
            int down = wanted.raster().height;
            int high = (room.height + wanted.gap()) / rows() - wanted.gap() - nameHeight();
            int pixel = high / down;
            while (pixel > 0 && wanted.width(columns, type, pixel * across) > freeWidth()) pixel--;
            if (pixel > 0) return new Dimension(pixel * across, pixel * down);
            double part = Math.min((double) high / down, (double) freeWidth() / columns / across);
            return new Dimension((int) Math.max(1, part * across), (int) Math.max(1, part * down));
        }
    }

    private int width() {
        return places.get(0).width;
    }
}
