package rasterlab.app.coordinates.figure;

import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Stream;

/** The rectangle around marks. */
public final class MarkBounds {
    private MarkBounds() {}

    /**
     * The box around all but what is drawn wrong, which may be anywhere; the unit square for
     * nothing.
     */
    public static Rectangle2D around(List<Mark> marks) {
        Rectangle2D.Double box = null;
        for (Mark mark : marks) {
            if (mark.ink().role() == MarkInk.Role.WRONG) continue;
            for (StagePoint spot : spots(mark).filter(StagePoint::isFinite).toList())
                if (box == null) box = new Rectangle2D.Double(spot.x(), spot.y(), 0, 0);
                else box.add(spot.x(), spot.y());
        }
        return box == null ? new Rectangle2D.Double(0, 0, 1, 1) : box;
    }

    private static Stream<StagePoint> spots(Mark mark) {
        if (mark instanceof Mark.LineMark line) return Stream.of(line.from(), line.to());
        if (mark instanceof Mark.PathMark path) return path.places().stream();
        if (mark instanceof Mark.AreaMark area) return area.corners().stream();
        if (mark instanceof Mark.ArrowMark arrow) return Stream.of(arrow.from(), arrow.to());
        if (mark instanceof Mark.DotMark dot) return Stream.of(dot.at());
        if (mark instanceof Mark.CrossMark cross) return Stream.of(cross.at());
        if (mark instanceof Mark.WrongMark wrong) return Stream.of(wrong.at());
        if (mark instanceof Mark.Beside beside) return Stream.of(beside.at());
        return Stream.of(((Mark.WordsMark) mark).at());
    }
}
