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
public final class ToneShading implements Shading {
    /** Factor of inner sides. */
    public static final double INNER = 0.60;

    /** Factor of a face's outline against its fill. */
    public static final double OUTLINE = 0.96;

    @Override
    public double intensity(FaceSide side) {
        double tone = Math.abs(side.nz());
        return side.inner() ? INNER * tone : tone;
    }
}
