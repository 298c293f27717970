package rasterlab.engine.visibility.painter;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FaceBrush;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;

/** Whole faces drawn one over the other in a given order. */
final class FaceSequence implements VisibilityWalk {
    private final ViewedMesh view;
    private final int[] order;
    private final double[] values;
    private final Tally tally;
    private final FaceBrush brush;
    private final ScreenPolygon polygon;
    private int drawn;

    /**
     * @param order numbers of the faces, first to last
     * @param values what decided about each face, by its number
     * @param tally what was done to find the order
     */
    FaceSequence(
            ViewedMesh view,
            int[] order,
            double[] values,
            Tally tally,
            FacePaint paint,
            Raster out) {
        this.view = view;
        this.order = order;
        this.values = values;
        this.tally = tally;
        brush = new FaceBrush(paint, out, tally);
        polygon = new ScreenPolygon(view);
    }

    @Override
    public boolean advance() {
        if (drawn == order.length) return false;
        int face = order[drawn++];
        polygon.load(view, face);
        brush.paint(polygon, face);
        return true;
    }

    @Override
    public VisibilityStep step() {
        int face = order[drawn - 1];
        return new VisibilityStep.FaceDrawn(face, values[face]);
    }

    @Override
    public VisibilityWork work() {
        return tally.work();
    }
}
