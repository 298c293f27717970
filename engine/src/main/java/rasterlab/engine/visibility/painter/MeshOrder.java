package rasterlab.engine.visibility.painter;

import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityWalk;

/** No method at all: faces in the order of the mesh, each over the ones before. */
final class MeshOrder implements SteppedVisibility {
    @Override
    public boolean drawsOutlines() {
        return true;
    }

    @Override
    public String decision() {
        return "number of the face";
    }

    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        int[] order = IntStream.range(0, view.mesh().faceCount()).toArray();
        double[] numbers = IntStream.of(order).asDoubleStream().toArray();
        return new FaceSequence(view, order, numbers, new Tally(), paint, out);
    }
}
