package rasterlab.app.practice;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Point;
import java.awt.geom.Point2D;
import java.util.Optional;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.practice.Board.NamedPick;
import rasterlab.app.practice.Board.Picking;
import rasterlab.app.practice.Board.PixelPick;
import rasterlab.app.practice.Board.RunPick;
import rasterlab.app.practice.Board.Target;

/**
 * An answer, or a part of one, that was given in the picture.
 *
 * @param tolerance the largest error of a number that a hand makes there
 */
record StagePick(ObjectNode answer, double tolerance) {
    /** View units from a thing or a point at which a click still means it. */
    private static final int REACH = 22;

    /** View units by which a click may miss a point. */
    private static final int HAND = 8;

    /** Confirms what is answered beside the picture. */
    static final StagePick NOTHING = new StagePick(JsonNodeFactory.instance.objectNode(), 0);

    /** Whether the pixels of the board are clicked. */
    static boolean isOfPixels(Picking picking) {
        return picking instanceof PixelPick || picking instanceof RunPick;
    }

    /**
     * The answer of pixels.
     *
     * @param from where the pointer was pressed
     * @param to where it was released
     */
    static StagePick pixels(Picking picking, Point from, Point to) {
        ObjectNode answer = JsonNodeFactory.instance.objectNode();
        if (picking instanceof PixelPick pixel) answer.put(pixel.x(), to.x).put(pixel.y(), to.y);
        if (picking instanceof RunPick run) {
            if (!run.row().isEmpty()) answer.put(run.row(), from.y);
            answer.put(run.from(), Math.min(from.x, to.x));
            answer.put(run.to(), Math.max(from.x, to.x) + 1);
        }
        return new StagePick(answer, 0);
    }

    /** The answer of a click in a plane; empty where it means nothing. */
    static Optional<StagePick> plane(Picking picking, PlaneMap map, Point view) {
        ObjectNode answer = JsonNodeFactory.instance.objectNode();
        if (picking instanceof Board.PointPick point) {
            answer.put(point.x(), map.pointedX(view.x)).put(point.y(), map.pointedY(view.y));
            return Optional.of(new StagePick(answer, map.worldWidth(PictureType.scaled(HAND))));
        }
        if (!(picking instanceof NamedPick named)) return Optional.empty();
        double nearest = PictureType.scaled(REACH);
        for (Target target : named.targets())
            for (Point2D each : target.points()) {
                double away = view.distance(map.viewX(each.getX()), map.viewY(each.getY()));
                if (away >= nearest) continue;
                nearest = away;
                answer.set(named.field(), target.value());
            }
        return answer.isEmpty() ? Optional.empty() : Optional.of(new StagePick(answer, 0));
    }
}
