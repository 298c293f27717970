package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.geom.Point2D;
import java.util.List;

/**
 * The drawing of a question.
 *
 * @param space what the coordinates are
 * @param figures later ones over earlier ones
 * @param picking what a click on it answers
 */
record Board(Space space, List<Figure> figures, Picking picking) {
    Board {
        figures = List.copyOf(figures);
    }

    /** The space that coordinates belong to. */
    enum Space {
        /** Pixels, with y down. */
        PIXELS,
        /** A plane, with y up and both axes to one scale. */
        PLANE,
        /** A plane with depth in place of y, upward, each axis to its own scale. */
        DEPTH,
        /** Space as {@link SpaceView} draws it; its coordinates cannot be read off. */
        SPACE
    }

    /** The purpose of a figure. */
    enum Look {
        /** Belongs to the input. */
        GIVEN,
        /** A pixel that nothing may cover. */
        WALL,
        /** Is made by earlier steps. */
        DONE,
        /** Is made by the newest step. */
        NEWEST,
        /** Is what the question is about. */
        ASKED,
        /** Was answered wrongly. */
        WRONG
    }

    /** Something in the picture. */
    sealed interface Figure permits Cell, Path, Dot {}

    /** A pixel. */
    record Cell(int x, int y, Look look) implements Figure {}

    /** A line from point to point. */
    record Path(List<Point2D> points, boolean closed, Look look) implements Figure {
        Path {
            points = List.copyOf(points);
        }
    }

    /**
     * A point.
     *
     * @param label beside it; "" for none, a word in the place of {@code label.…} in the texts
     */
    record Dot(Point2D at, String label, Look look) implements Figure {}

    /** How a click becomes an answer. */
    sealed interface Picking permits None, Pixel, Run, Point, Named {}

    /** Clicks answer nothing. */
    record None() implements Picking {}

    /** The pixel clicked, by the fields of its coordinates. */
    record Pixel(String x, String y) implements Picking {}

    /**
     * Pixels of one row, from the one pressed to the one released.
     *
     * @param row the field of the row; "" where the question tells it
     * @param from field of the first column
     * @param to field of the column behind the last one
     */
    record Run(String row, String from, String to) implements Picking {}

    /** The point clicked, by the fields of its coordinates. */
    record Point(String x, String y) implements Picking {}

    /** One of several things, clicked at one of its points. */
    record Named(String field, List<Target> targets) implements Picking {
        Named {
            targets = List.copyOf(targets);
        }
    }

    /**
     * Something that can be clicked.
     *
     * @param value the answer that it is
     * @param points of it; nearest counts
     */
    record Target(JsonNode value, List<Point2D> points) {
        Target {
            points = List.copyOf(points);
        }
    }
}
