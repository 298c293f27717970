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
record Board(BoardSpace space, List<BoardFigure> figures, Picking picking) {
    Board {
        figures = List.copyOf(figures);
    }

    /** The space that coordinates belong to. */
    enum BoardSpace {
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
    enum FigureLook {
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
    sealed interface BoardFigure permits BoardCell, BoardPath, BoardDot {}

    /** A pixel. */
    record BoardCell(int x, int y, FigureLook look) implements BoardFigure {}

    /** A line from point to point. */
    record BoardPath(List<Point2D> points, boolean closed, FigureLook look) implements BoardFigure {
        BoardPath {
            points = List.copyOf(points);
        }
    }

    /**
     * A point.
     *
     * @param label beside it; "" for none, a word in the place of {@code label.…} in the texts
     */
    record BoardDot(Point2D at, String label, FigureLook look) implements BoardFigure {}

    /** How a click becomes an answer. */
    sealed interface Picking permits NoPick, PixelPick, RunPick, PointPick, NamedPick {}

    /** Clicks answer nothing. */
    record NoPick() implements Picking {}

    /** The pixel clicked, by the fields of its coordinates. */
    record PixelPick(String x, String y) implements Picking {}

    /**
     * Pixels of one row, from the one pressed to the one released.
     *
     * @param row the field of the row; "" where the question tells it
     * @param from field of the first column
     * @param to field of the column behind the last one
     */
    record RunPick(String row, String from, String to) implements Picking {}

    /** The point clicked, by the fields of its coordinates. */
    record PointPick(String x, String y) implements Picking {}

    /** One of several things, clicked at one of its points. */
    record NamedPick(String field, List<Target> targets) implements Picking {
        NamedPick {
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
