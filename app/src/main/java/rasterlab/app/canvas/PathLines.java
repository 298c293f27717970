package rasterlab.app.canvas;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.util.ArrayList;
import java.util.List;

/** The straight parts of paths, for labels to keep off. */
public final class PathLines {
    private PathLines() {}

    /**
     * @param path of straight parts
     * @return those that are seen
     */
    public static List<Line2D> of(Path2D path, Rectangle view) {
        var lines = new ArrayList<Line2D>();
        var to = new double[6];
        double firstX = 0;
        double firstY = 0;
        double x = 0;
        double y = 0;
        for (PathIterator each = path.getPathIterator(null); !each.isDone(); each.next()) {
            int kind = each.currentSegment(to);
            if (kind == PathIterator.SEG_MOVETO) {
                firstX = to[0];
                firstY = to[1];
            } else {
                boolean closing = kind == PathIterator.SEG_CLOSE;
                if (closing) {
                    to[0] = firstX;
                    to[1] = firstY;
                }
                var line = new Line2D.Double(x, y, to[0], to[1]);
                if (line.intersects(view)) lines.add(line);
            }
            x = to[0];
            y = to[1];
        }
        return lines;
    }
}
