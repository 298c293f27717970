package rasterlab.app.visibility;

import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;

/**
 * A picture held against the exact one.
 *
 * @param request of the picture
 * @param difference all wrong pixels
 * @param exact the exact picture
 * @param actual the method's
 * @param missing pixels of a face that are background in the method's picture
 * @param extra background pixels that are of a face there
 */
public record Compared(
        RenderRequest request,
        PictureDifference difference,
        Raster exact,
        Raster actual,
        long missing,
        long extra) {
    /** The fault of a pixel. */
    enum PixelFault {
        NOTHING,
        MISSING,
        EXTRA,
        /** One face instead of another. */
        COLOR
    }

    /**
     * @throws IllegalArgumentException if the method refuses the scene
     */
    public static Compared of(
            RenderRequest request, PictureMaker maker, BooleanSupplier cancelled) {
        Raster exact = maker.picture(request.withVisibility(Renderer.REFERENCE), cancelled);
        Raster actual = maker.picture(request, cancelled);
        int background = background(request);
        long missing = 0;
        long extra = 0;
        for (int i = 0; i < exact.argb().length; i++)
            switch (wrong(exact.argb()[i], actual.argb()[i], background)) {
                case MISSING -> missing++;
                case EXTRA -> extra++;
                case NOTHING, COLOR -> {}
            }
        return new Compared(
                request, PictureDifference.of(exact, actual), exact, actual, missing, extra);
    }

    private static int background(RenderRequest request) {
        return 0xFF000000 | request.scene().backgroundRgb();
    }

    private static PixelFault wrong(int want, int have, int background) {
        if (want == have) return PixelFault.NOTHING;
        if (have == background) return PixelFault.MISSING;
        return want == background ? PixelFault.EXTRA : PixelFault.COLOR;
    }

    PixelFault at(int x, int y) {
        return wrong(exact.argb(x, y), actual.argb(x, y), background(request));
    }

    /** Pixels whose colour differs in any channel. */
    public long wrongPixels() {
        return difference.wrongPixels();
    }

    /** Pixels that show another face than they should. */
    long miscolored() {
        return wrongPixels() - missing - extra;
    }

    /** Wrong pixels as a share of all, 0 to 1. */
    public double share() {
        return difference.share();
    }
}
