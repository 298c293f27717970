package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Slip;
import rasterlab.engine.texture.Wrap;

/** Lookups that blend too little, take other texels or another level. */
final class FilterSlips {
    private FilterSlips() {}

    static List<Slip<TextureFilter>> of(TextureFilter right) {
        return List.of(
                Slip.of(
                        "cast-for-floor",
                        looked((u, v) -> new int[] {(int) u, (int) v}, true, true, false)),
                Slip.of("blended-in-s-alone", looked(FilterSlips::floors, true, false, false)),
                Slip.of("blended-in-t-alone", looked(FilterSlips::floors, false, true, false)),
                Slip.of("height-for-width", looked(FilterSlips::floors, true, true, true)),
                level("level-one-too-coarse", (s, right2, down) -> s + 1),
                level("level-one-too-fine", (s, right2, down) -> s - 1),
                level("both-steps-added", (s, right2, down) -> LookupMutants.lambda(right2 + down)),
                level(
                        "mean-of-both-steps",
                        (s, right2, down) -> LookupMutants.lambda((right2 + down) / 2)),
                level("logarithm-to-base-10", (s, right2, down) -> s * Math.log10(2)),
                level("level-halved", (s, right2, down) -> s / 2));
    }

    private interface Level {
        /**
         * A level.
         *
         * @param lambda the right one
         * @param right squared length of the step to the right, in texels
         * @param down the same downwards
         */
        double of(double lambda, double right, double down);
    }

    private static Slip<TextureFilter> level(String name, Level level) {
        return Slip.of(
                name,
                LookupMutants.looked(
                        Wrap.REPEAT,
                        (texture, s, t, right, down) ->
                                texture.trilinear(
                                        s,
                                        t,
                                        level.of(
                                                LookupMutants.lambda(Math.max(right, down)),
                                                right,
                                                down))));
    }

    private interface Whole {
        int[] texel(double u, double v);
    }

    private static int[] floors(double u, double v) {
        return new int[] {(int) Math.floor(u), (int) Math.floor(v)};
    }

    /**
     * A bilinear lookup.
     *
     * @param inS whether neighbours along s are blended
     * @param inT whether neighbours along t are
     * @param byHeight whether rows are taken to be as long as columns
     */
    private static TextureFilter looked(Whole whole, boolean inS, boolean inT, boolean byHeight) {
        return (width, height, argb, footprints) -> {
            var colors = new int[footprints.length / FilteredPixels.NUMBERS];
            for (int k = 0; k < colors.length; k++) {
                double s = footprints[FilteredPixels.NUMBERS * k];
                double t = footprints[FilteredPixels.NUMBERS * k + 1];
                double u = (s - Math.floor(s)) * width - 0.5;
                double v = (t - Math.floor(t)) * height - 0.5;
                int[] at = whole.texel(u, v);
                double a = inS ? u - at[0] : 0;
                double b = inT ? v - at[1] : 0;
                int row = byHeight ? height : width;
                for (int shift = 0; shift < 32; shift += 8) {
                    double sum = 0;
                    for (int corner = 0; corner < 4; corner++) {
                        int i = Math.floorMod(at[0] + corner % 2, width);
                        int j = Math.floorMod(at[1] + corner / 2, height);
                        int texel = argb[Math.min(j * row + i, argb.length - 1)];
                        sum +=
                                (corner % 2 == 1 ? a : 1 - a)
                                        * (corner / 2 == 1 ? b : 1 - b)
                                        * (texel >>> shift & 255);
                    }
                    colors[k] |= ((int) Math.round(sum) & 255) << shift;
                }
            }
            return colors;
        };
    }
}
