package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.engine.texture.TexelShare;

/** A filter that can say which texels it mixes a colour of. */
public interface SteppedFilter extends PreparedFilter {
    /** Texels of one picture. */
    @FunctionalInterface
    interface Trace {
        /** The texels of a pixel's colour; parameters as {@link Lookup#color} takes them. */
        List<TexelShare> texels(
                double s, double t, double dsdx, double dtdx, double dsdy, double dtdy);
    }

    /** Makes ready what does not depend on the pixel, as {@link #prepare} does. */
    Trace trace(int width, int height, int[] argb);

    /** The texels of each pixel's colour. */
    default List<List<TexelShare>> texels(FilteredPixels pixels) {
        Trace trace = trace(pixels.width(), pixels.height(), pixels.argb().clone());
        return pixels.each(trace::texels);
    }
}
