package rasterlab.app.canvas;

/** A drawing as it was when it was asked for, which becomes an SVG document later. */
@FunctionalInterface
public interface SvgDrawing {
    /** Takes long for a large drawing; on any thread, and on one at a time. */
    String document();
}
