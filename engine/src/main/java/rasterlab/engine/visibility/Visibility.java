package rasterlab.engine.visibility;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;

/** Draws the visible parts of a mesh. Stateless to the caller, safe to use from several threads. */
public interface Visibility {
    /**
     * Draws over the picture's background.
     *
     * @param view the mesh as the eye sees it
     * @param paint the colours of its faces
     * @param out as large as the view's fit
     * @param cancelled asked at least once per face or row, possibly by several threads
     * @return what was done, counted
     * @throws IllegalArgumentException if the method cannot draw that scene; the message says why
     * @throws CancellationException soon after {@code cancelled} says true; the picture is then
     *     half drawn
     */
    VisibilityWork draw(ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled);

    /** Whether the method can outline faces; one that cannot ignores the outline colours. */
    default boolean drawsOutlines() {
        return false;
    }
}
