package rasterlab.engine.raster;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/**
 * A picture of 0xAARRGGBB pixels, row by row, behind a {@link BufferedImage} of TYPE_INT_ARGB.
 *
 * <p>Pixel (x, y) is cell {@code y * width + x}; whole numbers name pixel centres, x grows to the
 * right, y grows down. One thread writes at a time, or several write different rows.
 */
public final class Raster {
    /** The longest side, in pixels: a picture of both sides takes 256 MiB. */
    public static final int LARGEST_SIDE = 8192;

    private final BufferedImage image;
    private final int[] argb;

    /**
     * A picture of transparent black.
     *
     * @param width 1 to {@value #LARGEST_SIDE} pixels
     * @param height 1 to {@value #LARGEST_SIDE} pixels
     */
    public Raster(int width, int height) {
        checkSize(width, height);
        image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        argb = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    }

    /** Refuses a size outside 1×1 to 8192×8192 and names it. */
    public static void checkSize(int width, int height) {
        if (width < 1 || height < 1 || width > LARGEST_SIDE || height > LARGEST_SIDE)
            throw new IllegalArgumentException(
                    "picture size must be from 1×1 to %d×%d pixels, got %d×%d"
                            .formatted(LARGEST_SIDE, LARGEST_SIDE, width, height));
    }

    public int width() {
        return image.getWidth();
    }

    public int height() {
        return image.getHeight();
    }

    /** The picture itself, not a copy: it shows every later write. */
    public BufferedImage image() {
        return image;
    }

    /** The pixels themselves, not a copy: width × height cells of 0xAARRGGBB. */
    public int[] argb() {
        return argb;
    }

    /** The colour 0xAARRGGBB of a pixel inside the picture. */
    public int argb(int x, int y) {
        if (!contains(x, y))
            throw new IndexOutOfBoundsException(
                    "pixel (%d, %d) is outside a picture of %d×%d"
                            .formatted(x, y, width(), height()));
        return argb[y * width() + x];
    }

    /** Whether (x, y) is a pixel of this picture. */
    public boolean contains(int x, int y) {
        return x >= 0 && y >= 0 && x < width() && y < height();
    }

    /** Gives every pixel one colour, 0xAARRGGBB. */
    public void clear(int color) {
        Arrays.fill(argb, color);
    }
}
