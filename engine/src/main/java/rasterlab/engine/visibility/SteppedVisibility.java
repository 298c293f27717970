package rasterlab.engine.visibility;

import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;

/** A method that can be watched while it draws. */
public interface SteppedVisibility extends Visibility {
    /** A walk that has drawn nothing yet. */
    VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out);

    /** The meaning of a step's value. */
    String decision();

    @Override
    default VisibilityWork draw(
            ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        Cancellation.check(cancelled);
        VisibilityWalk walk = walk(view, paint, out);
        boolean more;
        do {
            Cancellation.check(cancelled);
            more = walk.advance();
        } while (more);
        return walk.work();
    }
}
