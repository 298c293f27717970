package rasterlab.engine.texture.filter;

import rasterlab.contract.TextureFilter;

/** A filter that makes a picture ready once and then looks up one pixel after the other. */
@FunctionalInterface
interface PreparedFilter extends TextureFilter {
    /** Colours of one picture. */
    @FunctionalInterface
    interface Lookup {
        /**
         * The colour of a pixel.
         *
         * @param s of its centre, 0 to 1 across the picture
         * @param t of its centre, 0 to 1 up the picture
         * @param dsdx how s changes to the next pixel on the right
         * @param dtdx how t does
         * @param dsdy how s changes to the next pixel below
         * @param dtdy how t does
         * @return 0xAARRGGBB
         * @throws IllegalArgumentException if the method cannot filter that footprint
         */
        int color(double s, double t, double dsdx, double dtdx, double dsdy, double dtdy);
    }

    /** Makes ready what does not depend on the pixel; parameters as {@link #colors} takes them. */
    Lookup prepare(int width, int height, int[] argb);

    @Override
    default int[] colors(int width, int height, int[] argb, double[] footprints) {
        Lookup lookup = prepare(width, height, argb);
        var colors = new int[footprints.length / FilteredPixels.NUMBERS];
        for (int i = 0, at = 0; i < colors.length; i++, at += FilteredPixels.NUMBERS)
            colors[i] =
                    lookup.color(
                            footprints[at],
                            footprints[at + 1],
                            footprints[at + 2],
                            footprints[at + 3],
                            footprints[at + 4],
                            footprints[at + 5]);
        return colors;
    }
}
