package rasterlab.app.line;

import java.util.Map;

/** What a mode draws, in pixel coordinates; immutable. */
public sealed interface DrawnFigure permits ArcFigure, PenFigure, SlopeFigure {
    /** What can be moved: the name of its handle and its place. */
    Map<String, Spot> grips();

    DrawnFigure moved(String grip, Spot to);

    /** After two clicks on the ground; the same where nothing can be added. */
    default DrawnFigure added(Spot at) {
        return this;
    }

    /** Without that point; the same where it is needed. */
    default DrawnFigure without(String grip) {
        return this;
    }
}
