package rasterlab.engine.transform;

/**
 * Maps the picture plane (world units, y up, origin in the middle) to pixels (y down).
 *
 * <p>{@code pixelX = c1 + s·(X + e), pixelY = c2 − s·Y} with c1 = ⌊width / 2⌋, c2 = ⌊height / 2⌋,
 * so the object's centre falls on a pixel centre. Here y changes its direction; what is linear in
 * the pixel's row, as a z-buffer's nearness, changes its sign with it.
 *
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param pixelsPerUnit s, pixels per world unit at the object's centre
 * @param eyeX e: X is counted from the eye, which stands so far to the right of the middle; 0 but
 *     for the eyes of a stereo pair
 */
public record PictureFit(int width, int height, double pixelsPerUnit, double eyeX) {
    /** The picture size at which a scene has its natural scale, in pixels. */
    public static final int NATURAL_WIDTH = 800;

    /** See {@link #NATURAL_WIDTH}. */
    public static final int NATURAL_HEIGHT = 600;

    public PictureFit {
        if (width < 1 || height < 1 || !(pixelsPerUnit > 0))
            throw new IllegalArgumentException(
                    "picture fit needs at least 1×1 pixel and a scale above 0, got %d×%d, %s"
                            .formatted(width, height, pixelsPerUnit));
    }

    /** A fit with the eye in the middle. */
    public PictureFit(int width, int height, double pixelsPerUnit) {
        this(width, height, pixelsPerUnit, 0);
    }

    /** This fit for an eye so far to the right of the middle, in world units. */
    public PictureFit forEye(double toTheRight) {
        return new PictureFit(width, height, pixelsPerUnit, toTheRight);
    }

    /**
     * Keeps the proportions: s = naturalScale · min(width / 800, height / 600).
     *
     * @param naturalScale pixels per world unit in a picture of 800×600
     */
    public static PictureFit of(int width, int height, double naturalScale) {
        double factor = Math.min((double) width / NATURAL_WIDTH, (double) height / NATURAL_HEIGHT);
        return new PictureFit(width, height, naturalScale * factor);
    }

    /** c1: the column of the object's centre. */
    public int centerX() {
        return width / 2;
    }

    /** c2: the row of the object's centre. */
    public int centerY() {
        return height / 2;
    }

    public double toPixelX(double planeX) {
        return centerX() + pixelsPerUnit * (planeX + eyeX);
    }

    public double toPixelY(double planeY) {
        return centerY() - pixelsPerUnit * planeY;
    }

    public double toPlaneX(double pixelX) {
        return (pixelX - centerX()) / pixelsPerUnit - eyeX;
    }

    public double toPlaneY(double pixelY) {
        return (centerY() - pixelY) / pixelsPerUnit;
    }
}
