package rasterlab.contract;

/**
 * Clips a segment in space by the normalised view volume.
 *
 * <p>The eye is at the origin and looks along z. The volume is the closed pyramid without its tip
 * |x| ≤ z, |y| ≤ z, zmin ≤ z ≤ 1, where 0 &lt; zmin &lt; 1. Points at the eye (z = 0) and behind it
 * (z &lt; 0) are outside; a segment may well pass from there into the volume.
 *
 * <p>What is left of a segment is the set of its points in the volume, if only one point. Whether
 * something is left is decided for the exact segment. The part keeps the segment's direction; an
 * end in the volume stays as it is; a new end lies in the volume and within 10⁻¹² of the exact one
 * in each coordinate, the volume's depth being 1. A segment may be one point.
 *
 * <p>A segment may be refused only where a coordinate is larger than 10¹⁵⁰ in size, as differences
 * and products may not fit in a double there.
 */
@FunctionalInterface
public interface VolumeClipper {
    /**
     * Sends what is left of the segment from (x0, y0, z0) to (x1, y1, z1), once; nothing where
     * nothing is left.
     *
     * @param zmin distance of the nearest plane, the farthest being at 1; above 0 and below 1
     * @param x0 any finite number, as are the five others
     * @throws IllegalArgumentException if a number is not finite, {@code zmin} is out of range, or
     *     a coordinate is larger than 10¹⁵⁰ in size; the message names the value and what is
     *     allowed
     */
    void clip(
            double zmin,
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            SpaceSegmentSink out);
}
