package rasterlab.engine.sight;

import rasterlab.engine.range.Bounds;
import rasterlab.engine.sight.cost.PictureWork;

/**
 * How faces are lit and textured, as far as it tells what a picture takes.
 *
 * @param perCorner whether light is worked out at corners; otherwise once for each face
 * @param atPixels the faces that have the formula at each pixel
 * @param texelReads texture elements read for a pixel: 0, 1, 4 or 8
 * @param mixed whether a bound is worked out for each face first
 */
public record LightWork(boolean perCorner, boolean[] atPixels, int texelReads, boolean mixed) {
    /** The formulas that the bound for one face is worth, with a second pass over its vertices. */
    public static final int BOUND = 14;

    /** The share of hidden faces that are drawn, and lit, before what hides them. */
    private static final double BEFORE = 0.5;

    public LightWork {
        Bounds.require("texelReads", texelReads, 0, 8);
    }

    /**
     * The estimated work of a picture by a family's method.
     *
     * @param frontsOnly whether backs are left out; painters leave out all, the pipeline those that
     *     are not at an outline
     */
    public PictureWork estimate(
            ScreenAreas areas, boolean frontsOnly, boolean paintsAll, long pairs) {
        long faces = 0;
        long lights = 0;
        double fragments = 0;
        double atEachPixel = 0;
        double textured = 0;
        for (int f = 0; f < areas.faces(); f++) {
            if (frontsOnly && (paintsAll ? areas.back(f) : areas.spare(f))) continue;
            faces++;
            fragments += areas.area(f);
            double painted = areas.area(f) * (paintsAll || !areas.hidden(f) ? 1 : BEFORE);
            textured += painted;
            if (mixed) lights += BOUND;
            if (!atPixels[f]) lights += perCorner ? 4 : 1;
            else atEachPixel += painted;
        }
        double weight = areas.weight();
        fragments *= weight;
        double most = paintsAll ? fragments : Math.min(fragments, areas.pixels());
        return new PictureWork(
                areas.vertices(),
                areas.clipped(),
                Math.round(weight * faces),
                Math.round(weight * lights),
                Math.round(fragments),
                Math.round(Math.min(weight * atEachPixel, most)),
                Math.round(Math.min(weight * textured, most) * texelReads),
                areas.pixels(),
                pairs);
    }
}
