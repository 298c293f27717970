package rasterlab.engine.line;

import rasterlab.engine.raster.PixelWindow;

/** The steps of a walk whose pixels lie in a window; what lies before is walked all the same. */
record SeenWalk(LineWalk whole, PixelWindow window) implements LineWalk {
    @Override
    public boolean advance() {
        while (whole.advance()) if (window.contains(whole.x(), whole.y())) return true;
        return false;
    }

    @Override
    public int x() {
        return whole.x();
    }

    @Override
    public int y() {
        return whole.y();
    }

    @Override
    public double decision() {
        return whole.decision();
    }
}
