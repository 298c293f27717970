package rasterlab.app.light;

import rasterlab.engine.transform.PictureFit;

/**
 * Where {@link LightChoice.LightMarks} lie in a picture: they stay on their place of the scene when
 * the picture changes its size.
 *
 * <p>A mark's 0 to 1 is the frame of {@value PictureFit#NATURAL_WIDTH} × {@value
 * PictureFit#NATURAL_HEIGHT} that {@link PictureFit#of} puts as large as it fits into the middle of
 * the picture; a mark beside the picture is shown at its edge.
 *
 * @param width of the picture
 * @param height of the picture, in the same unit
 */
public record MarkPlaces(int width, int height) {
    private PictureFit frame() {
        return PictureFit.of(width, height, 1);
    }

    /** The mark's place across, from 0 to the picture's width. */
    public double x(double mark) {
        return within(frame().toPixelX((mark - 0.5) * PictureFit.NATURAL_WIDTH), width);
    }

    /** The mark's place down, from 0 to the picture's height. */
    public double y(double mark) {
        return within(frame().toPixelY((0.5 - mark) * PictureFit.NATURAL_HEIGHT), height);
    }

    /** Place of the mark that is shown there; one beside the picture is its edge. */
    public double markX(double x) {
        return 0.5 + frame().toPlaneX(within(x, width)) / PictureFit.NATURAL_WIDTH;
    }

    /** Place of the mark that is shown there; one beside the picture is its edge. */
    public double markY(double y) {
        return 0.5 - frame().toPlaneY(within(y, height)) / PictureFit.NATURAL_HEIGHT;
    }

    private static double within(double place, int end) {
        return Math.max(0, Math.min(end, place));
    }
}
