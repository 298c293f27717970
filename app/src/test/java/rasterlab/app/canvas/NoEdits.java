package rasterlab.app.canvas;

/** Lets nothing be moved. */
final class NoEdits implements PlaneEdits {
    @Override
    public void beginDrag() {}

    @Override
    public void endDrag() {}

    @Override
    public void move(String point, double x, double y) {}
}
