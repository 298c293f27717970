package rasterlab.app.canvas;

import java.awt.geom.Point2D;

/** A stage that can be brought nearer. */
public interface Zooming {
    /**
     * @param factor above 1 for nearer
     * @param view the point of the stage that keeps its place
     */
    void zoom(double factor, Point2D view);

    /** Shows everything again, and keeps doing so when the stage changes its size. */
    void fit();
}
