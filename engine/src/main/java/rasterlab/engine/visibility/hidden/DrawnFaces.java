package rasterlab.engine.visibility.hidden;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * The faces that a method shows, and the work it did for them.
 *
 * @param picture the face at each pixel
 * @param work what was counted
 */
public record DrawnFaces(FacePicture picture, VisibilityWork work) {

    /** Draws all at once. */
    public static DrawnFaces by(Visibility method, SurfaceView input) {
        return by(method, input, Thread.currentThread()::isInterrupted);
    }

    /** Draws all at once, as long as {@code cancelled} says false. */
    static DrawnFaces by(Visibility method, SurfaceView input, BooleanSupplier cancelled) {
        var out = new Raster(input.width(), input.height());
        VisibilityWork work = method.draw(input.view(), FacePicture.NUMBERS, out, cancelled);
        return new DrawnFaces(FacePicture.of(out), work);
    }

    /**
     * Draws step by step.
     *
     * @param observer gets each step
     */
    public static DrawnFaces watched(
            SteppedVisibility method, SurfaceView input, Consumer<VisibilityStep> observer) {
        var out = new Raster(input.width(), input.height());
        VisibilityWalk walk = method.walk(input.view(), FacePicture.NUMBERS, out);
        while (walk.advance()) observer.accept(walk.step());
        return new DrawnFaces(FacePicture.of(out), walk.work());
    }
}
