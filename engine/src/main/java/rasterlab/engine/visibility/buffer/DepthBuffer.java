package rasterlab.engine.visibility.buffer;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.BufferedWalk;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;

/** The depths that a method holds when its picture is done. */
public final class DepthBuffer {
    /** Grey levels of the nearest and the farthest depth. */
    private static final int NEAREST = 250;

    private static final int FARTHEST = 60;

    private final int width;
    private final int height;
    private final double[] stored;
    private final boolean largerIsNearer;

    private DepthBuffer(int width, int height, double[] stored, boolean largerIsNearer) {
        this.width = width;
        this.height = height;
        this.stored = stored;
        this.largerIsNearer = largerIsNearer;
    }

    /** Whether a method keeps such a buffer. */
    public static boolean keptBy(Visibility method) {
        return method instanceof ZBuffer;
    }

    /**
     * @param method keeps a buffer
     * @param steps how many steps are made, from 0; all if there are fewer
     * @throws IllegalArgumentException if it keeps none
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static DepthBuffer of(
            ViewedMesh view,
            Visibility method,
            FacePaint paint,
            int steps,
            BooleanSupplier cancelled) {
        if (!(method instanceof ZBuffer buffer))
            throw new IllegalArgumentException("the method keeps no depth buffer");
        var out = new Raster(view.fit().width(), view.fit().height());
        // The walk gets a buffer of its own, so that nobody draws into it before it is read.
        var walk = (BufferedWalk) buffer.alone().walk(view, paint, out);
        for (int i = 0; i < steps && walk.advance(); i++) Cancellation.check(cancelled);
        var stored = new double[out.width() * out.height()];
        for (int i = 0; i < stored.length; i++)
            stored[i] = walk.held(i % out.width(), i / out.width()).orElse(Double.NaN);
        return new DepthBuffer(out.width(), out.height(), stored, walk.largerIsNearer());
    }

    /** The content of a pixel, as the method stores it; empty where no face is. */
    public OptionalDouble at(int x, int y) {
        double depth = stored[y * width + x];
        return Double.isNaN(depth) ? OptionalDouble.empty() : OptionalDouble.of(depth);
    }

    /**
     * Greys linear in the stored depth, the nearest lightest.
     *
     * @param empty the colour 0xAARRGGBB of pixels that hold nothing
     */
    public Raster picture(int empty) {
        double least = Arrays.stream(stored).filter(d -> !Double.isNaN(d)).min().orElse(0);
        double most = Arrays.stream(stored).filter(d -> !Double.isNaN(d)).max().orElse(0);
        double extent = most > least ? most - least : 1;
        var picture = new Raster(width, height);
        for (int i = 0; i < stored.length; i++) {
            double share = (stored[i] - least) / extent;
            double near = largerIsNearer ? share : 1 - share;
            int gray = (int) Math.round(FARTHEST + (NEAREST - FARTHEST) * near);
            picture.argb()[i] = Double.isNaN(share) ? empty : 0xFF000000 | 0x010101 * gray;
        }
        return picture;
    }
}
