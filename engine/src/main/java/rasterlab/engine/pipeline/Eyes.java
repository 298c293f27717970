package rasterlab.engine.pipeline;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.StereoPair;

/**
 * Two eyes' pictures as one.
 *
 * <p>In an anaglyph red is the left eye's brightness, green and blue are the right eye's: 0.299·R +
 * 0.587·G + 0.114·B, rounded. It is seen through a red glass on the left and a cyan one on the
 * right.
 *
 * <p>Source of the weights: ITU-R, Recommendation BT.601.
 */
final class Eyes {
    private Eyes() {}

    static void require(Stereo stereo, Projection projection, SphericalView camera, int width) {
        if (projection != Projection.PERSPECTIVE)
            throw new IllegalArgumentException(
                    "stereo needs perspective, since two eyes see the same in projection '%s'"
                            .formatted(projection.code()));
        new StereoPair(camera, stereo.separation(camera.rho()));
        if (stereo.kind() == Stereo.StereoMode.SIDE_BY_SIDE && width < 2)
            throw new IllegalArgumentException(
                    "two pictures side by side need a width of at least 2, got " + width);
    }

    /** The width of each eye's picture. */
    static int width(Stereo stereo, int whole) {
        return stereo.kind() == Stereo.StereoMode.ANAGLYPH ? whole : whole / 2;
    }

    /** Puts two pictures of that width into the whole one. */
    static void join(Stereo stereo, Raster left, Raster right, Raster out) {
        if (stereo.kind() == Stereo.StereoMode.ANAGLYPH)
            anaglyph(left.argb(), right.argb(), out.argb());
        else {
            copy(left, out, 0);
            copy(right, out, out.width() - right.width());
        }
    }

    private static void anaglyph(int[] left, int[] right, int[] out) {
        for (int i = 0; i < out.length; i++)
            out[i] = 0xFF000000 | brightness(left[i]) << 16 | brightness(right[i]) * 0x0101;
    }

    private static int brightness(int argb) {
        return (299 * (argb >> 16 & 255) + 587 * (argb >> 8 & 255) + 114 * (argb & 255) + 500)
                / 1000;
    }

    private static void copy(Raster eye, Raster out, int column) {
        for (int y = 0; y < eye.height(); y++)
            System.arraycopy(
                    eye.argb(), y * eye.width(), out.argb(), y * out.width() + column, eye.width());
    }
}
