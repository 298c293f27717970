package rasterlab.engine.light;

/**
 * The rule of the vase's author: {@code I = |n_z|}, times 0.60 on inner sides.
 *
 * <p>n_z is the unit normal's share along the line of sight through the picture's middle, so a face
 * turned edge-on is black. The listing divides only n_z by the normal's length and leaves n_x and
 * n_y as they are; since nothing reads those, its tones are right, up to its rounded coordinates.
 *
 * <p>Source: student's coursework "three-dimensional model of a vase", program listing.
 */
public final class ToneShading {
    /** Factor of inner sides. */
    public static final double INNER = 0.60;

    /** Factor of a face's outline against its fill. */
    public static final double OUTLINE = 0.96;

    private ToneShading() {}

    /**
     * The share of a face's own colour that is seen, 0 to 1.
     *
     * @param nz z of the face's normal of length 1 in eye space
     * @param inner whether the picture shows the inner side
     */
    public static double intensity(double nz, boolean inner) {
        double tone = Math.abs(nz);
        return inner ? INNER * tone : tone;
    }

    /**
     * Each channel times the intensity, rounded to the nearest level, a tie to the even one.
     *
     * @param rgb 0xRRGGBB
     * @param intensity cut to 0 to 1
     * @return opaque 0xFFRRGGBB
     */
    public static int shade(int rgb, double intensity) {
        double share = Math.max(0, Math.min(1, intensity));
        int red = (int) Math.rint((rgb >> 16 & 255) * share);
        int green = (int) Math.rint((rgb >> 8 & 255) * share);
        int blue = (int) Math.rint((rgb & 255) * share);
        return 0xFF000000 | red << 16 | green << 8 | blue;
    }
}
